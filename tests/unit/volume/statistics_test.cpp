#include "core/volume/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.h"

namespace lacuna {
namespace {

template <class T>
Volume volume_of(std::vector<T> values, glm::ivec3 size = glm::ivec3(0)) {
    GridGeometry grid;
    grid.size = size.x > 0 ? size : glm::ivec3(1, 1, int(values.size()));
    grid.spacing = {1, 1, 5};
    return make_volume<T>(grid, [&](std::span<T> voxels) { std::copy(values.begin(), values.end(), voxels.begin()); });
}

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_inf = std::numeric_limits<float>::infinity();

TEST(Statistics, OnlyNanAndInfinity) {
    const VolumeStatistics s = compute_statistics(volume_of<float>({k_nan, k_inf, -k_inf}));
    EXPECT_EQ(s.nan_count, 3);
    EXPECT_EQ(s.range, (ValueRange{0, 0}));
    EXPECT_TRUE(s.histogram.empty());
    EXPECT_EQ(s.percentile(0.5), 0);
    EXPECT_EQ(otsu_threshold(s), 0);
}

TEST(Statistics, NanAmongNumbersIsCountedAndIgnored) {
    const VolumeStatistics s = compute_statistics(volume_of<float>({k_nan, 1, k_inf, 3, -k_inf, 2}));
    EXPECT_EQ(s.nan_count, 3);
    EXPECT_EQ(s.range, (ValueRange{1, 3}));
    EXPECT_DOUBLE_EQ(s.mean, 2);
    EXPECT_NEAR(s.stddev, std::sqrt(2.0 / 3), 1e-12);
    EXPECT_EQ(s.histogram.size(), 4096u);
    EXPECT_EQ(std::accumulate(s.histogram.begin(), s.histogram.end(), std::uint64_t(0)), 3u);
    EXPECT_EQ(s.histogram.front(), 1u);
    EXPECT_EQ(s.histogram.back(), 1u);
}

TEST(Statistics, ConstantVolumes) {
    const VolumeStatistics f = compute_statistics(volume_of<float>(std::vector<float>(7, -2.5f)));
    EXPECT_EQ(f.range, (ValueRange{-2.5, -2.5}));
    EXPECT_EQ(f.stddev, 0);
    EXPECT_EQ(f.percentile(0.3), -2.5);
    EXPECT_EQ(otsu_threshold(f), -2.5);
    const VolumeStatistics i = compute_statistics(volume_of<std::int8_t>(std::vector<std::int8_t>(9, -128)));
    EXPECT_EQ(i.range, (ValueRange{-128, -128}));
    EXPECT_EQ(i.histogram_range, (ValueRange{-128.5, -127.5}));
    EXPECT_EQ(i.mean, -128);
    EXPECT_EQ(otsu_threshold(i), -128);
}

TEST(Statistics, WidestIntegerRangesAndOddCounts) {
    const VolumeStatistics s = compute_statistics(volume_of<std::int16_t>({-32768, 32767, 0}));
    EXPECT_EQ(s.range, (ValueRange{-32768, 32767}));
    EXPECT_EQ(s.histogram.size(), 65536u);
    EXPECT_EQ(s.bin_width(), 1);
    EXPECT_EQ(s.bin_centre(0), -32768);
    EXPECT_NEAR(s.mean, -1.0 / 3, 1e-9);
    const VolumeStatistics u = compute_statistics(volume_of<std::uint16_t>({65535, 65535, 65534}));
    EXPECT_EQ(u.range, (ValueRange{65534, 65535}));
    EXPECT_EQ(u.histogram, (std::vector<std::uint64_t>{1, 2}));
}

TEST(Statistics, HugeFloatsDoNotOverflow) {
    const float big = std::numeric_limits<float>::max();
    const VolumeStatistics s = compute_statistics(volume_of<float>({-big, big}));
    EXPECT_EQ(s.range, (ValueRange{-double(big), double(big)}));
    EXPECT_EQ(s.mean, 0);
    EXPECT_TRUE(std::isfinite(s.stddev));
}

TEST(Statistics, SameForAnyNumberOfThreads) {
    std::vector<float> values(300'007);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(float(i)) * 1000 + 1e-3f * float(i);
    const Volume volume = volume_of(values);
    set_thread_count(1);
    const VolumeStatistics one = compute_statistics(volume);
    set_thread_count(5);
    const VolumeStatistics five = compute_statistics(volume);
    set_thread_count(0);
    EXPECT_EQ(one.mean, five.mean);
    EXPECT_EQ(one.stddev, five.stddev);
    EXPECT_EQ(one.histogram, five.histogram);
}

TEST(Statistics, ManyBandsAddUp) {
    std::vector<std::uint8_t> values(glm::ivec3(256, 256, 200).x * 256 * 200);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint8_t(i % 10 + 3);
    const VolumeStatistics s = compute_statistics(volume_of(values, {256, 256, 200}));
    ASSERT_EQ(s.histogram.size(), 10u);
    EXPECT_EQ(std::accumulate(s.histogram.begin(), s.histogram.end(), std::uint64_t(0)), values.size());
    EXPECT_NEAR(s.mean, 7.5, 1e-5);
    EXPECT_NEAR(s.stddev, std::sqrt(8.25), 1e-5);
}

TEST(Statistics, Percentiles) {
    const VolumeStatistics s = compute_statistics(volume_of<std::uint8_t>({10, 20, 30, 40, 50}));
    EXPECT_EQ(s.percentile(0), 10);
    EXPECT_EQ(s.percentile(0.2), 10);
    EXPECT_EQ(s.percentile(0.5), 30);
    EXPECT_EQ(s.percentile(1), 50);
    EXPECT_EQ(s.percentile(std::nan("")), 10);
}

TEST(Statistics, Cancels) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(compute_statistics(volume_of<std::uint8_t>({1, 2}), {stop.get_token(), nullptr}), Error);
}

TEST(Otsu, TwoLevelsTakeTheMiddleOfTheGap) {
    std::vector<std::uint8_t> values(1000, 20);
    std::fill(values.begin() + 300, values.end(), std::uint8_t(200));
    EXPECT_DOUBLE_EQ(otsu_threshold(compute_statistics(volume_of(values))), 110);
    EXPECT_DOUBLE_EQ(otsu_threshold(compute_statistics(volume_of<std::uint16_t>({7, 8}))), 7.5);
    EXPECT_DOUBLE_EQ(otsu_threshold(compute_statistics(volume_of<float>({0, 4096}))), 2048);
}

TEST(Otsu, MatchesAnExhaustiveSearch) {
    std::vector<std::uint8_t> values;
    for (int i = 0; i < 4000; ++i) values.push_back(std::uint8_t(60 + i * 7919 % 31 + (i % 4 == 0 ? 90 : 0)));
    const double threshold = otsu_threshold(compute_statistics(volume_of(values)));
    double best = -1, best_t = 0;
    for (double t = 60.5; t < 180; ++t) {
        double n[2]{}, sum[2]{};
        for (const std::uint8_t v : values) ++n[v > t], sum[v > t] += v;
        if (n[0] == 0 || n[1] == 0) continue;
        const double gap = sum[0] / n[0] - sum[1] / n[1];
        if (n[0] * n[1] * gap * gap > best * (1 + 1e-12)) best = n[0] * n[1] * gap * gap, best_t = t;
    }
    EXPECT_NEAR(threshold, best_t, 30.01);  // the gap between the classes is empty: its middle is taken
    EXPECT_GT(threshold, 90);
    EXPECT_LT(threshold, 150);
    EXPECT_DOUBLE_EQ(threshold, 0.5 * (90.5 + 149.5));
}

}  // namespace
}  // namespace lacuna
