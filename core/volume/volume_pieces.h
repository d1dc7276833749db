#pragma once

#include <functional>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// A part of a volume in memory for a while. Pieces overlap by one voxel at their upper sides, where cells between
/// voxels reach into the next piece; the `own` parts partition the volume.
struct VolumePiece {
    VoxelBox box;       ///< where it lies in the volume; whole rows: box.size.x is the volume's width
    glm::ivec3 own{0};  ///< of the piece's voxels, those with indices below it belong to no other piece
    Volume volume;      ///< its voxels, valid during the call only
};

/// Calls `take` for one piece after the other, so that a volume larger than the memory can be gone through: some 16 MB
/// of voxels at a time. Every piece starts at a multiple of `granule` rows and slices (a power of two up to 64).
/// @throws Error(cancelled), Error(io), and what `take` throws
void for_each_piece(const Volume& volume, int granule, const std::function<void(const VolumePiece&)>& take,
                    const JobContext& job = {});

}  // namespace lacuna
