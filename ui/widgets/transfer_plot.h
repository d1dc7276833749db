#pragma once

#include <QWidget>
#include <optional>
#include <set>
#include <vector>

#include "core/classify/transfer_function.h"

namespace lacuna::ui {

/// The picture of a transfer function over a histogram, with points to drag. Double click adds a point, Delete removes
/// the selected ones, right click or Enter asks for a colour, the wheel zooms the value axis. A drag from empty space
/// draws a box that selects the points in it (with Shift in addition); dragged points go together. They snap to the
/// histogram's peaks and valleys, to the values of other points, and to opacity 0 and 1; Alt switches that off.
/// Keys: arrows move the selected points, Page Up/Down select the next, Insert adds one beside it, Ctrl+A selects all,
/// Home shows the whole axis.
class TransferPlot final : public QWidget {
    Q_OBJECT
public:
    explicit TransferPlot(QWidget* parent = nullptr);

    /// What lies behind the curve; the part of the axis that is shown stays where the range does.
    void setHistogram(const std::vector<std::uint64_t>& counts, lacuna::ValueRange range);
    void setLogarithmic(bool on);
    /// Points have no colours of their own (a gradient-opacity curve): the curve alone is drawn.
    void setColorless(bool on);
    void setFunction(const lacuna::TransferFunction& function);  ///< emits nothing
    const lacuna::TransferFunction& function() const { return function_; }
    int selected() const { return selected_; }
    /// All selected points, `selected()` among them.
    const std::set<int>& selection() const { return selection_; }
    void select(int point);
    void setSelection(std::set<int> points);
    /// Where a point is drawn, in widget coordinates.
    QPointF pointPosition(int point) const;
    /// Values that dragged points snap to.
    const std::vector<double>& landmarks() const { return landmarks_; }
    double xOf(double value) const;
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
    void gestureEnded();  ///< what comes next is another step of undo

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
    double opacityAt(double y) const;
    double yOf(double opacity) const;
    int pointAt(const QPointF& position) const;
    void addPoint(double value, double opacity);
    /// Moves the selected points of `from` by as much of these differences as keeps the order and 0..1.
    void moveSelection(const TransferFunction& from, double value, double opacity);
    void dragTo(const QPointF& position, bool snap);
    double snappedValue(double value) const;
    void endGesture();
    void paintFunction(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;
    void paintFoot(QPainter& painter) const;

    std::vector<std::uint64_t> counts_;
    std::vector<double> landmarks_;
    ValueRange range_{0, 255}, shown_{0, 255};
    TransferFunction function_;
    int selected_ = 0;
    std::set<int> selection_{0};
    bool logarithmic_ = true, colorless_ = false;

    /// A drag of points: where it began and what the function was then.
    struct Grab {
        QPointF from;
        TransferFunction function;
    };
    std::optional<Grab> grab_;
    std::optional<QRectF> box_;         ///< while one is drawn; its first corner is where it began
    std::set<int> before_box_;          ///< selected when the box was begun with Shift
    std::optional<double> snapped_to_;  ///< drawn as a line while a point lies there
};

}  // namespace lacuna::ui
