#include "core/accel/brick_index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/memory_source.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

TEST(BrickIndex, PieceByPieceIsTheSame) {
    std::vector<test::NamedVolume> volumes = test::ugly_volumes();
    volumes.push_back({"several_pieces", test::bumpy_ball<std::uint16_t>({21, 150, 139}, {1, 1, 1}, 60000)});
    for (const test::NamedVolume& v : volumes) {
        const Volume apart = test::elsewhere(v.volume);
        const BrickIndex whole = build_brick_index(v.volume), parts = build_brick_index(apart);
        EXPECT_EQ(parts.of, apart.identity());
        EXPECT_EQ(parts.cells.cells, whole.cells.cells) << v.name;
        EXPECT_EQ(parts.cells.ranges, whole.cells.ranges) << v.name;
        EXPECT_EQ(parts.cells.has_nan, whole.cells.has_nan) << v.name;
        EXPECT_EQ(parts.statistics.histogram, whole.statistics.histogram) << v.name;
    }
}

/// Held against the voxels: an empty brick stores nothing visible, a uniform one a single value.
TEST(BrickIndex, StatesAreTrueOfEveryStoredVoxel) {
    GridGeometry cube;
    cube.size = glm::ivec3(80);
    const Volume block = make_volume<std::uint8_t>(cube, [](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i)
            voxels[i] = i % 80 < 48 && i / 80 % 80 < 48 && i / 6400 < 48 ? 200 : std::uint8_t(20 + i % 3);
    });
    const BrickIndex index = build_brick_index(block);
    for (const int edge : {8, 13, 32}) {
        const BrickGrid grid(block.geometry().size, edge, {2, 2, 2});
        const double iso = 100;
        const auto table = VisibilityTable::of_iso({}, iso, index.statistics.range);
        const auto states = brick_states(grid, index, classify_macrocells(index.cells, table, 1e-6));
        int empty = 0, uniform = 0;
        for (std::int64_t b = 0; b < grid.bricks(); ++b) {
            const VoxelBox box = grid.stored(grid.at(b));
            for (int z = 0; z < box.size.z; ++z)
                for (int y = 0; y < box.size.y; ++y)
                    for (int x = 0; x < box.size.x; ++x) {
                        const double v = block.value(box.first.x + x, box.first.y + y, box.first.z + z);
                        const BrickState& state = states[std::size_t(b)];
                        if (state.content == BrickContent::empty) {
                            ASSERT_LT(v, iso);
                        }
                        if (state.content == BrickContent::uniform) {
                            ASSERT_EQ(v, state.value);
                        }
                    }
            empty += states[std::size_t(b)].content == BrickContent::empty;
            uniform += states[std::size_t(b)].content == BrickContent::uniform;
        }
        EXPECT_GT(empty, 0) << edge;
        EXPECT_EQ(uniform > 0, edge < 32) << edge;
    }
}

TEST(BrickIndex, NaNIsNeverUniform) {
    Volume volume = test::bumpy_ball<float>({20, 20, 20}, {1, 1, 1}, 0, 5);
    reinterpret_cast<float*>(volume.buffer().data())[4000] = std::nanf("");
    const BrickIndex index = build_brick_index(volume);
    const BrickGrid grid(volume.geometry().size, 8, {2, 2, 2});
    const auto table = VisibilityTable::of_ranges({}, index.statistics.range);
    for (const BrickState& state : brick_states(grid, index, classify_macrocells(index.cells, table, 0)))
        EXPECT_NE(state.content, BrickContent::empty);
    const BrickState holding = brick_states(
        grid, index,
        classify_macrocells(index.cells, table, 0))[std::size_t(grid.index({0, 1, 1}))];  // voxel 4000 is (0, 0, 10)
    EXPECT_EQ(holding.content, BrickContent::full);
}

}  // namespace
}  // namespace lacuna
