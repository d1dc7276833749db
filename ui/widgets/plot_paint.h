#pragma once

#include <QColor>
#include <QPainter>
#include <QWidget>
#include <glm/vec3.hpp>

#include "core/volume/volume.h"

// What the plots of values (of points, of shapes) paint alike.

namespace lacuna::ui {

/// sRGB 0..1 and back.
QColor to_qcolor(const glm::dvec3& color);
glm::dvec3 from_qcolor(const QColor& color);

/// The ends of the axis of values, left and right in the foot; the painter is left with their small font.
void paint_axis_ends(QPainter& painter, const QWidget& plot, const QRectF& foot, const ValueRange& values);

/// The line around a plot, which tells whether it has the keys.
void paint_frame(QPainter& painter, const QWidget& plot);

}  // namespace lacuna::ui
