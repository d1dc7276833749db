#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/regions/regions.h"

namespace lacuna::ui {

/// The rows of a region table. The sort role gives numbers, so that 10 comes after 9.
class RegionModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr int k_sort_role = Qt::UserRole;
    static constexpr int k_id_role = Qt::UserRole + 1;

    explicit RegionModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
    void setTable(std::shared_ptr<const lacuna::RegionTable> table);
    /// What the axes are called that the centroids are told along.
    void setAxisNames(lacuna::AxisNames names);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    std::shared_ptr<const RegionTable> table_;
    AxisNames names_ = AxisNames::xyz;
};

}  // namespace lacuna::ui
