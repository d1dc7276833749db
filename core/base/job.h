#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

#include "core/base/error.h"

namespace lacuna {

/// What every job over 50 ms takes: a stop token to poll and a progress sink. Copyable; usable from any thread.
struct JobContext {
    std::stop_token stop{};                        ///< an empty token is never stopped
    std::function<void(double)> progress = nullptr;  ///< 0..1, never decreasing; may be called from any worker thread

    bool stopped() const { return stop.stop_requested(); }

    /// @throws Error(cancelled) once a stop was requested
    void check() const {
        if (stopped()) throw Error(Errc::cancelled, "Cancelled.");
    }

    /// Reports done/total, then throws Error(cancelled) if a stop was requested.
    void checkpoint(std::size_t done, std::size_t total) const {
        check();
        if (progress && total > 0) progress(double(done) / double(total));
    }

    /// The share [from, to] of this job's progress, for a step of a longer job.
    JobContext part(double from, double to) const {
        JobContext step{stop, nullptr};
        if (progress)
            step.progress = [report = progress, from, to](double f) { report(from + (to - from) * f); };
        return step;
    }
};

}  // namespace lacuna
