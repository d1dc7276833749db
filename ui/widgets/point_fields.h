#pragma once

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QWidget>

#include "ui/widgets/transfer_plot.h"

namespace lacuna::ui {

/// The numbers and the colour of a plot's selected point, and buttons that add and remove points. With several points
/// selected, the colour is that of all of them.
class PointFields final : public QWidget {
    Q_OBJECT
public:
    /// @param plot  whose points these are. @param colors  false: points have no colours of their own
    PointFields(TransferPlot* plot, bool colors, QWidget* parent = nullptr);
    /// The values a point can take, and what they are called.
    void setLimits(lacuna::ValueRange limits, const QString& unit);
    /// Shows the selected point anew.
    void refresh();
    QDoubleSpinBox* valueField() const { return value_; }
    QDoubleSpinBox* opacityField() const { return opacity_; }
    QList<QWidget*> tabChain() const { return {value_, opacity_, color_, add_, remove_}; }

Q_SIGNALS:
    void functionEdited(const QString& name, const lacuna::TransferFunction& function);

private:
    void editPoint();
    void pickColor();

    TransferPlot* plot_;
    ValueRange limits_{0, 100};
    QDoubleSpinBox *value_, *opacity_;
    QPushButton *color_, *add_, *remove_;
};

}  // namespace lacuna::ui
