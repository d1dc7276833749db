#include "core/session/pick.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

std::optional<glm::dvec3> point_at(const Frame& frame, const Scene& scene, glm::dvec2 share) {
    const glm::ivec2 size = frame.size;
    const glm::dvec2 pixel = glm::floor(share * glm::dvec2(size));
    if (!(pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.x && pixel.y < size.y)) return std::nullopt;
    const std::size_t at = std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x);
    if (at >= frame.depth_mm.size() || !std::isfinite(frame.depth_mm[at])) return std::nullopt;
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), size);
    return rays.origin(pixel.x, pixel.y) + rays.direction(pixel.x, pixel.y) * double(frame.depth_mm[at]);
}

double focus_at(const glm::dvec3& mm, const ViewRays& rays, const GridGeometry& geometry) {
    const double behind_centre = glm::dot(mm - geometry.centre_mm(), rays.forward);
    return std::clamp(0.5 + behind_centre / geometry.diameter_mm(), 0.0, 1.0);
}

}  // namespace lacuna
