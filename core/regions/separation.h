#pragma once

#include <vector>

#include "core/base/job.h"
#include "core/regions/point_tree.h"

namespace lacuna {

/// Shortest ways from a body's surface; infinity where there is nothing to go to.
struct Separation {
    double to_surface_mm;  ///< to the surface given
    double gap_mm;         ///< to the next body
};

/// How far bodies are from a surface and from each other, point to point.
/// @param bodies  points of each one's surface, all tagged with a number that is its own
/// Cost: O(n log n) over all points; memory 37 bytes a point beyond the bodies', and 16 a point of those at work.
std::vector<Separation> separations(const PointTree& surface, const std::vector<std::vector<PointTree::Point>>& bodies,
                                    const JobContext& job = {});

}  // namespace lacuna
