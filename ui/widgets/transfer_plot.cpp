#include "ui/widgets/transfer_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/classify/histogram_landmarks.h"
#include "ui/number_text.h"
#include "ui/theme.h"
#include "ui/widgets/histogram_shape.h"

namespace lacuna::ui {

namespace {
constexpr double k_margin = 10, k_foot = 26, k_pick_px = 10, k_snap_px = 6;
}

QColor to_qcolor(const glm::dvec3& color) {
    const auto part = [](double c) { return float(std::clamp(c, 0.0, 1.0)); };
    return QColor::fromRgbF(part(color.r), part(color.g), part(color.b));
}

glm::dvec3 from_qcolor(const QColor& color) { return {color.redF(), color.greenF(), color.blueF()}; }

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

void TransferPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme::colors().base);
    painter.save();
    painter.setClipRect(plotRect().adjusted(-6, -6, 6, 14));
    painter.fillPath(histogram_shape(counts_, range_, shown_, logarithmic_, plotRect()), theme::colors().plot_fill);
    if (!function_.points.empty()) paintFunction(painter);
    if (snapped_to_) {
        painter.setPen(QPen(theme::colors().accent, 1, Qt::DashLine));
        painter.drawLine(QPointF(xOf(*snapped_to_), plotRect().top()), QPointF(xOf(*snapped_to_), plotRect().bottom()));
    }
    paintPoints(painter);
    if (box_) {
        painter.setPen(QPen(theme::colors().accent, 1));
        QColor fill = theme::colors().accent;
        fill.setAlpha(40);
        painter.setBrush(fill);
        painter.drawRect(box_->normalized());
    }
    painter.restore();
    paintFoot(painter);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(hasFocus() ? theme::colors().accent : theme::colors().border, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void TransferPlot::paintFoot(QPainter& painter) const {
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.85);
    painter.setFont(small);
    painter.setPen(theme::colors().dim);
    const QRectF foot(plotRect().left(), plotRect().bottom() + 9, plotRect().width(), k_foot - 9);
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, number_text(shown_.lo, 'g', 5));
    painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, number_text(shown_.hi, 'g', 5));
    painter.setPen(theme::colors().text);
    if (selection_.size() > 1) {
        painter.drawText(foot, Qt::AlignCenter, tr("%n points selected", nullptr, int(selection_.size())));
    } else if (selected_ >= 0 && selected_ < int(function_.points.size())) {
        const TransferPoint& p = function_.points[std::size_t(selected_)];
        painter.drawText(foot, Qt::AlignCenter,
                         tr("%1 → %2").arg(number_text(p.value, 'g', 5), number_text(p.opacity, 'f', 3)));
    }
}

void TransferPlot::paintFunction(QPainter& painter) const {
    const QRectF plot = plotRect();
    TransferFunction by_points = function_;
    by_points.by_shapes = false;
    // The colours run along the foot, and under the curve as far as it is opaque.
    QLinearGradient colors(plot.left(), 0, plot.right(), 0);
    const int stops = 64;
    for (int i = 0; i <= stops; ++i) {
        const double share = double(i) / stops;
        colors.setColorAt(share, to_qcolor(by_points.at(shown_.lo + share * shown_.width()).color));
    }
    if (!colorless_) painter.fillRect(QRectF(plot.left(), plot.bottom() + 2, plot.width(), 5), colors);
    QPolygonF curve;
    curve << QPointF(plot.left() - 10, yOf(function_.points.front().opacity));
    for (int i = 0; i < int(function_.points.size()); ++i) curve << pointPosition(i);
    curve << QPointF(std::max(plot.right(), curve.back().x()) + 10, yOf(function_.points.back().opacity));
    curve.front().setX(std::min(curve.front().x(), curve.at(1).x() - 1));
    QPainterPath under;
    under.addPolygon(curve);
    under.lineTo(curve.back().x(), plot.bottom());
    under.lineTo(curve.front().x(), plot.bottom());
    under.closeSubpath();
    painter.setOpacity(0.45);
    painter.fillPath(under, colors);
    painter.setOpacity(1);
    painter.setPen(QPen(theme::colors().plot_line, 1.4));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(curve);
}

void TransferPlot::paintPoints(QPainter& painter) const {
    for (int i = 0; i < int(function_.points.size()); ++i) {
        const bool chosen = selection_.contains(i);
        painter.setBrush(to_qcolor(function_.points[std::size_t(i)].color));
        painter.setPen(QPen(chosen ? theme::colors().accent : theme::colors().plot_line, chosen ? 2.5 : 1.2));
        painter.drawEllipse(pointPosition(i), chosen ? 6 : 5, chosen ? 6 : 5);
    }
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
