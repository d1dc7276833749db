#pragma once

#include "core/accel/visible_voxels.h"
#include "core/base/job.h"
#include "core/render/engine.h"
#include "core/render/frame.h"
#include "core/render/plan.h"
#include "core/render/scene.h"
#include "core/render/shear_image.h"

namespace lacuna {

/// Shear-warp of the potentially visible surface voxels (Csebfalvi, Konig, Groller 1999), by 6 or 24 regions of
/// directions: the slices along the principal viewing axis are painted back to front into an intermediate image, no
/// z-buffer, and that is warped to the picture with bilinear sampling. Spacing and an oblique grid enter through the
/// shear and the warp. Lists are extracted when their region is first looked from, and kept for the last solid.
///
/// Plan::sampler nearest (while moving): slices move by whole voxels, one voxel one pixel. Lambert's shade is computed
/// a voxel as it is painted (the light moves with the eye: no shade holds for longer), Phong keeps the normals for the
/// pixels that stay visible. A voxel lies at most half a voxel beside its place in u and v and is drawn half a slice
/// before its centre, so the depth is within 1.6 voxel diagonals where the surface is not steeper than 45 degrees;
/// behind an open cut the shell of surface voxels, up to two thick, is seen from within.
/// Plan::sampler linear (when still): see paint_cells().
///
/// Where the principal axis switches, the picture pops: the samples of the two factorisations differ. One caller at a
/// time.
class ShearWarpRenderer {
public:
    /// The picture over nothing: alpha 1 on the surface, less on its outline. Counters: rays that meet the sheared
    /// volume; voxels or cells painted (samples) and not painted (skipped).
    /// @param built  what it took to build the lists: 0 ms when they were ready
    /// @throws Error(bad_usage) for a perspective camera; Error(cancelled) within 30 ms of a stop
    Frame render(const Scene& scene, const Plan& plan, const JobContext& job, BuildRecord& built);

    std::size_t bytes_held() const;
    void drop() { *this = {}; }

private:
    void paint_voxels(const VisibleVoxels& lists, const Scene& scene, const glm::dvec3& forward, const Shear& shear,
                      const JobContext& job);

    VisibleVoxelCache lists_;
    ShearImage image_;
};

}  // namespace lacuna
