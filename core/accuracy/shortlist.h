#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/render/plan_json.h"

namespace lacuna {

// The planner's decisions, as pure functions of what was measured or predicted.

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

/// Of plans by time (ms a frame with the build's share), how many of the fastest are worth timing against each other
/// once the first fits: those within this factor of it, at most k_finalists.
inline constexpr double k_close = 1.4;
inline constexpr std::size_t k_finalists = 3;
std::size_t finalists(const std::vector<double>& expected_ms, std::size_t first);

}  // namespace lacuna
