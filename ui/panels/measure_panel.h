#pragma once

#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "core/session/measurement.h"

namespace lacuna::ui {

/// The list of measurements: what and where each is and what it says; to choose, remove, copy and export them.
class MeasurePanel final : public QWidget {
    Q_OBJECT
public:
    /// One row: the measurement and its words in the columns' order behind number and kind.
    struct Row {
        Measurement measurement;
        QString where, size, mean, spread, least, most, pixels;
    };

    explicit MeasurePanel(QWidget* parent = nullptr);
    void setRows(const std::vector<Row>& rows);
    void select(std::uint32_t id);
    QTableWidget* table() const { return table_; }

Q_SIGNALS:
    void chosen(std::uint32_t id);  ///< 0: none
    void removeRequested();
    void copyRequested();
    void exportRequested();

private:
    QTableWidget* table_;
    QPushButton *remove_, *copy_, *export_;
    std::vector<std::uint32_t> ids_;
};

}  // namespace lacuna::ui
