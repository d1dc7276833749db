#pragma once

#include "core/base/job.h"
#include "core/render/frame.h"
#include "core/render/plan.h"
#include "core/render/scene.h"

namespace lacuna {

/// Samples the reference takes for each step of a plan with pre-integrated segments.
inline constexpr int k_reference_subdivision = 16;

/// The truth the kernels are held against: double precision, plain C++, no structure, no code shared with the kernels.
/// Renders iso, EA and the MIP family exactly as scene.h defines them, at the plan's step, sampler, refinement and
/// termination; the plan's structure is ignored. Pre-integrated segments are held against k_reference_subdivision times
/// as many plain samples. Transfer functions are evaluated from their points, not from tables.
/// Counters are always filled. Also what runs where no OpenCL device works.
/// @throws Error(unsupported) for shear_warp; Error(cancelled) within 30 ms of a stop
Frame render_reference(const Scene& scene, const Plan& plan, const JobContext& job = {});

}  // namespace lacuna
