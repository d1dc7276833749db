#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/volume/volume.h"

// What no grid can be, said before anything is calculated with it.
namespace lacuna {
namespace {

GridGeometry grid_of(glm::ivec3 size, glm::dvec3 spacing) {
    GridGeometry g;
    g.size = size;
    g.spacing = spacing;
    return g;
}

TEST(GridGeometry, FaultsAreNamed) {
    EXPECT_STREQ(fault_of(grid_of({2, 3, 4}, {1, 1, 5})), "");
    EXPECT_STREQ(fault_of(grid_of({2048, 2048, 32768}, glm::dvec3(1e-5))), "");
    const auto names = [](const GridGeometry& g, const char* word) {
        return std::string(fault_of(g)).find(word) != std::string::npos;
    };
    EXPECT_TRUE(names(grid_of({2, 0, 4}, glm::dvec3(1)), "no voxels"));
    EXPECT_TRUE(names(grid_of(glm::ivec3(INT32_MAX), glm::dvec3(1)), "too many voxels"));
    EXPECT_TRUE(names(grid_of(glm::ivec3(2), {1, NAN, 1}), "spacing"));
    EXPECT_TRUE(names(grid_of(glm::ivec3(2), glm::dvec3(1e-320)), "too small"));
    EXPECT_TRUE(names(grid_of(glm::ivec3(2), glm::dvec3(1e160, 1e160, 1)), "too large"));
    GridGeometry skewed = grid_of(glm::ivec3(2), glm::dvec3(1));
    skewed.direction[0][1] = 0.1;
    EXPECT_TRUE(names(skewed, "orthonormal"));
}

TEST(GridGeometry, AVolumeOfAnImpossibleGridIsRefused) {
    EXPECT_THROW(Volume(grid_of(glm::ivec3(INT32_MAX), glm::dvec3(1)), VoxelType::u8, VoxelBuffer(1)), Error);
}

}  // namespace
}  // namespace lacuna
