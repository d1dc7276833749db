#include "core/classify/part_histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace lacuna {
namespace {

template <class T>
Volume noise(glm::ivec3 size, glm::dvec3 spacing, unsigned seed, bool with_nan = false) {
    GridGeometry grid;
    grid.size = size;
    grid.spacing = spacing;
    grid.origin = {3, -7, 11};
    std::mt19937 random(seed);
    return make_volume<T>(grid, [&](std::span<T> voxels) {
        for (T& v : voxels) v = T(int(random() % 90) - (std::is_signed_v<T> ? 45 : 0));
        if (with_nan)
            if constexpr (std::is_floating_point_v<T>)
                for (std::size_t i = 0; i < voxels.size(); i += 37) voxels[i] = std::numeric_limits<T>::quiet_NaN();
    });
}

bool counts_in(const Volume& volume, const VolumePart& part, int x, int y, int z) {
    const double value = volume.value(x, y, z);
    const glm::dvec3 mm = volume.geometry().voxel_to_mm(glm::dvec3(x, y, z));
    for (const glm::dvec4& h : part.half_spaces)
        if (!(glm::dot(glm::dvec3(h), mm) + h.w >= 0)) return false;
    bool inside = part.ranges.empty() && std::isfinite(value);
    for (const ValueRange& r : part.ranges) inside = inside || r.contains(value);
    return inside;
}

std::vector<Volume> ugly_volumes() {
    return {noise<std::uint8_t>({17, 9, 11}, {1, 1, 5}, 1), noise<std::int16_t>({1, 1, 23}, {1, 1, 1}, 2),
            noise<float>({13, 7, 5}, {0.5, 2, 1}, 3, true), noise<std::uint16_t>({1, 1, 1}, {1, 1, 1}, 4)};
}

TEST(PartHistogram, CountsWhatBruteForceCounts) {
    const VolumePart parts[] = {{{{1, 0.5, -0.25, -6}}, {}},
                                {{{0, 0, 1, -14}, {-1, 0, 0, 9}}, {{10, 40}}},
                                {{}, {{0, 5}, {3, 30}}},
                                {{{0, 0, 1, -1e9}}, {}}};  // nothing is left
    for (const Volume& volume : ugly_volumes()) {
        const VolumeStatistics statistics = compute_statistics(volume);
        EXPECT_EQ(part_histogram(volume, statistics, {}), statistics.histogram);
        for (const VolumePart& part : parts) {
            std::vector<std::uint64_t> expected(statistics.histogram.size(), 0);
            const glm::ivec3 size = volume.geometry().size;
            for (int z = 0; z < size.z; ++z)
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x)
                        if (counts_in(volume, part, x, y, z)) {
                            const double at = (volume.value(x, y, z) - statistics.histogram_range.lo) /
                                              statistics.histogram_range.width() * double(expected.size());
                            ++expected[std::min(std::size_t(at), expected.size() - 1)];
                        }
            EXPECT_EQ(part_histogram(volume, statistics, part), expected);
        }
    }
}

TEST(JointHistogram, HoldsEveryVoxelAtItsValueAndGradient) {
    for (const Volume& volume : ugly_volumes()) {
        const VolumeStatistics statistics = compute_statistics(volume);
        const JointHistogram joint = joint_histogram(volume, statistics, {});
        ASSERT_EQ(joint.counts.size(), std::size_t(joint.bins.x) * std::size_t(joint.bins.y));
        const std::uint64_t finite =
            std::accumulate(statistics.histogram.begin(), statistics.histogram.end(), std::uint64_t(0));
        EXPECT_EQ(std::accumulate(joint.counts.begin(), joint.counts.end(), std::uint64_t(0)), finite);
        // The magnitudes by brute force, in the same bins.
        std::vector<std::uint64_t> expected(joint.counts.size(), 0);
        const glm::ivec3 size = volume.geometry().size;
        const glm::dvec3 s = volume.geometry().spacing;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const double v = volume.value(x, y, z);
                    if (!std::isfinite(v)) continue;
                    const auto at = [&](int dx, int dy, int dz) {
                        const glm::ivec3 p = glm::clamp(glm::ivec3(x + dx, y + dy, z + dz), glm::ivec3(0), size - 1);
                        return volume.value(p.x, p.y, p.z);
                    };
                    double m = glm::length(
                        glm::dvec3(at(1, 0, 0) - at(-1, 0, 0), at(0, 1, 0) - at(0, -1, 0), at(0, 0, 1) - at(0, 0, -1)) /
                        (2.0 * s));
                    if (!std::isfinite(m)) m = 0;
                    const auto bin = [](double value, ValueRange range, int bins) {
                        return std::clamp(int((value - range.lo) / range.width() * bins), 0, bins - 1);
                    };
                    ++expected[std::size_t(bin(m, joint.magnitudes, joint.bins.y) * joint.bins.x +
                                           bin(v, joint.values, joint.bins.x))];
                }
        std::uint64_t apart = 0;  // a magnitude on the edge of two bins may fall to either side
        for (std::size_t i = 0; i < expected.size(); ++i)
            apart += expected[i] > joint.counts[i] ? expected[i] - joint.counts[i] : joint.counts[i] - expected[i];
        EXPECT_LE(apart, 2 + finite / 100);
    }
}

TEST(JointHistogram, AStoppedJobThrows) {
    std::stop_source stop;
    stop.request_stop();
    const Volume volume = noise<std::uint8_t>({8, 8, 8}, {1, 1, 1}, 1);
    EXPECT_THROW(joint_histogram(volume, compute_statistics(volume), {}, {stop.get_token(), nullptr}), Error);
}

TEST(CountRanges, TellsWhatEachHoldsAndWhatEarlierOnesTook) {
    const std::vector<ValueRange> ranges = {{10, 30}, {20, 40}, {25, 26}, {1000, 2000}};
    for (const Volume& volume : ugly_volumes()) {
        const VolumeStatistics statistics = compute_statistics(volume);
        const std::vector<RangeCount> counts = count_ranges(volume, statistics, ranges);
        ASSERT_EQ(counts.size(), ranges.size());
        const glm::ivec3 size = volume.geometry().size;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            std::uint64_t voxels = 0, own = 0, finite = 0;
            double sum = 0;
            for (int z = 0; z < size.z; ++z)
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x) {
                        const double v = volume.value(x, y, z);
                        finite += std::isfinite(v);
                        if (!ranges[i].contains(v)) continue;
                        ++voxels;
                        sum += v;
                        bool earlier = false;
                        for (std::size_t j = 0; j < i; ++j) earlier = earlier || ranges[j].contains(v);
                        own += !earlier;
                    }
            EXPECT_EQ(counts[i].voxels, voxels);
            EXPECT_EQ(counts[i].own, own);
            EXPECT_DOUBLE_EQ(counts[i].share, double(voxels) / double(finite));
            EXPECT_NEAR(counts[i].mean, voxels ? sum / double(voxels) : 0, 1e-9);
            const glm::dvec3 s = volume.geometry().spacing;
            EXPECT_DOUBLE_EQ(counts[i].volume_mm3, double(voxels) * s.x * s.y * s.z);
        }
    }
}

}  // namespace
}  // namespace lacuna
