#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/classify/part_histogram.h"
#include "core/classify/transfer_function.h"

namespace lacuna::ui {

/// The plane of values (to the right) and gradient magnitudes (up) with how often they occur together, and shapes on
/// it. A drag from empty space draws a rectangle; a shape is dragged by its inside, and formed by its corners: those of
/// a rectangle keep it one, those of a trapezoid move alone. Right click or Enter asks for a colour. Keys: arrows move
/// the selected shape, with Shift they move its upper right corner; Page Up/Down select the next, Insert adds one,
/// Delete removes it.
class ShapePlot final : public QWidget {
    Q_OBJECT
public:
    explicit ShapePlot(QWidget* parent = nullptr);

    /// What the plane spans while nothing is counted.
    void setSpan(lacuna::ValueRange values, double steepest);
    void setJoint(std::shared_ptr<const lacuna::JointHistogram> joint);
    void setLogarithmic(bool on);
    void setShapes(const std::vector<lacuna::TransferShape>& shapes);  ///< emits nothing
    const std::vector<lacuna::TransferShape>& shapes() const { return shapes_; }
    int selected() const { return selected_; }
    void select(int shape);
    /// Where a value and a magnitude lie, in widget coordinates.
    QPointF positionOf(double value, double magnitude) const;
    /// Corners of a shape: lower left, lower right, upper right, upper left.
    std::array<QPointF, 4> corners(const lacuna::TransferShape& shape) const;
    QSize sizeHint() const override { return {280, 190}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

public Q_SLOTS:
    void addShape();
    void removeSelected();

Q_SIGNALS:
    void shapesEdited(const std::vector<lacuna::TransferShape>& shapes);
    void selectionChanged(int shape);
    void colorRequested(int shape);
    void gestureEnded();

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent*) override { update(); }
    void focusOutEvent(QFocusEvent*) override { update(); }

private:
    QRectF plotRect() const;
    double valueAt(double x) const;
    double magnitudeAt(double y) const;
    int shapeAt(const QPointF& position) const;
    int cornerAt(const QPointF& position) const;
    void makePicture();
    void insert(const TransferShape& shape);
    void put(const TransferShape& shape);
    TransferShape moved(const TransferShape& shape, double value, double magnitude) const;
    TransferShape formed(const TransferShape& shape, int corner, double value, double magnitude) const;
    void paintShape(QPainter& painter, const TransferShape& shape, bool chosen) const;
    void paintAxes(QPainter& painter) const;

    std::shared_ptr<const JointHistogram> joint_;
    QImage picture_;
    ValueRange values_{0, 255};
    double steepest_ = 1;
    bool logarithmic_ = true;
    std::vector<TransferShape> shapes_;
    int selected_ = -1;

    struct Grab {
        QPointF from;
        TransferShape shape;
        int corner = -1;  ///< -1: the shape as a whole
    };
    std::optional<Grab> grab_;
    std::optional<QRectF> drawn_;  ///< a rectangle being drawn
};

}  // namespace lacuna::ui
