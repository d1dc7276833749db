#pragma once

#include <string>

#include "core/base/job.h"
#include "core/compute/program.h"

namespace lacuna {

/// Compiles the test kernels and compares a ramp volume sampled between its voxels, and sums over work-groups, with
/// what they must be. Cost: some 30 ms once the device's compiler knows the kernels, up to 1 s before.
/// @param source the test kernels; other text than the embedded one only where the test itself is tested
/// @return what is wrong, a clause for DeviceInfo::fault; empty when nothing is. @throws Error(cancelled)
std::string self_test_fault(ComputeDevice& device, ProgramLibrary& library, const JobContext& job = {},
                            const std::string& source = expand_kernel_source("compute/self_test.cl"));

/// Milliseconds of the ranking load (rays through a 64^3 volume), the least of several runs.
/// @throws Error(device), Error(cancelled)
double measure_rank_ms(ComputeDevice& device, ProgramLibrary& library, const JobContext& job = {});

}  // namespace lacuna
