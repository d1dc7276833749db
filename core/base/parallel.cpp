#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace lacuna {

namespace {
std::atomic<int> g_threads{0};
}

int thread_count() {
    if (const int set = g_threads.load(); set > 0) return set;
    static const int found = [] {
        if (const char* text = std::getenv("LACUNA_THREADS")) {
            const int wanted = std::atoi(text);
            if (wanted > 0) return wanted;
        }
        return std::max(1, int(std::thread::hardware_concurrency()));
    }();
    return found;
}

void set_thread_count(int threads) { g_threads = std::max(0, threads); }

void run_on_threads(int count, const std::function<void()>& work) {
    std::vector<std::jthread> helpers;
    try {
        for (int t = 1; t < count; ++t) helpers.emplace_back(work);
    } catch (const std::system_error&) {  // the system has no more threads to give: those there are do it all
    }
    work();
}

void parallel_for(std::int64_t begin, std::int64_t end, const std::function<void(std::int64_t)>& body,
                  const JobContext& job) {
    if (end <= begin) return;
    const std::int64_t total = end - begin;
    std::atomic<std::int64_t> next{begin};
    std::int64_t done = 0;
    std::exception_ptr failure;
    std::mutex mutex;

    auto work = [&] {
        for (;;) {
            const std::int64_t i = next.fetch_add(1);
            if (i >= end) return;
            try {
                job.check();
                body(i);
                std::lock_guard lock(mutex);  // progress under the lock: it never decreases
                ++done;
                if (!failure) job.checkpoint(std::size_t(done), std::size_t(total));
            } catch (...) {
                std::lock_guard lock(mutex);
                if (!failure) failure = std::current_exception();
                next = end;
                return;
            }
        }
    };
    run_on_threads(int(std::min<std::int64_t>(thread_count(), total)), work);
    if (failure) std::rethrow_exception(failure);
}

void parallel_bands(std::int64_t begin, std::int64_t end, int bands,
                    const std::function<void(std::int64_t, std::int64_t)>& body, const JobContext& job) {
    const std::int64_t total = end - begin;
    if (total <= 0) return;
    const std::int64_t count = std::clamp<std::int64_t>(bands, 1, total);
    parallel_for(
        0, count, [&](std::int64_t b) { body(begin + total * b / count, begin + total * (b + 1) / count); }, job);
}

}  // namespace lacuna
