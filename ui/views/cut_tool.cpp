#include "ui/views/cut_tool.h"

#include <QPainterPath>
#include <cmath>

#include "ui/theme.h"

namespace lacuna::ui {

namespace {

const QColor k_shade(0, 0, 0, 150);  // under every line: seen on bright and on dark voxels

/// A line that can be told from whatever is below it.
void draw_line(QPainter& painter, const QPainterPath& path, const QColor& ink, double width,
               Qt::PenStyle style = Qt::SolidLine) {
    painter.setBrush(Qt::NoBrush);
    QColor shade = k_shade;
    shade.setAlphaF(shade.alphaF() * ink.alphaF());
    painter.setPen(QPen(shade, width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(ink, width, style, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

std::optional<QPainterPath> path_of(const ViewRays& rays, const std::vector<glm::dvec3>& corners, bool closed) {
    QPainterPath path;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::optional<glm::dvec2> at = in_picture(rays, corners[i]);
        if (!at) return std::nullopt;
        i == 0 ? path.moveTo(to_point(*at)) : path.lineTo(to_point(*at));
    }
    if (closed) path.closeSubpath();
    return path;
}

void draw_disc(QPainter& painter, const ViewRays& rays, const glm::dvec3& mm, double radius, const QColor& ink,
               bool hot) {
    const std::optional<glm::dvec2> at = in_picture(rays, mm);
    if (!at) return;
    painter.setPen(QPen(k_shade, 1.5));
    painter.setBrush(hot ? QColor(Qt::white) : ink);
    const double r = hot ? radius + 1.5 : radius;
    painter.drawEllipse(to_point(*at), r, r);
}

/// The colour a slice across that grid axis has.
QColor axis_color(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    if (size.z >= size.x && size.z >= size.y) return theme::k_axial;
    return size.y >= size.x ? theme::k_coronal : theme::k_sagittal;
}

}  // namespace

void CutTool::setCuts(const std::vector<CutSetting>& cuts) {
    cuts_ = cuts;
    if (hovered_.cut >= int(cuts.size())) hovered_ = {};
}

void CutTool::paint(QPainter& painter, const ViewRays& rays) const {
    if (!visible_) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (box_.enabled) paintBox(painter, rays);
    for (int cut = 0; cut < int(cuts_.size()); ++cut)
        if (cut != selected_ && shown(cut)) paintOutline(painter, rays, cut);
    if (selected_ >= 0 && selected_ < int(cuts_.size()) && shown(selected_)) {
        paintOutline(painter, rays, selected_);
        paintHandles(painter, rays);
    }
    painter.restore();
}

void CutTool::paintOutline(QPainter& painter, const ViewRays& rays, int cut) const {
    const std::vector<glm::dvec3> section = section_of(cuts_[std::size_t(cut)].plane, geometry_);
    const std::optional<QPainterPath> path = path_of(rays, section, true);
    if (!path || section.empty()) return;
    const bool selected = cut == selected_, hot = hovered_.cut == cut && hovered_.grip.kind == Grip::Kind::outline;
    QColor ink = hot ? QColor(Qt::white) : theme::k_volume;
    if (!selected && !hot) ink.setAlpha(150);
    if (selected && plane_drag_) {
        QColor wash = theme::k_volume;
        wash.setAlpha(14);
        painter.fillPath(*path, wash);
    }
    draw_line(painter, *path, ink, selected ? 2 : 1.25, selected ? Qt::SolidLine : Qt::DashLine);
    if (cuts_.size() < 2) return;
    const QPointF corner = to_point(*in_picture(rays, section.front()));
    painter.setPen(ink);
    painter.drawText(corner + QPointF(5, -4), QString::number(cut + 1));
}

void CutTool::paintHandles(QPainter& painter, const ViewRays& rays) const {
    const PlaneGizmo gizmo = gizmo_of(cuts_[std::size_t(selected_)].plane, geometry_, rays);
    const auto hot = [this](Grip::Kind kind, int index) {
        return hovered_.cut == selected_ && hovered_.grip == Grip{kind, index};
    };
    const bool moving = hot(Grip::Kind::move, 0);
    const QColor ink = moving ? QColor(Qt::white) : theme::k_volume;
    const auto from = in_picture(rays, gizmo.anchor), to = in_picture(rays, gizmo.tip);
    if (from && to) {
        QPainterPath shaft(to_point(*from));
        shaft.lineTo(to_point(*to));
        draw_line(painter, shaft, ink, 2.5);
        const QPointF along = to_point(*to - *from);
        const double length = std::hypot(along.x(), along.y());
        if (length > 6) {  // an arrow that points at the viewer has no head to be seen
            const QPointF d = along / length, across(-d.y(), d.x()), tip = to_point(*to);
            QPolygonF head;
            head << tip + 6 * d << tip - 7 * d + 6 * across << tip - 7 * d - 6 * across;
            painter.setPen(QPen(k_shade, 1.5));
            painter.setBrush(ink);
            painter.drawPolygon(head);
        } else {
            draw_disc(painter, rays, gizmo.tip, 6, ink, moving);
        }
    }
    draw_disc(painter, rays, gizmo.anchor, 4.5, theme::k_volume, moving);
    for (int i = 0; i < 4; ++i)
        draw_disc(painter, rays, gizmo.tilt[i], 5.5, theme::k_window.lighter(170), hot(Grip::Kind::tilt, i));
    for (const glm::dvec3& handle : gizmo.tilt) {
        const auto at = in_picture(rays, handle);
        if (!at) continue;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme::k_volume, 2));
        painter.drawEllipse(to_point(*at), 5.5, 5.5);
    }
}

void CutTool::paintBox(QPainter& painter, const ViewRays& rays) const {
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
            if (corner & (1 << axis)) continue;
            const auto path = path_of(
                rays, {corner_of(box_, corner, geometry_), corner_of(box_, corner | (1 << axis), geometry_)}, false);
            if (!path) continue;
            // An edge is behind when both its sides look away from the viewer.
            bool behind = true;
            for (int other = 0; other < 3; ++other) {
                if (other == axis) continue;
                const double outwards = corner & (1 << other) ? 1 : -1;
                const glm::dvec3 face = corner_of(box_, corner, geometry_);
                const glm::dvec3 sight = rays.perspective ? face - rays.eye : rays.forward;
                behind = behind && outwards * glm::dot(geometry_.direction[other], sight) > 0;
            }
            QColor ink = theme::k_accent;
            ink.setAlpha(behind ? 80 : 230);
            draw_line(painter, *path, ink, behind ? 1 : 1.5);
        }
    const auto square = [&](const glm::dvec3& mm, const QColor& ink, bool hot) {
        const auto at = in_picture(rays, mm);
        if (!at) return;
        const double r = hot ? 6 : 4.5;
        painter.setPen(QPen(k_shade, 1.5));
        painter.setBrush(hot ? QColor(Qt::white) : ink);
        painter.drawRect(QRectF(at->x - r, at->y - r, 2 * r, 2 * r));
    };
    const auto hot = [this](Grip::Kind kind, int index) {
        return hovered_.cut < 0 && hovered_.grip == Grip{kind, index};
    };
    square(middle_of(box_, geometry_), theme::k_accent, hot(Grip::Kind::box, 0));
    for (int side = 0; side < 6; ++side)
        square(side_of(box_, side, geometry_), axis_color(geometry_.direction[side / 2]), hot(Grip::Kind::side, side));
}

CutTool::Target CutTool::targetAt(const ViewRays& rays, const glm::dvec2& at) const {
    if (!visible_) return {};
    if (selected_ >= 0 && selected_ < int(cuts_.size()) && shown(selected_)) {
        const Grip grip = grip_at(gizmo_of(cuts_[std::size_t(selected_)].plane, geometry_, rays), rays, at, k_reach_px);
        if (grip) return {selected_, grip};
    }
    if (box_.enabled)
        if (const Grip grip = grip_at(box_, geometry_, rays, at, k_reach_px)) return {-1, grip};
    for (int cut = 0; cut < int(cuts_.size()); ++cut) {
        if (cut == selected_ || !shown(cut)) continue;
        PlaneGizmo outline;
        outline.section = section_of(cuts_[std::size_t(cut)].plane, geometry_);
        if (outline.section.empty()) continue;
        outline.anchor = outline.tip = outline.section.front();
        for (glm::dvec3& handle : outline.tilt) handle = outline.anchor;
        if (grip_at(outline, rays, at, k_reach_px)) return {cut, {Grip::Kind::outline, 0}};
    }
    return {};
}

bool CutTool::press(const ViewRays& rays, const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    const glm::dvec2 at = to_glm(event.position());
    const Target target = targetAt(rays, at);
    if (!target.grip) return false;
    hovered_ = target;
    if (target.cut < 0) {
        box_drag_.emplace(box_, target.grip, geometry_, rays, at);
    } else {
        if (target.cut != selected_) Q_EMIT cutChosen(target.cut);
        plane_drag_.emplace(cuts_[std::size_t(target.cut)].plane, target.grip, geometry_, rays, at);
    }
    Q_EMIT repaintNeeded();
    return true;
}

void CutTool::drag(const ViewRays&, const QMouseEvent& event) {
    const glm::dvec2 at = to_glm(event.position());
    if (box_drag_) {
        Q_EMIT boxEdited(tr("Box"), box_drag_->to(at));
    } else if (plane_drag_ && hovered_.cut >= 0 && hovered_.cut < int(cuts_.size())) {
        std::vector<CutSetting> next = cuts_;
        next[std::size_t(hovered_.cut)].plane = plane_drag_->to(at, event.modifiers() & Qt::ControlModifier);
        Q_EMIT cutsEdited(hovered_.grip.kind == Grip::Kind::tilt ? tr("Tilt a cut") : tr("Move a cut"), next);
    }
}

void CutTool::release() {
    plane_drag_.reset();
    box_drag_.reset();
    Q_EMIT repaintNeeded();
}

bool CutTool::hover(const ViewRays& rays, const QMouseEvent& event) {
    const Target target = targetAt(rays, to_glm(event.position()));
    if (target.cut != hovered_.cut || !(target.grip == hovered_.grip)) {
        hovered_ = target;
        Q_EMIT repaintNeeded();
    }
    return bool(target.grip);
}

void CutTool::leave() {
    hovered_ = {};
    Q_EMIT repaintNeeded();
}

}  // namespace lacuna::ui
