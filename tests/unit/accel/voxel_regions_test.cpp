#include "core/accel/voxel_regions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/volume/statistics.h"

namespace lacuna {
namespace {

constexpr int k_edge = 17;

/// Values whose gradients all lie on one face of the cube of directions, no two of a cell's corners the same.
Volume bowl() {
    GridGeometry grid;
    grid.size = glm::ivec3(k_edge);
    return make_volume<float>(grid, [](std::span<float> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < k_edge; ++z)
            for (int y = 0; y < k_edge; ++y)
                for (int x = 0; x < k_edge; ++x) voxels[i++] = float(100 * x + y * y + z * z);
    });
}

/// Cells that count as homogeneous where every value looks the same.
std::int64_t homogeneous_cells(const Volume& volume, double angle_deg) {
    const ValueRange values = compute_statistics(volume).range;
    Classification even;
    even.tf.points = {{values.lo, glm::dvec3(0.5), 0.3}, {values.hi, glm::dvec3(0.5), 0.3}};
    const VisibilityTable visible = VisibilityTable::of_opacity(even, values);
    const HomogeneityTable alike(even, values, 0.5);
    VoxelRules rules{visible};
    rules.second = VoxelRules::Second::homogeneous;
    rules.alike = &alike;
    rules.gradients = true;
    rules.angle_deg = angle_deg;
    const RegionGrid grid = voxel_regions(volume, rules);
    return std::count(grid.region.begin(), grid.region.end(), std::uint8_t(2));
}

// The finer the angle, the more directions there are to number: beyond 2^64 of them none is taken for another.
TEST(VoxelRegions, TheSmallestAnglesPartAllDirections) {
    const Volume volume = bowl();
    EXPECT_EQ(homogeneous_cells(volume, 180), k_edge * k_edge * k_edge);
    EXPECT_GT(homogeneous_cells(volume, 60), 0);
    // The gradient is the same at all corners of some cells at the border: those may count, and no others.
    const std::int64_t same = homogeneous_cells(volume, 1e-4);
    EXPECT_LE(same, k_edge);
    for (const double angle_deg : {1e-6, 1e-8, 1e-12, 1e-30, 1e-300})
        EXPECT_LE(homogeneous_cells(volume, angle_deg), same) << angle_deg;
}

}  // namespace
}  // namespace lacuna
