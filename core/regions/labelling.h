#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/job.h"
#include "core/regions/regions.h"
#include "core/regions/run_components.h"
#include "core/volume/volume.h"

/// The steps of find_regions, seen only inside the room.
namespace lacuna::labelling {

/// Rows of marks: 1 for voxels that may be in a region (finite, no background, gradient within the limit).
runs::MarkRow mark_eligible(const Volume& volume, const RegionOptions& options);

/// Label of a voxel that is in no region and can join none. Outside of the steps here it is never seen.
inline constexpr std::uint32_t k_never = 0xFFFFFFFFu;

/// More rows than this are no table any more; growing stops with a sentence that names the way out.
inline constexpr std::uint32_t k_most_regions = 1u << 22;

/// Provisional ids 1..n in the scan order of each region's first voxel.
struct ProvisionalLabels {
    std::shared_ptr<std::vector<std::uint32_t>> labels;  ///< per voxel: id, 0 or k_never
    std::vector<std::uint64_t> voxels;                   ///< per id: voxels of the region; [0] unused
    std::vector<double> mean;  ///< per id, of its values; only where regions were grown; [0] unused
};

/// Homogeneous-region growing (Frey & Ertl 2009, section 3): every voxel without a label is, in scan order, the seed of
/// a region; a voxel joins while the region's largest less smallest value stays within `width` (in the volume's unit).
/// The front is a first-in first-out list of row segments, so the outcome is one and the same on every machine. A voxel
/// refused once would be refused for good, because the admissible values only shrink: at the end no voxel left over
/// beside a region fits it. Regions under `min_voxels` go to k_never. Cost: one visit per voxel and face; no
/// allocation per region.
ProvisionalLabels grow_regions(const Volume& volume, double width, const RegionOptions& options, const JobContext& job);

/// Connected components of the voxels within `range`, by runs of rows: final ids 1..n per voxel by descending size,
/// ties by first voxel; components under `min_voxels` are 0. @throws Error(bad_usage) beyond k_most_regions
std::shared_ptr<std::vector<std::uint32_t>> label_components(const Volume& volume, const RegionOptions& options,
                                                             const JobContext& job);

/// Gives slivers (RegionOptions::merge_slivers) to their neighbours and ranks ids by size anew. Cost: two passes over
/// the rows; memory follows the runs of what is left over.
void merge_slivers(const Volume& volume, const RegionOptions& options, std::vector<std::uint32_t>& labels,
                   const JobContext& job);

/// Renumbers in place: final ids 1..n by descending size, ties by first voxel; regions under `min_voxels` and k_never
/// become 0. Returns n. @throws Error(bad_usage) beyond k_most_regions
std::uint32_t number_by_size(ProvisionalLabels& provisional, std::int64_t min_voxels, const JobContext& job);

/// The sentence for a volume that falls apart. @throws Error(bad_usage) always
[[noreturn]] void refuse_region_count(std::int64_t min_voxels);

}  // namespace lacuna::labelling
