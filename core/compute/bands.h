#pragma once

#include <functional>

#include "core/base/job.h"
#include "core/compute/device.h"

namespace lacuna {

/// Runs a picture's rows as a sequence of launches, because a launch cannot be taken back: at most two are in flight,
/// and a stop is seen between them. The height of a band follows the time of those before it, towards `band_ms`, so a
/// stop takes effect within about two band times. Cost beyond the work: some 15 us a launch on PoCL.
/// @param rows     rows in all; nothing runs for 0
/// @param granule  every band but the last has a multiple of this many rows, e.g. the rows of a work-group
/// @param enqueue  launches rows [first, first + count) on the device's queue and sets `done` to the launch's event.
///                 The first row belongs into a kernel argument, not into the global offset: PoCL compiles a kernel
///                 anew (0.2 s) for launches with an offset
/// @param granules with the height to start with, in granules, and to leave with: for a picture made by many calls
/// Returns, or throws, when nothing is in flight any more. Progress counts finished rows.
/// @throws Error(cancelled) from `job`; Error(device); what `enqueue` throws
void run_in_bands(ComputeDevice& device, int rows, int granule,
                  const std::function<void(int first, int count, cl::Event& done)>& enqueue, const JobContext& job = {},
                  double band_ms = 8, int* granules = nullptr);

}  // namespace lacuna
