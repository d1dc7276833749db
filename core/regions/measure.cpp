#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <unordered_map>

#include "core/base/parallel.h"
#include "core/regions/labelling.h"
#include "core/regions/neighbourhood.h"
#include "core/regions/principal_axes.h"
#include "core/regions/regions.h"
#include "core/regions/topology.h"

namespace lacuna {

namespace {

using neighbourhood::LocalMeasures;

/// Sums of one region. Counts and coordinates are whole numbers; values are summed against `shift`, one of the region's
/// own, so that a large offset costs no digits.
struct Sums {
    std::int64_t voxels = 0, x = 0, y = 0, z = 0;
    std::int64_t xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
    std::int64_t surface = 0, euler = 0;
    glm::ivec3 first{std::numeric_limits<int>::max()}, last{-1};
    double shift = 0, value = 0, square = 0;
    double min = std::numeric_limits<double>::infinity(), max = -std::numeric_limits<double>::infinity();

    void merge(const Sums& other) {
        if (voxels == 0) {
            *this = other;
            return;
        }
        const double delta = other.shift - shift;
        value += other.value + double(other.voxels) * delta;
        square += other.square + 2 * delta * other.value + double(other.voxels) * delta * delta;
        voxels += other.voxels, x += other.x, y += other.y, z += other.z;
        xx += other.xx, yy += other.yy, zz += other.zz, xy += other.xy, xz += other.xz, yz += other.yz;
        surface += other.surface, euler += other.euler;
        first = glm::min(first, other.first), last = glm::max(last, other.last);
        min = std::min(min, other.min), max = std::max(max, other.max);
    }
};

/// Bit k of the result: earlier neighbour k has the centre's label; bit 13 + k: its opposite has.
/// @param row  the 9 rows round the centre row, (dz + 1) * 3 + dy + 1
inline std::uint32_t same_label(const std::uint32_t* const* row, std::int64_t x) {
    const std::uint32_t c = row[4][x];
    const auto bit = [c](std::uint32_t other, int k) { return std::uint32_t(other == c) << k; };
    return bit(row[0][x - 1], 0) | bit(row[0][x], 1) | bit(row[0][x + 1], 2) | bit(row[1][x - 1], 3) |
           bit(row[1][x], 4) | bit(row[1][x + 1], 5) | bit(row[2][x - 1], 6) | bit(row[2][x], 7) |
           bit(row[2][x + 1], 8) | bit(row[3][x - 1], 9) | bit(row[3][x], 10) | bit(row[3][x + 1], 11) |
           bit(row[4][x - 1], 12) | bit(row[8][x + 1], 13) | bit(row[8][x], 14) | bit(row[8][x - 1], 15) |
           bit(row[7][x + 1], 16) | bit(row[7][x], 17) | bit(row[7][x - 1], 18) | bit(row[6][x + 1], 19) |
           bit(row[6][x], 20) | bit(row[6][x - 1], 21) | bit(row[5][x + 1], 22) | bit(row[5][x], 23) |
           bit(row[5][x - 1], 24) | bit(row[4][x + 1], 25);
}

/// The sums of the regions met in one band of slices, in the order met.
struct Band {
    std::vector<std::uint32_t> slot_of;  // per id: 1 + index into sums, 0 if not met
    std::vector<std::uint32_t> ids;
    std::vector<Sums> sums;

    Sums& of(std::uint32_t id) {
        if (slot_of[id] == 0) {
            ids.push_back(id);
            sums.emplace_back();
            slot_of[id] = std::uint32_t(sums.size());
        }
        return sums[slot_of[id] - 1];
    }
    void clear() {
        for (const std::uint32_t id : ids) slot_of[id] = 0;
        ids.clear();
        sums.clear();
    }
};

template <class T>
class BandMeasurer {
public:
    BandMeasurer(const T* values, const std::uint32_t* labels, const glm::ivec3& size, const LocalMeasures& local)
        : values_(values),
          labels_(labels),
          size_(size),
          local_(local),
          outside_(std::size_t(size.x), labelling::k_never),
          same_(std::size_t(size.x)) {}

    void measure(int first_z, int last_z, Band& band, const JobContext& job) {
        for (int z = first_z; z < last_z; ++z) {
            job.check();
            for (int y = 0; y < size_.y; ++y) measure_row(y, z, band);
        }
    }

private:
    const std::uint32_t* label_row(int y, int z) const {
        if (y < 0 || z < 0 || y >= size_.y || z >= size_.z) return outside_.data();
        return labels_ + (std::int64_t(z) * size_.y + y) * size_.x;
    }

    void measure_row(int y, int z, Band& band) {
        const std::uint32_t* centre = label_row(y, z);
        int first = 0, last = size_.x - 1;
        while (first <= last && centre[first] == 0) ++first;
        if (first > last) return;
        while (centre[last] == 0) --last;
        compare_neighbours(y, z, first, last);
        const T* values = values_ + (std::int64_t(z) * size_.y + y) * size_.x;
        for (int x = first; x <= last;) {
            const std::uint32_t id = centre[x];
            int end = x + 1;
            while (end <= last && centre[end] == id) ++end;
            if (id != 0) {
                Sums& sums = band.of(id);
                add_positions(sums, x, end - 1, y, z);
                add_values(sums, values + x, end - x);
                add_local(sums, x, end);
            }
            x = end;
        }
    }

    void compare_neighbours(int y, int z, int first, int last) {
        const std::uint32_t* row[9];
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) row[(dz + 1) * 3 + dy + 1] = label_row(y + dy, z + dz);
        const int inner_end = std::min(last, size_.x - 2);
        std::uint32_t* __restrict same = same_.data();
        for (int x = std::max(first, 1); x <= inner_end; ++x) same[x] = same_label(row, x);
        if (first == 0) same[0] = same_at_end(row, 0);
        if (last == size_.x - 1) same[last] = same_at_end(row, last);
    }

    /// The first and last voxel of a row have no neighbour on one side, or on both.
    std::uint32_t same_at_end(const std::uint32_t* const* row, int x) const {
        std::uint32_t padded[9][3];
        const std::uint32_t* pointer[9];
        for (int r = 0; r < 9; ++r) {
            for (int dx = -1; dx <= 1; ++dx)
                padded[r][dx + 1] = x + dx < 0 || x + dx >= size_.x ? labelling::k_never : row[r][x + dx];
            pointer[r] = padded[r];
        }
        return same_label(pointer, 1);
    }

    static void add_positions(Sums& s, std::int64_t a, std::int64_t b, std::int64_t y, std::int64_t z) {
        const auto squares_to = [](std::int64_t n) { return n * (n + 1) * (2 * n + 1) / 6; };
        const std::int64_t n = b - a + 1, x = (a + b) * n / 2;
        s.voxels += n, s.x += x, s.y += n * y, s.z += n * z;
        s.xx += squares_to(b) - squares_to(a - 1), s.yy += n * y * y, s.zz += n * z * z;
        s.xy += x * y, s.xz += x * z, s.yz += n * y * z;
        s.first = glm::min(s.first, glm::ivec3(a, y, z));
        s.last = glm::max(s.last, glm::ivec3(b, y, z));
    }

    static void add_values(Sums& s, const T* values, int count) {
        if (s.min > s.max) s.shift = double(values[0]);
        T lo = values[0], hi = values[0];
        using Sum = std::conditional_t<std::is_integral_v<T>, std::int64_t, double>;
        Sum value = 0, square = 0;
        const Sum shift = Sum(s.shift);
        for (int i = 0; i < count; ++i) {
            const Sum d = Sum(values[i]) - shift;
            value += d;
            square += d * d;
            lo = std::min(lo, values[i]);
            hi = std::max(hi, values[i]);
        }
        s.value += double(value);
        s.square += double(square);
        s.min = std::min(s.min, double(lo));
        s.max = std::max(s.max, double(hi));
    }

    void add_local(Sums& s, int x, int end) const {
        for (; x < end; ++x) {
            const std::uint32_t same = same_[std::size_t(x)];
            if (same == neighbourhood::k_surrounded) continue;
            s.surface += local_.surface(same);
            s.euler += local_.euler(same);
        }
    }

    const T* values_;
    const std::uint32_t* labels_;
    glm::ivec3 size_;
    const LocalMeasures& local_;
    std::vector<std::uint32_t> outside_, same_;
};

/// Bands are cut by the volume alone and merged in their order: the same bits for any number of threads.
std::vector<Sums> sum_regions(const Volume& volume, const std::uint32_t* labels, std::uint32_t ids,
                              const LocalMeasures& local, const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    const int bands = std::min(size.z, 64), at_once = std::min(thread_count(), bands);
    std::vector<Sums> total(std::size_t(ids) + 1);
    std::vector<Band> slots(static_cast<std::size_t>(at_once));
    for (Band& slot : slots) slot.slot_of.assign(std::size_t(ids) + 1, 0);
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        for (int round = 0; round < bands; round += at_once) {
            const int count = std::min(at_once, bands - round);
            parallel_for(
                0, count,
                [&](std::int64_t i) {
                    const std::int64_t band = round + i;
                    BandMeasurer<T>(volume.view<T>().data, labels, size, local)
                        .measure(int(size.z * band / bands), int(size.z * (band + 1) / bands), slots[std::size_t(i)],
                                 job);
                },
                JobContext{job.stop, nullptr});
            for (int i = 0; i < count; ++i) {
                Band& slot = slots[std::size_t(i)];
                for (std::size_t k = 0; k < slot.ids.size(); ++k) total[slot.ids[k]].merge(slot.sums[k]);
                slot.clear();
            }
            job.checkpoint(std::size_t(round + count), std::size_t(bands));
        }
    });
    return total;
}

/// An axis of one voxel has no inside a region could keep to: its two ends are no border, where there is another axis.
bool touches_border(const Sums& sums, const glm::ivec3& size) {
    bool any_axis = false, touches = false;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] == 1) continue;
        any_axis = true;
        touches = touches || sums.first[axis] == 0 || sums.last[axis] == size[axis] - 1;
    }
    return touches || !any_axis;
}

void set_box(RegionCharacteristics& row, const Sums& sums, const GridGeometry& geometry) {
    row.bbox_first = sums.first;
    row.bbox_last = sums.last;
    row.bbox_min_mm = glm::dvec3(std::numeric_limits<double>::infinity());
    row.bbox_max_mm = -row.bbox_min_mm;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const glm::dvec3 mm =
            geometry.voxel_to_mm(glm::mix(glm::dvec3(sums.first) - 0.5, glm::dvec3(sums.last) + 0.5, side));
        row.bbox_min_mm = glm::min(row.bbox_min_mm, mm);
        row.bbox_max_mm = glm::max(row.bbox_max_mm, mm);
    }
    row.touches_border = touches_border(sums, geometry.size);
}

void set_shape(RegionCharacteristics& row, const Sums& sums, const GridGeometry& geometry, double surface_unit_mm2) {
    constexpr double pi = std::numbers::pi;
    row.voxels = sums.voxels;
    row.volume_mm3 = double(sums.voxels) * geometry.voxel_volume_mm3();
    row.equivalent_diameter_mm = std::cbrt(6 * row.volume_mm3 / pi);
    const double ball_mm2 = pi * row.equivalent_diameter_mm * row.equivalent_diameter_mm;
    row.surface_mm2 = row.surface_crofton_mm2 = double(sums.surface) * surface_unit_mm2;
    row.shape_factor = row.surface_mm2 / row.volume_mm3 * row.surface_mm2 / row.volume_mm3 * row.surface_mm2;
    row.sphericity = ball_mm2 / row.surface_mm2;
    if (row.surface_mm2 > ball_mm2) {
        row.shape_factor = std::max(row.shape_factor, 36 * pi);
        row.sphericity = std::min(row.sphericity, 1.0);
        return;
    }
    row.surface_mm2 = ball_mm2;  // no body has less surface than the ball of its volume
    row.shape_factor = 36 * pi;
    row.sphericity = 1;
    row.flags.emplace_back("surface_clamped");
}

void set_moments(RegionCharacteristics& row, const Sums& sums, const GridGeometry& geometry) {
    const double n = double(sums.voxels);
    const glm::dvec3 mean = glm::dvec3(sums.x, sums.y, sums.z) / n, h = geometry.spacing;
    row.centroid_mm = geometry.voxel_to_mm(mean);
    // A voxel is a cell, not a point: 1/12 of its edge squared along each axis.
    const SymmetricMatrix moments{
        .xx = (double(sums.xx) / n - mean.x * mean.x + 1.0 / 12) * h.x * h.x,
        .yy = (double(sums.yy) / n - mean.y * mean.y + 1.0 / 12) * h.y * h.y,
        .zz = (double(sums.zz) / n - mean.z * mean.z + 1.0 / 12) * h.z * h.z,
        .xy = (double(sums.xy) / n - mean.x * mean.y) * h.x * h.y,
        .xz = (double(sums.xz) / n - mean.x * mean.z) * h.x * h.z,
        .yz = (double(sums.yz) / n - mean.y * mean.z) * h.y * h.z,
    };
    const glm::dvec3 eigenvalues = eigenvalues_descending(moments);
    for (int axis = 0; axis < 3; ++axis)
        row.principal_lengths_mm[axis] = 2 * std::sqrt(5 * std::max(0.0, eigenvalues[axis]));
}

void set_values(RegionCharacteristics& row, const Sums& sums) {
    const double n = double(sums.voxels);
    row.mean = sums.shift + sums.value / n;
    row.min = sums.min;
    row.max = sums.max;
    if (row.min <= row.max) row.mean = std::clamp(row.mean, row.min, row.max);  // else no voxel has a value
    row.stddev = std::sqrt(std::max(0.0, (sums.square - sums.value * sums.value / n) / n));
}

void set_topology(std::vector<RegionCharacteristics>& rows, const std::uint32_t* labels, std::uint32_t ids,
                  const glm::ivec3& size, Connectivity connectivity, const JobContext& job) {
    std::vector<std::uint8_t> candidate(std::size_t(ids) + 1, 0);
    for (const RegionCharacteristics& row : rows)
        candidate[row.id] = topology::can_enclose(row.voxels, row.bbox_last - row.bbox_first + 1, connectivity);
    const std::vector<std::uint32_t> cavities = topology::count_cavities(labels, size, candidate, connectivity, job);
    for (RegionCharacteristics& row : rows) {
        row.holes = cavities[row.id];
        row.tunnels = 1 + row.holes - row.euler;
        if (row.tunnels >= 0) continue;
        row.tunnels = 0;  // only where regions cross each other at edges, or a label is not connected
        row.flags.emplace_back("topology_unsure");
    }
}

/// The labels with ids 1..n in the order of the ids found, for ids too large to index by.
std::vector<std::uint32_t> compact_ids(const std::vector<std::uint32_t>& labels, std::vector<std::uint32_t>& names) {
    std::unordered_map<std::uint32_t, std::uint32_t> index;
    for (const std::uint32_t id : labels)
        if (id != 0) index.emplace(id, 0);
    names.assign(1, 0);
    for (const auto& entry : index) names.push_back(entry.first);
    std::sort(names.begin(), names.end());
    for (std::size_t i = 1; i < names.size(); ++i) index[names[i]] = std::uint32_t(i);
    std::vector<std::uint32_t> compact(labels.size(), 0);
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] != 0) compact[i] = index[labels[i]];
    return compact;
}

std::vector<RegionCharacteristics> measure_ids(const Volume& volume, const std::uint32_t* labels, std::uint32_t ids,
                                               Connectivity connectivity, const JobContext& job) {
    const GridGeometry& geometry = volume.geometry();
    const LocalMeasures local(geometry.spacing, connectivity);
    std::vector<RegionCharacteristics> rows;
    {
        const std::vector<Sums> total = sum_regions(volume, labels, ids, local, job.part(0, 0.7));
        std::int64_t all = 0;
        for (const Sums& sums : total) all += sums.voxels;
        rows.reserve(std::size_t(std::count_if(total.begin(), total.end(), [](const Sums& s) { return s.voxels; })));
        for (std::uint32_t id = 1; id <= ids; ++id) {
            const Sums& sums = total[id];
            if (sums.voxels == 0) continue;
            RegionCharacteristics& row = rows.emplace_back();
            row.id = id;
            row.euler = sums.euler;
            row.fraction = double(sums.voxels) / double(all);
            set_box(row, sums, geometry);
            set_shape(row, sums, geometry, local.surface_unit_mm2());
            set_moments(row, sums, geometry);
            set_values(row, sums);
        }
    }
    set_topology(rows, labels, ids, geometry.size, connectivity, job.part(0.7, 1));
    return rows;
}

}  // namespace

std::vector<RegionCharacteristics> measure_regions(const Volume& volume, const LabelVolume& labels,
                                                   Connectivity connectivity, const JobContext& job) {
    const std::int64_t count = volume.geometry().voxel_count();
    if (volume.empty() || labels.geometry.size != volume.geometry().size || !labels.labels ||
        std::int64_t(labels.labels->size()) != count)
        throw Error(Errc::bad_input, "The labels do not lie on the volume's grid; make them from this volume.");
    const std::vector<std::uint32_t>& ids = *labels.labels;
    const std::uint32_t largest = *std::max_element(ids.begin(), ids.end());
    if (largest <= labelling::k_most_regions) return measure_ids(volume, ids.data(), largest, connectivity, job);

    std::vector<std::uint32_t> names;
    const std::vector<std::uint32_t> compact = compact_ids(ids, names);
    auto rows = measure_ids(volume, compact.data(), std::uint32_t(names.size() - 1), connectivity, job);
    for (RegionCharacteristics& row : rows) row.id = names[row.id];
    return rows;
}

}  // namespace lacuna
