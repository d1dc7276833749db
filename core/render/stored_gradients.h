#pragma once

#include "core/base/job.h"
#include "core/render/plan.h"
#include "core/volume/volume.h"

namespace lacuna {

/// A gradient a voxel, packed for the kernels (kernels/include/gradient.clh): word 0 is a float, the scale S; then a
/// word a voxel, x fastest: three signed 9-bit mantissas (x lowest) and a 5-bit exponent e, component = m * S *
/// 2^(e-38) per mm along the grid's axes; e = 31 stands for NaN. The largest component keeps 8 bits, so a direction is
/// off by at most 0.2 degrees. Axes with one voxel are stored twice, as the voxels are on the device.
/// @param values  range of the volume's values, which bounds the gradient
/// Cost: one pass on all threads, 4 bytes a voxel. @throws Error(cancelled), Error(out_of_memory)
VoxelBuffer make_stored_gradients(const Volume& volume, GradientFilter filter, ValueRange values,
                                  const JobContext& job = {});

/// The packed word of a gradient in units of S; for tests as well.
std::uint32_t pack_gradient(const glm::dvec3& gradient);
glm::dvec3 unpack_gradient(std::uint32_t word);

}  // namespace lacuna
