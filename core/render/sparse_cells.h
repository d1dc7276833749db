#pragma once

#include <cstdint>
#include <vector>

#include "core/accel/macrocells.h"
#include "core/base/job.h"
#include "core/render/scene.h"
#include "core/render/sparse_casting.h"

namespace lacuna {

/// The structure-aware part of sparse casting: marks the k x k blocks of pixels (grid.blocks() of them, row by row) in
/// which min-max cells allow for something that none of the block's four cast rays met, so that what is thinner than k
/// pixels is not lost:
///   iso         a cell that may hold surface where all four rays missed, or more than a cell's diagonal in front of
///   all
///               four depths
///   ea          a cell that may be visible where all four rays saw less than `gradient`; behind or before what is seen
///               nothing is promised
///   mip, minip  a cell whose extreme value would be drawn more than `gradient` (0..1) brighter (darker) than the most
///               extreme of the four; grey pictures only
///   lmip, mean  nothing
/// Conservative: a cell marks all blocks its box may cover. @param classes VisibilityTable::Answer a cell, for the mode
std::vector<std::uint8_t> blocks_with_hidden_cells(const Scene& scene, const Frame& cast, const SparseGrid& grid,
                                                   const MacrocellGrid& cells, const std::vector<std::uint8_t>& classes,
                                                   double gradient, const JobContext& job = {});

}  // namespace lacuna
