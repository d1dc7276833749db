#pragma once

#include <string>
#include <vector>

#include "core/render/plan_json.h"

namespace lacuna {

/// A way of drawing a scene that a sweep considers.
struct Candidate {
    ModePlan plan;
    std::string refused = {};  ///< why it cannot serve the scene; empty: it can
};

enum class SweepExtent {
    quick,  ///< each structure once, and one example of each way to trade error for time
    full    ///< for each structure also steps, samplers, termination, sparse casting, thresholds and cell sizes
};

/// The ways to draw a scene worth measuring, brute force first, no two alike. Pure: follows the enumerations of plan.h,
/// so that a new structure, sampler or refinement is swept as soon as it has a name. A structure that cannot serve the
/// scene is one candidate with the reason; of the others only those that can are listed. iso scenes that are
/// orthographic may also be drawn by shear-warp.
/// @param step  of the reference, in smallest voxel spacings; the sweep takes it and coarser ones
std::vector<Candidate> candidates(const Scene& scene, double step, SweepExtent extent);

/// How a plan differs from the reference, in a few words ("step 1, ert 0.01"); "" where only the structure does.
std::string difference_in_words(const ModePlan& plan, const ModePlan& reference);

}  // namespace lacuna
