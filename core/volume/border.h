#pragma once

#include <functional>

#include "core/volume/volume.h"

namespace lacuna {

/// Share (0..1) of the voxels on the six sides of a box whose value `counts`; of a large side a regular grid of at most
/// 128 x 128 of them. 0 of a volume whose voxels do not lie in memory. Cost: below 100000 voxels, about 1 ms.
/// @pre the box lies inside the grid and holds a voxel
double border_share(const Volume& volume, const VoxelBox& box, const std::function<bool(double value)>& counts);

}  // namespace lacuna
