#pragma once

#include "core/accel/distance_field.h"
#include "core/classify/classification.h"

namespace lacuna {

/// Which value ranges look alike: opacity and colour under a classification, cut into steps of the threshold; all
/// invisible values are alike. Two values of one step differ by less than the threshold, so that regions cannot drift,
/// and the steps of a threshold hold those of its half. O(1) a query, from prefix sums over 65536 values.
class HomogeneityTable {
public:
    /// @param threshold largest difference of opacities (per unit distance) and of colours, 0..1; 0: equal values only
    HomogeneityTable(const Classification& classification, ValueRange values, double threshold);
    bool alike(double lo, double hi) const;

private:
    ValueRange values_;
    double entries_per_unit_ = 0;
    std::vector<std::uint32_t> changes_;  ///< up to each entry; empty at threshold 0
};

/// How voxels are put into regions: cell c covers the positions [c, c+1) an axis, and so the 2x2x2 voxels from c on
/// that nearest or trilinear reconstruction can touch there.
struct VoxelRules {
    const VisibilityTable& visible;
    double slack = 0;  ///< how far a query must be widened for the renderer's rounding
    enum class Second { all_visible, busy, homogeneous } second = Second::busy;  ///< what the second kind of region is
    const HomogeneityTable* alike = nullptr;                                     ///< homogeneous only
    bool gradients = false;  ///< homogeneous only: gradients at the corners must be alike too
    double angle_deg = 0;    ///< largest angle between alike gradients; 0: they must be zero; 180: any
};

/// Regions of voxel cells (Es, Keles & Isler 2006): kind 1 shows nothing; kind 2 by the rules; border cells the rest.
/// Homogeneous cells that touch share a voxel, so that all of a connected set are alike.
/// Cost: one pass over the voxels on all threads, a byte a voxel.
RegionGrid voxel_regions(const Volume& volume, const VoxelRules& rules, const JobContext& job = {});

}  // namespace lacuna
