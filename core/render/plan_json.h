#pragma once

#include <string>

#include "core/render/plan.h"

namespace lacuna {

/// A plan and the mode it draws: all that is needed, besides the scene, to draw the same picture again.
struct ModePlan {
    ViewMode mode = ViewMode::ea;
    Plan plan;
};

/// The plan as a JSON object on one line: {"mode", "structure", "step", "sampler", "gradient", "refine",
/// "refine_steps", "ert", "sparse", "sparse_gradient", "cells", "directions", "voxel_gradient",
/// "homogeneity", "homogeneity_angle", "brick", "why": [..]};
/// sparse and sparse_gradient are null where every pixel is cast, brick where the volume is not cut into bricks.
std::string to_json(const ModePlan& plan);

/// Reads what to_json wrote; a key left out keeps its default, an unknown one is refused.
/// @param where  names the text in complaints, e.g. a file
/// @throws Error(bad_input) naming `where` and the key
ModePlan plan_from_json(const std::string& json, const std::string& where);

}  // namespace lacuna
