#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/accuracy/candidates.h"
#include "core/accuracy/device_costs.h"
#include "core/render/engine.h"

namespace lacuna {

/// What a plan may cost.
struct Budget {
    std::optional<double> error = {};    ///< largest difference of any channel from brute force, in 1/255
    std::optional<double> time_ms = {};  ///< of a frame, warm
    double step = 0.5;                   ///< of the brute force meant, in smallest voxel spacings
    int frames = 100;                    ///< expected of this scene: what builds must pay for
    /// What the device is known to cost (costs_of): candidates without a chance are then not measured.
    std::optional<DeviceCosts> costs = {};
};

/// A plan with what is known of it.
struct PlannedPlan {
    Plan plan;                 ///< its `why` says what was measured, and of every candidate refused the reason
    double error = 0;          ///< largest difference from brute force over the whole view, in 1/255, measured
    double ms = 0;             ///< of a frame of the view, measured
    bool meets_budget = true;  ///< false where no candidate fits the time budget: then it is the fastest found
};

/// Picks the plan for a view by measuring candidates on the scene itself, in three steps: structures by time, lossless;
/// then, with the cheapest of them, the ways to trade error for time; both on a picture a quarter as wide and high,
/// whose rays are a regular subset of the view's. What seems to fit is then drawn whole and held against the whole
/// brute-force picture, and is taken only if it fits there: a promise about every pixel of this view, not about others.
/// The fastest of those that fit are timed against each other in turn. Not measured is what the view's facts and the
/// device's costs give no chance (shortlist.h), and what a milder plan already failed at. A structure whose build is
/// not paid back within the expected frames is refused, and with an error budget a method that is known to fail on such
/// a scene (limits.h) more than brute force does, before it is tried. With an error budget the cheapest plan that keeps
/// it (brute force always does); with a time budget the most exact one that fits; with both the cheapest within the
/// error, which meets the budget if it also fits the time. Cost: about two brute-force frames of the view and some
/// small ones; structures are built as tried.
/// @throws Error(bad_usage) for a budget that is not above 0 (an error budget may be 0), for none, and for shear_warp;
/// Error(cancelled)
PlannedPlan choose_plan(Engine& engine, const Scene& scene, const Budget& budget, const JobContext& job = {});

}  // namespace lacuna
