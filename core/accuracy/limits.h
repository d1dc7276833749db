#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/accuracy/scene_facts.h"
#include "core/render/plan.h"

namespace lacuna {

/// What is done about a failure. refused: the method is not run; detected: it is run, and said; corrected: Lacuna's
/// form of the method does not have it; bounded: it is there, and no larger than stated.
enum class Guard { refused, detected, corrected, bounded };
std::string_view name_of(Guard guard);

/// What a failure belongs to, in the order of docs/limits.md.
enum class LimitTopic {
    surfaces,
    emission_absorption,
    projections,
    shear_warp,
    structures,
    sparse,
    effects,
    volumes,
    regions,
    measures
};
std::string_view title_of(LimitTopic topic);

/// That a scene meets a failure.
struct LimitMet {
    double extent = 0;  ///< 0: it does not; else how much of the picture may suffer, the largest 1
    std::string how;    ///< one sentence with the measured facts; empty where it does not
};

/// One named way in which a method fails: the scenes that break it, what is done about that, and how it is known.
struct Limit {
    std::string_view name;  ///< short and unique
    LimitTopic topic;
    std::string_view fails;  ///< in plain words: what the scene is, and what goes wrong
    Guard guard;
    std::string_view guarded;  ///< how
    std::string_view bound;    ///< measured by the test
    std::string_view test;     ///< Suite.Case (GoogleTest) that shows failure, guard and bound
    /// Whether a plan for a scene uses the method; null: no picture's matter.
    bool (*concerns)(const Scene& scene, const Plan& plan) = nullptr;
    /// Whether the scene meets it; null: no fact tells beforehand.
    LimitMet (*met)(const SceneFacts& facts, const Scene& scene, const Plan& plan) = nullptr;
};

/// The catalogue: the one source of docs/limits.md, of what the window shows and of what the planner refuses.
std::span<const Limit> limits();

/// Where the methods of a plan fail, in the catalogue's order.
std::vector<const Limit*> limits_of(const Scene& scene, const Plan& plan);

struct MetLimit {
    const Limit* limit = nullptr;
    double extent = 0;
    std::string how;
};

/// Those of limits_of() that the scene meets. Cost: none; the facts are measure_facts(scene).
std::vector<MetLimit> limits_met(const SceneFacts& facts, const Scene& scene, const Plan& plan);

/// Why a plan is not to be used where another one, `least`, is: a failure the scene meets which `least` does not have,
/// or has less than half as much, and which is worth over `levels` of 255; "" where there is none.
std::string refused_by_limits(const SceneFacts& facts, const Scene& scene, const Plan& plan, const Plan& least,
                              double levels);

/// The largest share of a one-voxel spot's height that samples `step` smallest spacings apart can lose: the nearest one
/// lies up to half a step off, and the trilinear spot falls by its distance along each axis. No ray of the view loses
/// more; in perspective none may lose quite as much.
double spot_loss(const Scene& scene, double step);

/// A limit as docs/limits.md has it: one line of text, "- **Name.** ...".
std::string to_markdown(const Limit& limit);

}  // namespace lacuna
