#pragma once

#include <QWidget>
#include <vector>

#include "core/classify/transfer_function.h"

namespace lacuna::ui {

/// The picture of a transfer function over the volume's histogram (log scale), with points to drag. Double click adds
/// a point, Delete removes the selected one, right click or Enter asks for its colour, the wheel zooms the value axis.
/// Keys: arrows move the selected point, Page Up/Down select the next, Insert adds one beside it, Home shows all.
class TransferPlot final : public QWidget {
    Q_OBJECT
public:
    explicit TransferPlot(QWidget* parent = nullptr);

    void setHistogram(const std::vector<std::uint64_t>& counts, lacuna::ValueRange range);
    void setFunction(const lacuna::TransferFunction& function);  ///< emits nothing
    const lacuna::TransferFunction& function() const { return function_; }
    int selected() const { return selected_; }
    void select(int point);
    /// Where a point is drawn, in widget coordinates.
    QPointF pointPosition(int point) const;
    QSize sizeHint() const override { return {280, 170}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

public Q_SLOTS:
    void addPointBeside();
    void removeSelected();
    void showAll();

Q_SIGNALS:
    void functionEdited(const lacuna::TransferFunction& function);
    void selectionChanged(int point);
    void colorRequested(int point);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;

private:
    QRectF plotRect() const;
    double valueAt(double x) const;
    double xOf(double value) const;
    double opacityAt(double y) const;
    double yOf(double opacity) const;
    int pointAt(const QPointF& position) const;
    void movePoint(int point, double value, double opacity);
    void addPoint(double value, double opacity);
    void paintHistogram(QPainter& painter) const;
    void paintFunction(QPainter& painter) const;

    std::vector<std::uint64_t> counts_;
    ValueRange range_{0, 255}, shown_{0, 255};
    TransferFunction function_;
    int selected_ = 0;
    bool dragging_ = false;
};

/// sRGB 0..1 and back.
QColor to_qcolor(const glm::dvec3& color);
glm::dvec3 from_qcolor(const QColor& color);

}  // namespace lacuna::ui
