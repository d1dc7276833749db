#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/volume/grid_geometry.h"

namespace lacuna {

/// The contract's camera. The eye looks at the centre from direction (sin A cos E, -cos A cos E, sin E), +z up;
/// A = 0, E = 0 looks from the front (anterior). At zoom 1 the image's shorter side spans the diameter of the volume's
/// bounding sphere, for perspective in the plane through the centre, where fov_deg is the angle of that side.
struct Camera {
    double azimuth_deg = 0, elevation_deg = 0;
    double roll_deg = 0;                  ///< turns the camera clockwise about the view axis, the picture the other way
    double zoom = 1;                      ///< > 0
    std::optional<glm::dvec3> center_mm;  ///< none: the volume's centre
    std::optional<double> fov_deg;        ///< none: orthographic; else 0.01 <= fov < 180
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// The camera resolved for one volume and image size, in mm. The ray of the pixel in column x, row y (row 0 on top)
/// starts at origin(x, y) and runs along direction(x, y), a unit vector, through the pixel's centre.
struct ViewRays {
    glm::dvec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};  ///< unit; picture's right, picture's up, into the scene
    glm::dvec3 eye{0};       ///< perspective: the eye; orthographic: a point in the plane all rays start from
    glm::dvec3 target{0};    ///< the centre looked at
    double pixel_mm = 1;     ///< size of a pixel in the plane through the centre
    double distance_mm = 1;  ///< from eye to target
    bool perspective = false;
    glm::ivec2 size{1};

    /// Offset of a pixel's centre from the image's middle, in the plane through the target, mm.
    glm::dvec3 offset(double x, double y) const {
        return right * ((x + 0.5 - 0.5 * size.x) * pixel_mm) + up * ((0.5 * size.y - y - 0.5) * pixel_mm);
    }
    glm::dvec3 origin(double x, double y) const { return perspective ? eye : eye + offset(x, y); }
    glm::dvec3 direction(double x, double y) const {
        return perspective ? glm::normalize(forward * distance_mm + offset(x, y)) : forward;
    }
    /// Where a position in mm falls in the picture (fractional pixels, pixel centres at whole numbers).
    glm::dvec2 project(const glm::dvec3& mm) const;
};

/// @throws Error(bad_usage) for a camera no picture can be drawn with: zoom <= 0, a field of view outside [0.01, 180),
/// an angle or a centre that is not finite
void check(const Camera& camera);

/// @throws Error(bad_usage) as check(), and for an image side outside 1..16384
ViewRays resolve(const Camera& camera, const GridGeometry& geometry, glm::ivec2 image_size);

}  // namespace lacuna
