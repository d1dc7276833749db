#pragma once

#include <QColor>
#include <QWidget>

#include "core/volume/volume.h"

namespace lacuna::ui {

/// A slider with two handles for a closed range of values. Drag a handle, or the bar between them to move both. Keys:
/// Tab goes from handle to handle and on, arrows move the handle by a step, Page Up/Down by ten, Home and End to the
/// limits.
class RangeSlider final : public QWidget {
    Q_OBJECT
public:
    explicit RangeSlider(QWidget* parent = nullptr);

    void setLimits(lacuna::ValueRange limits);
    /// From the program: emits nothing. Values are kept inside the limits.
    void setRange(lacuna::ValueRange range);
    /// The smallest movement by key; also what dragged values are rounded to.
    void setStep(double step) { step_ = step; }
    /// The bar between the handles; an invalid colour is the theme's.
    void setColor(const QColor& color);
    lacuna::ValueRange range() const { return range_; }
    lacuna::ValueRange limits() const { return limits_; }
    /// Middle of a handle in widget coordinates (0: low, 1: high).
    QPointF handlePosition(int handle) const;
    QSize sizeHint() const override { return {160, 24}; }
    QSize minimumSizeHint() const override { return {80, 22}; }

Q_SIGNALS:
    void rangeEdited(lacuna::ValueRange range);  ///< from a person, while moving

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    bool focusNextPrevChild(bool next) override;

private:
    enum Part { k_none = -1, k_low = 0, k_high = 1, k_bar = 2 };
    double valueAt(double x) const;
    void moveHandle(Part part, double value);
    void emitRange(lacuna::ValueRange range);
    void describe();

    ValueRange limits_{0, 1}, range_{0, 1};
    double step_ = 0.01;
    QColor color_;
    Part active_ = k_low, dragged_ = k_none;
    double grab_ = 0;  ///< value between the mouse and the low handle while the bar is dragged
};

}  // namespace lacuna::ui
