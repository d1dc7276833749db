#include "ui/models/region_model.h"

#include <array>

#include "ui/core_sentences.h"
#include "ui/number_text.h"

namespace lacuna::ui {

namespace {

struct Column {
    const char *name, *hint;  ///< the hint of a patient's coordinate says where it counts to
    int digits;               ///< significant digits; 0: a whole number
    double (*value)(const RegionCharacteristics&);
    bool coordinate = false;
};

constexpr const char* k_centroid = QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Coordinate of the centroid");

using Row = const RegionCharacteristics&;
constexpr std::array k_columns = {
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Id"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Number of the region, by descending size"), 0,
           [](Row r) { return double(r.id); }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Voxels"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Number of voxels"), 0, [](Row r) { return double(r.voxels); }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Volume mm³"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Voxels times the volume of one"), 5,
           [](Row r) { return r.volume_mm3; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Share %"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Of the voxels of all regions"), 4,
           [](Row r) { return 100 * r.fraction; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Surface mm²"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Estimated surface area"), 5,
           [](Row r) { return r.surface_mm2; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Sphericity"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "1 for a ball"), 4, [](Row r) { return r.sphericity; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Shape factor"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel",
                             "Surface cubed over volume squared; 113.1 for a ball, more for anything less compact"),
           5, [](Row r) { return r.shape_factor; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Holes"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Closed cavities"), 0, [](Row r) { return double(r.holes); }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Tunnels"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Handles through the region"), 0,
           [](Row r) { return double(r.tunnels); }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Diameter mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Of the ball of equal volume"), 4,
           [](Row r) { return r.equivalent_diameter_mm; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Length mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Longest axis of the ellipsoid of equal moments"), 4,
           [](Row r) { return r.principal_lengths_mm.x; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Mean"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Mean value"), 5, [](Row r) { return r.mean; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Min"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Smallest value"), 5, [](Row r) { return r.min; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Max"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Largest value"), 5, [](Row r) { return r.max; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Std. dev."),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Standard deviation of the values"), 4,
           [](Row r) { return r.stddev; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "x mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Centroid, to the patient's left"), 5,
           [](Row r) { return r.centroid_mm.x; }, true},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "y mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Centroid, to the back"), 5,
           [](Row r) { return r.centroid_mm.y; }, true},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "z mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Centroid, to the head"), 5,
           [](Row r) { return r.centroid_mm.z; }, true},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "Border"),
           QT_TRANSLATE_NOOP("lacuna::ui::RegionModel", "The region touches the volume's border"), 0,
           [](Row r) { return r.touches_border ? 1.0 : 0.0; }}};

}  // namespace

void RegionModel::setAxisNames(AxisNames names) {
    if (names == names_) return;
    names_ = names;
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, int(k_columns.size()) - 1);
}

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
        for (const std::string& flag : row.flags) flags << core_sentence(flag);
        return flags.join(QLatin1Char('\n'));
    }
    if (role != Qt::DisplayRole) return {};
    if (index.column() + 1 == int(k_columns.size())) return row.touches_border ? tr("yes") : tr("no");
    const double value = column.value(row);
    return column.digits == 0 ? QString::number(qlonglong(value)) : number_text(value, 'g', column.digits);
}

QVariant RegionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= int(k_columns.size())) return {};
    if (role == Qt::DisplayRole) return tr(k_columns[std::size_t(section)].name);
    const Column& column = k_columns[std::size_t(section)];
    if (role == Qt::ToolTipRole) return tr(column.coordinate && names_ == AxisNames::xyz ? k_centroid : column.hint);
    return {};
}

}  // namespace lacuna::ui
