#include <gtest/gtest.h>

#include "tests/unit/regions/brute_force.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

struct Zoo {
    const char* name;
    Shape shape;
    int regions_6, regions_26;  // how many components
    int holes, tunnels;         // of the largest, the same for 6 and 26
};

class ShapeTopology : public testing::TestWithParam<Zoo> {};

TEST_P(ShapeTopology, CountsHolesAndTunnels) {
    const Volume volume = mask_volume(grid({33, 31, 29}), GetParam().shape);
    for (const Connectivity c : {Connectivity::c6, Connectivity::c18, Connectivity::c26}) {
        SCOPED_TRACE(int(c));
        const RegionTable table = regions_of(volume, c);
        ASSERT_FALSE(table.rows.empty());
        if (c == Connectivity::c6) {
            EXPECT_EQ(int(table.rows.size()), GetParam().regions_6);
        } else if (c == Connectivity::c26) {
            EXPECT_EQ(int(table.rows.size()), GetParam().regions_26);
        }
        EXPECT_EQ(table.rows[0].holes, GetParam().holes);
        EXPECT_EQ(table.rows[0].tunnels, GetParam().tunnels);
        EXPECT_EQ(table.rows[0].euler, 1 + GetParam().holes - GetParam().tunnels);
    }
}

const glm::dvec3 k_middle(16, 15, 14);

Shape either(Shape a, Shape b) {
    return [=](const glm::dvec3& p) { return a(p) || b(p); };
}
Shape box(const glm::dvec3& lo, const glm::dvec3& hi) {
    return [=](const glm::dvec3& p) {
        return glm::all(glm::greaterThanEqual(p, lo)) && glm::all(glm::lessThanEqual(p, hi));
    };
}
Shape without(Shape a, Shape b) {
    return [=](const glm::dvec3& p) { return a(p) && !b(p); };
}

INSTANTIATE_TEST_SUITE_P(
    Zoo, ShapeTopology,
    testing::Values(
        Zoo{"one_voxel", box({3, 3, 3}, {3, 3, 3}), 1, 1, 0, 0},
        Zoo{"edge_touching_boxes", either(box({3, 3, 3}, {6, 6, 6}), box({7, 7, 3}, {10, 10, 5})), 2, 1, 0, 0},
        Zoo{"corner_touching_boxes", either(box({3, 3, 3}, {6, 6, 6}), box({7, 7, 7}, {10, 10, 9})), 2, 1, 0, 0},
        Zoo{"frame_to_frame", box({0, 0, 0}, {32, 30, 28}), 1, 1, 0, 0},
        Zoo{"box_open_at_frame", without(box({0, 0, 0}, {32, 30, 28}), box({5, 5, 0}, {9, 9, 12})), 1, 1, 0, 0},
        Zoo{"pipe_through_frame", without(box({0, 0, 0}, {32, 30, 28}), box({5, 5, 0}, {9, 9, 28})), 1, 1, 0, 1},
        Zoo{"ball_2", ball(k_middle, 2), 1, 1, 0, 0}, Zoo{"ball_12", ball(k_middle, 12), 1, 1, 0, 0},
        Zoo{"torus", torus(k_middle, 9, 3.2), 1, 1, 0, 1}, Zoo{"hollow_ball", shell(k_middle, 6, 12), 1, 1, 1, 0},
        Zoo{"hollow_torus", without(torus(k_middle, 9, 4.4), torus(k_middle, 9, 1.6)), 1, 1, 1, 2},
        Zoo{"nested_shells", either(shell(k_middle, 9.5, 13), shell(k_middle, 3, 6)), 2, 2, 1, 0},
        Zoo{"two_cavities", without(without(ball(k_middle, 13), ball({10, 15, 14}, 3)), ball({22, 15, 14}, 3)), 1, 1, 2,
            0},
        Zoo{"cage",
            without(without(without(box({4, 4, 4}, {20, 20, 20}), box({8, 8, 0}, {16, 16, 28})),
                            box({8, 0, 8}, {16, 28, 16})),
                    box({0, 8, 8}, {28, 16, 16})),
            1, 1, 0, 5}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Topology, AShellWithADiagonalGapIsClosedForOneAdjacencyOnly) {
    // A cube's shell whose wall loses one edge row: a 6-connected wall leaks there through the 26-connected complement.
    const Volume volume = volume_of<std::uint8_t>(grid({9, 9, 9}), [](int x, int y, int z) {
        const auto wall = [](int v) { return v == 1 || v == 6; };
        const auto in = [](int v) { return v >= 1 && v <= 6; };
        const bool shell = in(x) && in(y) && in(z) && (wall(x) || wall(y) || wall(z));
        return shell && !(x == 1 && y == 1) ? 100 : 0;
    });
    const RegionTable six = regions_of(volume, Connectivity::c6);
    const RegionTable all = regions_of(volume, Connectivity::c26);
    EXPECT_EQ(six.rows[0].holes, 0);
    EXPECT_EQ(all.rows[0].holes, 1);
    EXPECT_EQ(all.rows[0].tunnels, 0);
}

TEST(Topology, MatchesBruteForceOnRandomMasks) {
    for (int seed = 0; seed < 12; ++seed) {
        Noise noise(seed + 1);
        const int density = 25 + 6 * seed;
        const Volume volume = volume_of<std::uint8_t>(
            grid({9, 8, 7}), [&](int, int, int) { return noise.below(100) < density ? 100 : 0; });
        for (const Connectivity c : {Connectivity::c6, Connectivity::c18, Connectivity::c26}) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << " connectivity " << int(c));
            const RegionTable table = regions_of(volume, c);
            const int complement = c == Connectivity::c6 ? 26 : 6;
            glm::ivec3 size;
            for (const RegionCharacteristics& row : table.rows) {
                const std::vector<int> parts = flood(padded(table.labels, row.id, size), size, int(c));
                ASSERT_EQ(*std::max_element(parts.begin(), parts.end()), 1);
                ASSERT_EQ(row.holes, cavities_of(table.labels, row.id, complement));
                if (c == Connectivity::c6) {
                    ASSERT_EQ(row.euler, euler_of_face_graph(table.labels, row.id));
                }
                if (c == Connectivity::c26) {
                    ASSERT_EQ(row.euler, euler_of_cells(table.labels, row.id));
                }
                ASSERT_GE(row.tunnels, 0);
                ASSERT_TRUE(row.flags.empty() || row.flags[0] == "surface_clamped");
            }
        }
    }
}

TEST(Topology, MatchesBruteForceInAPartition) {
    int cavities = 0;
    for (int seed = 0; seed < 8; ++seed) {
        Noise noise(seed + 100);
        // Few values, favouring one: nested and adjoining regions, some inside others.
        const Volume volume = volume_of<std::uint8_t>(grid({14, 13, 12}), [&](int, int, int) {
            const int draw = noise.below(100);
            return draw < 97 - seed ? 40 : draw < 99 ? 120 : 200;
        });
        const RegionTable table = grown(volume, 0.1);
        for (const RegionCharacteristics& row : table.rows) {
            ASSERT_EQ(row.holes, cavities_of(table.labels, row.id, 26));
            ASSERT_EQ(row.euler, euler_of_face_graph(table.labels, row.id));
            ASSERT_EQ(row.tunnels, 1 + row.holes - row.euler);
            cavities += int(row.holes);
        }
    }
    EXPECT_GT(cavities, 50);  // the table must have had something to find
}

TEST(Topology, NestedShellsOfAPartitionEachHoldTheInnerOnes) {
    const GridGeometry geometry = grid({41, 41, 41});
    const Volume volume = volume_of<std::uint8_t>(geometry, [](int x, int y, int z) {
        const double r = glm::length(glm::dvec3(x, y, z) - 20.0);
        return r < 5 ? 200 : r < 10 ? 100 : r < 15 ? 200 : 0;
    });
    const RegionTable table = grown(volume, 0.1);
    ASSERT_EQ(table.rows.size(), 4u);
    int with_cavity = 0;
    for (const RegionCharacteristics& row : table.rows) {
        EXPECT_EQ(row.tunnels, 0);
        with_cavity += row.holes == 1;
    }
    EXPECT_EQ(with_cavity, 3);  // all but the innermost ball
    EXPECT_EQ(table.rows.back().holes, 0);
}

}  // namespace
}  // namespace lacuna::test
