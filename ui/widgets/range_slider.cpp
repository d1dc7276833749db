#include "ui/widgets/range_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/number_text.h"
#include "ui/theme.h"

namespace lacuna::ui {

namespace {
constexpr double k_margin = 9;
}

RangeSlider::RangeSlider(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Value range"));
    describe();
}

void RangeSlider::setLimits(ValueRange limits) {
    limits_ = limits.width() > 0 ? limits : ValueRange{limits.lo, limits.lo + 1};
    setRange(range_);
}

void RangeSlider::setRange(ValueRange range) {
    range_.lo = std::clamp(range.lo, limits_.lo, limits_.hi);
    range_.hi = std::clamp(range.hi, range_.lo, limits_.hi);
    describe();
    update();
}

void RangeSlider::setColor(const QColor& color) {
    color_ = color;
    update();
}

void RangeSlider::describe() {
    setAccessibleDescription(tr("From %1 to %2; arrow keys move the %3 end")
                                 .arg(number_text(range_.lo))
                                 .arg(number_text(range_.hi))
                                 .arg(active_ == k_high ? tr("upper") : tr("lower")));
}

QPointF RangeSlider::handlePosition(int handle) const {
    const double value = handle == k_low ? range_.lo : range_.hi;
    const double span = std::max(1.0, width() - 2 * k_margin);
    return {k_margin + (value - limits_.lo) / limits_.width() * span, 0.5 * height()};
}

double RangeSlider::valueAt(double x) const {
    const double span = std::max(1.0, width() - 2 * k_margin);
    return limits_.lo + (x - k_margin) / span * limits_.width();
}

void RangeSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double y = 0.5 * height();
    const QPointF low = handlePosition(k_low), high = handlePosition(k_high);
    const ThemeColors& c = theme::colors();
    painter.setPen(QPen(isEnabled() ? c.control : c.disabled, 1));
    painter.setBrush(c.base);
    painter.drawRoundedRect(QRectF(k_margin, y - 3, width() - 2 * k_margin, 6), 3, 3);
    painter.setPen(Qt::NoPen);
    painter.setBrush(!isEnabled() ? c.border : color_.isValid() ? color_ : c.highlight);
    painter.drawRoundedRect(QRectF(low.x(), y - 3, std::max(1.0, high.x() - low.x()), 6), 3, 3);
    for (const Part part : {k_low, k_high}) {
        const QPointF at = handlePosition(part);
        const bool focused = hasFocus() && active_ == part;
        painter.setPen(QPen(focused ? c.accent : isEnabled() ? c.control : c.disabled, focused ? 2 : 1));
        painter.setBrush(!isEnabled() ? c.border : theme::scheme() == Scheme::light ? c.base : c.plot_line);
        painter.drawRoundedRect(QRectF(at.x() - 5, at.y() - 8, 10, 16), 3, 3);
    }
}

void RangeSlider::emitRange(ValueRange range) {
    if (range == range_) return;
    setRange(range);
    Q_EMIT rangeEdited(range_);
}

void RangeSlider::moveHandle(Part part, double value) {
    const double rounded = limits_.lo + std::round((value - limits_.lo) / step_) * step_;
    ValueRange range = range_;
    if (part == k_bar) {
        const double width = range_.width();
        range.lo = std::clamp(rounded, limits_.lo, limits_.hi - width);
        range.hi = range.lo + width;
    } else if (part == k_low) {
        range.lo = std::clamp(rounded, limits_.lo, range_.hi);
    } else {
        range.hi = std::clamp(rounded, range_.lo, limits_.hi);
    }
    emitRange(range);
}

void RangeSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const double x = event->position().x();
    const double to_low = std::abs(x - handlePosition(k_low).x()), to_high = std::abs(x - handlePosition(k_high).x());
    const bool between = x > handlePosition(k_low).x() + 8 && x < handlePosition(k_high).x() - 8;
    if (between) {
        dragged_ = k_bar;
        grab_ = valueAt(x) - range_.lo;
    } else {
        // Where both handles lie on one another, the one that can move towards the mouse is meant.
        dragged_ = to_low < to_high || (to_low == to_high && x < handlePosition(k_low).x()) ? k_low : k_high;
        active_ = dragged_;
        if (std::min(to_low, to_high) > 8) moveHandle(dragged_, valueAt(x));
    }
    describe();
    update();
}

void RangeSlider::mouseMoveEvent(QMouseEvent* event) {
    if (dragged_ == k_none) return;
    const double value = valueAt(event->position().x());
    moveHandle(dragged_, dragged_ == k_bar ? value - grab_ : value);
}

void RangeSlider::mouseReleaseEvent(QMouseEvent*) { dragged_ = k_none; }

void RangeSlider::keyPressEvent(QKeyEvent* event) {
    const double value = active_ == k_high ? range_.hi : range_.lo;
    switch (event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Down:
            return moveHandle(active_, value - step_);
        case Qt::Key_Right:
        case Qt::Key_Up:
            return moveHandle(active_, value + step_);
        case Qt::Key_PageDown:
            return moveHandle(active_, value - 10 * step_);
        case Qt::Key_PageUp:
            return moveHandle(active_, value + 10 * step_);
        case Qt::Key_Home:
            return moveHandle(active_, limits_.lo);
        case Qt::Key_End:
            return moveHandle(active_, limits_.hi);
        default:
            QWidget::keyPressEvent(event);
    }
}

bool RangeSlider::focusNextPrevChild(bool next) {
    const Part wanted = next ? k_high : k_low;
    if (hasFocus() && active_ != wanted) {
        active_ = wanted;
        describe();
        update();
        return true;
    }
    return QWidget::focusNextPrevChild(next);
}

void RangeSlider::focusInEvent(QFocusEvent* event) {
    if (event->reason() == Qt::TabFocusReason) active_ = k_low;
    if (event->reason() == Qt::BacktabFocusReason) active_ = k_high;
    describe();
    update();
}

void RangeSlider::focusOutEvent(QFocusEvent*) { update(); }

}  // namespace lacuna::ui
