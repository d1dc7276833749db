#include "ui/panels/range_row.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <cmath>

#include "ui/number_text.h"
#include "ui/preset_title.h"
#include "ui/tab_chain.h"
#include "ui/widgets/plot_paint.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

namespace {
constexpr double k_one_color_opacity = 0.5;
}

TransferFunction one_color_function(const RangeSetting& setting, double unit_distance_mm) {
    TransferFunction tf;
    tf.name = k_one_color_name;
    tf.unit_distance_mm = unit_distance_mm;
    tf.points = {{setting.range.range.lo, setting.color, k_one_color_opacity}};
    return tf;
}

RangeRow::RangeRow(int number, ValueRange limits, const QString& unit, QWidget* parent)
    : QWidget(parent),
      enabled_(new QCheckBox(this)),
      name_(new QLineEdit(this)),
      color_(new QToolButton(this)),
      up_(new QToolButton(this)),
      slider_(new RangeSlider(this)),
      lo_(new NumberBox(this)),
      hi_(new NumberBox(this)),
      colors_(new QComboBox(this)),
      remove_(new QPushButton(tr("Remove"), this)),
      count_(new QLabel(this)) {
    build(number);
    const ValueSteps steps = ValueSteps::of(limits);
    slider_->setLimits(limits);
    slider_->setStep(steps.decimals == 0 ? std::max(1.0, std::round(limits.width() / 500)) : steps.step);
    for (QDoubleSpinBox* end : {lo_, hi_}) {
        end->setRange(limits.lo, limits.hi);
        end->setDecimals(steps.decimals);
        end->setSingleStep(steps.step);
        end->setKeyboardTracking(false);
        end->setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
        if (!unit.isEmpty()) end->setSuffix(QStringLiteral(" ") + unit);
    }
    connectParts();
}

void RangeRow::build(int number) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 4, 0, 10);
    auto* head = new QHBoxLayout;
    head->addWidget(enabled_);
    head->addWidget(color_);
    head->addWidget(name_, 1);
    head->addWidget(up_);
    grid->addLayout(head, 0, 0, 1, 2);
    grid->addWidget(slider_, 1, 0, 1, 2);
    auto* ends = new QHBoxLayout;
    ends->addWidget(lo_, 1);
    ends->addWidget(new QLabel(tr("to"), this));
    ends->addWidget(hi_, 1);
    grid->addLayout(ends, 2, 0, 1, 2);
    grid->addWidget(colors_, 3, 0);
    grid->addWidget(remove_, 3, 1);
    grid->addWidget(count_, 4, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    count_->setWordWrap(true);
    up_->setArrowType(Qt::UpArrow);
    up_->setFocusPolicy(Qt::StrongFocus);
    up_->setEnabled(number > 1);
    up_->setToolTip(tr("Moves it one place up: where ranges overlap, the upper one counts"));
    color_->setFocusPolicy(Qt::StrongFocus);
    color_->setToolTip(tr("The range's colour"));
    enabled_->setToolTip(tr("Whether the range is in use"));
    colors_->addItems({tr("Scene's colours"), tr("Own colours…"), tr("One colour")});
    for (const std::string& name : preset_names()) colors_->addItem(preset_title(name), QString::fromStdString(name));
    enabled_->setAccessibleName(tr("Range %1 in use").arg(number));
    name_->setAccessibleName(tr("Name of range %1").arg(number));
    color_->setAccessibleName(tr("Colour of range %1").arg(number));
    up_->setAccessibleName(tr("Move range %1 up").arg(number));
    slider_->setAccessibleName(tr("Range %1").arg(number));
    lo_->setAccessibleName(tr("Lower end of range %1").arg(number));
    hi_->setAccessibleName(tr("Upper end of range %1").arg(number));
    colors_->setAccessibleName(tr("Colours of range %1").arg(number));
    remove_->setAccessibleName(tr("Remove range %1").arg(number));
    count_->setAccessibleName(tr("What range %1 holds").arg(number));
    chain_tabs({enabled_, color_, name_, up_, slider_, lo_, hi_, colors_, remove_});
}

void RangeRow::connectParts() {
    connect(enabled_, &QCheckBox::toggled, this, [this](bool on) {
        setting_.enabled = on;
        Q_EMIT edited(on ? tr("Use a range") : tr("Leave out a range"), setting_);
    });
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        const std::string name = name_->text().trimmed().toStdString();
        if (name == setting_.range.name || name.empty())
            return name_->setText(QString::fromStdString(setting_.range.name));
        setting_.range.name = name;
        Q_EMIT edited(tr("Name of a range"), setting_);
    });
    connect(color_, &QToolButton::clicked, this, &RangeRow::colorRequested);
    connect(up_, &QToolButton::clicked, this, &RangeRow::upRequested);
    connect(slider_, &RangeSlider::rangeEdited, this, &RangeRow::editEnds);
    connect(lo_, &QDoubleSpinBox::valueChanged, this, [this](double lo) {
        editEnds({lo, std::max(lo, setting_.range.range.hi)});
    });
    connect(hi_, &QDoubleSpinBox::valueChanged, this, [this](double hi) {
        editEnds({std::min(hi, setting_.range.range.lo), hi});
    });
    connect(colors_, &QComboBox::activated, this, &RangeRow::chooseColors);
    connect(remove_, &QPushButton::clicked, this, &RangeRow::removeRequested);
}

void RangeRow::chooseColors(int index) {
    if (index == k_own) {
        Q_EMIT ownColorsRequested();
    } else if (index >= k_first_preset) {
        Q_EMIT presetChosen(colors_->itemData(index).toString());
    } else {
        const double unit_mm = setting_.range.tf ? setting_.range.tf->unit_distance_mm : unit_distance_mm_;
        setting_.range.tf.reset();
        if (index == k_one_color) setting_.range.tf = one_color_function(setting_, unit_mm);
        Q_EMIT edited(tr("Colours of a range"), setting_);
    }
}

void RangeRow::setSetting(const RangeSetting& setting) {
    setting_ = setting;
    const QSignalBlocker quiet[] = {QSignalBlocker(enabled_), QSignalBlocker(lo_), QSignalBlocker(hi_)};
    enabled_->setChecked(setting.enabled);
    const QString name = QString::fromStdString(setting.range.name);
    if (name_->text() != name) name_->setText(name);
    QPixmap swatch(14, 14);
    swatch.fill(to_qcolor(setting.color));
    color_->setIcon(swatch);
    slider_->setColor(to_qcolor(setting.color));
    if (slider_->range() != setting.range.range) slider_->setRange(setting.range.range);
    lo_->setValue(setting.range.range.lo);
    hi_->setValue(setting.range.range.hi);
    int index = k_scene;
    if (const auto& tf = setting.range.tf) {
        const int preset = colors_->findData(QString::fromStdString(tf->name));
        index = tf->name == k_one_color_name ? int(k_one_color) : preset >= k_first_preset ? preset : int(k_own);
    }
    colors_->setCurrentIndex(index);
}

void RangeRow::setCount(const std::optional<RangeCount>& count) {
    if (!count) return count_->setText(QStringLiteral("…"));
    const int decimals = count->volume_mm3 >= 1000 ? 0 : count->volume_mm3 >= 1 ? 2 : 5;
    QString text = tr("%1 voxels · %2 mm³ · %3 %")
                       .arg(count_text(count->voxels), number_text(count->volume_mm3, 'f', decimals),
                            number_text(100 * count->share, 'f', 2));
    if (count->voxels > 0) text += tr(" · mean %1").arg(number_text(count->mean, 'g', 5));
    if (count->own < count->voxels)
        text += tr("\n%1 of them are in a range above, which draws them").arg(count_text(count->voxels - count->own));
    count_->setText(text);
}

void RangeRow::editEnds(ValueRange range) {
    setting_.range.range = range;
    setSetting(RangeSetting(setting_));
    Q_EMIT edited(tr("Ends of %1").arg(QString::fromStdString(setting_.range.name)), setting_);
}

}  // namespace lacuna::ui
