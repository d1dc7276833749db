#pragma once

#include "core/accuracy/truth.h"

namespace lacuna {

/// Draws the formula a sample was made from instead of its voxels, inside the box of voxel cells.
/// iso: where every object is a ball or ellipsoid of the material, the exact intersection with it, whatever the
/// isovalue; else the first change of side found in steps of a quarter voxel, bisected to 1e-9 voxels. Normals are the
/// quadric's, or the formula's gradient. ea, mip, minip, mean: the formula integrated or searched in steps 16 times
/// finer than the plan's.
/// @throws as render_truth
TrueFrame render_closed_form(const Scene& scene, const AnalyticSample& sample, const Plan& like, const JobContext& job);

}  // namespace lacuna
