#include "core/render/camera.h"

#include <cmath>

#include "core/base/error.h"

namespace lacuna {

void check(const Camera& camera) {
    if (!(camera.zoom > 0) || !std::isfinite(camera.zoom))
        throw Error(Errc::bad_usage, "The zoom must be a positive number.");
    // Rays of smaller fields start so far away that single precision loses the volume; they are parallel to the eye.
    constexpr double k_least_fov_deg = 0.01;
    if (camera.fov_deg && !(*camera.fov_deg >= k_least_fov_deg && *camera.fov_deg < 180))
        throw Error(Errc::bad_usage,
                    "The field of view must lie from 0.01 to below 180 degrees; parallel rays need none.");
    if (!std::isfinite(camera.azimuth_deg) || !std::isfinite(camera.elevation_deg) || !std::isfinite(camera.roll_deg))
        throw Error(Errc::bad_usage, "The camera's angles must be finite numbers.");
    if (camera.center_mm && !std::isfinite(camera.center_mm->x + camera.center_mm->y + camera.center_mm->z))
        throw Error(Errc::bad_usage, "The centre looked at must be finite numbers.");
}

ViewRays resolve(const Camera& camera, const GridGeometry& geometry, glm::ivec2 image_size) {
    check(camera);
    if (image_size.x < 1 || image_size.y < 1 || image_size.x > 16384 || image_size.y > 16384)
        throw Error(Errc::bad_usage, "The image size must be 1 to 16384 pixels on each side.");

    const double a = glm::radians(camera.azimuth_deg), e = glm::radians(camera.elevation_deg);
    const double r = glm::radians(camera.roll_deg);
    ViewRays rays;
    rays.size = image_size;
    rays.forward = -glm::dvec3(std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e));
    const glm::dvec3 level_right(std::cos(a), std::sin(a), 0);
    const glm::dvec3 level_up = glm::cross(level_right, rays.forward);
    rays.right = level_right * std::cos(r) - level_up * std::sin(r);
    rays.up = level_right * std::sin(r) + level_up * std::cos(r);

    const double span_mm = geometry.diameter_mm();
    rays.target = camera.center_mm.value_or(geometry.centre_mm());
    rays.pixel_mm = span_mm / camera.zoom / std::min(image_size.x, image_size.y);
    rays.perspective = camera.fov_deg.has_value();
    // Orthographic rays start far enough away that a centre anywhere in the volume leaves all of it in front.
    rays.distance_mm = rays.perspective ? 0.5 * span_mm / std::tan(0.5 * glm::radians(*camera.fov_deg))
                                        : 0.5 * span_mm + glm::length(rays.target - geometry.centre_mm());
    rays.eye = rays.target - rays.forward * rays.distance_mm;
    return rays;
}

glm::dvec2 ViewRays::project(const glm::dvec3& mm) const {
    const glm::dvec3 from_target = mm - target;
    double scale = 1 / pixel_mm;
    if (perspective) scale *= distance_mm / glm::dot(mm - eye, forward);
    return {glm::dot(from_target, right) * scale + 0.5 * size.x - 0.5,
            0.5 * size.y - 0.5 - glm::dot(from_target, up) * scale};
}

}  // namespace lacuna
