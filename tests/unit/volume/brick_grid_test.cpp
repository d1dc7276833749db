#include "core/volume/brick_grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

/// The bricks that own a position along x.
int owners(const BrickGrid& grid, float x) {
    int count = 0;
    for (int b = 0; b < grid.count.x; ++b) count += x >= grid.lo({b, 0, 0}).x && x < grid.hi({b, 0, 0}).x;
    return count;
}

TEST(BrickGrid, EveryPositionBelongsToOneBrickThatStoresWhatItIsMadeFrom) {
    for (const int size : {1, 2, 8, 9, 16, 17, 18, 31, 100})
        for (const int edge : {8, 9, 16}) {
            const BrickGrid grid({size, 3, 1}, edge, {2, 2, 2});
            EXPECT_EQ(grid.count.y, 1);
            EXPECT_EQ(grid.count.z, 1);
            for (float x = -0.5f; x <= float(size) - 0.5f; x += 0.125f) {
                EXPECT_EQ(owners(grid, x), 1) << size << " " << edge << " " << x;
                for (int b = 0; b < grid.count.x; ++b) {
                    if (!(x >= grid.lo({b, 0, 0}).x && x < grid.hi({b, 0, 0}).x)) continue;
                    // Central differences of the trilinear signal reach one voxel further each way.
                    const int least = std::max(0, int(std::floor(x)) - 1);
                    const int most = std::min(size - 1, int(std::floor(x)) + 2);
                    const VoxelBox box = grid.stored({b, 0, 0});
                    EXPECT_LE(box.first.x, least);
                    EXPECT_GE(box.first.x + box.size.x - 1, std::min(most, size - 1));
                }
            }
        }
}

TEST(BrickGrid, NumbersAndPlacesAgree) {
    const BrickGrid grid({40, 17, 9}, 8, {2, 3, 2});
    EXPECT_EQ(grid.count, glm::ivec3(5, 2, 1));
    std::int64_t largest = 0;
    for (std::int64_t i = 0; i < grid.bricks(); ++i) {
        EXPECT_EQ(grid.index(grid.at(i)), i);
        const VoxelBox box = grid.stored(grid.at(i));
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(box.first, glm::ivec3(0))));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(box.first + box.size, grid.size)));
        largest = std::max(largest, box.voxels());
    }
    EXPECT_GE(grid.largest_stored(), largest);
    EXPECT_LE(grid.largest_stored(), 13 * 15 * 9);
}

TEST(BrickGrid, LongAxesDoNotOverflow) {
    const BrickGrid grid({1 << 17, 1, 1}, 1 << 30, {2, 2, 2});
    EXPECT_EQ(grid.bricks(), 1);
    EXPECT_EQ(grid.stored({0, 0, 0}).size.x, 1 << 17);
    const BrickGrid many({1 << 17, 5, 5}, 256, {2, 2, 2});
    EXPECT_EQ(many.count.x, 512);
    EXPECT_EQ(many.stored({511, 0, 0}).first.x + many.stored({511, 0, 0}).size.x, 1 << 17);
}

}  // namespace
}  // namespace lacuna
