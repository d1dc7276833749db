#include "core/accel/steady_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lacuna {
namespace {

Classification plateaus() {
    Classification classes;
    classes.tf = {"steps",
                  1,
                  {{10, {1, 0, 0}, 0},
                   {20, {0, 1, 0}, 0},
                   {30, {0, 1, 0}, 0.5},
                   {40, {0, 1, 0}, 0.5},
                   {50, {0, 1, 0}, 0.5},
                   {50, {0, 0, 1}, 0.5},
                   {60, {0, 0, 1}, 0.5}},
                  {}};
    return classes;
}

TEST(PlateauTable, TellsWhatIsDrawnAlike) {
    const PlateauTable table(plateaus());
    EXPECT_TRUE(table.level({-1000, 15}));  // invisible: colours do not count
    EXPECT_TRUE(table.level({10, 19.9}));
    EXPECT_FALSE(table.level({15, 20.1}));
    EXPECT_FALSE(table.level({25, 26}));     // rises
    EXPECT_TRUE(table.level({30.1, 49.9}));  // across a corner where nothing changes
    EXPECT_FALSE(table.level({45, 50}));     // 50 itself is blue
    EXPECT_FALSE(table.level({45, 55}));
    EXPECT_TRUE(table.level({50.1, 1e9}));
}

TEST(PlateauTable, NeverClaimsWhatTheClassificationDenies) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(0, 70);
    for (int round = 0; round < 40; ++round) {
        Classification classes = plateaus();
        for (int r = 0; r < round % 4; ++r) {
            const double a = std::floor(any(random)), b = std::floor(any(random));
            SegmentationRange range{"r", {std::min(a, b), std::max(a, b)}, {}};
            if (r % 2) range.tf = TransferFunction{"own", 2, {{35, {0, 1, 0}, 0.5}, {45, {0, 1, 0}, 0.5}}, {}};
            classes.ranges.push_back(range);
        }
        const PlateauTable table(classes);
        int level = 0;
        for (int i = 0; i < 300; ++i) {
            const double lo = any(random), hi = lo + 0.2 * any(random);
            if (!table.level({lo, hi})) continue;
            ++level;
            const ColorOpacity first = classes.at(lo);
            for (double v = lo; v <= hi; v += 0.05) {
                const ColorOpacity at = classes.at(v);
                EXPECT_EQ(at.opacity, first.opacity) << lo << " " << hi << " at " << v;
                if (first.opacity > 0) {
                    EXPECT_EQ(at.color, first.color) << lo << " " << hi << " at " << v;
                }
            }
        }
        EXPECT_GT(level, 0);
    }
}

// Against the voxels: every neighbourhood a sample of a steady block can read.
TEST(SteadyBlocks, HoldForEveryNeighbourhood) {
    std::mt19937 random(3);
    GridGeometry grid;
    grid.size = {19, 10, 13};
    const Volume volume = make_volume<float>(grid, [&](std::span<float> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i)
            voxels[i] = i % 977 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                     : float(i / 190 < 7 ? 3 + random() % 9 : random() % 70);
    });
    const MacrocellGrid cells = build_macrocells(volume, 2);
    const Classification classes = plateaus();
    const auto blocks = steady_blocks_of_opacity(cells, PlateauTable(classes), 0.01);
    ASSERT_EQ(blocks.size(), std::size_t(5 * 3 * 4));
    int steady = 0;
    for (int z = 0; z < 13; ++z)
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < 19; ++x) {
                if (!blocks[std::size_t(((z / 4) * 3 + y / 4) * 5 + x / 4)]) continue;
                ++steady;
                for (int k = z; k <= std::min(z + 1, 12); ++k)
                    for (int j = y; j <= std::min(y + 1, 9); ++j)
                        for (int i = x; i <= std::min(x + 1, 18); ++i) {
                            const double v = volume.value(i, j, k);
                            ASSERT_FALSE(std::isnan(v));
                            EXPECT_EQ(classes.at(v).opacity, classes.at(volume.value(x, y, z)).opacity);
                        }
            }
    EXPECT_GT(steady, 0);
    EXPECT_LT(steady, 19 * 10 * 13);
}

TEST(SteadyBlocks, OfIsoAndOfValues) {
    GridGeometry grid;
    grid.size = {9, 5, 5};
    const Volume volume = make_volume<std::uint8_t>(grid, [&](std::span<std::uint8_t> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = i % 9 < 5 ? 7 : std::uint8_t(40 + i % 9);
    });
    const MacrocellGrid cells = build_macrocells(volume, 2);  // voxels 0..4, 4..8, 8
    Classification none;
    none.tf.points = {{0, glm::dvec3(1), 0.5}};
    const auto all = VisibilityTable::of_ranges(none, {0, 60});
    const auto values = steady_blocks_of_values(cells, all, 0);
    EXPECT_EQ(values[0], 1);
    EXPECT_EQ(values[1], 0);
    EXPECT_EQ(values[2], 1);
    const auto iso = steady_blocks_of_iso(cells, VisibilityTable::of_iso(none, 20, {0, 60}), 0.01);
    EXPECT_EQ(iso[0], 1);
    EXPECT_EQ(iso[1], 0);  // voxel 4 is 7, voxel 5 is 45
    EXPECT_EQ(iso[2], 1);
}

}  // namespace
}  // namespace lacuna
