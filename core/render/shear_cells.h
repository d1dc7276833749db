#pragma once

#include "core/accel/visible_voxels.h"
#include "core/render/scene.h"
#include "core/render/shear_image.h"

namespace lacuna {

/// Bilinear shear-warp: each pixel of the intermediate image is a ray that meets every slice between voxels; the first
/// bilinear sample inside the object is found by painting the visible cells back to front, and the turn before it is
/// sharpened once by regula falsi between the two slices. Normals are central differences of the trilinear
/// reconstruction there, caps and open cuts begin where the ray enters them: as in the isosurface mode, at one sample a
/// slice. With segmentation ranges the measure of the voxels is interpolated, so the object is the one the cells were
/// listed for. Fills rows [first, last) of the image.
void paint_cells(const VisibleCells& cells, const Scene& scene, const glm::dvec3& forward, const Shear& shear,
                 ShearImage& image, int first, int last, const JobContext& job);

}  // namespace lacuna
