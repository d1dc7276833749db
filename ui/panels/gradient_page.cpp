#include "ui/panels/gradient_page.h"

#include <QSignalBlocker>
#include <QVBoxLayout>

namespace lacuna::ui {

namespace {

/// The curve as a function the plot can draw and edit.
TransferFunction drawn_of(const std::vector<GradientOpacityPoint>& curve) {
    TransferFunction drawn;
    for (const GradientOpacityPoint& p : curve) drawn.points.push_back({p.magnitude, glm::dvec3(1), p.opacity});
    return drawn;
}

}  // namespace

GradientPage::GradientPage(QWidget* parent)
    : QWidget(parent),
      use_(new QCheckBox(tr("O&pacity by gradient"), this)),
      plot_(new TransferPlot(this)),
      fields_(new PointFields(plot_, false, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(use_);
    column->addWidget(plot_, 1);
    column->addWidget(fields_);
    use_->setToolTip(
        tr("Multiplies the opacity by a factor that depends on how fast the values change: surfaces stand "
           "out, even regions fade."));
    plot_->setColorless(true);
    plot_->setAccessibleName(tr("Gradient opacity"));
    plot_->setToolTip(
        tr("Factor on the opacity by gradient magnitude · drag points · double click adds one · Delete "
           "removes it · wheel zooms the axis"));
    connect(use_, &QCheckBox::toggled, this, [this](bool on) {
        std::vector<GradientOpacityPoint> curve;
        if (on) curve = last_.empty() ? std::vector<GradientOpacityPoint>{{0, 0}, {0.3 * steepest_, 1}} : last_;
        Q_EMIT curveEdited(on ? tr("Opacity by gradient") : tr("No opacity by gradient"), curve);
        Q_EMIT gestureEnded();
    });
    connect(plot_, &TransferPlot::functionEdited, this, &GradientPage::edit);
    connect(plot_, &TransferPlot::gestureEnded, this, &GradientPage::gestureEnded);
    connect(fields_, &PointFields::functionEdited, this,
            [this](const QString&, const TransferFunction& drawn) { edit(drawn); });
    setFunction({});
}

QList<QWidget*> GradientPage::tabChain() const { return QList<QWidget*>{use_, plot_} + fields_->tabChain(); }

void GradientPage::setSteepest(double magnitude) {
    steepest_ = magnitude > 0 ? magnitude : 1;
    plot_->setHistogram({}, {0, steepest_});
    fields_->setLimits({0, 10 * steepest_}, QString());
    last_.clear();
}

void GradientPage::setJoint(std::shared_ptr<const JointHistogram> joint) {
    std::vector<std::uint64_t> rows(std::size_t(joint->bins.y), 0);
    for (std::size_t i = 0; i < joint->counts.size(); ++i) rows[i / std::size_t(joint->bins.x)] += joint->counts[i];
    steepest_ = joint->magnitudes.hi;
    plot_->setHistogram(rows, joint->magnitudes);
    fields_->setLimits({0, 10 * steepest_}, QString());
}

void GradientPage::setFunction(const TransferFunction& function) {
    const bool on = !function.gradient_opacity.empty();
    if (on) last_ = function.gradient_opacity;
    const QSignalBlocker quiet(use_);
    use_->setChecked(on);
    plot_->setEnabled(on);
    fields_->setEnabled(on);
    plot_->setFunction(drawn_of(function.gradient_opacity));
    fields_->refresh();
}

void GradientPage::edit(const TransferFunction& drawn) {
    std::vector<GradientOpacityPoint> curve;
    for (const TransferPoint& p : drawn.points) curve.push_back({std::max(0.0, p.value), p.opacity});
    fields_->refresh();
    Q_EMIT curveEdited(tr("Gradient opacity"), curve);
}

}  // namespace lacuna::ui
