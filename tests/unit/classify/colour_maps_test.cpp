#include "core/classify/colour_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/classify/histogram_landmarks.h"

namespace lacuna {
namespace {

TEST(ColourMaps, LightnessRisesEvenly) {
    ASSERT_GE(colour_map_names().size(), 6u);
    for (const std::string& name : colour_map_names()) {
        const bool diverging = name == "cold-warm";
        double before = lightness_of(colour_map_at(name, 0));
        double least = 1, most = 0;
        for (int i = 1; i <= (diverging ? 32 : 64); ++i) {
            const glm::dvec3 color = colour_map_at(name, i / 64.0);
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(color[c], 0) << name;
                EXPECT_LE(color[c], 1) << name;
            }
            const double now = lightness_of(color);
            if (i > 4) {  // the cube root is steep at black
                least = std::min(least, now - before);
                most = std::max(most, now - before);
            }
            before = now;
        }
        EXPECT_GT(least, 0) << name;
        EXPECT_LT(most, 4 * std::max(least, 0.004)) << name;
        EXPECT_GT(before - lightness_of(colour_map_at(name, 0)), 0.45) << name;
    }
    EXPECT_NEAR(lightness_of({1, 1, 1}), 1, 1e-6);
    EXPECT_NEAR(lightness_of({0, 0, 0}), 0, 1e-6);
}

TEST(ColourMaps, UnknownNamesAreRefusedAndTIsClamped) {
    EXPECT_THROW(colour_map_at("rainbow", 0.5), Error);
    EXPECT_EQ(colour_map_at("heat", -3), colour_map_at("heat", 0));
    EXPECT_EQ(colour_map_at("heat", 7), colour_map_at("heat", 1));
    EXPECT_EQ(colour_map_at("heat", std::nan("")), colour_map_at("heat", 0));
}

TEST(ColourMaps, KeepTheOpacityAndShowTheMap) {
    TransferFunction tf;
    tf.points = {
        {-5, {1, 1, 1}, 0.3}, {0, {1, 1, 1}, 0.1}, {10, {1, 1, 1}, 0.9}, {10, {1, 1, 1}, 0.2}, {20, {0, 1, 0}, 1}};
    const TransferFunction made = with_colour_map(tf, "meadow", 1, 3);
    EXPECT_NO_THROW(check(made));
    EXPECT_EQ(made.points.front(), tf.points.front());
    EXPECT_EQ(made.points.back(), tf.points.back());
    for (double v = -6; v < 21; v += 0.37) EXPECT_NEAR(made.at(v).opacity, tf.at(v).opacity, 1e-12) << v;
    for (double v = 0; v < 10; v += 0.1)
        EXPECT_LT(std::abs(lightness_of(made.at(v).color) - lightness_of(colour_map_at("meadow", v / 10))), 0.03) << v;
    TransferFunction one;
    one.points = {{3, {1, 1, 1}, 1}};
    EXPECT_EQ(with_colour_map(one, "heat", 0, 0).points.size(), 1u);
    EXPECT_EQ(with_colours_reversed(tf).points.front().color, tf.points.back().color);
}

TEST(HistogramLandmarks, ArePeaksAndTheValleysBetween) {
    std::vector<std::uint64_t> counts(1000, 0);
    for (int i = 0; i < 1000; ++i)
        counts[std::size_t(i)] = std::uint64_t(1e6 * std::exp(-std::pow((i - 200) / 30.0, 2)) +
                                               1e4 * std::exp(-std::pow((i - 700) / 50.0, 2)));
    const std::vector<double> found = histogram_landmarks(counts, {-500, 500});
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found[0], -300, 6);
    EXPECT_NEAR(found[2], 200, 6);
    EXPECT_GT(found[1], found[0]);
    EXPECT_LT(found[1], found[2]);
    EXPECT_TRUE(histogram_landmarks({}, {0, 1}).empty());
    EXPECT_TRUE(histogram_landmarks({0, 0, 0}, {0, 1}).empty());
    EXPECT_TRUE(histogram_landmarks({5}, {1, 1}).empty());
}

}  // namespace
}  // namespace lacuna
