#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/inspect/batch.h"

namespace lacuna::ui {

/// The parts of a series with what has become of them.
class BatchModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { k_name, k_state, k_progress, k_verdict, k_reason, k_columns };

    explicit BatchModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void setParts(const std::vector<BatchPart>& parts);
    void setState(std::size_t part, PartState state, double progress);
    /// The rows of a finished series, told by name.
    void setRows(const std::vector<BatchRow>& rows);
    /// Parts whose work was stopped wait again.
    void stopRunning();
    /// Of all parts that are done or broken.
    int finishedParts() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        QString name;
        PartState state = PartState::waiting;
        double progress = 0;
        std::optional<Verdict> verdict;
        QStringList reasons;
    };
    QString text(const Row& row, int column) const;
    std::vector<Row> rows_;
};

}  // namespace lacuna::ui
