#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/job.h"
#include "core/render/frame.h"
#include "core/render/plan.h"
#include "core/volume/samples.h"

namespace lacuna {

/// What a picture is held against. All three are drawn in double precision on the processor.
enum class Truth {
    samples,     ///< the same sample lattice, brute force: what a structure or a device made of it
    fine,        ///< brute force at a 16 times finer step: what the step made of it
    closed_form  ///< the formula an analytic sample was made from, no voxels: what voxels and filter made of it
};
std::string_view name_of(Truth truth);
/// @throws Error(bad_usage) listing the known names
Truth parse_truth(std::string_view text);

struct TrueFrame {
    Frame frame;
    std::string reference;  ///< in words, for ImageError::reference
    /// False where only the depths are true: the sample's surface has no normal to shade with.
    bool has_colors = true;
};

/// The picture the scene should be, for a plan like this one (its step and refinement count). Effects are applied,
/// highlights are not.
/// @param sample  what the scene's volume was made from; needed for closed_form alone
/// @throws Error(unsupported) for shear_warp, and for closed_form without a sample or with what has no closed form:
/// cuts, segmentation ranges, effects, lmip, shaded ea of a sample made of solid parts
TrueFrame render_truth(Truth truth, const Scene& scene, const Plan& like, const AnalyticSample* sample = nullptr,
                       const JobContext& job = {});

}  // namespace lacuna
