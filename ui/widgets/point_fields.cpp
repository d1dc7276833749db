#include "ui/widgets/point_fields.h"

#include <QColorDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "ui/number_text.h"
#include "ui/widgets/plot_paint.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {

PointFields::PointFields(TransferPlot* plot, bool colors, QWidget* parent)
    : QWidget(parent),
      plot_(plot),
      value_(new NumberBox(this)),
      opacity_(new NumberBox(this)),
      color_(new QPushButton(tr("Colour…"), this)),
      add_(new QPushButton(tr("Add"), this)),
      remove_(new QPushButton(tr("Remove"), this)) {
    value_->setAccessibleName(tr("Value of the selected point"));
    value_->setKeyboardTracking(false);
    opacity_->setAccessibleName(tr("Opacity of the selected point"));
    opacity_->setRange(0, 1);
    opacity_->setDecimals(3);
    opacity_->setSingleStep(0.02);
    opacity_->setKeyboardTracking(false);
    color_->setAccessibleName(tr("Colour of the selected points"));
    color_->setVisible(colors);
    add_->setAccessibleName(tr("Add a point after the selected one"));
    remove_->setAccessibleName(tr("Remove the selected points"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    auto* value_label = new QLabel(colors ? tr("V&alue") : tr("Gradie&nt"), this);
    value_label->setBuddy(value_);
    auto* opacity_label = new QLabel(colors ? tr("&Opacity") : tr("Fa&ctor"), this);
    opacity_label->setBuddy(opacity_);
    grid->addWidget(value_label, 0, 0);
    grid->addWidget(value_, 0, 1);
    grid->addWidget(opacity_label, 0, 2);
    grid->addWidget(opacity_, 0, 3);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {color_, add_, remove_}) buttons->addWidget(button);
    grid->addLayout(buttons, 1, 0, 1, 4);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    connect(value_, &QDoubleSpinBox::valueChanged, this, &PointFields::editPoint);
    connect(opacity_, &QDoubleSpinBox::valueChanged, this, &PointFields::editPoint);
    connect(color_, &QPushButton::clicked, this, &PointFields::pickColor);
    connect(add_, &QPushButton::clicked, plot_, &TransferPlot::addPointBeside);
    connect(remove_, &QPushButton::clicked, plot_, &TransferPlot::removeSelected);
    connect(plot_, &TransferPlot::selectionChanged, this, &PointFields::refresh);
    if (colors) connect(plot_, &TransferPlot::colorRequested, this, &PointFields::pickColor);
    refresh();
}

void PointFields::setLimits(ValueRange limits, const QString& unit) {
    const ValueSteps steps = ValueSteps::of(limits);
    const QSignalBlocker quiet(value_);
    value_->setDecimals(steps.decimals);
    value_->setSingleStep(steps.step);
    limits_ = limits;
    value_->setRange(limits.lo, limits.hi);
    value_->setSuffix(unit.isEmpty() ? QString() : QStringLiteral(" ") + unit);
    refresh();
}

void PointFields::refresh() {
    const auto& points = plot_->function().points;
    const int i = plot_->selected();
    const bool some = i >= 0 && i < int(points.size());
    value_->setEnabled(some);
    opacity_->setEnabled(some);
    color_->setEnabled(some);
    remove_->setEnabled(some && points.size() > 1);
    if (!some) return;
    const QSignalBlocker quiet_value(value_), quiet_opacity(opacity_);
    // A function made for other data may have points far beyond these: they are shown, and kept, where they are.
    const double value = points[std::size_t(i)].value;
    value_->setRange(std::min(limits_.lo, value), std::max(limits_.hi, value));
    value_->setValue(value);
    opacity_->setValue(points[std::size_t(i)].opacity);
    QPixmap swatch(16, 16);
    swatch.fill(to_qcolor(points[std::size_t(i)].color));
    color_->setIcon(swatch);
}

void PointFields::editPoint() {
    TransferFunction function = plot_->function();
    const std::size_t i = std::size_t(plot_->selected());
    if (i >= function.points.size()) return;
    const auto& points = function.points;
    double value = value_->value();
    if (i > 0) value = std::max(value, points[i - 1].value);
    if (i + 1 < points.size()) value = std::min(value, points[i + 1].value);
    // Fields show rounded numbers; one that was not touched keeps the exact one.
    const double unit = std::pow(10.0, -value_->decimals());
    if (std::abs(value - points[i].value) > 0.5 * unit) function.points[i].value = value;
    if (std::abs(opacity_->value() - points[i].opacity) > 0.0005) function.points[i].opacity = opacity_->value();
    for (std::size_t k = 2; k < points.size(); ++k)
        if (points[k - 2].value >= points[k].value) return refresh();  // a third at one value has no place
    if (function == plot_->function()) return refresh();  // it stands against its neighbour: so say the fields
    plot_->setFunction(function);
    refresh();
    Q_EMIT functionEdited(tr("Transfer function"), function);
}

void PointFields::pickColor() {
    const int point = plot_->selected();
    if (point < 0 || point >= int(plot_->function().points.size())) return;
    auto* dialog = new QColorDialog(to_qcolor(plot_->function().points[std::size_t(point)].color), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(tr("Colour of the point"));
    connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& color) {
        TransferFunction function = plot_->function();
        for (const int i : plot_->selection())
            if (i >= 0 && i < int(function.points.size())) function.points[std::size_t(i)].color = from_qcolor(color);
        plot_->setFunction(function);
        refresh();
        Q_EMIT functionEdited(tr("Colour of a point"), function);
    });
    dialog->open();
}

}  // namespace lacuna::ui
