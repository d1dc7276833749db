#pragma once

#include <QCheckBox>
#include <QWidget>
#include <memory>

#include "core/classify/part_histogram.h"
#include "ui/widgets/point_fields.h"
#include "ui/widgets/transfer_plot.h"

namespace lacuna::ui {

/// Edits the gradient-opacity curve of a transfer function, over the histogram of gradient magnitudes.
class GradientPage final : public QWidget {
    Q_OBJECT
public:
    explicit GradientPage(QWidget* parent = nullptr);
    /// Until the gradients are counted: up to the steepest there could be, in units per mm.
    void setSteepest(double magnitude);
    void setJoint(std::shared_ptr<const lacuna::JointHistogram> joint);
    void setLogarithmic(bool on) { plot_->setLogarithmic(on); }
    void setFunction(const lacuna::TransferFunction& function);
    TransferPlot* plot() const { return plot_; }
    QCheckBox* use() const { return use_; }
    QList<QWidget*> tabChain() const;

Q_SIGNALS:
    void curveEdited(const QString& name, const std::vector<lacuna::GradientOpacityPoint>& curve);
    void gestureEnded();

private:
    void edit(const TransferFunction& drawn);

    QCheckBox* use_;
    TransferPlot* plot_;
    PointFields* fields_;
    double steepest_ = 1;
    std::vector<GradientOpacityPoint> last_;  ///< what was last in use, for switching it on again
};

}  // namespace lacuna::ui
