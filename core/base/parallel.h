#pragma once

#include <cstdint>
#include <functional>

#include "core/base/job.h"

namespace lacuna {

/// Number of worker threads parallel loops use: the hardware's, or what set_thread_count() or LACUNA_THREADS said.
int thread_count();
/// Overrides the number of threads of all later loops (0: back to the hardware's).
void set_thread_count(int threads);

/// Calls work() on this thread and, at the same time, on up to `count` - 1 others: fewer where the system has no more
/// to give. Returns when all calls have. @pre count > 0; work() does not throw
void run_on_threads(int count, const std::function<void()>& work);

/// Calls body(i) once for each i in [begin, end), each index on one thread, in no promised order. The result must not
/// depend on the order: then it does not depend on the number of threads either. The first exception of a body stops
/// the loop and is rethrown here; a requested stop becomes Error(cancelled). Progress counts finished indices.
void parallel_for(std::int64_t begin, std::int64_t end, const std::function<void(std::int64_t)>& body,
                  const JobContext& job = {});

/// As parallel_for, over contiguous bands: body(first, last) for `bands` ranges that partition [begin, end).
void parallel_bands(std::int64_t begin, std::int64_t end, int bands,
                    const std::function<void(std::int64_t, std::int64_t)>& body, const JobContext& job = {});

}  // namespace lacuna
