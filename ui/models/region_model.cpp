#include "ui/models/region_model.h"

#include <array>

namespace lacuna::ui {

namespace {

struct Column {
    const char *name, *hint;
    int digits;  ///< significant digits; 0: a whole number
    double (*value)(const RegionCharacteristics&);
};

using Row = const RegionCharacteristics&;
constexpr std::array k_columns = {
    Column{"Id", "Number of the region, by descending size", 0, [](Row r) { return double(r.id); }},
    Column{"Voxels", "Number of voxels", 0, [](Row r) { return double(r.voxels); }},
    Column{"Volume mm³", "Voxels times the volume of one", 5, [](Row r) { return r.volume_mm3; }},
    Column{"Share %", "Of the voxels of all regions", 4, [](Row r) { return 100 * r.fraction; }},
    Column{"Surface mm²", "Estimated surface area", 5, [](Row r) { return r.surface_mm2; }},
    Column{"Sphericity", "1 for a ball", 4, [](Row r) { return r.sphericity; }},
    Column{"Shape factor", "Surface cubed over volume squared; 113.1 for a ball, more for anything less compact", 5,
           [](Row r) { return r.shape_factor; }},
    Column{"Holes", "Closed cavities", 0, [](Row r) { return double(r.holes); }},
    Column{"Tunnels", "Handles through the region", 0, [](Row r) { return double(r.tunnels); }},
    Column{"Diameter mm", "Of the ball of equal volume", 4, [](Row r) { return r.equivalent_diameter_mm; }},
    Column{"Length mm", "Longest axis of the ellipsoid of equal moments", 4,
           [](Row r) { return r.principal_lengths_mm.x; }},
    Column{"Mean", "Mean value", 5, [](Row r) { return r.mean; }},
    Column{"Min", "Smallest value", 5, [](Row r) { return r.min; }},
    Column{"Max", "Largest value", 5, [](Row r) { return r.max; }},
    Column{"Std. dev.", "Standard deviation of the values", 4, [](Row r) { return r.stddev; }},
    Column{"x mm", "Centroid, to the patient's left", 5, [](Row r) { return r.centroid_mm.x; }},
    Column{"y mm", "Centroid, to the back", 5, [](Row r) { return r.centroid_mm.y; }},
    Column{"z mm", "Centroid, to the head", 5, [](Row r) { return r.centroid_mm.z; }},
    Column{"Border", "The region touches the volume's border", 0, [](Row r) { return r.touches_border ? 1.0 : 0.0; }}};

}  // namespace

void RegionModel::setTable(std::shared_ptr<const RegionTable> table) {
    beginResetModel();
    table_ = std::move(table);
    endResetModel();
}

int RegionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !table_ ? 0 : int(table_->rows.size());
}

int RegionModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(k_columns.size()); }

QVariant RegionModel::data(const QModelIndex& index, int role) const {
    if (!table_ || !index.isValid()) return {};
    const RegionCharacteristics& row = table_->rows[std::size_t(index.row())];
    const Column& column = k_columns[std::size_t(index.column())];
    if (role == k_sort_role) return column.value(row);
    if (role == k_id_role) return row.id;
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && !row.flags.empty()) {
        QStringList flags;
        for (const std::string& flag : row.flags) flags << QString::fromStdString(flag);
        return flags.join(QLatin1Char('\n'));
    }
    if (role != Qt::DisplayRole) return {};
    if (index.column() + 1 == int(k_columns.size())) return row.touches_border ? tr("yes") : tr("no");
    const double value = column.value(row);
    return column.digits == 0 ? QString::number(qlonglong(value)) : QString::number(value, 'g', column.digits);
}

QVariant RegionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= int(k_columns.size())) return {};
    if (role == Qt::DisplayRole) return tr(k_columns[std::size_t(section)].name);
    if (role == Qt::ToolTipRole) return tr(k_columns[std::size_t(section)].hint);
    return {};
}

int RegionModel::rowOf(std::uint32_t id) const {
    if (!table_) return -1;
    for (std::size_t i = 0; i < table_->rows.size(); ++i)
        if (table_->rows[i].id == id) return int(i);
    return -1;
}

}  // namespace lacuna::ui
