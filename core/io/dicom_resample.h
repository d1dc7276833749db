#pragma once

#include "core/base/job.h"
#include "core/io/dicom_stack.h"
#include "core/volume/volume.h"

namespace lacuna::dicom {

/// Which values are no tissue and must not be mixed with any: at or below `highest`. Beside them the nearest value is
/// taken instead of the interpolated one; outside the slices stands `outside`.
struct AirRule {
    double highest = 0, outside = 0;
    bool active = false;
};

/// Fills the planes plan.missing between their neighbours, in place, linearly in z.
void fill_missing_planes(const VoxelBuffer& voxels, VoxelType type, const StackPlan& plan, const AirRule& air,
                         const JobContext& job);

/// Brings loaded slices (plane i is used slice i) of `size` columns and rows onto plan.grid: each slice is shifted
/// within its plane by whole and part pixels (bilinear), and planes between slices are interpolated linearly.
VoxelBuffer resample_slices(const VoxelBuffer& slices, VoxelType type, glm::ivec2 size, const StackPlan& plan,
                            const AirRule& air, const JobContext& job);

}  // namespace lacuna::dicom
