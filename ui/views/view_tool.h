#pragma once

#include <QMouseEvent>
#include <QPainter>

#include "core/render/camera.h"

namespace lacuna::ui {

/// Something drawn over the 3D picture that may take the mouse before the camera does. Positions are those of the
/// view's ViewRays: logical pixels from its upper left corner.
class ViewTool {
public:
    virtual ~ViewTool() = default;
    virtual void paint(QPainter&, const ViewRays&) const {}
    /// A button goes down. True: the mouse is this tool's until the button goes up.
    virtual bool press(const ViewRays&, const QMouseEvent&) { return false; }
    virtual void drag(const ViewRays&, const QMouseEvent&) {}
    virtual void release() {}
    /// The mouse moves without a button. True: it is on something that can be taken hold of.
    virtual bool hover(const ViewRays&, const QMouseEvent&) { return false; }
    virtual void leave() {}
};

inline glm::dvec2 to_glm(const QPointF& point) { return {point.x(), point.y()}; }
inline QPointF to_point(const glm::dvec2& point) { return {point.x, point.y}; }

}  // namespace lacuna::ui
