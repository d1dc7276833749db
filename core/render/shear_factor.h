#pragma once

#include "core/accel/slice_direction.h"
#include "core/render/camera.h"

namespace lacuna {

/// The shear factorisation of an orthographic view (Csebfalvi, Konig, Groller 1999, section 3): slice c, moved by
/// place(c) along u and v, is seen straight on in the intermediate image, one voxel one pixel; an affine warp makes the
/// picture of it. Spacing and the grid's axes enter through slope, warp and depth. The image has an empty border of at
/// least one pixel.
struct Shear {
    /// @param regions  6 or 24
    Shear(const ViewRays& rays, const GridGeometry& geometry, int regions);

    SliceDirection direction;
    glm::dvec2 slope{0};                   ///< shift of u and v a slice, at most 1 each way
    glm::dvec2 shift{0};                   ///< of slice 0
    glm::ivec2 size{0};                    ///< of the intermediate image
    glm::dvec2 at_first{0};                ///< intermediate position of the picture's pixel (0, 0)
    glm::dvec2 per_column{0}, per_row{0};  ///< and its change from pixel to pixel: the warp
    double depth_origin_mm = 0;            ///< depth of voxel (0, 0, 0)
    glm::dvec3 depth_per_voxel_mm{0};      ///< and its change along u, v and the axis
    double slice_mm = 1;                   ///< length of a ray between two slices

    glm::dvec2 place(int slice) const { return shift - double(slice) * slope; }
    double depth_mm(double u, double v, double slice) const {
        return depth_origin_mm + u * depth_per_voxel_mm.x + v * depth_per_voxel_mm.y + slice * depth_per_voxel_mm.z;
    }
};

}  // namespace lacuna
