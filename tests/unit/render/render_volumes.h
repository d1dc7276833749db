#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "core/render/reference_renderer.h"
#include "core/render/scene.h"

namespace lacuna::test {

inline const float k_nan = std::numeric_limits<float>::quiet_NaN();

/// A grid of the size and spacing centred on the origin of mm space, its axes turned by `turn_deg` about (1, 2, 3).
inline GridGeometry centred(glm::ivec3 size, glm::dvec3 spacing = glm::dvec3(1), double turn_deg = 0) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    if (turn_deg != 0)
        geometry.direction =
            glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(turn_deg), glm::normalize(glm::dvec3(1, 2, 3))));
    geometry.origin = -(geometry.direction * (0.5 * glm::dvec3(size - 1) * spacing));
    return geometry;
}

/// Voxels from a function of the position in mm.
template <class T = float, class Fn>
Volume sampled(const GridGeometry& geometry, Fn&& value) {
    return make_volume<T>(geometry, [&](std::span<T> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < geometry.size.z; ++z)
            for (int y = 0; y < geometry.size.y; ++y)
                for (int x = 0; x < geometry.size.x; ++x)
                    voxels[i++] = T(value(geometry.voxel_to_mm(glm::dvec3(x, y, z))));
    });
}

/// Signed distance into a ball about the origin: positive inside.
inline Volume ball(const GridGeometry& geometry, double radius_mm) {
    return sampled(geometry, [=](const glm::dvec3& mm) { return radius_mm - glm::length(mm); });
}

inline TransferFunction constant_tf(double opacity, glm::dvec3 color = glm::dvec3(1)) {
    TransferFunction tf;
    tf.points = {{0.0, color, opacity}};
    return tf;
}

inline Scene scene_of(const Volume& volume, ViewMode mode, int pixels = 33) {
    Scene scene;
    scene.volume = volume;
    scene.mode = mode;
    scene.size = {pixels, pixels};
    scene.shading = Shading::none;
    scene.classification.tf = constant_tf(0.5);
    scene.window = {0, 100};
    return scene;
}

inline Plan brute_force(double step = 0.5) {
    Plan plan;
    plan.structure = Structure::none;
    plan.step = step;
    plan.ert = 0;
    return plan;
}

/// Distance along a ray to the ball about the origin (first or second meeting), or infinity.
inline double ball_depth(const glm::dvec3& origin, const glm::dvec3& direction, double radius, bool far_side = false) {
    const double b = glm::dot(origin, direction), c = glm::dot(origin, origin) - radius * radius;
    if (b * b - c < 0) return std::numeric_limits<double>::infinity();
    return -b + (far_side ? 1 : -1) * std::sqrt(b * b - c);
}

inline std::size_t pixel_index(const Frame& frame, int x, int y) { return std::size_t(y) * frame.size.x + x; }

}  // namespace lacuna::test
