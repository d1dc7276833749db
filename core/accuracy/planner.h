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
    /// Other views of the scene to be drawn by the same plan (a turntable's), in their order. An error budget then has
    /// to hold in all of them by rule (known_bound); plan and rule are also measured in up to three of them.
    std::vector<Camera> other_views = {};
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

/// Picks the plan for a view by measuring candidates on the scene itself. First structures, lossless, and with the
/// cheapest of them the ways to trade error for time, on a picture a quarter as wide and high, whose rays are a regular
/// subset of the view's; what sparse casting would come to is told by the whole brute-force picture. What may fit is
/// then drawn whole in the order of the time expected and held against that picture, and goes on only if it fits there:
/// a promise about every pixel of this view, and about others only where a rule says so (Budget::other_views). As long
/// as a candidate may be faster than those that fit it is drawn, too (shortlist.h); those that fit are timed against
/// each other in turn, and the fastest is taken. Not measured is what the view's facts and the device's costs give no
/// chance, and what a milder plan already failed at. A structure whose build is not paid back within the expected
/// frames is refused, and with an error budget a method that is known to fail on such a scene (limits.h) more than
/// brute force does, before it is tried. With an error budget the cheapest plan that keeps it (brute force always
/// does); with a time budget the most exact one that fits; with both the cheapest within the error, which meets the
/// budget if it also fits the time. Cost: about two brute-force frames of the view, some thirty small ones and up to
/// about sixty of the finalists' (1.5 s of them at most, or three rounds); structures are built as tried.
/// @throws Error(bad_usage) for a budget that is not above 0 (an error budget may be 0), for none, and for shear_warp;
/// Error(cancelled)
PlannedPlan choose_plan(Engine& engine, const Scene& scene, const Budget& budget, const JobContext& job = {});

}  // namespace lacuna
