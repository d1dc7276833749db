#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/render/scene.h"

namespace lacuna {

/// How thick what is seen is, from voxel to voxel along the three axes, in smallest spacings.
struct ThicknessCounts {
    static constexpr int k_bins = 64;
    static constexpr double k_bin = 1.0 / 16;  ///< width of a bin; four spacings in all
    std::array<std::int64_t, k_bins> thin{};   ///< places by thickness; thicker ones are only in `places`
    std::int64_t places = 0;                   ///< voxels at a surface, or pairs of voxels a peak lies in

    void add(double thickness);
    /// Share of the places, 0..1, that rays square on would miss, sampled every `step`: 1 - thickness/step each.
    double missed(double step) const;
    /// Places thinner than `step`.
    std::int64_t thinner_than(double step) const;
};

/// What of a scene decides whether a method fails on it, counted over all its voxels.
struct SceneFacts {
    bool voxels_seen = false;  ///< false: they do not lie in memory, and only what is above them is known
    double anisotropy = 1;     ///< largest spacing over smallest
    std::optional<double>
        narrowest;          ///< width in values of the narrowest peak of the classification, at half its height
    double peaks_span = 0;  ///< between the outermost points of the classification

    std::int64_t voxels = 0, not_finite = 0;
    ValueRange range;              ///< of the finite values
    ThicknessCounts walls;         ///< iso: of voxels inside; ea: of visible voxels
    ThicknessCounts shells;        ///< ea: where values pass a whole peak between two voxels
    std::int64_t shown = 0;        ///< iso: voxels inside; ea: visible ones
    std::int64_t wires = 0;        ///< voxels shown (mip family: beyond their neighbours) across two axes at least
    std::int64_t spots = 0;        ///< mip family: voxels beyond all six neighbours by over two grey levels
    double spot_height = 0;        ///< the largest such difference, in values
    std::int64_t equal_pairs = 0;  ///< voxels equal to the next along x
    bool constant() const { return voxels_seen && !(range.hi > range.lo); }
};

/// Counts. Cost: one pass over the voxels on all threads (about 10 ns a voxel and thread), none for a volume that does
/// not lie in memory. @throws Error(cancelled)
SceneFacts measure_facts(const Scene& scene, const JobContext& job = {});

}  // namespace lacuna
