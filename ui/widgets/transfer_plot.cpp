#include "ui/widgets/transfer_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/classify/histogram_landmarks.h"

namespace lacuna::ui {

namespace {
constexpr double k_margin = 10, k_foot = 26, k_pick_px = 10, k_snap_px = 6;
}

TransferPlot::TransferPlot(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Transfer function"));
    setAccessibleDescription(
        tr("Arrow keys move the selected points, Page Up and Page Down select another, Control A all, Insert adds one, "
           "Delete removes them, Enter chooses the colour."));
    setToolTip(
        tr("Drag points · drag a box to select several · double click adds one · Delete removes it · right click "
           "chooses its colour · wheel zooms the value axis · points snap to peaks and valleys, not with Alt"));
}

void TransferPlot::setHistogram(const std::vector<std::uint64_t>& counts, ValueRange range) {
    counts_ = counts;
    landmarks_ = histogram_landmarks(counts, range);
    const ValueRange next = range.width() > 0 ? range : ValueRange{range.lo - 0.5, range.lo + 0.5};
    const bool same = next == range_;
    range_ = next;
    same ? update() : showAll();
}

void TransferPlot::setLogarithmic(bool on) {
    logarithmic_ = on;
    update();
}

void TransferPlot::setColorless(bool on) {
    colorless_ = on;
    update();
}

void TransferPlot::setFunction(const TransferFunction& function) {
    if (function == function_) return;
    function_ = function;
    const int count = int(function_.points.size());
    std::erase_if(selection_, [&](int point) { return point >= count; });
    if (!selection_.contains(selected_)) select(std::clamp(selected_, 0, std::max(0, count - 1)));
    update();
}

void TransferPlot::select(int point) { setSelection({point}); }

void TransferPlot::setSelection(std::set<int> points) {
    const int primary = points.contains(selected_) ? selected_ : points.empty() ? -1 : *points.begin();
    if (primary == selected_ && points == selection_) return;
    selection_ = std::move(points);
    selected_ = primary;
    update();
    Q_EMIT selectionChanged(selected_);
}

void TransferPlot::showAll() {
    shown_ = range_;
    update();
}

QRectF TransferPlot::plotRect() const { return QRectF(rect()).adjusted(k_margin, k_margin, -k_margin, -k_foot); }
double TransferPlot::valueAt(double x) const {
    return shown_.lo + (x - plotRect().left()) / plotRect().width() * shown_.width();
}
double TransferPlot::xOf(double value) const {
    return plotRect().left() + (value - shown_.lo) / shown_.width() * plotRect().width();
}
double TransferPlot::opacityAt(double y) const {
    return std::clamp((plotRect().bottom() - y) / plotRect().height(), 0.0, 1.0);
}
double TransferPlot::yOf(double opacity) const { return plotRect().bottom() - opacity * plotRect().height(); }

QPointF TransferPlot::pointPosition(int point) const {
    const TransferPoint& p = function_.points[std::size_t(point)];
    return {xOf(p.value), yOf(p.opacity)};
}

int TransferPlot::pointAt(const QPointF& position) const {
    int nearest = -1;
    double nearest_px = k_pick_px;
    for (int i = 0; i < int(function_.points.size()); ++i) {
        const QPointF to = pointPosition(i) - position;
        const double px = std::hypot(to.x(), to.y());
        if (px < nearest_px) nearest_px = px, nearest = i;
    }
    return nearest;
}

void TransferPlot::moveSelection(const TransferFunction& from, double value, double opacity) {
    TransferFunction moved = from;
    const auto count = int(from.points.size());
    double left = -1e300, right = 1e300, down = -1, up = 1;  // how far all can go
    for (const int i : selection_) {
        if (i < 0 || i >= count) return;
        const TransferPoint& p = from.points[std::size_t(i)];
        // A preset's outer points may lie beyond the data; they are not pulled in by an edit of their opacity.
        if (!selection_.contains(i - 1))
            left = std::max(left,
                            (i > 0 ? from.points[std::size_t(i) - 1].value : std::min(range_.lo, p.value)) - p.value);
        if (!selection_.contains(i + 1))
            right =
                std::min(right, (i + 1 < count ? from.points[std::size_t(i) + 1].value : std::max(range_.hi, p.value)) -
                                    p.value);
        down = std::max(down, -p.opacity);
        up = std::min(up, 1 - p.opacity);
    }
    value = std::clamp(value, std::min(left, 0.0), std::max(right, 0.0));
    opacity = std::clamp(opacity, down, up);
    for (const int i : selection_) {
        TransferPoint& p = moved.points[std::size_t(i)];
        p.value += value;
        p.opacity = std::clamp(p.opacity + opacity, 0.0, 1.0);
    }
    // Two points may meet in a jump, a third has no place there.
    for (std::size_t i = 2; i < moved.points.size(); ++i)
        if (moved.points[i - 2].value >= moved.points[i].value) return;
    if (moved == function_) return;
    function_ = moved;
    update();
    Q_EMIT functionEdited(function_);
}

double TransferPlot::snappedValue(double value) const {
    const double reach = k_snap_px / plotRect().width() * shown_.width();
    double nearest = value, least = reach;
    const auto offer = [&](double to) {
        if (std::abs(to - value) < least) least = std::abs(to - value), nearest = to;
    };
    for (const double landmark : landmarks_) offer(landmark);
    for (int i = 0; i < int(function_.points.size()); ++i)
        if (!selection_.contains(i)) offer(function_.points[std::size_t(i)].value);
    return nearest;
}

void TransferPlot::dragTo(const QPointF& position, bool snap) {
    const TransferPoint& held = grab_->function.points[std::size_t(selected_)];
    double value = held.value + valueAt(position.x()) - valueAt(grab_->from.x());
    double opacity = held.opacity + (grab_->from.y() - position.y()) / plotRect().height();
    snapped_to_.reset();
    if (snap) {
        const double to = snappedValue(value);
        if (to != value) snapped_to_ = value = to;
        const double reach = k_snap_px / plotRect().height();
        for (const double level : {0.0, 1.0})
            if (std::abs(opacity - level) < reach) opacity = level;
    }
    moveSelection(grab_->function, value - held.value, opacity - held.opacity);
}

void TransferPlot::addPoint(double value, double opacity) {
    auto& points = function_.points;
    if (std::count_if(points.begin(), points.end(), [&](const TransferPoint& p) { return p.value == value; }) > 1)
        return;
    const auto next = std::upper_bound(points.begin(), points.end(), value,
                                       [](double v, const TransferPoint& p) { return v < p.value; });
    const glm::dvec3 color = colorless_ || points.empty() ? glm::dvec3(1) : function_.at(value).color;
    const auto added = points.insert(next, {value, color, opacity});
    selected_ = int(added - points.begin());
    selection_ = {selected_};
    update();
    Q_EMIT selectionChanged(selected_);
    Q_EMIT functionEdited(function_);
}

void TransferPlot::addPointBeside() {
    const auto& points = function_.points;
    const std::size_t i = std::size_t(std::max(0, selected_));
    const double from = i < points.size() ? points[i].value : range_.lo;
    const double to = i + 1 < points.size() ? points[i + 1].value : std::max(from, range_.hi);
    const double value = 0.5 * (from + to);
    const double next = i + 1 < points.size() ? points[i + 1].opacity : i < points.size() ? points[i].opacity : 1.0;
    addPoint(value, i < points.size() ? 0.5 * (points[i].opacity + next) : next);
    Q_EMIT gestureEnded();
}

void TransferPlot::removeSelected() {
    const auto count = int(function_.points.size());
    std::vector<TransferPoint> kept;
    for (int i = 0; i < count; ++i)
        if (!selection_.contains(i)) kept.push_back(function_.points[std::size_t(i)]);
    if (kept.empty() && count > 1) kept.push_back(function_.points.front());  // one point at least
    if (kept.empty() || int(kept.size()) == count) return;
    function_.points = std::move(kept);
    selected_ = std::clamp(selected_, 0, int(function_.points.size()) - 1);
    selection_ = {selected_};
    update();
    Q_EMIT selectionChanged(selected_);
    Q_EMIT functionEdited(function_);
    Q_EMIT gestureEnded();
}

void TransferPlot::mousePressEvent(QMouseEvent* event) {
    const int point = pointAt(event->position());
    const bool adding = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
    if (point < 0) {
        if (event->button() != Qt::LeftButton) return;
        before_box_ = adding ? selection_ : std::set<int>{};
        box_ = QRectF(event->position(), QSizeF(0, 0));
        return;
    }
    if (adding && event->button() == Qt::LeftButton) {
        std::set<int> next = selection_;
        if (!next.erase(point)) next.insert(point);
        return setSelection(std::move(next));
    }
    if (!selection_.contains(point)) select(point);
    if (selected_ != point) {
        selected_ = point;  // of several, the one that is held tells where all snap
        Q_EMIT selectionChanged(point);
        update();
    }
    if (event->button() == Qt::LeftButton) grab_ = Grab{event->position(), function_};
    if (event->button() == Qt::RightButton) Q_EMIT colorRequested(point);
}

void TransferPlot::mouseMoveEvent(QMouseEvent* event) {
    if (grab_ && selected_ >= 0 && selected_ < int(grab_->function.points.size()))
        return dragTo(event->position(), !(event->modifiers() & Qt::AltModifier));
    if (!box_) return;
    box_->setBottomRight(event->position());
    std::set<int> inside = before_box_;
    for (int i = 0; i < int(function_.points.size()); ++i)
        if (box_->normalized().contains(pointPosition(i))) inside.insert(i);
    setSelection(std::move(inside));
    update();
}

void TransferPlot::mouseReleaseEvent(QMouseEvent*) {
    if (box_ && selection_.empty() && !function_.points.empty()) {
        // A click beside the points leaves one selected, for the fields below to show.
        setSelection({0});
    }
    box_.reset();
    if (grab_) endGesture();
    update();
}

void TransferPlot::endGesture() {
    const bool edited = grab_ && grab_->function != function_;
    grab_.reset();
    snapped_to_.reset();
    update();
    if (edited) Q_EMIT gestureEnded();
}

void TransferPlot::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || pointAt(event->position()) >= 0) return;
    box_.reset();
    TransferFunction before = function_;
    addPoint(std::clamp(valueAt(event->position().x()), range_.lo, range_.hi), opacityAt(event->position().y()));
    // Still held, it can be dragged; both are one step.
    if (function_ != before) grab_ = Grab{event->position(), function_};
    Q_EMIT gestureEnded();
}

void TransferPlot::wheelEvent(QWheelEvent* event) {
    const double factor = std::exp(-event->angleDelta().y() / 500.0);
    const double width = std::clamp(shown_.width() * factor, range_.width() * 0.005, range_.width());
    const double share = std::clamp((event->position().x() - plotRect().left()) / plotRect().width(), 0.0, 1.0);
    const double lo = valueAt(event->position().x()) - share * width;
    shown_.lo = std::clamp(lo, range_.lo, range_.hi - width);
    shown_.hi = shown_.lo + width;
    update();
    event->accept();
}

void TransferPlot::keyPressEvent(QKeyEvent* event) {
    const int count = int(function_.points.size());
    if (count == 0 || selected_ < 0 || selected_ >= count) return QWidget::keyPressEvent(event);
    if (event->matches(QKeySequence::SelectAll)) {
        std::set<int> all;
        for (int i = 0; i < count; ++i) all.insert(i);
        return setSelection(std::move(all));
    }
    const double step = shown_.width() / 100, rise = 0.02;
    switch (event->key()) {
        case Qt::Key_Left:
            return moveSelection(function_, -step, 0);
        case Qt::Key_Right:
            return moveSelection(function_, step, 0);
        case Qt::Key_Up:
            return moveSelection(function_, 0, rise);
        case Qt::Key_Down:
            return moveSelection(function_, 0, -rise);
        case Qt::Key_PageUp:
            return select((selected_ + 1) % count);
        case Qt::Key_PageDown:
            return select((selected_ + count - 1) % count);
        case Qt::Key_Insert:
            return addPointBeside();
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return removeSelected();
        case Qt::Key_Home:
            return showAll();
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            Q_EMIT colorRequested(selected_);
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void TransferPlot::focusInEvent(QFocusEvent*) { update(); }
void TransferPlot::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace lacuna::ui
