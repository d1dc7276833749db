#include "ui/widgets/shape_plot.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/number_text.h"
#include "ui/theme.h"
#include "ui/widgets/plot_paint.h"

namespace lacuna::ui {

namespace {

constexpr double k_margin = 10, k_foot = 26, k_pick_px = 9, k_least_px = 5;

}  // namespace

ShapePlot::ShapePlot(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Shapes of value and gradient"));
    setAccessibleDescription(tr(
        "Arrow keys move the selected shape, with Shift its upper right corner, Page Up and Page Down select another, "
        "Insert adds one, Delete removes it, Enter chooses its colour."));
    setToolTip(
        tr("Values to the right, gradient magnitudes up · drag on empty ground to draw a rectangle · drag a shape or "
           "its corners · Delete removes it · right click chooses its colour"));
}

void ShapePlot::setSpan(ValueRange values, double steepest) {
    joint_.reset();
    picture_ = {};
    values_ = values.width() > 0 ? values : ValueRange{values.lo - 0.5, values.lo + 0.5};
    steepest_ = steepest > 0 ? steepest : 1;
    update();
}

void ShapePlot::setJoint(std::shared_ptr<const JointHistogram> joint) {
    joint_ = std::move(joint);
    values_ = joint_->values;
    steepest_ = joint_->magnitudes.hi;
    makePicture();
}

void ShapePlot::setLogarithmic(bool on) {
    logarithmic_ = on;
    makePicture();
}

void ShapePlot::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) makePicture();  // its colours are the theme's
    QWidget::changeEvent(event);
}

void ShapePlot::makePicture() {
    update();
    if (!joint_) return;
    const auto height = [&](std::uint64_t n) { return logarithmic_ ? std::log1p(double(n)) : double(n); };
    double most = 1e-9;
    for (const std::uint64_t n : joint_->counts) most = std::max(most, height(n));
    picture_ = QImage(joint_->bins.x, joint_->bins.y, QImage::Format_RGB32);
    const QColor ground = theme::colors().base, ink = theme::colors().text;
    for (int y = 0; y < joint_->bins.y; ++y)
        for (int x = 0; x < joint_->bins.x; ++x) {
            const std::uint64_t n = joint_->counts[std::size_t(y) * std::size_t(joint_->bins.x) + std::size_t(x)];
            const double f = n ? 0.12 + 0.88 * height(n) / most : 0;
            const auto mixed = [f](int a, int b) { return int(a + f * (b - a)); };
            picture_.setPixel(x, joint_->bins.y - 1 - y,
                              qRgb(mixed(ground.red(), ink.red()), mixed(ground.green(), ink.green()),
                                   mixed(ground.blue(), ink.blue())));
        }
}

void ShapePlot::setShapes(const std::vector<TransferShape>& shapes) {
    if (shapes == shapes_) return;
    shapes_ = shapes;
    const int last = int(shapes_.size()) - 1;
    if (selected_ > last || (selected_ < 0 && last >= 0)) select(last);
    update();
}

void ShapePlot::select(int shape) {
    if (shape == selected_) return;
    selected_ = shape;
    update();
    Q_EMIT selectionChanged(shape);
}

QRectF ShapePlot::plotRect() const { return QRectF(rect()).adjusted(k_margin, k_margin, -k_margin, -k_foot); }

QPointF ShapePlot::positionOf(double value, double magnitude) const {
    const QRectF plot = plotRect();
    return {plot.left() + (value - values_.lo) / values_.width() * plot.width(),
            plot.bottom() - magnitude / steepest_ * plot.height()};
}

double ShapePlot::valueAt(double x) const {
    return values_.lo + (x - plotRect().left()) / plotRect().width() * values_.width();
}

double ShapePlot::magnitudeAt(double y) const {
    return std::max(0.0, (plotRect().bottom() - y) / plotRect().height() * steepest_);
}

std::array<QPointF, 4> ShapePlot::corners(const TransferShape& s) const {
    return {positionOf(s.at_lo.lo, s.magnitude.lo), positionOf(s.at_lo.hi, s.magnitude.lo),
            positionOf(s.at_hi.hi, s.magnitude.hi), positionOf(s.at_hi.lo, s.magnitude.hi)};
}

int ShapePlot::shapeAt(const QPointF& position) const {
    const double value = valueAt(position.x()), magnitude = magnitudeAt(position.y());
    const auto covers = [&](TransferShape shape) {
        shape.opacity = 1;
        shape.softness = 0;
        return shape.opacity_at(value, magnitude) > 0;
    };
    if (selected_ >= 0 && covers(shapes_[std::size_t(selected_)])) return selected_;
    for (int i = int(shapes_.size()) - 1; i >= 0; --i)
        if (covers(shapes_[std::size_t(i)])) return i;
    return -1;
}

int ShapePlot::cornerAt(const QPointF& position) const {
    if (selected_ < 0) return -1;
    const std::array<QPointF, 4> at = corners(shapes_[std::size_t(selected_)]);
    for (int c = 3; c >= 0; --c)
        if (std::hypot(at[std::size_t(c)].x() - position.x(), at[std::size_t(c)].y() - position.y()) < k_pick_px)
            return c;
    return -1;
}

TransferShape ShapePlot::moved(const TransferShape& shape, double value, double magnitude) const {
    TransferShape next = shape;
    magnitude = std::max(magnitude, -shape.magnitude.lo);
    next.magnitude = {shape.magnitude.lo + magnitude, shape.magnitude.hi + magnitude};
    next.at_lo = {shape.at_lo.lo + value, shape.at_lo.hi + value};
    next.at_hi = {shape.at_hi.lo + value, shape.at_hi.hi + value};
    return next;
}

TransferShape ShapePlot::formed(const TransferShape& shape, int corner, double value, double magnitude) const {
    TransferShape next = shape;
    const double least = 1e-3 * steepest_;
    const bool left = corner == 0 || corner == 3, lower = corner < 2;
    if (lower)
        next.magnitude.lo = std::clamp(magnitude, 0.0, std::max(0.0, shape.magnitude.hi - least));
    else
        next.magnitude.hi = std::max(magnitude, shape.magnitude.lo + least);
    ValueRange& side = lower ? next.at_lo : next.at_hi;
    if (left)
        side.lo = std::min(value, side.hi);
    else
        side.hi = std::max(value, side.lo);
    if (shape.is_rectangle()) next.at_lo = next.at_hi = side;
    return next;
}

void ShapePlot::put(const TransferShape& shape) {
    if (shapes_[std::size_t(selected_)] == shape) return;
    shapes_[std::size_t(selected_)] = shape;
    update();
    Q_EMIT shapesEdited(shapes_);
}

void ShapePlot::insert(const TransferShape& shape) {
    if (shapes_.size() >= TransferFunction::k_max_shapes) return;
    shapes_.push_back(shape);
    select(int(shapes_.size()) - 1);
    Q_EMIT shapesEdited(shapes_);
    Q_EMIT gestureEnded();
}

void ShapePlot::addShape() {
    TransferShape shape;
    shape.magnitude = {0.25 * steepest_, 0.75 * steepest_};
    shape.at_lo = shape.at_hi = {values_.lo + 0.4 * values_.width(), values_.lo + 0.7 * values_.width()};
    shape.color = {0.95, 0.72, 0.45};
    shape.softness = 0.4;
    insert(shape);
}

void ShapePlot::removeSelected() {
    if (selected_ < 0) return;
    shapes_.erase(shapes_.begin() + selected_);
    selected_ = std::min(selected_, int(shapes_.size()) - 1);
    update();
    Q_EMIT selectionChanged(selected_);
    Q_EMIT shapesEdited(shapes_);
    Q_EMIT gestureEnded();
}

void ShapePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme::colors().base);
    painter.fillRect(plotRect(), theme::colors().base);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!picture_.isNull()) painter.drawImage(plotRect(), picture_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(plotRect().adjusted(-6, -6, 6, 6));
    for (int i = 0; i < int(shapes_.size()); ++i)
        if (i != selected_) paintShape(painter, shapes_[std::size_t(i)], false);
    if (selected_ >= 0) paintShape(painter, shapes_[std::size_t(selected_)], true);
    if (drawn_) {
        painter.setPen(QPen(theme::colors().accent, 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(drawn_->normalized());
    }
    painter.restore();
    paintAxes(painter);
}

void ShapePlot::paintShape(QPainter& painter, const TransferShape& shape, bool chosen) const {
    const std::array<QPointF, 4> at = corners(shape);
    QColor fill = to_qcolor(shape.color);
    fill.setAlphaF(float(0.15 + 0.6 * shape.opacity));
    painter.setBrush(fill);
    painter.setPen(QPen(chosen ? theme::colors().accent : theme::colors().text, chosen ? 2 : 1.2));
    painter.drawPolygon(at.data(), 4);
    if (!chosen) return;
    painter.setBrush(theme::colors().text);
    for (const QPointF& corner : at) painter.drawRect(QRectF(corner - QPointF(4, 4), QSizeF(8, 8)));
}

void ShapePlot::paintAxes(QPainter& painter) const {
    const QRectF foot(plotRect().left(), plotRect().bottom() + 4, plotRect().width(), k_foot - 6);
    paint_axis_ends(painter, *this, foot, values_);
    painter.drawText(foot, Qt::AlignCenter, tr("value →  ↑ gradient to %1 per mm").arg(number_text(steepest_, 'g', 5)));
    paint_frame(painter, *this);
}

void ShapePlot::mousePressEvent(QMouseEvent* event) {
    const int corner = event->button() == Qt::LeftButton ? cornerAt(event->position()) : -1;
    const int shape = corner >= 0 ? selected_ : shapeAt(event->position());
    if (shape < 0) {
        if (event->button() == Qt::LeftButton) drawn_ = QRectF(event->position(), QSizeF(0, 0));
        return;
    }
    select(shape);
    if (event->button() == Qt::LeftButton) grab_ = Grab{event->position(), shapes_[std::size_t(shape)], corner};
    if (event->button() == Qt::RightButton) Q_EMIT colorRequested(shape);
}

void ShapePlot::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (drawn_) {
        drawn_->setBottomRight(at);
        update();
    } else if (grab_ && selected_ >= 0 && selected_ < int(shapes_.size())) {
        if (grab_->corner >= 0) return put(formed(grab_->shape, grab_->corner, valueAt(at.x()), magnitudeAt(at.y())));
        const double rise = (grab_->from.y() - at.y()) / plotRect().height() * steepest_;
        put(moved(grab_->shape, valueAt(at.x()) - valueAt(grab_->from.x()), rise));
    }
}

void ShapePlot::mouseReleaseEvent(QMouseEvent*) {
    if (grab_) {
        const bool edited = selected_ >= 0 && shapes_[std::size_t(selected_)] != grab_->shape;
        grab_.reset();
        if (edited) Q_EMIT gestureEnded();
    }
    if (!drawn_) return;
    const QRectF box = drawn_->normalized();
    drawn_.reset();
    update();
    if (box.width() < k_least_px || box.height() < k_least_px) return;
    TransferShape shape;
    shape.magnitude = {magnitudeAt(box.bottom()), magnitudeAt(box.top())};
    shape.at_lo = shape.at_hi = {valueAt(box.left()), valueAt(box.right())};
    shape.color = {0.95, 0.72, 0.45};
    if (shape.magnitude.lo < shape.magnitude.hi) insert(shape);
}

void ShapePlot::keyPressEvent(QKeyEvent* event) {
    const int count = int(shapes_.size()), key = event->key();
    if (key == Qt::Key_Insert) return addShape();
    if (count == 0 || selected_ < 0) return QWidget::keyPressEvent(event);
    const double dv = key == Qt::Key_Left ? -1 : key == Qt::Key_Right ? 1 : 0;
    const double dm = key == Qt::Key_Down ? -1 : key == Qt::Key_Up ? 1 : 0;
    const TransferShape& shape = shapes_[std::size_t(selected_)];
    if (dv != 0 || dm != 0) {
        const double value = dv * values_.width() / 100, magnitude = dm * steepest_ / 100;
        if (event->modifiers() & Qt::ShiftModifier)
            put(formed(shape, 2, shape.at_hi.hi + value, shape.magnitude.hi + magnitude));
        else
            put(moved(shape, value, magnitude));
    } else if (key == Qt::Key_PageUp) {
        select((selected_ + 1) % count);
    } else if (key == Qt::Key_PageDown) {
        select((selected_ + count - 1) % count);
    } else if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
        removeSelected();
    } else if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space) {
        Q_EMIT colorRequested(selected_);
    } else {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace lacuna::ui
