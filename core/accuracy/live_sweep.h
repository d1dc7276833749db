#pragma once

#include <set>

#include "core/accuracy/sweep.h"

namespace lacuna {

/// A sweep of one view that is measured in pieces, as somebody has time for them: next() names a plan, draw_visit()
/// measures it once (on any thread), add() takes the result. The first round gives every plan its error, the others go
/// on timing all of them in turn, forth and back, so that the times become medians over rounds. A value; not
/// thread-safe.
class LiveSweep {
public:
    static constexpr int k_rounds = 5;

    /// One visit of a plan.
    struct Visit {
        std::string refused = {};  ///< why the plan could not be drawn; empty: it was
        double ms = 0;             ///< of one frame, warm
        double build_ms = 0;       ///< of what had to be built for it
        std::size_t bytes = 0;     ///< of the structures it reads
        ImageError error;          ///< of the first round alone
    };

    LiveSweep() = default;
    /// @param current  the plan in use, measured second; brute force is the first
    LiveSweep(const Scene& scene, double step, SweepExtent extent, const ModePlan& current);

    /// The place of the plan to visit next among result().points; none when all rounds are done.
    std::optional<std::size_t> next() const;
    /// Takes the visit of the plan next() named.
    void add(const Visit& visit);
    /// Adds a plan that came into use later; it is measured next. Does nothing for one that is listed.
    void include(const ModePlan& plan);
    /// Where a plan stands among the points; none if it does not.
    std::optional<std::size_t> find(const ModePlan& plan) const;
    /// The points in a fixed order, brute force first; those without a time yet are `refused` as not measured yet, and
    /// pending() tells them from those that cannot be drawn.
    const SceneResult& result() const { return result_; }
    bool pending(std::size_t point) const { return times_[point].empty() && !impossible_.count(point); }
    std::size_t measured() const;

private:
    void append(const ModePlan& plan, const std::string& refused);

    SceneResult result_;
    std::vector<std::vector<double>> times_;  // by point
    std::vector<std::size_t> order_;          // points that can be drawn, as visited
    std::set<std::size_t> impossible_;
    std::size_t visits_ = 0;
};

/// Draws a plan once untimed and once timed. @param truth  the error is measured against it where it is given
/// @throws Error(cancelled); what else goes wrong is in the visit
LiveSweep::Visit draw_visit(Engine& engine, const Scene& scene, const ModePlan& plan, const TruePicture* truth,
                            const JobContext& job = {});

}  // namespace lacuna
