#include "core/base/deadline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>

namespace lacuna {

Deadline::Deadline(std::stop_token outer, double seconds)
    : outer_(outer), forward_(std::move(outer), Forward{source_}) {
    if (!std::isfinite(seconds)) return;
    constexpr double k_longest_s = 1e8;  // what a clock can be asked to wait for
    const std::chrono::duration<double> wait(std::clamp(seconds, 0.0, k_longest_s));
    timer_ = std::jthread([this, wait](const std::stop_token& gone) {
        std::mutex mutex;
        std::unique_lock lock(mutex);
        const auto until =
            std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(wait);
        if (!std::condition_variable_any().wait_until(lock, gone, until, [&] { return gone.stop_requested(); }))
            source_.request_stop();
    });
}

bool Deadline::ended(const Error& error) const {
    return error.code() == Errc::cancelled && !outer_.stop_requested() && source_.stop_requested();
}

}  // namespace lacuna
