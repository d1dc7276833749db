#pragma once

#include "core/base/job.h"
#include "core/render/scene.h"

namespace lacuna {

/// Work along rays, counted on the sample lattice.
struct RayFacts {
    double samples = 0;    ///< lattice samples
    double shown = 0;      ///< of these, that can show something: opacity above 0; iso: the sides change there; the
                           ///< projections: let through by the ranges
    double stretches = 0;  ///< runs of samples in a row that show nothing
    double empty_run() const { return stretches > 0 ? (samples - shown) / stretches : 0; }
};

/// What is known of a view before any method draws it: of all its rays, from a regular subset of them.
struct ViewFacts {
    double pixels = 0;
    double rays = 0;          ///< that meet what the cuts keep of the volume
    RayFacts whole;           ///< rays followed to their end
    RayFacts seen;            ///< rays followed until nothing more is seen: ea to opacity 0.998, iso to the first hit
    double value_change = 0;  ///< mean difference of successive samples, as a share of the largest difference seen
    double occupancy() const { return whole.samples > 0 ? whole.shown / whole.samples : 0; }
};

/// Measures a view's facts on the host. @param step in smallest voxel spacings @param rays about so many are followed
/// @pre the scene's voxels are in memory  @throws Error(cancelled)
ViewFacts measure_view_facts(const Scene& scene, double step, int rays = 1500, const JobContext& job = {});

}  // namespace lacuna
