#include "ui/models/defect_model.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/core_sentences.h"
#include "ui/number_text.h"

namespace lacuna::ui {

namespace {

constexpr double k_none = std::numeric_limits<double>::quiet_NaN();

struct Column {
    const char *name, *hint;
    const char* word;  ///< in the filter; "": none
    int digits;        ///< significant digits; 0: a whole number; -1: text
    double (*value)(const Defect&);
    const Measured* (*interval)(const Defect&);
};

using Row = const Defect&;
constexpr auto k_no_interval = [](Row) -> const Measured* { return nullptr; };
constexpr int k_type_column = 1, k_verdict_column = 2, k_why_column = 14;
constexpr std::array k_columns = {
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Id"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Number of the defect, by descending volume"), "id", 0,
           [](Row r) { return double(r.id); }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Type"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Void or inclusion"), "", -1,
           [](Row r) { return double(int(r.type)); }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Verdict"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Held against the limits, or decided by hand"), "", -1,
           [](Row) { return k_none; }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Volume mm³"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "From grey values, below the size of a voxel"), "volume", 4,
           [](Row r) { return r.measurable ? r.volume_mm3.value : k_none; }, [](Row r) { return &r.volume_mm3; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Voxels"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Number of voxels"), "voxels", 0,
           [](Row r) { return double(r.voxels); }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Diameter mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Of the circumscribed sphere"), "diameter", 4,
           [](Row r) { return r.measurable ? r.diameter_mm.value : k_none; }, [](Row r) { return &r.diameter_mm; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Eq. diameter mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Of the ball of equal volume"), "equivalent", 4,
           [](Row r) { return r.measurable ? r.equivalent_diameter_mm.value : k_none; },
           [](Row r) { return &r.equivalent_diameter_mm; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Depth mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Distance to the part's surface"), "depth", 4,
           [](Row r) { return r.surface_distance_mm.value; }, [](Row r) { return &r.surface_distance_mm; }},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Gap mm"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "To the next defect"), "gap", 4, [](Row r) { return r.gap_mm; },
           k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Sphericity"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "1 for a ball"), "sphericity", 3,
           [](Row r) { return r.sphericity; }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Probability"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "That it is a defect and no noise"), "probability", 3,
           [](Row r) { return r.probability; }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Mean"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Mean value"), "mean", 5, [](Row r) { return r.mean; },
           k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Cavities"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Closed cavities inside"), "cavities", 0,
           [](Row r) { return double(r.cavities); }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Tunnels"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Handles through it"), "tunnels", 0,
           [](Row r) { return double(r.tunnels); }, k_no_interval},
    Column{QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "Why"),
           QT_TRANSLATE_NOOP("lacuna::ui::DefectModel", "What decided the verdict"), "", -1, [](Row) { return k_none; },
           k_no_interval}};

/// Dark blue over grey to yellow, of even steps in lightness.
QColor scale_color(double share) {
    static const std::array<QColor, 5> stops = {QColor(0, 45, 106), QColor(66, 86, 122), QColor(124, 123, 120),
                                                QColor(186, 166, 92), QColor(253, 231, 55)};
    const double at = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0) * (stops.size() - 1);
    const std::size_t low = std::min<std::size_t>(std::size_t(at), stops.size() - 2);
    const double rest = at - double(low);
    const auto mix = [&](int a, int b) { return int(std::lround(a + (b - a) * rest)); };
    const QColor &a = stops[low], &b = stops[low + 1];
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

QColor verdict_color(Verdict verdict) {
    if (verdict == Verdict::pass) return {0, 158, 115};
    return verdict == Verdict::fail ? QColor(213, 94, 0) : QColor(240, 200, 40);
}

/// Of every defect, how far its value lies on the way from the smallest to the largest.
template <class Value>
std::vector<double> shares(const PartAnalysis& part, Value value) {
    std::vector<double> shares;
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const Defect& defect : part.defects) {
        shares.push_back(value(defect));
        if (!std::isfinite(shares.back())) continue;
        lo = std::min(lo, shares.back());
        hi = std::max(hi, shares.back());
    }
    for (double& share : shares) share = hi > lo ? (share - lo) / (hi - lo) : 1;
    return shares;
}

}  // namespace

std::vector<QColor> defect_colors(const PartAnalysis& part, const Judgement& judgement, DefectColoring coloring) {
    std::vector<QColor> colors;
    if (coloring == DefectColoring::size)
        for (const double share : shares(part, [](Row r) { return std::log(std::max(1.0, double(r.voxels))); }))
            colors.push_back(scale_color(share));
    else if (coloring == DefectColoring::depth)
        for (const double share : shares(part, [](Row r) { return r.surface_distance_mm.value; }))
            colors.push_back(scale_color(1 - share));
    else
        for (std::size_t row = 0; row < part.defects.size(); ++row)
            colors.push_back(
                verdict_color(row < judgement.defects.size() ? judgement.defects[row].verdict : Verdict::cannot_tell));
    return colors;
}

void DefectModel::set(std::shared_ptr<const PartAnalysis> part, const Judgement& judgement) {
    beginResetModel();
    part_ = std::move(part);
    judgement_ = judgement;
    recolor();
    endResetModel();
}

void DefectModel::setJudgement(const Judgement& judgement) {
    judgement_ = judgement;
    recolor();
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void DefectModel::setColoring(DefectColoring coloring) {
    coloring_ = coloring;
    recolor();
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, 0), {Qt::DecorationRole});
}

void DefectModel::recolor() { colors_ = part_ ? defect_colors(*part_, judgement_, coloring_) : std::vector<QColor>(); }

int DefectModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !part_ ? 0 : int(part_->defects.size());
}

int DefectModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(k_columns.size()); }

QString DefectModel::text(std::size_t row, int column) const {
    const Defect& defect = part_->defects[row];
    if (column == k_type_column) return defect.type == DefectType::void_ ? tr("void") : tr("inclusion");
    if (row >= judgement_.defects.size()) return {};
    const DefectJudgement& judged = judgement_.defects[row];
    if (column == k_why_column) return core_sentence(judged.why);
    return judged.verdict == Verdict::pass   ? tr("pass")
           : judged.verdict == Verdict::fail ? tr("fail")
                                             : tr("cannot tell");
}

QVariant DefectModel::data(const QModelIndex& index, int role) const {
    if (!part_ || !index.isValid()) return {};
    const auto row = std::size_t(index.row());
    const Defect& defect = part_->defects[row];
    const Column& column = k_columns[std::size_t(index.column())];
    const bool words = column.digits < 0;
    if (role == k_id_role) return defect.id;
    if (role == k_sort_role) return words ? QVariant(text(row, index.column())) : QVariant(column.value(defect));
    if (role == Qt::TextAlignmentRole) return int((words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::DecorationRole && index.column() == 0) return colors_[row];
    if (role == Qt::ToolTipRole) {
        QStringList lines;
        if (const Measured* interval = column.interval(defect); interval && std::isfinite(interval->value))
            lines << tr("%1 to %2").arg(number_text(interval->lo, 'g', 4), number_text(interval->hi, 'g', 4));
        if (words) lines << text(row, index.column());
        for (const std::string& flag : defect.flags) lines << core_sentence(flag);
        return lines.join(QLatin1Char('\n'));
    }
    if (role != Qt::DisplayRole) return {};
    if (words) return text(row, index.column());
    const double value = column.value(defect);
    if (std::isnan(value)) return tr("not measurable");
    return column.digits == 0 ? QString::number(qlonglong(value)) : number_text(value, 'g', column.digits);
}

QVariant DefectModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= int(k_columns.size())) return {};
    if (role == Qt::DisplayRole) return tr(k_columns[std::size_t(section)].name);
    if (role == Qt::ToolTipRole) return tr(k_columns[std::size_t(section)].hint);
    return {};
}

namespace {

/// By the word of reports, or by what stands above it in the window, with its unit or without.
bool is_named(const Column& column, const QString& name) {
    if (*column.word == 0) return false;
    static const QRegularExpression unit(QStringLiteral("\\s+(mm|mm²|mm³|%)$"));
    const QString title = DefectModel::tr(column.name);
    for (const QString& known : {QString::fromLatin1(column.word), title, QString(title).remove(unit)})
        if (name.compare(known, Qt::CaseInsensitive) == 0) return true;
    return false;
}

}  // namespace

void DefectFilter::setText(const QString& text) {
    static const QRegularExpression comparison(QStringLiteral("^\\s*(.+?)\\s*(<=|>=|<|>)\\s*([-+.,eE0-9]+)\\s*$"));
    words_ = text.trimmed();
    column_ = -1;
    const QRegularExpressionMatch match = comparison.match(text);
    const std::optional<double> limit = typed_number(match.captured(3));
    limit_ = limit.value_or(0);
    for (std::size_t i = 0; limit && i < k_columns.size(); ++i)
        if (is_named(k_columns[i], match.captured(1))) column_ = int(i);
    side_ = match.captured(2);
    invalidateFilter();
}

bool DefectFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    if (words_.isEmpty()) return true;
    if (column_ >= 0) {
        const double value = sourceModel()->index(row, column_, parent).data(DefectModel::k_sort_role).toDouble();
        if (side_ == QLatin1String("<")) return value < limit_;
        if (side_ == QLatin1String(">")) return value > limit_;
        return side_ == QLatin1String("<=") ? value <= limit_ : value >= limit_;
    }
    for (const int column : {k_type_column, k_verdict_column, k_why_column})
        if (sourceModel()->index(row, column, parent).data().toString().contains(words_, Qt::CaseInsensitive))
            return true;
    return false;
}

}  // namespace lacuna::ui
