#pragma once

#include <cstdint>
#include <vector>

#include "core/base/job.h"
#include "core/regions/regions.h"

namespace lacuna::topology {

/// Whether a region of this many voxels and this box can close a cavity off at all.
bool can_enclose(std::int64_t voxels, const glm::ivec3& extent, Connectivity connectivity);

/// Counts the cavities of all regions at once: the connected parts of a region's complement that the outside cannot
/// reach. Everything but the candidates is joined into pieces (complementary adjacency: 26 for 6-connected regions,
/// 6 else); in the graph of pieces and candidates that touch, rooted at the outside, a candidate's cavities are the
/// subtrees that hang on it alone (cut vertices, Tarjan 1972). Another region counts as one connected whole.
/// @param labels     ids up to candidate.size() - 1, 0 is background
/// @param candidate  per id: 1 where can_enclose() holds
/// @return cavities per id. Cost: one pass over the rows' runs; memory grows with pieces, not voxels.
std::vector<std::uint32_t> count_cavities(const std::uint32_t* labels, const glm::ivec3& size,
                                          const std::vector<std::uint8_t>& candidate, Connectivity connectivity,
                                          const JobContext& job);

}  // namespace lacuna::topology
