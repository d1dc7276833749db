#include "core/session/arcball.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

glm::dvec3 on_ball(glm::dvec2 at) {
    const double off = glm::dot(at, at);
    return off < 1 ? glm::dvec3(at, std::sqrt(1 - off)) : glm::dvec3(at / std::sqrt(off), 0);
}

/// v turned by the quaternion (a . b, a x b): twice the angle from a to b.
glm::dvec3 turned_twice(const glm::dvec3& v, const glm::dvec3& a, const glm::dvec3& b) {
    const double w = glm::dot(a, b);
    const glm::dvec3 q = glm::cross(a, b), t = 2.0 * glm::cross(q, v);
    return v + w * t + glm::cross(q, t);
}

/// A grid no camera depends on: angles alone are wanted.
ViewRays frame_of(const Camera& camera) {
    GridGeometry unit;
    unit.size = {1, 1, 1};
    Camera plain;
    plain.azimuth_deg = camera.azimuth_deg;
    plain.elevation_deg = camera.elevation_deg;
    plain.roll_deg = camera.roll_deg;
    return resolve(plain, unit, {2, 2});
}

}  // namespace

void set_angles(Camera& camera, const glm::dvec3& right, const glm::dvec3& forward, double azimuth_deg) {
    const double level = std::hypot(forward.x, forward.y);
    camera.elevation_deg = glm::degrees(std::atan2(-forward.z, level));
    camera.azimuth_deg = level > 1e-9 ? glm::degrees(std::atan2(-forward.x, forward.y)) : azimuth_deg;
    const double a = glm::radians(camera.azimuth_deg);
    const glm::dvec3 level_right(std::cos(a), std::sin(a), 0), level_up = glm::cross(level_right, forward);
    camera.roll_deg = glm::degrees(std::atan2(-glm::dot(right, level_up), glm::dot(right, level_right)));
}

Camera Arcball::to(glm::dvec2 at) const {
    const glm::dvec3 a = on_ball(from_), b = on_ball(at);
    const ViewRays frame = frame_of(start_);
    // The volume turns with the hand, so the camera the other way; in its own axes: right, up, towards the viewer.
    const auto in_world = [&](const glm::dvec3& v) {
        return glm::normalize(frame.right * v.x + frame.up * v.y - frame.forward * v.z);
    };
    const glm::dvec3 right = in_world(turned_twice({1, 0, 0}, b, a));
    const glm::dvec3 forward = in_world(turned_twice({0, 0, -1}, b, a));
    Camera camera = start_;
    set_angles(camera, right, forward, start_.azimuth_deg);
    return camera;
}

}  // namespace lacuna
