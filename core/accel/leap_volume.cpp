#include "core/accel/leap_volume.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "core/base/parallel.h"
#include "core/regions/regions.h"

namespace lacuna {

namespace {

constexpr int k_units_a_voxel = 8;      // of the smallest spacing
constexpr int k_most_code = 32767;      // of 15 bits
constexpr double k_rounding_mm = 0.01;  // of the smallest spacing: how far single precision may place a sample wrongly
constexpr int k_class_bits = 4;         // of the labels, for voxel classes

void check_options(const Volume& volume, const LeapOptions& options) {
    if (!(options.range_width >= 0 && options.range_width <= 1))
        throw Error(Errc::bad_usage, "The homogeneity of leaping is a share of the value range: give 0 to 1.");
    if (!(options.step_mm > 0 && std::isfinite(options.step_mm)))
        throw Error(Errc::bad_usage, "Leaping needs the sampling step it prepares for, in mm and above 0.");
    if (!(options.groups.probability >= 0 && options.groups.probability <= 1) ||
        !(options.groups.relative_radius >= 0 && options.groups.relative_radius <= 1))
        throw Error(Errc::bad_usage, "The probability and relative radius of centre-voxel groups must lie in 0 to 1.");
    if (volume.type() != VoxelType::f32) return;
    if (!options.quantisation)
        throw Error(Errc::bad_usage,
                    "Leaping keeps densities of 15 bits, and this volume has f32 values: state the range to quantise "
                    "(--leap-quantise LO,HI), or use the structure macrocells, octree, pyramid, pc, acd or eacd.");
    if (!(options.quantisation->lo < options.quantisation->hi) || !std::isfinite(options.quantisation->width()))
        throw Error(Errc::bad_usage, "The lower end of the range to quantise must be below its upper end.");
}

/// An f32 volume as codes 0..32766; NaN and infinite values as 32767, which counts for the codes' range too.
Volume quantised(const Volume& volume, ValueRange range, const JobContext& job) {
    VoxelBuffer codes(std::size_t(volume.geometry().voxel_count()) * sizeof(std::uint16_t));
    auto* out = reinterpret_cast<std::uint16_t*>(codes.data());
    const float* in = volume.view<float>().data;
    const double scale = (k_leap_nan - 1) / range.width();
    parallel_bands(
        0, volume.geometry().voxel_count(), 64,
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t i = first; i < last; ++i) {
                const double code = std::clamp((double(in[i]) - range.lo) * scale, 0.0, double(k_leap_nan - 1));
                out[i] = std::isfinite(in[i]) ? std::uint16_t(std::lround(code)) : k_leap_nan;
            }
        },
        job);
    return Volume(volume.geometry(), VoxelType::u16, std::move(codes));
}

/// Cuts the labels where the voxels' classes change: the class goes into the lowest bits.
void cut_by_class(std::vector<std::uint32_t>& labels, const std::uint8_t* voxel_class, const JobContext& job) {
    parallel_bands(
        0, std::int64_t(labels.size()), 64,
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t i = first; i < last; ++i) {
                std::uint32_t& label = labels[std::size_t(i)];
                const std::uint32_t mask = (1u << k_class_bits) - 1;
                if (label != 0) label = label << k_class_bits | std::min<std::uint32_t>(voxel_class[i], mask);
            }
        },
        job);
}

/// Everything the entries are made from.
struct Layout {
    LabelGrid grid;
    int label_shift = 0;  ///< from a label to its region
    const std::vector<double>& mean;
    int radius = 0, margin = 0;  ///< units
    glm::ivec3 border{0};        ///< voxels from the volume's border that are guards
};

/// Turns distances in `entries` into leap voxels, guards and densities; counts leap voxels and those of regions.
/// @param code  of a value, 0..32767
template <class T, class Code>
void fill_entries(const T* voxels, const Layout& layout, const Code& code, LeapVolume& made, const JobContext& job) {
    const glm::ivec3 n = layout.grid.size;
    auto* entries = reinterpret_cast<std::uint16_t*>(made.entries.data());
    std::atomic<std::int64_t> leaps = 0, in_regions = 0;
    const auto at_border = [](int i, int size, int border) { return i < border || i >= size - border; };
    parallel_for(
        0, n.z,
        [&](std::int64_t z) {
            std::int64_t leaps_here = 0, here = 0;
            for (int y = 0; y < n.y; ++y) {
                const std::int64_t row = (z * n.y + y) * n.x;
                const bool guards = at_border(int(z), n.z, layout.border.z) || at_border(y, n.y, layout.border.y);
                const std::uint32_t* labels = layout.grid.labels + row;
                for (int x = 0; x < n.x; ++x) {
                    std::uint16_t& entry = entries[row + x];
                    if (labels[x] == 0) {
                        entry = code(double(voxels[row + x]));
                        continue;
                    }
                    ++here;
                    if (entry > layout.radius && !guards && !at_border(x, n.x, layout.border.x)) {
                        entry = std::uint16_t(k_leap_bit | (entry - layout.margin));
                        ++leaps_here;
                    } else {
                        entry = code(layout.mean[labels[x] >> layout.label_shift]);
                    }
                }
            }
            leaps += leaps_here;
            in_regions += here;
        },
        job);
    made.leap_voxels = leaps;
    made.region_voxels = in_regions;
}

/// The volume with each region at its average, in its own type.
template <class T>
Volume flattened(const Volume& volume, const Layout& layout, const JobContext& job) {
    const T* in = volume.view<T>().data;
    const std::vector<double>& mean = layout.mean;
    std::vector<T> rounded(mean.size());
    std::transform(mean.begin(), mean.end(), rounded.begin(), [](double m) { return T(std::lround(m)); });
    VoxelBuffer buffer(volume.bytes());
    auto* out = reinterpret_cast<T*>(buffer.data());
    parallel_bands(
        0, volume.geometry().voxel_count(), 64,
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t i = first; i < last; ++i) {
                const std::uint32_t label = layout.grid.labels[i];
                out[i] = label == 0 ? in[i] : rounded[label >> layout.label_shift];
            }
        },
        job);
    return Volume(volume.geometry(), volume.type(), std::move(buffer));
}

/// The f32 volume that codes stand for, its regions at their averages.
Volume dequantised(const Volume& volume, const Volume& codes, const Layout& layout, const LeapVolume& made,
                   const JobContext& job) {
    const std::uint16_t* in = codes.view<std::uint16_t>().data;
    VoxelBuffer buffer(volume.bytes());
    auto* out = reinterpret_cast<float*>(buffer.data());
    parallel_bands(
        0, volume.geometry().voxel_count(), 64,
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t i = first; i < last; ++i) {
                const std::uint32_t label = layout.grid.labels[i];
                const double code = label == 0 ? in[i] : std::round(layout.mean[label >> layout.label_shift]);
                out[i] = code == k_leap_nan ? std::nanf("") : float(made.value_lo + code * made.value_scale);
            }
        },
        job);
    return Volume(volume.geometry(), VoxelType::f32, std::move(buffer));
}

/// Distances to the nearest voxel of another label, in the entries.
void find_distances(const Layout& layout, std::uint32_t labels, const LeapOptions& options, LeapVolume& made,
                    const JobContext& job) {
    auto* entries = reinterpret_cast<std::uint16_t*>(made.entries.data());
    if (options.way == LeapWay::transform) return exact_distances(layout.grid, made.unit_mm, entries, job);
    const BoundaryList boundary = boundary_list(layout.grid, labels, job.part(0, 0.1));
    classify_by_neighbours(layout.grid, boundary, made.unit_mm, layout.radius, entries, job.part(0.1, 0.2));
    const JobContext rest = job.part(0.2, 1);
    if (options.way == LeapWay::kd_tree) return tree_distances(layout.grid, boundary, made.unit_mm, entries, rest);
    group_distances(layout.grid, boundary, made.unit_mm, layout.radius, options.groups, entries, rest);
}

void place_guards(const GridGeometry& geometry, const LeapOptions& options, Layout& layout, LeapVolume& made) {
    const glm::dvec3 s = geometry.spacing;
    const double smallest = geometry.smallest_spacing_mm(), diagonal = glm::length(s);
    made.unit_mm = smallest / k_units_a_voxel;
    made.step_mm = options.step_mm;
    // A ray anywhere in the voxel's cell, half a diagonal from its centre, reads voxels less than a diagonal away.
    const double margin_mm = 1.5 * diagonal + k_rounding_mm * smallest;
    layout.margin = std::min(int(std::ceil(margin_mm / made.unit_mm)), k_leap_limit);
    made.radius_mm = 2 * (diagonal + options.step_mm) + k_rounding_mm * smallest;
    layout.radius = int(std::min(std::ceil(made.radius_mm / made.unit_mm), double(k_leap_limit)));
    const glm::dvec3 deep = glm::ceil(2 * options.step_mm / s) + 1.0;
    layout.border = glm::ivec3(glm::min(deep, glm::dvec3(geometry.size)));
}

template <class T>
void finish(const Volume& volume, const Layout& layout, const LeapOptions& options, LeapVolume& made,
            const JobContext& job) {
    const auto code = [&](double value) {
        return std::uint16_t(std::clamp((value - made.value_lo) / made.value_scale + 0.5, 0.0, double(k_most_code)));
    };
    fill_entries(volume.view<T>().data, layout, code, made, job.part(0, 0.6));
    if (!options.flatten) return;
    made.flat = options.range_width > 0 ? flattened<T>(volume, layout, job.part(0.6, 1)) : volume;
}

}  // namespace

LeapVolume build_leap_volume(const Volume& volume, const LeapOptions& options, const JobContext& job) {
    check_options(volume, options);
    const bool is_float = volume.type() == VoxelType::f32;
    const Volume whole = is_float ? quantised(volume, *options.quantisation, job.part(0, 0.05)) : volume;

    RegionOptions growing;
    growing.range_width = options.range_width;
    if (is_float && options.range_width > 0) {  // a share of what is stated, not of the codes that occur
        const auto codes = whole.view<std::uint16_t>().voxels();
        const auto [least, most] = std::minmax_element(codes.begin(), codes.end());
        const double width = std::max(1, *most - *least);
        growing.range_width = std::min(1.0, options.range_width * (k_leap_nan - 1) / width);
    }
    growing.min_voxels = std::max<std::int64_t>(1, options.min_voxels);
    if (is_float) growing.background = ValueRange{k_leap_nan, k_leap_nan};
    const HomogeneousRegions regions = grow_homogeneous_regions(whole, growing, job.part(0.05, 0.6));

    LeapVolume made;
    made.size = volume.geometry().size;
    made.regions = std::int64_t(regions.mean.size()) - 1;
    made.value_lo = is_float ? options.quantisation->lo : regions.value_range.lo;
    made.value_scale = is_float ? options.quantisation->width() / (k_leap_nan - 1)
                                : std::max(1.0, regions.value_range.width() / k_most_code);
    Layout layout{.grid = {made.size, volume.geometry().spacing, regions.labels.labels->data()}, .mean = regions.mean};
    auto labels = std::uint32_t(made.regions);
    if (options.voxel_class) {
        cut_by_class(*regions.labels.labels, options.voxel_class, job.part(0.6, 0.62));
        layout.label_shift = k_class_bits;
        labels = (labels + 1) << k_class_bits;
    }
    place_guards(volume.geometry(), options, layout, made);
    made.entries = VoxelBuffer(std::size_t(volume.geometry().voxel_count()) * sizeof(std::uint16_t));
    find_distances(layout, labels, options, made, job.part(0.62, 0.9));

    const JobContext last = job.part(0.9, 1);
    if (is_float) {
        fill_entries(
            whole.view<std::uint16_t>().data, layout, [](double v) { return std::uint16_t(std::lround(v)); }, made,
            last.part(0, 0.6));
        if (options.flatten) made.flat = dequantised(volume, whole, layout, made, last.part(0.6, 1));
        return made;
    }
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        if constexpr (std::is_integral_v<T>) finish<T>(volume, layout, options, made, last);
    });
    return made;
}

}  // namespace lacuna
