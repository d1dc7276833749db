#include "core/regions/regions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/regions/labelling.h"
#include "core/regions/region_march.h"

namespace lacuna {

namespace {

void check_options(const Volume& volume, const RegionOptions& options) {
    if (volume.empty()) throw Error(Errc::bad_input, "There is no volume to find regions in; load one first.");
    if (options.range_width.has_value() == options.threshold.has_value())
        throw Error(Errc::bad_usage, "Regions need either a range width or a threshold: give exactly one of them.");
    if (options.range_width && !(*options.range_width >= 0 && *options.range_width <= 1))
        throw Error(Errc::bad_usage,
                    "The range width is a share of the volume's value range: give a number from 0 to 1.");
    if (options.threshold && !(options.threshold->lo <= options.threshold->hi))
        throw Error(Errc::bad_usage, "The threshold's lower value must not exceed its upper one.");
    if (options.background && !(options.background->lo <= options.background->hi))
        throw Error(Errc::bad_usage, "The background's lower value must not exceed its upper one.");
    if (options.min_voxels < 1) throw Error(Errc::bad_usage, "The smallest region has 1 voxel: give at least 1.");
    if (options.gradient_limit && !(*options.gradient_limit >= 0))
        throw Error(Errc::bad_usage, "The gradient limit is a number from 0 up, in the volume's unit per mm.");
    const int adjacency = int(options.connectivity);
    if (adjacency != 6 && adjacency != 18 && adjacency != 26)
        throw Error(Errc::bad_usage, "The connectivity is 6, 18 or 26.");
}

template <class T>
ValueRange range_of_band(const T* values, std::int64_t count) {
    T lo = std::numeric_limits<T>::max(), hi = std::numeric_limits<T>::lowest();
    for (std::int64_t i = 0; i < count; ++i) {
        if constexpr (std::is_floating_point_v<T>)
            if (!std::isfinite(values[i])) continue;
        lo = std::min(lo, values[i]);
        hi = std::max(hi, values[i]);
    }
    return {double(lo), double(hi)};
}

/// Smallest and largest finite value; {0, 0} if there is none.
ValueRange finite_range(const Volume& volume, const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    const std::int64_t slice = std::int64_t(size.x) * size.y;
    std::vector<ValueRange> slices(std::size_t(size.z));
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        const T* values = volume.view<T>().data;
        parallel_for(
            0, size.z, [&](std::int64_t z) { slices[std::size_t(z)] = range_of_band(values + z * slice, slice); }, job);
    });
    ValueRange range = slices.front();
    for (const ValueRange& r : slices) range = {std::min(range.lo, r.lo), std::max(range.hi, r.hi)};
    return range.lo <= range.hi ? range : ValueRange{};
}

std::string describe_adjacency(Connectivity connectivity) {
    const int cavities = connectivity == Connectivity::c6 ? 26 : 6;
    return "regions " + std::to_string(int(connectivity)) + "-connected, cavities " + std::to_string(cavities) +
           "-connected";
}

}  // namespace

RegionTable find_regions(const Volume& volume, const RegionOptions& options, const JobContext& job) {
    check_options(volume, options);
    RegionTable table;
    table.made_with = options;
    table.value_range = finite_range(volume, job.part(0, 0.03));
    if (options.range_width) {
        labelling::ProvisionalLabels provisional = labelling::grow_regions(
            volume, *options.range_width * table.value_range.width(), options, job.part(0.03, 0.5));
        labelling::number_by_size(provisional, options.min_voxels, job.part(0.5, 0.55));
        table.labels = {volume.geometry(), provisional.labels};
    } else {
        table.labels = {volume.geometry(), labelling::label_components(volume, options, job.part(0.03, 0.55))};
    }
    if (options.merge_slivers) labelling::merge_slivers(volume, options, *table.labels.labels, job.part(0.55, 0.6));
    table.rows = measure_regions(volume, table.labels, options.connectivity, job.part(0.6, 1));
    table.surface_method = "Crofton's formula, 13 directions, weighted for the voxel spacing";
    table.adjacency = describe_adjacency(options.connectivity);
    return table;
}

HomogeneousRegions grow_homogeneous_regions(const Volume& volume, const RegionOptions& options, const JobContext& job) {
    check_options(volume, options);
    if (!options.range_width) throw Error(Errc::bad_usage, "Homogeneous regions need a range width, not a threshold.");
    HomogeneousRegions made;
    made.value_range = finite_range(volume, job.part(0, 0.04));
    labelling::ProvisionalLabels provisional =
        labelling::grow_regions(volume, *options.range_width * made.value_range.width(), options, job.part(0.04, 0.9));
    labelling::number_by_size(provisional, options.min_voxels, job.part(0.9, 1));
    made.labels = {volume.geometry(), provisional.labels};
    made.mean = std::move(provisional.mean);
    return made;
}

std::vector<std::uint8_t> region_mask(const LabelVolume& labels, const RegionCharacteristics& region) {
    check_box(labels, region);
    const glm::ivec3 first = region.bbox_first, extent = region.bbox_last - first + 1;
    std::vector<std::uint8_t> mask(std::size_t(std::int64_t(extent.x) * extent.y * extent.z));
    std::uint8_t* out = mask.data();
    for (int z = 0; z < extent.z; ++z)
        for (int y = 0; y < extent.y; ++y) {
            const std::uint32_t* row =
                labels.labels->data() + labels.geometry.linear_index(first.x, first.y + y, first.z + z);
            for (int x = 0; x < extent.x; ++x) *out++ = row[x] == region.id;
        }
    return mask;
}

}  // namespace lacuna
