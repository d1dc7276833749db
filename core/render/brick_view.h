#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/render/frame.h"
#include "core/volume/brick_grid.h"
#include "shared/ray_params.h"

namespace lacuna {

/// Pixels [first, end) of a picture.
struct PixelRect {
    glm::ivec2 first{0}, end{0};
    bool empty() const { return first.x >= end.x || first.y >= end.y; }
    glm::ivec2 size() const { return end - first; }
};

/// How a view meets the bricks of a volume. Everything comes from the kernels' own parameters (of the whole volume), so
/// that no rounding stands between what a ray does and what is said of it here.
class BrickView {
public:
    /// @param params  of the whole volume, with the picture's size
    BrickView(const BrickGrid& grid, const RayParams& params, bool perspective);

    /// All bricks, front to back: no ray comes from a brick into one that is before it. Along a ray every axis' brick
    /// index moves away from the eye's (orthographic: one way), so the sum of these distances only grows.
    std::vector<std::int64_t> front_to_back() const;
    /// The pixels whose rays can meet the brick, and perhaps some more; empty where it is outside the picture.
    PixelRect pixels_of(glm::ivec3 brick) const;
    /// Whether the ray of a pixel meets the brick, or passes within `margin` voxels of it.
    bool meets(glm::ivec3 brick, int x, int y, double margin) const;

private:
    struct Corners {
        glm::dvec3 lo, hi;
    };
    Corners box(glm::ivec3 brick, double margin) const;

    BrickGrid grid_;
    bool perspective_;
    int width_, height_;
    glm::dvec3 origin_, origin_dx_, origin_dy_, dir_, dir_dx_, dir_dy_;
};

}  // namespace lacuna
