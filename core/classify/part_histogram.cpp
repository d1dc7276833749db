#include "core/classify/part_histogram.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr glm::ivec2 k_joint_bins{256, 1024};  // along magnitudes over all that could be, cut to those that are
constexpr int k_most_rows = 256;

void require_memory(const Volume& volume) {
    if (!volume.in_memory())
        throw Error(Errc::unsupported,
                    "This volume does not lie in memory, where its values could be counted again; crop it, or raise "
                    "the memory limit.");
}

/// The voxels of a part, row by row.
template <class T>
class PartRows {
public:
    PartRows(const Volume& volume, const VolumePart& part)
        : view_(volume.view<T>()), geometry_(volume.geometry()), part_(part) {}

    /// visit(x, value) for the voxels of one row that count.
    template <class Visit>
    void for_each(int y, int z, Visit&& visit) const {
        const auto [first, end] = kept(y, z);
        const T* row = view_.row(y, z);
        for (int x = first; x < end; ++x) {
            const double value = double(row[x]);
            if (std::isfinite(value) && in_ranges(value)) visit(x, value);
        }
    }

private:
    /// The stretch of a row inside all half-spaces: along a row each is a function linear in x.
    std::pair<int, int> kept(int y, int z) const {
        int first = 0, end = view_.size.x;
        const glm::dvec3 from = geometry_.voxel_to_mm({0, double(y), double(z)});
        const glm::dvec3 along = geometry_.voxel_to_mm({1, double(y), double(z)}) - from;
        for (const glm::dvec4& h : part_.half_spaces) {
            const double at = glm::dot(glm::dvec3(h), from) + h.w, slope = glm::dot(glm::dvec3(h), along);
            while (first < end && !(at + first * slope >= 0)) ++first;
            while (end > first && !(at + (end - 1) * slope >= 0)) --end;
        }
        return {first, end};
    }
    bool in_ranges(double value) const {
        return part_.ranges.empty() || std::any_of(part_.ranges.begin(), part_.ranges.end(),
                                                   [&](const ValueRange& r) { return r.contains(value); });
    }

    VolumeView<T> view_;
    const GridGeometry& geometry_;
    const VolumePart& part_;
};

/// Sums what visit(rows, y, z, counts) counts over all rows; every band of slices counts for itself.
template <class Visit>
std::vector<std::uint64_t> count_rows(glm::ivec3 size, std::size_t bins, const JobContext& job, Visit&& visit) {
    std::vector<std::uint64_t> sum(bins, 0);
    std::mutex mutex;
    const int bands = std::clamp(size.z / 4, 1, 16 * thread_count());
    parallel_bands(
        0, size.z, bands,
        [&](std::int64_t first, std::int64_t last) {
            std::vector<std::uint64_t> counts(bins, 0);
            for (std::int64_t z = first; z < last; ++z) {
                job.check();
                for (int y = 0; y < size.y; ++y) visit(y, int(z), counts);
            }
            std::lock_guard lock(mutex);  // whole numbers: the order of adding cannot be seen
            for (std::size_t b = 0; b < bins; ++b) sum[b] += counts[b];
        },
        job);
    return sum;
}

/// Index of a value's bin.
struct Bins {
    ValueRange range;
    std::size_t count;
    std::size_t of(double value) const {
        const double at = (value - range.lo) / range.width() * double(count);
        return std::size_t(std::clamp(at >= 0 ? at : 0.0, 0.0, double(count - 1)));
    }
};

Bins bins_of(const VolumeStatistics& statistics, std::size_t count) {
    const ValueRange range = statistics.histogram_range;
    return {range.width() > 0 ? range : ValueRange{range.lo - 0.5, range.lo + 0.5}, std::max<std::size_t>(count, 1)};
}

/// Gradient magnitude at a voxel, units per mm; 0 where a neighbour is not finite.
template <class T>
double magnitude_at(const VolumeView<T>& view, const glm::dvec3& per_mm, int x, int y, int z) {
    const glm::ivec3 last = view.size - 1;
    const auto difference = [](T a, T b) { return double(b) - double(a); };
    const glm::dvec3 g(difference(view(std::max(x - 1, 0), y, z), view(std::min(x + 1, last.x), y, z)),
                       difference(view(x, std::max(y - 1, 0), z), view(x, std::min(y + 1, last.y), z)),
                       difference(view(x, y, std::max(z - 1, 0)), view(x, y, std::min(z + 1, last.z))));
    const double length = glm::length(g * per_mm);
    return std::isfinite(length) ? length : 0;
}

/// Leaves out the rows above the last that is used, and joins rows until no more than k_most_rows are left.
void fit_rows(JointHistogram& joint) {
    const auto width = std::size_t(joint.bins.x);
    const auto last = std::find_if(joint.counts.rbegin(), joint.counts.rend(), [](auto n) { return n > 0; });
    const std::size_t used = std::max<std::size_t>(1, (std::size_t(joint.counts.rend() - last) + width - 1) / width);
    const std::size_t joined = (used + k_most_rows - 1) / k_most_rows, rows = (used + joined - 1) / joined;
    std::vector<std::uint64_t> counts(rows * width, 0);
    for (std::size_t row = 0; row < used; ++row)
        for (std::size_t x = 0; x < width; ++x) counts[row / joined * width + x] += joint.counts[row * width + x];
    joint.magnitudes.hi *= double(rows * joined) / joint.bins.y;
    joint.bins.y = int(rows);
    joint.counts = std::move(counts);
}

}  // namespace

std::vector<std::uint64_t> part_histogram(const Volume& volume, const VolumeStatistics& statistics,
                                          const VolumePart& part, const JobContext& job) {
    if (part.whole()) return statistics.histogram;
    require_memory(volume);
    if (statistics.histogram.empty()) return {};
    const Bins bins = bins_of(statistics, statistics.histogram.size());
    return visit_type(volume.type(), [&](auto tag) {
        const PartRows<decltype(tag)> rows(volume, part);
        return count_rows(volume.geometry().size, bins.count, job, [&](int y, int z, auto& counts) {
            rows.for_each(y, z, [&](int, double value) { ++counts[bins.of(value)]; });
        });
    });
}

JointHistogram joint_histogram(const Volume& volume, const VolumeStatistics& statistics, const VolumePart& part,
                               const JobContext& job) {
    require_memory(volume);
    const glm::dvec3 per_mm = 0.5 / volume.geometry().spacing;
    const Bins values = bins_of(statistics, std::size_t(k_joint_bins.x));
    const double steepest = statistics.range.width() * glm::length(per_mm);  // no difference can be larger
    const Bins magnitudes{{0, steepest > 0 ? steepest : 1.0}, std::size_t(k_joint_bins.y)};
    JointHistogram joint{values.range, magnitudes.range, k_joint_bins, {}};
    joint.counts = visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        const PartRows<T> rows(volume, part);
        const VolumeView<T> view = volume.view<T>();
        return count_rows(view.size, values.count * magnitudes.count, job, [&](int y, int z, auto& counts) {
            rows.for_each(y, z, [&](int x, double value) {
                const double magnitude = magnitude_at(view, per_mm, x, y, z);
                ++counts[magnitudes.of(magnitude) * values.count + values.of(value)];
            });
        });
    });
    fit_rows(joint);
    return joint;
}

namespace {

/// Counts one value that occurs `times` times.
struct RangeCounter {
    const std::vector<ValueRange>& ranges;
    std::vector<RangeCount> counts{ranges.size()};  // `mean` is the sum until the end

    void add(double value, std::uint64_t times) {
        bool taken = false;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            if (!ranges[i].contains(value)) continue;
            counts[i].voxels += times;
            counts[i].mean += value * double(times);
            if (!taken) counts[i].own += times;
            taken = true;
        }
    }
};

}  // namespace

std::vector<RangeCount> count_ranges(const Volume& volume, const VolumeStatistics& statistics,
                                     const std::vector<ValueRange>& ranges, const JobContext& job) {
    RangeCounter total{ranges};
    std::uint64_t finite = 0;
    for (const std::uint64_t n : statistics.histogram) finite += n;
    if (volume.type() != VoxelType::f32 && statistics.bin_width() == 1) {
        for (std::size_t b = 0; b < statistics.histogram.size(); ++b)
            if (statistics.histogram[b]) total.add(statistics.bin_centre(b), statistics.histogram[b]);
    } else {
        require_memory(volume);
        const glm::ivec3 size = volume.geometry().size;
        std::vector<RangeCounter> slices(std::size_t(size.z), RangeCounter{ranges});  // added in order: one sum
        const VolumePart whole;
        visit_type(volume.type(), [&](auto tag) {
            const PartRows<decltype(tag)> rows(volume, whole);
            parallel_for(
                0, size.z,
                [&](std::int64_t z) {
                    for (int y = 0; y < size.y; ++y)
                        rows.for_each(y, int(z), [&](int, double value) { slices[std::size_t(z)].add(value, 1); });
                },
                job);
        });
        for (const RangeCounter& slice : slices)
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                total.counts[i].voxels += slice.counts[i].voxels;
                total.counts[i].own += slice.counts[i].own;
                total.counts[i].mean += slice.counts[i].mean;
            }
    }
    const glm::dvec3 s = volume.geometry().spacing;
    for (RangeCount& count : total.counts) {
        if (count.voxels) count.mean /= double(count.voxels);
        count.share = finite ? double(count.voxels) / double(finite) : 0;
        count.volume_mm3 = double(count.voxels) * s.x * s.y * s.z;
    }
    return total.counts;
}

}  // namespace lacuna
