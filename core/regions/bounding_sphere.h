#pragma once

#include <glm/glm.hpp>
#include <span>

namespace lacuna {

struct Sphere {
    glm::dvec3 centre{0};
    double radius = 0;
};

/// The smallest sphere round all points: the farthest point joins the supports until none lies outside (Gaertner 1999,
/// "Fast and robust smallest enclosing balls"); exact to rounding. Some ten passes over the points. Empty: radius 0.
Sphere smallest_enclosing_sphere(std::span<const glm::dvec3> points);

}  // namespace lacuna
