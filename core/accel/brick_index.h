#pragma once

#include <cstdint>
#include <vector>

#include "core/accel/macrocells.h"
#include "core/base/job.h"
#include "core/volume/brick_grid.h"
#include "core/volume/statistics.h"
#include "core/volume/volume.h"

namespace lacuna {

/// What must be known of a volume before any of its bricks is loaded: the ranges of its values, cell by cell, by which
/// bricks are found empty, and its statistics, by which a scene is fitted.
struct BrickIndex {
    const void* of = nullptr;  ///< Volume::identity()
    MacrocellGrid cells;       ///< cells of 16 voxels: 8 bytes for every 4096 voxels
    VolumeStatistics statistics;
};

/// Cost: one pass over the voxels (two for f32), a few megabytes at a time; reading them is most of it.
/// @throws Error(io), Error(cancelled)
BrickIndex build_brick_index(const Volume& volume, const JobContext& job = {});

/// What a brick can bring to a picture.
enum class BrickContent : std::uint8_t {
    empty,    ///< nothing a ray could see: never loaded
    uniform,  ///< one value all through, which can be seen: cast, but never loaded
    full
};

struct BrickState {
    BrickContent content = BrickContent::full;
    double value = 0;  ///< uniform
};

/// The state of every brick, from the index and the classes of its cells (classify_macrocells). A brick is looked at
/// with all the voxels it stores, ghosts included: a ray comes from a brick into an empty one only where what it saw
/// last was not visible either.
std::vector<BrickState> brick_states(const BrickGrid& grid, const BrickIndex& index,
                                     const std::vector<std::uint8_t>& classes);

}  // namespace lacuna
