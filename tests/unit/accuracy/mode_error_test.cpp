#include "core/accuracy/mode_error.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/accuracy/difference_map.h"
#include "core/base/error.h"
#include "tests/unit/accuracy/pictures.h"

namespace lacuna {
namespace {

using namespace test;

constexpr float k_none = std::numeric_limits<float>::infinity(), k_nan = std::numeric_limits<float>::quiet_NaN();

Frame depths(std::vector<float> values) {
    Frame frame = flat({int(values.size()), 1}, glm::vec4(1));
    frame.depth_mm = std::move(values);
    return frame;
}

Frame greys(std::vector<float> values) {
    Frame frame = flat({int(values.size()), 1}, glm::vec4(1));
    for (std::size_t i = 0; i < values.size(); ++i) frame.color[i] = glm::vec4(glm::vec3(values[i]), 1);
    return frame;
}

TEST(SurfaceError, DepthsInVoxelsAndSilhouettes) {
    const SurfaceError error =
        compare_surfaces(depths({10, 10.5f, 13, k_none, 5, k_none}), depths({10, 10, 10, 7, k_none, k_none}), 0.5);
    EXPECT_EQ(error.both, 3u);
    EXPECT_EQ(error.missed, 1u);
    EXPECT_EQ(error.false_hits, 1u);
    EXPECT_EQ(error.over_one_voxel, 1u);
    EXPECT_DOUBLE_EQ(error.max_voxels, 6);
    EXPECT_DOUBLE_EQ(error.mean_voxels, (0 + 1 + 6) / 3.0);
    EXPECT_DOUBLE_EQ(error.rms_voxels, std::sqrt((0 + 1 + 36) / 3.0));
}

TEST(SurfaceError, NothingHitIsNoErrorAndNaNFails) {
    EXPECT_EQ(compare_surfaces(depths({k_none}), depths({k_none}), 1).max_voxels, 0);
    EXPECT_TRUE(std::isinf(compare_surfaces(depths({k_nan, 1}), depths({1, 1}), 1).max_voxels));
    EXPECT_TRUE(std::isinf(compare_surfaces(depths({1, 1}), depths({1, k_nan}), 1).mean_voxels));
    EXPECT_THROW(compare_surfaces(depths({1}), depths({1, 1}), 1), Error);
    EXPECT_THROW(compare_surfaces(depths({1}), depths({1}), 0), Error);
}

TEST(ProjectionError, UndershootInTheVolumesUnit) {
    const ValueRange window{-1000, 1000};
    const ProjectionError error = compare_projections(greys({0.5f, 0.25f, 0.75f}), greys({0.5f, 0.5f, 0.5f}), window);
    EXPECT_NEAR(error.max_undershoot, 500, 1e-3);
    EXPECT_NEAR(error.max_overshoot, 500, 1e-3);
    EXPECT_NEAR(error.mean_undershoot, 500.0 / 3, 1e-3);
    EXPECT_EQ(error.pixels, 1u);
    const ProjectionError least = compare_projections(greys({0.6f}), greys({0.5f}), window, true);
    EXPECT_NEAR(least.max_undershoot, 200, 1e-3);
    EXPECT_TRUE(std::isinf(compare_projections(greys({k_nan}), greys({0.5f}), window).max_undershoot));
    EXPECT_THROW(compare_projections(greys({1}), greys({1, 1}), window), Error);
}

TEST(DifferenceMap, ShowsWhereAndHowMuch) {
    const Frame truth = flat({5, 1}, {0.5f, 0.5f, 0.5f, 1});
    Frame frame = truth;
    frame.color[1].r += 2.f / 255;
    frame.color[2].g -= 8.f / 255;
    frame.color[3].b = k_nan;
    frame.color[4].b += 200.f / 255;  // clamped at white
    const DifferenceMap map = difference_map(frame, truth, {0, 0, 0}, 8);
    const auto at = [&](int i) { return glm::ivec3(map.rgb[3 * i], map.rgb[3 * i + 1], map.rgb[3 * i + 2]); };
    const auto lightness = [&](int i) { return 0.2 * at(i).r + 0.7 * at(i).g + 0.1 * at(i).b; };
    EXPECT_EQ(at(0), glm::ivec3(0));
    EXPECT_GT(lightness(1), 5);
    EXPECT_GT(lightness(2), lightness(1) + 100);
    EXPECT_EQ(at(3), glm::ivec3(0, 255, 255));
    EXPECT_EQ(at(4), at(2)) << "at full scale and above";
    EXPECT_EQ(map.full_scale, 8);
    EXPECT_NEAR(difference_map(frame, truth, {0, 0, 0}).full_scale, 127.5, 1e-3);
    EXPECT_EQ(difference_map(truth, truth, {0, 0, 0}).rgb, std::vector<std::uint8_t>(15, 0));
    EXPECT_THROW(difference_map(flat({1, 5}, {}), truth, {0, 0, 0}), Error);
}

TEST(DifferenceMap, LightnessRisesSteadily) {
    double before = -1;
    for (int i = 0; i <= 64; ++i) {
        const glm::dvec3 c = heat_color(i / 64.0);
        const double y = 0.2126 * std::pow(c.r, 2.2) + 0.7152 * std::pow(c.g, 2.2) + 0.0722 * std::pow(c.b, 2.2);
        EXPECT_GT(y, before) << i;
        before = y;
    }
}

}  // namespace
}  // namespace lacuna
