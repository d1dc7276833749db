// The min-max-average octree against the voxels: every range, average, class and flag by brute force.
#include "core/accel/minmax_octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/scenes.h"

namespace lacuna {
namespace {

/// What is true of a node's voxels.
struct Truth {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;  ///< finite values of the box
    double sum = 0;
    std::int64_t finite = 0, voxels = 0;
};

Truth look(const Volume& volume, glm::ivec3 from, glm::ivec3 to) {
    Truth t;
    from = glm::max(from, glm::ivec3(0));
    to = glm::min(to, volume.geometry().size - 1);
    for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) {
                const double v = volume.value(x, y, z);
                ++t.voxels;
                if (!std::isfinite(v)) continue;
                ++t.finite;
                t.sum += v;
                t.lo = std::min(t.lo, v);
                t.hi = std::max(t.hi, v);
            }
    return t;
}

template <class Each>
void for_nodes(const OctreeLayout& layout, Each&& each) {
    for (int level = 0; level <= layout.root(); ++level) {
        const glm::ivec3 n = layout.nodes[std::size_t(level)];
        for (int z = 0; z < n.z; ++z)
            for (int y = 0; y < n.y; ++y)
                for (int x = 0; x < n.x; ++x) each(level, glm::ivec3(x, y, z), layout.index(level, {x, y, z}));
    }
}

/// Values that a transfer function hides below and above a band, so that trees have something to be wrong about.
Classification band(const Volume& volume) {
    const VolumeStatistics all = compute_statistics(volume);
    const double lo = all.range.lo, w = all.range.width();
    Classification c;
    c.tf = {
        "band", 1.0, {{lo + 0.4 * w, {1, 1, 1}, 0}, {lo + 0.5 * w, {1, 1, 1}, 0.5}, {lo + 0.7 * w, {1, 1, 1}, 0}}, {}};
    return c;
}

Volume with_plateaus() {
    GridGeometry grid;
    grid.size = {48, 40, 33};
    return make_volume<std::uint16_t>(grid, [&](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            const int x = int(i % 48), y = int(i / 48 % 40), z = int(i / (48 * 40));
            voxels[i] = std::uint16_t(x < 20 ? 1000 : x > 30 && y < 25 ? 2000 : 100 + 7 * x + 3 * y + z);
        }
    });
}

std::vector<test::NamedVolume> volumes() {
    auto all = test::ugly_volumes();
    all.push_back({"plateaus", with_plateaus()});
    return all;
}

TEST(MinMaxOctree, RangesHoldEveryVoxelASampleCanTouchAndNoMore) {
    for (const auto& [name, volume] : volumes()) {
        const MinMaxOctree tree = build_minmax_octree(volume, build_macrocells(volume));
        for_nodes(tree.layout, [&](int level, glm::ivec3 node, std::size_t i) {
            const int edge = 8 << level;
            const Truth t = look(volume, node * edge, (node + 1) * edge);
            if (t.finite == 0) {
                ASSERT_GT(tree.ranges[i].x, tree.ranges[i].y) << name;
                ASSERT_TRUE(std::isnan(tree.averages[i])) << name;
                return;
            }
            ASSERT_EQ(tree.ranges[i].x, float(t.lo)) << name << " level " << level;
            ASSERT_EQ(tree.ranges[i].y, float(t.hi)) << name << " level " << level;
            const Truth own = look(volume, node * edge, (node + 1) * edge - 1);
            ASSERT_GE(tree.averages[i], tree.ranges[i].x) << name;
            ASSERT_LE(tree.averages[i], tree.ranges[i].y) << name;
            if (own.finite > 0) {
                ASSERT_NEAR(tree.averages[i], own.sum / double(own.finite), 1e-5 * std::abs(t.hi) + 1e-6) << name;
            }
        });
        EXPECT_EQ(tree.layout.nodes.back(), glm::ivec3(1)) << name;
    }
}

TEST(MinMaxOctree, NodesNumberOne448thOfTheVoxels) {
    const OctreeLayout layout(glm::ivec3(64));  // 512^3
    EXPECT_NEAR(double(layout.count()), 512.0 * 512 * 512 / 448, 1);
}

TEST(MinMaxOctree, ClassesHideNothingVisible) {
    for (const auto& [name, volume] : volumes()) {
        const Classification c = band(volume);
        const MacrocellGrid leaves = build_macrocells(volume);
        const VisibilityTable table = VisibilityTable::of_opacity(c, compute_statistics(volume).range);
        const OctreeLayout layout(leaves.cells);
        const OctreeClasses made = classify_octree(layout, leaves, table, 0, true, std::nullopt);
        for_nodes(layout, [&](int level, glm::ivec3 node, std::size_t i) {
            const int edge = 8 << level;
            const Truth t = look(volume, node * edge, (node + 1) * edge);
            const int answer = made.nodes[i] & k_node_class;
            bool any = false, all = t.finite == t.voxels;
            for (int s = 0; s <= 256 && t.finite > 0; ++s) {
                // At the leaves every value between the extremes can be reconstructed; above, those of some leaf.
                if (level > 0) break;
                const bool visible = c.at(t.lo + (t.hi - t.lo) * s / 256).opacity > 0;
                any = any || visible;
                all = all && visible;
            }
            if (level > 0)
                for (int z = node.z * edge / 8; z < (node.z + 1) * edge / 8; ++z)
                    for (int y = node.y * edge / 8; y < (node.y + 1) * edge / 8; ++y)
                        for (int x = node.x * edge / 8; x < (node.x + 1) * edge / 8; ++x) {
                            if (glm::any(glm::greaterThanEqual(glm::ivec3(x, y, z), leaves.cells))) continue;
                            const int leaf = made.nodes[layout.index(0, {x, y, z})] & k_node_class;
                            any = any || leaf != int(VisibilityTable::Answer::none);
                            all = all && leaf == int(VisibilityTable::Answer::all);
                        }
            if (any) {
                ASSERT_NE(answer, int(VisibilityTable::Answer::none)) << name << " level " << level;
            }
            if (!all) {
                ASSERT_NE(answer, int(VisibilityTable::Answer::all)) << name << " level " << level;
            }
            if (made.nodes[i] & k_node_steady) {
                ASSERT_EQ(answer, int(VisibilityTable::Answer::all)) << name;
            }
            ASSERT_EQ(made.nodes[i] & k_node_flat, 0) << name;
            if (level > made.top) {
                ASSERT_EQ(answer, int(VisibilityTable::Answer::some)) << name;
            }
        });
    }
}

TEST(MinMaxOctree, FlatNodesAreFlatUpToWhatGradientsRead) {
    const Volume volume = with_plateaus();
    const MacrocellGrid leaves = build_macrocells(volume);
    Classification c;
    c.tf = {"all", 1.0, {{0, {1, 1, 1}, 0.5}, {3000, {1, 1, 1}, 0.5}}, {}};
    const VisibilityTable table = VisibilityTable::of_opacity(c, compute_statistics(volume).range);
    const OctreeLayout layout(leaves.cells);
    for (const double threshold : {0.0, 30.0}) {
        const auto wide = gradient_ranges(volume, leaves, threshold);
        for (const bool gradients : {false, true}) {
            const FlatRule rule{threshold, gradients ? &wide : &leaves.ranges};
            const OctreeClasses made = classify_octree(layout, leaves, table, 0, true, rule);
            EXPECT_TRUE(made.any_flat);
            int parents = 0;
            for_nodes(layout, [&](int level, glm::ivec3 node, std::size_t i) {
                const int edge = 8 << level, more = gradients ? 1 : 0;
                const Truth t = look(volume, node * edge - more, (node + 1) * edge + more);
                if (level == 0) {
                    ASSERT_EQ((made.nodes[i] & k_node_flat) != 0, t.hi - t.lo <= threshold);
                }
                if (made.nodes[i] & k_node_flat) {
                    ASSERT_LE(t.hi - t.lo, threshold) << "level " << level;
                    parents += level > 0;
                    ASSERT_EQ(made.nodes[i] & k_node_steady, 0);
                }
            });
            EXPECT_GT(parents, 0);
        }
    }
}

TEST(MinMaxOctree, AStoppedBuildThrows) {
    const Volume volume = with_plateaus();
    const MacrocellGrid leaves = build_macrocells(volume);
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(build_minmax_octree(volume, leaves, {source.get_token(), nullptr}), Error);
    EXPECT_THROW(gradient_ranges(volume, leaves, 0, {source.get_token(), nullptr}), Error);
}

}  // namespace
}  // namespace lacuna
