#pragma once

#include "core/inspect/grey_levels.h"
#include "core/inspect/part_analysis.h"

namespace lacuna::inspect {

/// The curve and, beside it, the part's voxels (material and voids) at each threshold.
struct StabilitySweep {
    StabilityCurve curve;
    std::vector<double> part_voxels;

    /// Between the curve's points, linear; outside them, the ends.
    double part_voxels_at(double threshold) const;
};

/// Segments anew at thresholds from 20 to 80 % of the contrast; counts and Euler's number are of voids of at least
/// min_voxels. Cost: one pass over the volume a threshold, by runs; no memory a voxel.
StabilitySweep sweep_thresholds(const Volume& volume, const GreyLevels& levels, bool filled, Connectivity connectivity,
                                std::int64_t min_voxels, const JobContext& job);

/// The plateau: the longest stretch of thresholds on which porosity changes at most 1.5 times as fast as where it
/// changes least, and the count stays within 10 % (or half a void) of its middle; at least 15 % of the contrast long,
/// else none
/// ({0, -1}). A blurred edge is steepest, and so the volume inside it steadiest, half way between its two sides.
ValueRange find_plateau(const StabilityCurve& curve, double contrast);

}  // namespace lacuna::inspect
