#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/render/plan_json.h"

namespace lacuna {

// The planner's decisions, as pure functions of what was measured or predicted.

/// The largest number of three digits below a positive one; 0 for 0. What plans get is read by people, and what is
/// bounded by a budget must stay within it.
double rounded_down(double value);

/// Ways to draw a scene without loss: every structure that can serve it, those over macro-cells with cells of 8 voxels
/// and, where the volume is small enough for them, of 4. @param brute  what they are held against
std::vector<ModePlan> lossless_plans(const Scene& scene, const ModePlan& brute);

/// Ways to trade error for time with a structure: early termination, coarser steps, other samplers, segments, fewer
/// refinement steps; only those that can serve the scene.
/// @param exact  a plan without loss  @param error  the budget in 1/255; none: any error may do
std::vector<ModePlan> trades(const Scene& scene, const ModePlan& exact, const std::optional<double>& error);

/// A plan with the time it is expected to take.
struct Outlook {
    ModePlan plan;
    std::optional<double> ms;  ///< none: nothing is known of it
};

/// Predictions are off by up to a factor of two either way where rays go in packets (docs/accuracy.md): a plan is only
/// given up unmeasured where it is expected to take so many times the best one's time.
inline constexpr double k_hopeless = 4;

/// The reason why each plan is not worth measuring; empty where it is. Plans nothing is known of always are, and the
/// best one.
std::vector<std::string> leave_out(const std::vector<Outlook>& outlooks);

/// A plan that was measured and is off by more than it may be.
struct TooFarOff {
    ModePlan plan;
    double error = 0;  ///< 1/255
};

/// Why a plan need not be measured: one that differs from it by a shorter step or less termination alone is too far off
/// already. Empty: it has to be measured.
std::string off_already(const ModePlan& plan, const std::vector<TooFarOff>& measured);

/// How small pictures and predictions may mislead: once a plan fits, others are drawn whole, too, as long as they are
/// expected to take less than so many times its time, and until so many fit.
inline constexpr double k_close = 1.8;
inline constexpr std::size_t k_finalists = 6;
bool worth_a_trial(double expected_ms, double best_ms, std::size_t fitting);

/// Finalists that go on being timed in turn: those within this factor of the fastest. @param ms medians so far
inline constexpr double k_tie = 1.25;
std::vector<bool> still_in(const std::vector<double>& ms);

}  // namespace lacuna
