#include "ui/panels/criteria_form.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "ui/number_text.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

OptionalValue::OptionalValue(const QString& label, const QString& accessible_name, QWidget* parent)
    : QWidget(parent), box_(new QCheckBox(label, this)), spin_(new NumberBox(this)) {
    box_->setAccessibleName(accessible_name);
    spin_->setAccessibleName(tr("%1, value").arg(accessible_name));
    spin_->setEnabled(false);
    spin_->setKeyboardTracking(false);
    // Room for what is entered, not for the largest number there is: what is cut off at the form's side is out of
    // reach.
    spin_->setMinimumWidth(spin_->fontMetrics().horizontalAdvance(QStringLiteral("0000.000 mm³")) + 24);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(box_, 1);
    row->addWidget(spin_);
    connect(box_, &QCheckBox::toggled, this, [this](bool on) {
        spin_->setEnabled(on);
        Q_EMIT edited();
    });
    connect(spin_, &QDoubleSpinBox::valueChanged, this, &OptionalValue::edited);
}

std::optional<double> OptionalValue::value() const {
    return box_->isChecked() ? std::optional(spin_->value()) : std::nullopt;
}

void OptionalValue::setValue(std::optional<double> value) {
    const QSignalBlocker box(box_), spin(spin_);
    box_->setChecked(value.has_value());
    spin_->setEnabled(value.has_value());
    if (value) spin_->setValue(*value);
}

namespace {

struct LimitText {
    Rule rule;
    const char *label, *suffix;
    double start, step;
    int decimals;
};
constexpr std::array k_limit_texts = {
    LimitText{Rule::porosity_percent, QT_TRANSLATE_NOOP("lacuna::ui::CriteriaForm", "Porosity at most"), " %", 1, 0.1,
              3},
    LimitText{Rule::defect_volume_mm3, QT_TRANSLATE_NOOP("lacuna::ui::CriteriaForm", "Volume at most"), " mm³", 1, 0.1,
              4},
    LimitText{Rule::defect_diameter_mm, QT_TRANSLATE_NOOP("lacuna::ui::CriteriaForm", "Diameter at most"), " mm", 1,
              0.1, 4},
    LimitText{Rule::count, QT_TRANSLATE_NOOP("lacuna::ui::CriteriaForm", "Defects at most"), "", 10, 1, 0},
    LimitText{Rule::min_gap_mm, QT_TRANSLATE_NOOP("lacuna::ui::CriteriaForm", "Gap at least"), " mm", 1, 0.1, 4},
    LimitText{Rule::min_surface_distance_mm, QT_TRANSLATE_NOOP("lacuna::ui::CriteriaForm", "Depth at least"), " mm", 1,
              0.1, 4}};

}  // namespace

CriteriaForm::CriteriaForm(QWidget* parent)
    : QWidget(parent),
      material_(new OptionalValue(tr("Material from"), tr("Material from this value on"), this)),
      void_below_(new OptionalValue(tr("below"), tr("Voids below this value"), this)),
      inclusion_above_(new OptionalValue(tr("above"), tr("Inclusions above this value"), this)),
      voids_(new QCheckBox(tr("Voids"), this)),
      inclusions_(new QCheckBox(tr("Inclusions"), this)),
      min_voxels_(new QSpinBox(this)),
      zones_(new QLabel(this)) {
    material_->setToolTip(tr("Unchecked: found in the histogram, at the middle of the threshold's stable plateau"));
    void_below_->setToolTip(tr("Unchecked: half-way between the two sides of each boundary"));
    voids_->setAccessibleName(tr("Look for voids"));
    inclusions_->setAccessibleName(tr("Look for inclusions"));
    min_voxels_->setRange(1, 1000000);
    min_voxels_->setPrefix(tr("at least "));
    min_voxels_->setSuffix(tr(" voxels"));
    min_voxels_->setAccessibleName(tr("Smallest defect, voxels"));
    min_voxels_->setKeyboardTracking(false);
    zones_->setEnabled(false);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(3);
    grid->addWidget(material_, 0, 0, 1, 2);
    grid->addWidget(voids_, 1, 0);
    grid->addWidget(void_below_, 1, 1);
    grid->addWidget(inclusions_, 2, 0);
    grid->addWidget(inclusion_above_, 2, 1);
    grid->addWidget(min_voxels_, 3, 0, 1, 2);
    int row = 4;
    for (const LimitText& text : k_limit_texts) {
        const QString label = tr(text.label);
        auto* limit = new OptionalValue(label, label, this);
        limit->spin()->setDecimals(text.decimals);
        limit->spin()->setRange(0, 1e9);
        limit->spin()->setValue(text.start);
        limit->spin()->setSingleStep(text.step);
        limit->spin()->setSuffix(QString::fromUtf8(text.suffix));
        limits_[std::size_t(text.rule)] = limit;
        grid->addWidget(limit, row++, 0, 1, 2);
        connect(limit, &OptionalValue::edited, this, &CriteriaForm::takeLimits);
    }
    grid->addWidget(zones_, row, 0, 1, 2);
    grid->setRowStretch(row + 1, 1);
    for (OptionalValue* value : {material_, void_below_, inclusion_above_})
        connect(value, &OptionalValue::edited, this, &CriteriaForm::takeDetection);
    for (QCheckBox* box : {voids_, inclusions_}) connect(box, &QCheckBox::toggled, this, &CriteriaForm::takeDetection);
    connect(min_voxels_, &QSpinBox::valueChanged, this, &CriteriaForm::takeDetection);
    criteria_.json = criteria_to_json(criteria_);
    show(criteria_);
}

void CriteriaForm::setVolume(const Volume& volume, const VolumeStatistics& statistics) {
    highest_ = statistics.range.hi;
    const ValueSteps steps = ValueSteps::of(statistics.range);
    const double otsu = otsu_threshold(statistics);
    for (OptionalValue* value : {material_, void_below_, inclusion_above_}) {
        const QSignalBlocker quiet(value->spin());
        value->spin()->setDecimals(steps.decimals);
        value->spin()->setSingleStep(steps.step);
        value->spin()->setRange(statistics.range.lo, statistics.range.hi);
        value->spin()->setSuffix(volume.unit.empty() ? QString()
                                                     : QStringLiteral(" ") + QString::fromStdString(volume.unit));
        if (!value->value()) value->spin()->setValue(value == inclusion_above_ ? statistics.range.hi : otsu);
    }
}

void CriteriaForm::show(const Criteria& criteria) {
    const DetectionOptions& detection = criteria.detection;
    const QSignalBlocker voids(voids_), inclusions(inclusions_), least(min_voxels_);
    material_->setValue(detection.material ? std::optional(detection.material->lo) : std::nullopt);
    voids_->setChecked(detection.voids);
    void_below_->setValue(detection.void_below);
    inclusions_->setChecked(detection.inclusions);
    inclusion_above_->setValue(detection.inclusion_above);
    min_voxels_->setValue(int(detection.min_voxels));
    void_below_->setEnabled(detection.voids);
    inclusion_above_->setEnabled(detection.inclusions);
    for (const Rule rule : k_rules) limits_[std::size_t(rule)]->setValue(criteria.limits[rule]);
    QStringList names;
    for (const Zone& zone : criteria.zones) names << QString::fromStdString(zone.name);
    zones_->setText(names.isEmpty() ? tr("No zones") : tr("Zones: %1").arg(names.join(QStringLiteral(", "))));
}

void CriteriaForm::setCriteria(const Criteria& criteria) {
    criteria_ = criteria;
    show(criteria_);
}

void CriteriaForm::takeDetection() {
    DetectionOptions& detection = criteria_.detection;
    const std::optional<double> material = material_->value();
    const double top = detection.material ? std::max(detection.material->hi, highest_) : highest_;
    detection.material = material ? std::optional(ValueRange{*material, std::max(*material, top)}) : std::nullopt;
    if (!voids_->isChecked() && !inclusions_->isChecked()) {  // there must be something to look for
        const QSignalBlocker quiet(voids_);
        voids_->setChecked(true);
    }
    detection.voids = voids_->isChecked();
    detection.void_below = void_below_->value();
    detection.inclusions = inclusions_->isChecked();
    detection.inclusion_above = inclusion_above_->value();
    detection.min_voxels = min_voxels_->value();
    void_below_->setEnabled(detection.voids);
    inclusion_above_->setEnabled(detection.inclusions);
    criteria_.json = criteria_to_json(criteria_);
    Q_EMIT detectionEdited();
}

void CriteriaForm::takeLimits() {
    for (const Rule rule : k_rules) criteria_.limits[rule] = limits_[std::size_t(rule)]->value();
    criteria_.json = criteria_to_json(criteria_);
    Q_EMIT limitsEdited();
}

}  // namespace lacuna::ui
