#include "core/regions/iso_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

/// Distance from the middle, so that the isosurface is a sphere, on a grid with uneven spacing.
Volume distance_field(glm::ivec3 size, glm::dvec3 spacing) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    const glm::dvec3 middle = geometry.voxel_to_mm(0.5 * glm::dvec3(size - 1));
    return make_volume<float>(geometry, [&](std::span<float> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    voxels[i++] = float(-glm::length(geometry.voxel_to_mm(glm::dvec3(x, y, z)) - middle));
    });
}

TEST(IsoMesh, ABallIsClosedAndOfItsSize) {
    const Volume volume = distance_field({41, 33, 21}, {0.5, 0.6, 1.0});
    const TriangleMesh mesh = iso_mesh(volume, -8);
    EXPECT_TRUE(is_closed(mesh));
    const double ball = 4.0 / 3 * M_PI * 512;
    EXPECT_NEAR(enclosed_volume_mm3(mesh), ball, 0.02 * ball);
    for (const glm::dvec3& vertex : mesh.vertices)
        EXPECT_NEAR(glm::length(vertex - volume.geometry().voxel_to_mm({20, 16, 10})), 8, 0.05);
}

TEST(IsoMesh, WhatReachesTheBorderIsClosedThere) {
    const TriangleMesh mesh = iso_mesh(distance_field({9, 9, 9}, {1, 1, 1}), -100);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_NEAR(enclosed_volume_mm3(mesh), 9 * 9 * 9, 40);  // the edges are blunt
}

TEST(IsoMesh, NothingInsideIsSaid) {
    EXPECT_THROW(iso_mesh(distance_field({5, 5, 5}, {1, 1, 1}), 1), Error);
    GridGeometry geometry;
    geometry.size = {3, 1, 2};
    const Volume nan = make_volume<float>(geometry, [](std::span<float> voxels) {
        std::fill(voxels.begin(), voxels.end(), std::numeric_limits<float>::quiet_NaN());
    });
    EXPECT_THROW(iso_mesh(nan, 0), Error);
}

}  // namespace
}  // namespace lacuna
