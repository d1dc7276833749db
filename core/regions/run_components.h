#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/job.h"
#include "core/regions/regions.h"

/// Connected components on the runs of a mask instead of its voxels: memory and time follow the mask's surface.
namespace lacuna::runs {

/// A stretch of one row inside the mask, both ends included.
struct Run {
    std::int32_t first, last;
};

/// All runs of one slice, row by row: those of row y are [row_begin[y], row_begin[y + 1]).
struct Slice {
    std::vector<std::uint32_t> row_begin;
    std::vector<Run> runs;
};

/// The runs of a mask in scan order. A run's number is slice_begin of its slice plus its place in it.
struct RunList {
    glm::ivec3 size{0};
    std::vector<Slice> slices;
    std::vector<std::uint64_t> slice_begin;  ///< size.z + 1 entries

    std::size_t count() const { return slice_begin.empty() ? 0 : std::size_t(slice_begin.back()); }
    std::int64_t voxels() const;
};

/// Writes 1 or 0 for each voxel of row (y, z); called from several threads, with a buffer of each thread's own.
using MarkRow = std::function<void(int y, int z, std::uint8_t* marks)>;

/// The mask's runs. Cost: one call of `mark` a row, a few operations for every 8 voxels of equal marks.
RunList find_runs(const glm::ivec3& size, const MarkRow& mark, const JobContext& job = {});

/// Marks the finite values of a closed range.
MarkRow mark_in_range(const Volume& volume, const ValueRange& range);
/// Marks the values that are not at or above the threshold, NaN among them.
MarkRow mark_below(const Volume& volume, double threshold);
/// Marks the finite values above the threshold.
MarkRow mark_above(const Volume& volume, double threshold);

/// Which component each run belongs to.
struct Components {
    std::vector<std::uint32_t> of_run;  ///< per run: 0..n-1, in the scan order of the components' first voxels
    std::vector<std::uint64_t> voxels;  ///< per component
    std::uint32_t count() const { return std::uint32_t(voxels.size()); }
};

/// Joins runs that touch (Wu, Otoo, Suzuki 2009, union-find with the first run as root): bands of slices each on their
/// own, then across their borders. The same components for any number of threads.
/// @throws Error(out_of_memory) for more than 2^32 runs
Components join(const RunList& runs, Connectivity connectivity, const JobContext& job = {});

/// Calls visit(y, z, run, number of the run) for all runs of a slice.
template <class Visit>
void for_runs(const RunList& runs, int z, Visit&& visit) {
    const Slice& slice = runs.slices[std::size_t(z)];
    const std::size_t base = std::size_t(runs.slice_begin[std::size_t(z)]);
    for (int y = 0; y < runs.size.y; ++y)
        for (std::uint32_t k = slice.row_begin[std::size_t(y)]; k < slice.row_begin[std::size_t(y) + 1]; ++k)
            visit(y, z, slice.runs[k], base + k);
}

}  // namespace lacuna::runs
