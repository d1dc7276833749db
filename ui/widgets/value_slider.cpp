#include "ui/widgets/value_slider.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace lacuna::ui {

ValueSteps ValueSteps::of(ValueRange limits) {
    ValueSteps steps;
    const double width = limits.width();
    if (!(width > 0) || width >= 100) return steps;
    steps.decimals = std::clamp(int(std::ceil(2 - std::log10(width))), 1, 9);
    steps.step = std::pow(10.0, -steps.decimals);
    return steps;
}

ValueSlider::ValueSlider(const QString& accessible_name, QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal, this)), spin_(new NumberBox(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(slider_, 1);
    row->addWidget(spin_);
    slider_->setRange(0, k_ticks);
    slider_->setPageStep(k_ticks / 20);
    slider_->setSingleStep(k_ticks / 200);
    slider_->setAccessibleName(accessible_name);
    spin_->setAccessibleName(tr("%1, number").arg(accessible_name));
    spin_->setKeyboardTracking(false);
    spin_->setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
    spin_->setMinimumWidth(84);
    connect(slider_, &QSlider::valueChanged, this, [this](int tick) {
        const double raw = limits_.lo + limits_.width() * tick / k_ticks;
        const double scale = std::pow(10.0, decimals_);
        const double value = std::round(raw * scale) / scale;
        const QSignalBlocker quiet(spin_);
        spin_->setValue(value);
        Q_EMIT valueEdited(spin_->value());
    });
    connect(spin_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        const QSignalBlocker quiet(slider_);
        slider_->setValue(tickOf(value));
        Q_EMIT valueEdited(value);
    });
}

void ValueSlider::setLimits(ValueRange limits) {
    const ValueRange next = limits.width() > 0 ? limits : ValueRange{limits.lo, limits.lo + 1};
    if (next == limits_) return;  // do not move a slider in a person's hand
    limits_ = next;
    const QSignalBlocker quiet(spin_), quiet_slider(slider_);
    const ValueSteps steps = ValueSteps::of(limits_);
    setSteps(steps.decimals, steps.step);
    spin_->setRange(limits_.lo, limits_.hi);
    slider_->setValue(tickOf(spin_->value()));
}

void ValueSlider::setSteps(int decimals, double step) {
    const QSignalBlocker quiet(spin_);
    decimals_ = decimals;
    if (keeps_typed_)
        spin_->setShownDecimals(decimals);
    else
        spin_->setDecimals(decimals);
    spin_->setSingleStep(step);
}

void ValueSlider::keepTypedDigits() {
    keeps_typed_ = true;
    setSteps(decimals_, spin_->singleStep());
}

void ValueSlider::setValue(double value) {
    const QSignalBlocker quiet_spin(spin_), quiet_slider(slider_);
    // What was set elsewhere (a window by the mouse, a plane by its handles) may lie beyond: the number stays true.
    spin_->setRange(std::min(limits_.lo, value), std::max(limits_.hi, value));
    if (spin_->value() == value) return;
    spin_->setValue(value);
    slider_->setValue(tickOf(value));
}

int ValueSlider::tickOf(double value) const {
    return int(std::lround(std::clamp((value - limits_.lo) / limits_.width(), 0.0, 1.0) * k_ticks));
}

}  // namespace lacuna::ui
