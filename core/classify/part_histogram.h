#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/job.h"
#include "core/volume/statistics.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Which voxels of a volume count: those whose centre lies in every half-space and whose value lies in one of the
/// ranges.
struct VolumePart {
    std::vector<glm::dvec4> half_spaces;  ///< kept is x*p.x + y*p.y + z*p.z + w >= 0, mm
    std::vector<ValueRange> ranges;       ///< none: every value that is finite
    bool whole() const { return half_spaces.empty() && ranges.empty(); }
    friend bool operator==(const VolumePart&, const VolumePart&) = default;
};

/// How often each value occurs in a part, in the bins of the volume's own histogram.
/// @throws Error(cancelled), Error(unsupported) for a volume that does not lie in memory
std::vector<std::uint64_t> part_histogram(const Volume& volume, const VolumeStatistics& statistics,
                                          const VolumePart& part, const JobContext& job = {});

/// How often values and gradient magnitudes occur together (Kindlmann & Durkin 1998): surfaces are arches.
struct JointHistogram {
    ValueRange values, magnitudes;      ///< from the first bin's lower to the last one's upper end; units, units per mm
    glm::ivec2 bins{0};                 ///< along values, along magnitudes
    std::vector<std::uint64_t> counts;  ///< bins.x * bins.y, values fastest, lowest magnitudes first
};

/// Of a part of the volume, gradients by central differences over one voxel each way, as the renderers take them (at
/// the border it is repeated). Magnitudes end at the largest that occurs. Voxels with a neighbour that is not finite
/// count with magnitude 0. Cost: one pass over the voxels, seven reads each.
/// @throws Error(cancelled), Error(unsupported) for a volume that does not lie in memory
JointHistogram joint_histogram(const Volume& volume, const VolumeStatistics& statistics, const VolumePart& part,
                               const JobContext& job = {});

/// What a segmentation range holds of a volume.
struct RangeCount {
    std::uint64_t voxels = 0;  ///< values inside it
    std::uint64_t own = 0;     ///< of these, not in an earlier range of the list: what it gives its colours to
    double share = 0;          ///< voxels of all finite voxels
    double volume_mm3 = 0;     ///< voxels times a voxel's volume
    double mean = 0;           ///< of the values inside; 0 where there are none
    friend bool operator==(const RangeCount&, const RangeCount&) = default;
};

/// Counts for each of the ranges. Integer volumes with a bin a value are counted from the histogram (exact, at once);
/// others in one pass over the voxels. @throws Error(cancelled), Error(unsupported) as above
std::vector<RangeCount> count_ranges(const Volume& volume, const VolumeStatistics& statistics,
                                     const std::vector<ValueRange>& ranges, const JobContext& job = {});

}  // namespace lacuna
