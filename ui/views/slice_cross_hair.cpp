#include "ui/views/slice_cross_hair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/views/slice_view.h"

namespace lacuna::ui {

namespace {

constexpr double k_gap = 7, k_handle_radius = 4.5, k_reach = 9;
constexpr double k_key_step = std::numbers::pi / 180;

/// The line in which another family's plane cuts this view, as a direction in the widget.
struct Line {
    SliceKind kind;
    QPointF direction;
};

std::vector<Line> lines_of(const SliceView& view) {
    std::vector<Line> lines;
    const auto normals = slice_normals(view.volume().geometry(), view.settings().tilt);
    const glm::dvec3 normal = view.pose().frame.normal();
    for (const SliceKind kind : k_slice_kinds) {
        if (kind == view.kind()) continue;
        const glm::dvec3 along = glm::normalize(glm::cross(normal, normals[std::size_t(kind)]));
        lines.push_back({kind, view.directionInWidget(along)});
    }
    return lines;
}

double handle_distance(const SliceView& view) { return 0.38 * std::min(view.width(), view.height()); }

double angle_about(const SliceView& view, const QPointF& position) {
    const QPointF off = position - view.toWidget(view.cursorMm());
    return std::atan2(off.y(), off.x());
}

}  // namespace

std::vector<QPointF> SliceCrossHair::handles(const SliceView& view) {
    std::vector<QPointF> found;
    const QPointF at = view.toWidget(view.cursorMm());
    for (const Line& line : lines_of(view))
        for (const double side : {-1.0, 1.0}) {
            const QPointF handle = at + line.direction * (side * handle_distance(view));
            if (view.rect().adjusted(4, 4, -4, -4).contains(handle.toPoint())) found.push_back(handle);
        }
    return found;
}

void SliceCrossHair::turn(SliceView& view, double radians) {
    if (radians == 0) return;
    // Clockwise on the screen is positive about the normal, because it points into the screen.
    const glm::dquat step = glm::angleAxis(radians, view.pose().frame.normal());
    Q_EMIT view.tiltEdited(glm::normalize(step * view.settings().tilt));
}

bool SliceCrossHair::press(SliceView& view, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    const auto all = handles(view);
    const bool on_handle = std::any_of(all.begin(), all.end(), [&](const QPointF& handle) {
        return std::hypot(handle.x() - event.position().x(), handle.y() - event.position().y()) <= k_reach;
    });
    if (!on_handle && !(event.modifiers() & Qt::ShiftModifier)) return false;
    turning_ = &view;
    last_angle_ = angle_about(view, event.position());
    return true;
}

bool SliceCrossHair::move(SliceView& view, const QMouseEvent& event) {
    if (over_ != &view) {
        over_ = &view;
        view.update();
    }
    if (turning_ == &view && (event.buttons() & Qt::LeftButton)) {
        const double angle = angle_about(view, event.position());
        const double moved = std::remainder(angle - last_angle_, 2 * std::numbers::pi);
        last_angle_ = angle;
        turn(view, moved);
        return true;
    }
    if (event.buttons() != Qt::NoButton) return false;
    for (const QPointF& handle : handles(view))
        if (std::hypot(handle.x() - event.position().x(), handle.y() - event.position().y()) <= k_reach) {
            view.setCursor(Qt::PointingHandCursor);
            return true;
        }
    return false;
}

bool SliceCrossHair::release(SliceView& view, const QMouseEvent&) {
    const bool turned = turning_ == &view;
    turning_ = nullptr;
    return turned;
}

bool SliceCrossHair::key(SliceView& view, const QKeyEvent& event) {
    if (event.modifiers() != Qt::ControlModifier) return false;
    if (event.key() != Qt::Key_Left && event.key() != Qt::Key_Right) return false;
    turn(view, event.key() == Qt::Key_Right ? k_key_step : -k_key_step);
    return true;
}

void SliceCrossHair::leave(SliceView& view) {
    if (over_ == &view) over_ = nullptr;
}

void SliceCrossHair::paint(const SliceView& view, QPainter& painter) const {
    const QPointF at = view.toWidget(view.cursorMm());
    const double far = view.width() + view.height() + std::hypot(at.x(), at.y());
    painter.save();
    painter.setClipRect(view.pictureRect());
    for (const Line& line : lines_of(view)) {
        QColor ink = slice_color(line.kind);
        ink.setAlpha(190);  // the middle stays free
        painter.setPen(QPen(ink, 1));
        painter.drawLine(at - line.direction * far, at - line.direction * k_gap);
        painter.drawLine(at + line.direction * k_gap, at + line.direction * far);
    }
    painter.restore();
    if (over_ != &view && turning_ != &view) return;
    painter.setPen(QPen(QColor(235, 238, 242, 210), 1.2));
    painter.setBrush(QColor(20, 22, 26, 150));
    for (const QPointF& handle : handles(view)) painter.drawEllipse(handle, k_handle_radius, k_handle_radius);
    painter.setBrush(Qt::NoBrush);
}

}  // namespace lacuna::ui
