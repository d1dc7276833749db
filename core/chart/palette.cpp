#include "core/chart/palette.h"

#include <array>
#include <cmath>

namespace lacuna {

namespace {

constexpr glm::dvec3 rgb(int hex) { return {(hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0}; }

constexpr std::array<glm::dvec3, 10> k_colors{rgb(0x0072b2), rgb(0xd55e00), rgb(0x006d2c), rgb(0xcc79a7),
                                              rgb(0xddaa33), rgb(0x56b4e9), rgb(0x882255), rgb(0x332288),
                                              rgb(0x777777), rgb(0x661100)};
constexpr std::array k_markers{Marker::circle,  Marker::square,        Marker::triangle,
                               Marker::diamond, Marker::down_triangle, Marker::pentagon,
                               Marker::plus,    Marker::cross,         Marker::star};

std::vector<glm::dvec2> polygon_about(const glm::dvec2& at, double radius, int corners, double first_deg) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = glm::radians(first_deg + 360.0 * i / corners);
        points.push_back(at + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

std::vector<glm::dvec2> star_about(const glm::dvec2& at, double radius) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 10; ++i) {
        const double angle = glm::radians(-90 + 36.0 * i), r = i % 2 ? 0.45 * radius : radius;
        points.push_back(at + r * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// Two crossed strokes, the first along the direction.
void draw_crossing(Canvas& canvas, const glm::dvec2& at, const glm::dvec2& d, double size, const glm::dvec3& color) {
    const glm::dvec2 across(-d.y, d.x);
    // White underneath, as the edge of the filled markers.
    for (const auto& [ink, width] : {std::pair(glm::dvec3(1), 0.5 * size), std::pair(color, 0.28 * size)}) {
        canvas.line(at - d, at + d, {ink, width});
        canvas.line(at - across, at + across, {ink, width});
    }
}

}  // namespace

std::span<const glm::dvec3> series_colors() { return k_colors; }
glm::dvec3 series_color(std::size_t i) { return k_colors[i % k_colors.size()]; }
Marker series_marker(std::size_t i) { return k_markers[i % k_markers.size()]; }

void draw_marker(Canvas& canvas, Marker marker, const glm::dvec2& at, double size, const glm::dvec3& color, bool open) {
    const double r = 0.5 * size;
    const Fill fill{open ? glm::dvec3(1) : color, 1};
    const Stroke edge = open ? Stroke{color, 0.18 * size} : Stroke{glm::dvec3(1), 0.11 * size};
    const auto shape = [&](const std::vector<glm::dvec2>& points) { canvas.polygon(points, fill, edge); };
    switch (marker) {
        case Marker::none:
            return;
        case Marker::circle:
            return canvas.circle(at, r, fill, edge);
        case Marker::dot:
            return canvas.circle(at, 0.5 * r, fill, edge);
        case Marker::square:
            return shape(polygon_about(at, 1.2 * r, 4, 45));
        case Marker::diamond:
            return shape(polygon_about(at, 1.3 * r, 4, 0));
        case Marker::triangle:
            return shape(polygon_about(at + glm::dvec2(0, 0.2 * r), 1.3 * r, 3, -90));
        case Marker::down_triangle:
            return shape(polygon_about(at - glm::dvec2(0, 0.2 * r), 1.3 * r, 3, 90));
        case Marker::pentagon:
            return shape(polygon_about(at, 1.15 * r, 5, -90));
        case Marker::star:
            return shape(star_about(at, 1.4 * r));
        case Marker::plus:
            return draw_crossing(canvas, at, glm::dvec2(1.15 * r, 0), size, color);
        case Marker::cross:
            return draw_crossing(canvas, at, glm::dvec2(0.9 * r, 0.9 * r), size, color);
    }
}

}  // namespace lacuna
