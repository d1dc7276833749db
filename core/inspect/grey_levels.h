#pragma once

#include "core/base/job.h"
#include "core/volume/statistics.h"
#include "core/volume/volume.h"

/// What a part's grey values say of its scan: levels of air and material, noise, sharpness.
namespace lacuna::inspect {

struct GreyLevels {
    bool has_material = false;
    double air = 0, material = 0;  ///< the two sides' modes
    double threshold = 0;  ///< Otsu's, or half way to the deepest values where pores are too few to make a class
    double noise = 0;      ///< standard deviation within the material
    std::string why_not;   ///< a sentence when there is no material

    double contrast() const { return material - air; }
};

/// Levels by the histogram: Otsu's threshold parts it, a side's level is its mode. Where no valley lies between the two
/// sides (Otsu splits the material's own noise when pores are few), the main mode is the material if values far below
/// it exist (six standard deviations), and there is none otherwise.
GreyLevels find_levels(const Volume& volume, const VolumeStatistics& statistics);

/// Standard deviation of noise within the material: from differences of voxels three apart along x in stretches of
/// material (their median absolute value, so that edges and defects do not count); correlation over less than three
/// voxels does not hide it.
double measure_noise(const Volume& volume, double threshold);

/// Sigma of a Gaussian blur in mm, from edges: where a row of voxels passes from air to material nearly at right angles
/// and without turning back, half the width from 16 to 84 % of the step between the two levels (median over up to
/// 200 000 edges), less what sampling and linear interpolation add. 0 for values that are binary; NaN where there are
/// no such edges.
double measure_edge_width(const Volume& volume, const GreyLevels& levels, const JobContext& job);

}  // namespace lacuna::inspect
