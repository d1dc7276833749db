#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "tests/unit/regions/brute_force.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

TEST(Growing, AStaircaseGivesOneRegionAStep) {
    const Volume volume = volume_of<std::uint8_t>(grid({40, 6, 5}), [](int x, int, int) { return x / 10 * 60; });
    const RegionTable table = grown(volume, 0.2);
    ASSERT_EQ(table.rows.size(), 4u);
    for (int step = 0; step < 4; ++step) {
        EXPECT_EQ(table.rows[std::size_t(step)].voxels, 300);
        EXPECT_EQ(table.rows[std::size_t(step)].mean, step * 60);
        EXPECT_EQ(table.labels(step * 10, 3, 2), std::uint32_t(step + 1));
    }
}

TEST(Growing, ARampIsCutIntoPiecesOfTheFullWidth) {
    // 101 values 0..100: width 0.2 admits 21 of them.
    const Volume volume = volume_of<std::int16_t>(grid({101, 3, 1}), [](int x, int, int) { return x - 50; });
    const RegionTable table = grown(volume, 0.2);
    ASSERT_EQ(table.rows.size(), 5u);
    EXPECT_EQ(table.labels(20, 0, 0), table.labels(0, 0, 0));
    EXPECT_NE(table.labels(21, 0, 0), table.labels(0, 0, 0));
    EXPECT_EQ(table.rows.back().voxels, 3 * 17);
}

TEST(Growing, WidthZeroJoinsEqualValuesOnlyAndOneJoinsEverything) {
    const Volume volume = volume_of<std::uint16_t>(grid({7, 5, 3}), [](int x, int, int) { return x * 1000; });
    EXPECT_EQ(grown(volume, 0).rows.size(), 7u);
    EXPECT_EQ(grown(volume, 1).rows.size(), 1u);
}

TEST(Growing, WholeWidthsOfIntegersSurviveRounding) {
    // 0.29 * 100 is a hair under 29 in binary; the region must still hold both values.
    const Volume volume = volume_of<std::uint8_t>(grid({3, 1, 1}), [](int x, int, int) {
        return x == 0 ? 0 : x == 1 ? 29 : 100;
    });
    EXPECT_EQ(grown(volume, 0.29).rows.size(), 2u);
}

template <class T>
void expect_partition_invariants(const Volume& volume, double width, Connectivity c) {
    const RegionTable table = grown(volume, width, c);
    const double most = width * table.value_range.width();
    for (const RegionCharacteristics& row : table.rows) ASSERT_LE(row.max - row.min, most + 1e-6);
    const glm::ivec3 size = volume.geometry().size;
    std::int64_t labelled = 0;
    // Seeds go in scan order, so of two neighbours the one whose region began later was refused by the earlier one.
    std::vector<std::size_t> first(table.rows.size() + 1, std::numeric_limits<std::size_t>::max());
    const auto& labels = *table.labels.labels;
    for (std::size_t i = labels.size(); i-- > 0;) first[labels[i]] = i, labelled += labels[i] != 0;
    EXPECT_EQ(labelled, volume.geometry().voxel_count());
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int k = 0; k < 27; ++k) {
                    const glm::ivec3 d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), q = glm::ivec3(x, y, z) + d;
                    if (!adjacent(d, int(c)) || glm::any(glm::lessThan(q, glm::ivec3(0))) ||
                        glm::any(glm::greaterThanEqual(q, size)))
                        continue;
                    const std::uint32_t a = table.labels(x, y, z), b = table.labels(q.x, q.y, q.z);
                    if (a == b || first[a] > first[b]) continue;
                    const RegionCharacteristics& row = table.rows[a - 1];
                    const double v = volume.value(q.x, q.y, q.z);
                    ASSERT_GT(std::max(row.max, v) - std::min(row.min, v), std::floor(most))
                        << "a voxel left over fits";
                }
    glm::ivec3 box;
    for (std::size_t i = 0; i < std::min<std::size_t>(table.rows.size(), 5); ++i) {
        const std::vector<int> parts = flood(padded(table.labels, table.rows[i].id, box), box, int(c));
        ASSERT_EQ(*std::max_element(parts.begin(), parts.end()), 1) << "a region in pieces";
    }
}

TEST(Growing, NoiseIsPartitionedWithinTheWidthAndNoVoxelLeftOverFits) {
    for (const Connectivity c : {Connectivity::c6, Connectivity::c18, Connectivity::c26}) {
        Noise noise(3);
        const Volume bytes =
            volume_of<std::uint8_t>(grid({23, 17, 13}), [&](int, int, int) { return noise.below(256); });
        expect_partition_invariants<std::uint8_t>(bytes, 0.1, c);
        expect_partition_invariants<std::uint8_t>(bytes, 0.5, c);
        const Volume smooth = volume_of<std::int16_t>(grid({23, 17, 13}), [&](int x, int y, int z) {
            return 800 * std::sin(0.3 * x) * std::cos(0.4 * y + 0.2 * z) + noise.below(200);
        });
        expect_partition_invariants<std::int16_t>(smooth, 0.25, c);
    }
}

TEST(Growing, FloatsKeepTheWidthExactly) {
    Noise noise(9);
    const Volume volume =
        volume_of<float>(grid({19, 11, 7}), [&](int, int, int) { return float(noise.below(1 << 20)) * 1e-3f - 300.f; });
    const RegionTable table = grown(volume, 0.3);
    for (const RegionCharacteristics& row : table.rows)
        ASSERT_LE(row.max - row.min, 0.3 * table.value_range.width() * (1 + 1e-12));
}

TEST(Growing, NanVoxelsAndTheBackgroundStayOut) {
    const Volume volume = volume_of<float>(grid({6, 4, 1}), [](int x, int y, int) {
        return x == 2 ? std::nanf("") : y == 3 ? -1000.f : 5.f;
    });
    RegionOptions options;
    options.range_width = 1.0;
    options.background = ValueRange{-1100, -900};
    const RegionTable table = find_regions(volume, options);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0].voxels, 9);
    EXPECT_EQ(table.rows[1].voxels, 6);
    EXPECT_EQ(table.labels(2, 1, 0), 0u);
    EXPECT_EQ(table.labels(0, 3, 0), 0u);
}

TEST(Growing, MinVoxelsDropsRegionsButTheyStillBlock) {
    // One odd voxel between two halves of a row: it is dropped, and the halves do not grow over it.
    const Volume volume =
        volume_of<std::uint8_t>(grid({11, 1, 1}), [](int x, int, int) { return x == 5 ? 200 : 10 + x % 2; });
    const RegionTable table = grown(volume, 0.1, Connectivity::c6, 2);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.labels(5, 0, 0), 0u);
    EXPECT_EQ(table.rows[0].fraction, 0.5);
}

struct Flat {
    const char* name;
    glm::ivec3 size;
};
class UglySizes : public testing::TestWithParam<Flat> {};
TEST_P(UglySizes, GrowMeasureAndMesh) {
    const glm::ivec3 size = GetParam().size;
    const Volume volume =
        volume_of<std::int8_t>(grid(size), [](int x, int y, int z) { return (x + y + z) % 5 == 4 ? 100 : -100; });
    for (const Connectivity c : {Connectivity::c6, Connectivity::c18, Connectivity::c26}) {
        const RegionTable table = grown(volume, 0.5, c);
        std::int64_t voxels = 0;
        for (const RegionCharacteristics& row : table.rows) {
            voxels += row.voxels;
            EXPECT_EQ(row.holes, 0);
            EXPECT_GE(row.tunnels, 0);
            EXPECT_LE(row.sphericity, 1);
            bool at_end = size == glm::ivec3(1);
            for (int i = 0; i < int(volume.geometry().voxel_count()); ++i) {
                const glm::ivec3 p(i % size.x, i / size.x % size.y, i / size.x / size.y);
                for (int axis = 0; axis < 3; ++axis)
                    at_end |= table.labels(p.x, p.y, p.z) == row.id && size[axis] > 1 &&
                              (p[axis] == 0 || p[axis] == size[axis] - 1);
            }
            EXPECT_EQ(row.touches_border, at_end) << "an axis of one voxel has no border";
            EXPECT_TRUE(is_closed(region_mesh(table.labels, row)));
        }
        EXPECT_EQ(voxels, volume.geometry().voxel_count());
    }
}
INSTANTIATE_TEST_SUITE_P(Growing, UglySizes,
                         testing::Values(Flat{"one_voxel", {1, 1, 1}}, Flat{"line_x", {97, 1, 1}},
                                         Flat{"line_y", {1, 97, 1}}, Flat{"line_z", {1, 1, 97}},
                                         Flat{"flat_z", {13, 11, 1}}, Flat{"flat_x", {1, 11, 13}},
                                         Flat{"two", {2, 2, 2}}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Growing, SameLabelsAndBitsForAnyNumberOfThreads) {
    Noise noise(21);
    const Volume volume = volume_of<float>(grid({40, 37, 90}, {0.3, 0.7, 1.1}), [&](int x, int y, int z) {
        return std::sin(0.2 * x) + std::cos(0.15 * y) + 0.01 * z + 1e-3 * noise.below(1000);
    });
    std::optional<RegionTable> expect;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        RegionTable table = grown(volume, 0.3);
        if (!expect) {
            expect = table;
            ASSERT_GT(table.rows.size(), 10u);
            continue;
        }
        EXPECT_EQ(*table.labels.labels, *expect->labels.labels);
        EXPECT_EQ(regions_to_csv(table), regions_to_csv(*expect)) << threads << " threads";
    }
    set_thread_count(0);
}

TEST(Growing, ACancelInTheMiddleStopsEveryStepSoon) {
    Noise noise(5);
    const Volume volume =
        volume_of<std::uint8_t>(grid({160, 160, 160}), [&](int, int, int) { return 100 + noise.below(20); });
    for (const double at : {0.0, 0.2, 0.4, 0.52, 0.6, 0.9}) {
        for (const bool threshold : {false, true}) {
            std::stop_source source;
            double reached = -1;
            JobContext job{source.get_token(), [&](double f) {
                               EXPECT_GE(f, reached);
                               reached = f;
                               if (f >= at) source.request_stop();
                           }};
            RegionOptions options;
            if (threshold)
                options.threshold = ValueRange{100, 110};
            else
                options.range_width = 0.9;
            try {
                find_regions(volume, options, job);
                FAIL() << "ran to the end, asked to stop at " << at;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), Errc::cancelled);
            }
        }
    }
}

TEST(Growing, TheGradientLimitKeepsEdgesOut) {
    // A step of 10 over one voxel, then flat: within the width, so without a limit all is one region.
    const Volume volume =
        volume_of<std::uint8_t>(grid({12, 5, 5}, {0.5, 1, 1}), [](int x, int, int) { return x < 6 ? 50 : 60; });
    RegionOptions options;
    options.range_width = 1;
    EXPECT_EQ(find_regions(volume, options).rows.size(), 1u);
    options.gradient_limit = 9.9;  // central difference at the step: 10 over 1 mm
    const RegionTable table = find_regions(volume, options);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0].voxels, 5 * 25);
    EXPECT_EQ(table.labels(5, 2, 2), 0u);
    EXPECT_EQ(table.labels(6, 2, 2), 0u);
    options.gradient_limit = 10;
    EXPECT_EQ(find_regions(volume, options).rows.size(), 1u);
    options.gradient_limit = -1;
    EXPECT_THROW(find_regions(volume, options), Error);

    RegionOptions components;
    components.threshold = ValueRange{40, 70};
    components.gradient_limit = 9.9;
    EXPECT_EQ(find_regions(volume, components).rows.size(), 2u);
}

TEST(Growing, SliversJoinTheRegionTheyTouchMost) {
    // Two halves with single odd voxels: one at the border of both, nearer the left; one in the right.
    const auto value = [](int x, int y, int z) {
        if (glm::ivec3(x, y, z) == glm::ivec3(4, 2, 2) || glm::ivec3(x, y, z) == glm::ivec3(8, 2, 2)) return 200;
        return x < 5 ? 10 : 100;
    };
    const Volume volume = volume_of<std::uint8_t>(grid({12, 5, 5}), value);
    RegionOptions options;
    options.range_width = 0.1;
    options.min_voxels = 5;
    EXPECT_EQ(find_regions(volume, options).labels(4, 2, 2), 0u);
    options.merge_slivers = true;
    const RegionTable table = find_regions(volume, options);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.labels(4, 2, 2), table.labels(0, 0, 0));
    EXPECT_EQ(table.labels(8, 2, 2), table.labels(11, 0, 0));
    EXPECT_EQ(table.rows[0].voxels + table.rows[1].voxels, 300);
    EXPECT_GE(table.rows[0].voxels, table.rows[1].voxels);
    options.background = ValueRange{200, 200};  // background is no sliver
    EXPECT_EQ(find_regions(volume, options).labels(4, 2, 2), 0u);
}

}  // namespace
}  // namespace lacuna::test
