#pragma once

#include <glm/glm.hpp>

#include "core/render/camera.h"

namespace lacuna {

/// Turns the volume as a ball under the hand (Shoemake, "ARCBALL: a user interface for specifying three-dimensional
/// orientation using a mouse", Graphics Interface 1992): the arc from where it was taken to where it is, twice. The
/// way between does not matter: coming back turns back. Outside the ball the view rolls.
class Arcball {
public:
    /// @param from  where the ball is taken: its middle is 0, its rim at distance 1; x to the right, y up
    Arcball(const Camera& camera, glm::dvec2 from) : start_(camera), from_(from) {}
    /// The camera with the ball drawn to a place; its centre, zoom and perspective stay.
    Camera to(glm::dvec2 at) const;

private:
    Camera start_;
    glm::dvec2 from_;
};

/// The camera's angles for a frame of unit vectors (as ViewRays); looking straight up or down keeps `azimuth_deg`.
void set_angles(Camera& camera, const glm::dvec3& right, const glm::dvec3& forward, double azimuth_deg);

}  // namespace lacuna
