#pragma once

#include "core/base/job.h"
#include "core/render/frame.h"
#include "core/render/scene.h"

namespace lacuna {

/// Blends a highlight over a finished frame: each ray is followed through the highlight's voxels one by one (Amanatides
/// & Woo 1987) to the first that is set, shaded by the mask's own gradient. Nothing hides it, no cut removes it: a
/// selected pore is seen through the part. Host code: the box is small, and most pixels miss it.
void draw_highlight(const Scene& scene, const Highlight& highlight, Frame& frame, const JobContext& job = {});

}  // namespace lacuna
