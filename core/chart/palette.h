#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/chart/canvas.h"

namespace lacuna {

/// What a point of a series is drawn as. Series differ by colour and by marker, so that a chart reads in grey too.
enum class Marker { none, circle, square, diamond, triangle, down_triangle, pentagon, plus, cross, star, dot };

/// Ten line colours that stay apart for all three kinds of colour blindness and on white paper (after Paul Tol's
/// qualitative schemes and Okabe & Ito 2008).
std::span<const glm::dvec3> series_colors();
/// Colour and marker of the i-th series of a chart that leaves the choice to it; they repeat after 10 and 9.
glm::dvec3 series_color(std::size_t i);
Marker series_marker(std::size_t i);

/// Draws a marker about a point; `size` is the diameter of its circle in points. An open one is filled white.
void draw_marker(Canvas& canvas, Marker marker, const glm::dvec2& at, double size, const glm::dvec3& color,
                 bool open = false);

}  // namespace lacuna
