#pragma once

#include "core/base/job.h"
#include "core/regions/triangle_mesh.h"
#include "core/volume/volume.h"

namespace lacuna {

/// The isosurface of a whole volume as a closed, outward-oriented mesh in mm: marching cubes, vertices where the
/// values, taken as linear between voxels, pass the isovalue; inside is value >= iso. Where the inside reaches the
/// volume's border it is closed half a voxel beyond the last voxels. NaN is outside. Cost: one pass over the voxels,
/// memory for two slices and the mesh.
/// @throws Error(bad_input) where no voxel lies inside; Error(cancelled)
TriangleMesh iso_mesh(const Volume& volume, double iso, const JobContext& job = {});

}  // namespace lacuna
