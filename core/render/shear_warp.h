#pragma once

#include "core/accel/visible_voxels.h"
#include "core/base/job.h"
#include "core/render/engine.h"
#include "core/render/frame.h"
#include "core/render/plan.h"
#include "core/render/scene.h"

namespace lacuna {

/// Shear-warp of the potentially visible surface voxels (Csebfalvi, Konig, Groller 1999), six directions: the slices
/// along the principal viewing axis, each moved by whole voxels, are painted back to front into an intermediate image,
/// one voxel one pixel, no z-buffer; only what stays visible is shaded; the image is then warped to the picture with
/// bilinear sampling. Spacing and an oblique grid enter through the shear and the warp. A voxel lies at most half a
/// voxel beside its place in u and v (the rounding of the shear) and is drawn half a slice before its centre. So the
/// depth is within 1.5 voxel diagonals where the surface is not steeper than 45 degrees; behind an open cut the shell
/// of surface voxels, up to two thick, is seen from within. Holds the lists of the last solid. One caller at a time.
class ShearWarpRenderer {
public:
    /// The picture over nothing: alpha 1 on the surface, less on its outline. Counters: rays that meet the sheared
    /// volume; voxels painted (samples) and not painted (skipped).
    /// @param built  what it took to build the lists: 0 ms when they were ready
    /// @throws Error(bad_usage) for a perspective camera; Error(cancelled) within 30 ms of a stop
    Frame render(const Scene& scene, const Plan& plan, const JobContext& job, BuildRecord& built);

    std::size_t bytes_held() const { return lists_.bytes_held(); }
    void drop() { lists_.drop(); }

private:
    VisibleVoxelCache lists_;
};

}  // namespace lacuna
