#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "tests/unit/regions/brute_force.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

TEST(Components, MatchFloodFillOnRandomMasks) {
    for (int seed = 0; seed < 10; ++seed) {
        Noise noise(seed + 7);
        const glm::ivec3 size(11, 9, 8);
        const Volume volume = volume_of<std::uint8_t>(
            grid(size), [&](int, int, int) { return noise.below(100) < 15 + 5 * seed ? 100 : 0; });
        std::vector<std::uint8_t> mask;
        for (const std::uint8_t v : volume.view<std::uint8_t>().voxels()) mask.push_back(v > 0);
        for (const int c : {6, 18, 26}) {
            const RegionTable table = regions_of(volume, Connectivity(c));
            const std::vector<int> expect = flood(mask, size, c);
            ASSERT_EQ(int(table.rows.size()), *std::max_element(expect.begin(), expect.end()));
            std::vector<std::uint32_t> name(table.rows.size() + 1, 0);
            for (std::size_t i = 0; i < expect.size(); ++i) {
                const std::uint32_t id = (*table.labels.labels)[i];
                ASSERT_EQ(expect[i] == 0, id == 0);
                if (name[std::size_t(expect[i])] == 0) name[std::size_t(expect[i])] = id;
                ASSERT_EQ(name[std::size_t(expect[i])], id);
            }
        }
    }
}

TEST(Components, IdsGoByDescendingSizeThenByFirstVoxel) {
    const Volume volume = volume_of<std::uint8_t>(grid({20, 1, 1}), [](int x, int, int) {
        return x == 0 || (x >= 2 && x <= 4) || x == 6 || (x >= 8 && x <= 10) || x >= 12 ? 100 : 0;
    });
    const RegionTable table = regions_of(volume);
    ASSERT_EQ(table.rows.size(), 5u);
    EXPECT_EQ(table.labels(12, 0, 0), 1u);
    EXPECT_EQ(table.labels(2, 0, 0), 2u);
    EXPECT_EQ(table.labels(8, 0, 0), 3u);
    EXPECT_EQ(table.labels(0, 0, 0), 4u);
    EXPECT_EQ(table.labels(6, 0, 0), 5u);
    EXPECT_EQ(table.labels(1, 0, 0), 0u);
    EXPECT_TRUE(table.rows[0].touches_border);
}

TEST(Components, SmallRegionsGoBackToBackgroundAndOutOfTheFraction) {
    const Volume volume = volume_of<std::uint8_t>(
        grid({10, 3, 1}), [](int x, int y, int) { return x < 5 || (x == 7 && y == 1) ? 100 : 0; });
    const RegionTable table = regions_of(volume, Connectivity::c26, 2);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.labels(7, 1, 0), 0u);
    EXPECT_EQ(table.rows[0].voxels, 15);
    EXPECT_EQ(table.rows[0].fraction, 1.0);
}

TEST(Components, NanAndInfiniteVoxelsBelongToNoRegion) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const Volume volume = volume_of<float>(grid({5, 1, 1}), [&](int x, int, int) {
        return x == 1 ? nan : x == 3 ? inf : 1.5f;
    });
    RegionOptions options;
    options.threshold = ValueRange{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const RegionTable table = find_regions(volume, options);
    EXPECT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(table.labels(1, 0, 0), 0u);
    EXPECT_EQ(table.labels(3, 0, 0), 0u);
    EXPECT_EQ(table.value_range, (ValueRange{1.5, 1.5}));
}

TEST(Components, AllNanGivesAnEmptyTable) {
    const Volume volume = volume_of<float>(grid({4, 3, 2}), [](int, int, int) { return std::nanf(""); });
    EXPECT_TRUE(grown(volume, 0.5).rows.empty());
    EXPECT_TRUE(regions_of(volume).rows.empty());
}

struct BadOptions {
    const char* name;
    std::optional<double> range_width;
    std::optional<ValueRange> threshold;
    std::int64_t min_voxels;
};
class RefusedOptions : public testing::TestWithParam<BadOptions> {};
TEST_P(RefusedOptions, AreNamedAsUsage) {
    const Volume volume = volume_of<std::uint8_t>(grid({2, 2, 2}), [](int x, int, int) { return x; });
    RegionOptions options;
    options.range_width = GetParam().range_width;
    options.threshold = GetParam().threshold;
    options.min_voxels = GetParam().min_voxels;
    try {
        find_regions(volume, options);
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_usage);
    }
}
INSTANTIATE_TEST_SUITE_P(Regions, RefusedOptions,
                         testing::Values(BadOptions{"nothing", {}, {}, 1}, BadOptions{"width_nan", std::nan(""), {}, 1},
                                         BadOptions{"width_over_one", 1.01, {}, 1},
                                         BadOptions{"width_negative", -0.1, {}, 1},
                                         BadOptions{"both", 0.1, ValueRange{0, 1}, 1},
                                         BadOptions{"threshold_reversed", {}, ValueRange{2, 1}, 1},
                                         BadOptions{"threshold_nan", {}, ValueRange{0, std::nan("")}, 1},
                                         BadOptions{"no_voxels", 0.1, {}, 0}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Components, MoreRegionsThanATableHoldsAreRefusedWithTheWayOut) {
    const Volume volume =
        volume_of<std::uint8_t>(grid({256, 256, 129}), [](int x, int y, int z) { return (x + y + z) % 2 ? 100 : 0; });
    for (const bool threshold : {false, true}) {
        try {
            threshold ? regions_of(volume) : grown(volume, 0.1);
            FAIL() << "not refused";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::bad_usage);
            EXPECT_NE(std::string(error.what()).find("--min-voxels"), std::string::npos);
        }
    }
    EXPECT_TRUE(grown(volume, 0.1, Connectivity::c6, 2).rows.empty());
    EXPECT_EQ(regions_of(volume, Connectivity::c26).rows.size(), 1u);
}

TEST(Components, MeasuringRefusesLabelsOfAnotherGrid) {
    const Volume volume = volume_of<std::uint8_t>(grid({4, 4, 4}), [](int, int, int) { return 1; });
    LabelVolume labels{grid({4, 4, 3}), std::make_shared<std::vector<std::uint32_t>>(48, 1u)};
    try {
        measure_regions(volume, labels, Connectivity::c6);
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_input);
    }
}

TEST(Components, ARegionWithoutAValueIsMeasured) {
    constexpr float k_none = std::numeric_limits<float>::quiet_NaN();
    const Volume volume = volume_of<float>(grid({4, 4, 4}), [](int x, int, int) { return x < 2 ? k_none : 7.0f; });
    LabelVolume labels{volume.geometry(), std::make_shared<std::vector<std::uint32_t>>(64, 0u)};
    for (std::size_t i = 0; i < 64; ++i) (*labels.labels)[i] = i % 4 < 2 ? 1u : 2u;
    const auto rows = measure_regions(volume, labels, Connectivity::c6);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].voxels, 32);
    EXPECT_TRUE(std::isnan(rows[0].mean));
    EXPECT_EQ(rows[1].mean, 7);
}

TEST(Components, MeasuringTakesIdsOfAnySize) {
    const Volume volume = volume_of<std::uint8_t>(grid({4, 4, 4}), [](int x, int, int) { return 10 * x; });
    LabelVolume labels{volume.geometry(), std::make_shared<std::vector<std::uint32_t>>(64, 0u)};
    for (std::size_t i = 0; i < 64; ++i) (*labels.labels)[i] = i % 4 == 0 ? 4'000'000'000u : i % 4 == 1 ? 17u : 0u;
    const auto rows = measure_regions(volume, labels, Connectivity::c26);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].id, 17u);
    EXPECT_EQ(rows[0].mean, 10);
    EXPECT_EQ(rows[1].id, 4'000'000'000u);
    EXPECT_EQ(rows[1].voxels, 16);
}

}  // namespace
}  // namespace lacuna::test
