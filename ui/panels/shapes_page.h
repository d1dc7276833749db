#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QWidget>

#include "ui/widgets/shape_plot.h"

namespace lacuna::ui {

/// Edits the shapes of a transfer function of value and gradient magnitude.
class ShapesPage final : public QWidget {
    Q_OBJECT
public:
    explicit ShapesPage(QWidget* parent = nullptr);
    void setSpan(lacuna::ValueRange values, double steepest) { plot_->setSpan(values, steepest); }
    void setJoint(std::shared_ptr<const lacuna::JointHistogram> joint) { plot_->setJoint(std::move(joint)); }
    void setLogarithmic(bool on) { plot_->setLogarithmic(on); }
    void setFunction(const lacuna::TransferFunction& function);
    ShapePlot* plot() const { return plot_; }
    QCheckBox* use() const { return use_; }
    QComboBox* kindBox() const { return kind_; }
    QDoubleSpinBox* opacityField() const { return opacity_; }
    QList<QWidget*> tabChain() const;

Q_SIGNALS:
    void shapesEdited(const QString& name, const std::vector<lacuna::TransferShape>& shapes, bool in_use);
    void gestureEnded();

private:
    void build();
    void showShape();
    /// Changes the selected shape.
    template <class Change>
    void change(const QString& name, Change&& apply);
    void pickColor();

    QCheckBox* use_;
    ShapePlot* plot_;
    QComboBox* kind_;
    QDoubleSpinBox *opacity_, *softness_;
    QPushButton *color_, *add_, *remove_;
};

}  // namespace lacuna::ui
