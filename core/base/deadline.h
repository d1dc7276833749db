#pragma once

#include <stop_token>
#include <thread>

#include "core/base/job.h"

namespace lacuna {

/// A stop token of its own that is stopped when another one is, or after so many seconds, whichever comes first.
class Deadline {
public:
    /// @param seconds  from now; infinity: never
    Deadline(std::stop_token outer, double seconds);
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    std::stop_token token() const { return source_.get_token(); }
    /// Whether an error came of the time alone: what else the outer job has to do may go on.
    bool ended(const Error& error) const;

private:
    struct Forward {
        std::stop_source& source;
        void operator()() const { source.request_stop(); }
    };
    std::stop_source source_;
    std::stop_token outer_;
    std::stop_callback<Forward> forward_;
    std::jthread timer_;  ///< last: gone before what it stops
};

}  // namespace lacuna
