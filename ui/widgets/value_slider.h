#pragma once

#include <QSlider>
#include <QWidget>

#include "core/volume/volume.h"
#include "ui/number_text.h"

namespace lacuna::ui {

/// Decimals and a step that suit a range of values: whole numbers where the range is wide, hundredths of it else.
struct ValueSteps {
    int decimals = 0;
    double step = 1;
    static ValueSteps of(ValueRange limits);
};

/// A slider and a spin box of one value.
class ValueSlider final : public QWidget {
    Q_OBJECT
public:
    explicit ValueSlider(const QString& accessible_name, QWidget* parent = nullptr);

    void setLimits(lacuna::ValueRange limits);
    void setSteps(int decimals, double step);
    /// What is typed into the box is taken and shown as typed (as_typed_text()), finer than the steps where it is so.
    void keepTypedDigits();
    void setSuffix(const QString& suffix) { spin_->setSuffix(suffix); }
    void setValue(double value);  ///< from the program: emits nothing
    double value() const { return spin_->value(); }
    QSlider* slider() const { return slider_; }
    QDoubleSpinBox* spin() const { return spin_; }

Q_SIGNALS:
    void valueEdited(double value);

private:
    static constexpr int k_ticks = 1000;
    int tickOf(double value) const;

    ValueRange limits_{0, 0};
    int decimals_ = 2;  ///< that the handle moves by and a box shows at least
    bool keeps_typed_ = false;
    QSlider* slider_;
    NumberBox* spin_;
};

}  // namespace lacuna::ui
