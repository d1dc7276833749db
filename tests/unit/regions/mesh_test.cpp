#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(TriangleMesh, MeasuresATetrahedron) {
    TriangleMesh mesh;
    mesh.vertices = {{5, 5, 5}, {7, 5, 5}, {5, 7, 5}, {5, 5, 7}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    EXPECT_NEAR(enclosed_volume_mm3(mesh), 8.0 / 6, 1e-12);
    EXPECT_NEAR(area_mm2(mesh), 3 * 2 + std::sqrt(3.0) / 4 * 8, 1e-12);
    EXPECT_TRUE(is_closed(mesh));

    TriangleMesh open = mesh;
    open.triangles.pop_back();
    EXPECT_FALSE(is_closed(open));
    TriangleMesh turned = mesh;
    std::swap(turned.triangles[3][0], turned.triangles[3][1]);
    EXPECT_FALSE(is_closed(turned));
    TriangleMesh doubled = mesh;
    doubled.triangles.insert(doubled.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    EXPECT_FALSE(is_closed(doubled));
    EXPECT_EQ(enclosed_volume_mm3(TriangleMesh{}), 0);
}

struct MeshCase {
    const char* name;
    Shape shape;
    glm::dvec3 spacing;
    double volume_bound;  // against the voxels' volume: what cutting the corners off takes
};
class RegionMesh : public testing::TestWithParam<MeshCase> {};
TEST_P(RegionMesh, IsClosedOutwardAndHoldsTheVolume) {
    const Volume volume = mask_volume(grid({31, 31, 31}, GetParam().spacing), GetParam().shape);
    const RegionTable table = regions_of(volume, Connectivity::c26);
    ASSERT_EQ(table.rows.size(), 1u);
    const RegionCharacteristics& row = table.rows[0];
    const TriangleMesh mesh = region_mesh(table.labels, row);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_LE(std::abs(enclosed_volume_mm3(mesh) / row.volume_mm3 - 1), GetParam().volume_bound)
        << enclosed_volume_mm3(mesh) / row.volume_mm3 - 1;
    for (const glm::dvec3& v : mesh.vertices) {
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(v, row.bbox_min_mm - 1e-9)));
        ASSERT_TRUE(glm::all(glm::lessThanEqual(v, row.bbox_max_mm + 1e-9)));
    }
    if (row.voxels < 100) return;
    TriangleMesh fitted = mesh;
    offset_to_volume(fitted, row.volume_mm3, 0.5 * volume.geometry().smallest_spacing_mm());
    EXPECT_TRUE(is_closed(fitted));
    EXPECT_NEAR(enclosed_volume_mm3(fitted), row.volume_mm3, 0.01 * row.volume_mm3);
}
const glm::dvec3 k_middle(15);
INSTANTIATE_TEST_SUITE_P(Regions, RegionMesh,
                         testing::Values(MeshCase{"one_voxel", ball(k_middle, 0.5), {1, 1, 1}, 0.84},
                                         MeshCase{"ball_3", ball(k_middle, 3), {1, 1, 1}, 0.10},
                                         MeshCase{"ball_6", ball(k_middle, 6), {1, 1, 1}, 0.03},
                                         MeshCase{"ball_12", ball(k_middle, 12), {1, 1, 1}, 0.01},
                                         MeshCase{"hollow_ball", shell(k_middle, 6, 12), {1, 1, 1}, 0.02},
                                         MeshCase{"torus", torus(k_middle, 9, 4), {1, 1, 1}, 0.03},
                                         MeshCase{"ball_slices2", ball({15, 15, 30}, 12), {1, 1, 2}, 0.03},
                                         MeshCase{"corner_touching",
                                                  [](const glm::dvec3& p) {
                                                      return (p.x <= 9 && p.y <= 9 && p.z <= 9) ||
                                                             (p.x > 9 && p.y > 9 && p.z > 9 && p.x < 20);
                                                  },
                                                  {1, 1, 1},
                                                  0.02},
                                         MeshCase{"edge_touching",
                                                  [](const glm::dvec3& p) {
                                                      return (p.x <= 9 && p.y <= 9) || (p.x > 9 && p.y > 9 && p.x < 20);
                                                  },
                                                  {1, 1, 1},
                                                  0.02},
                                         MeshCase{
                                             "whole_volume", [](const glm::dvec3&) { return true; }, {1, 1, 1}, 0.01}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(RegionMeshes, OfRandomMasksAreClosed) {
    for (int seed = 0; seed < 10; ++seed) {
        Noise noise(seed + 31);
        const Volume volume = volume_of<std::uint8_t>(grid({12, 11, 10}),
                                                      [&](int, int, int) { return noise.below(10) <= seed ? 100 : 0; });
        const RegionTable table = regions_of(volume, Connectivity::c26);
        for (std::size_t i = 0; i < std::min<std::size_t>(table.rows.size(), 10); ++i) {
            const TriangleMesh mesh = region_mesh(table.labels, table.rows[i]);
            ASSERT_TRUE(is_closed(mesh)) << "seed " << seed << " region " << i;
            ASSERT_GT(enclosed_volume_mm3(mesh), 0);
        }
    }
}

TEST(RegionMeshes, StandInMillimetresAndOutwardOnAMirroredGrid) {
    GridGeometry geometry = grid({9, 9, 9}, {0.5, 0.5, 0.5});
    geometry.origin = {10, 20, 30};
    geometry.direction = glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1);
    const Volume volume = volume_of<std::uint8_t>(
        geometry, [](int x, int y, int z) { return glm::length(glm::dvec3(x, y, z) - 4.0) < 3 ? 100 : 0; });
    const RegionTable table = regions_of(volume);
    const TriangleMesh mesh = region_mesh(table.labels, table.rows.at(0));
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_GT(enclosed_volume_mm3(mesh), 0);
    glm::dvec3 middle(0);
    for (const glm::dvec3& v : mesh.vertices) middle += v / double(mesh.vertices.size());
    EXPECT_LE(glm::length(middle - glm::dvec3(8, 22, 32)), 1e-9);
}

TEST(RegionMask, CoversTheBoxAndHoldsTheRegionAlone) {
    const Volume volume = volume_of<std::uint8_t>(grid({8, 7, 6}), [](int x, int y, int z) {
        return (x >= 2 && x <= 4 && y == 3 && z >= 1 && z <= 2) || (x == 3 && y == 4 && z == 1) || x == 7 ? 100 : 0;
    });
    const RegionTable table = regions_of(volume);
    const RegionCharacteristics& row = table.rows.at(1);
    const std::vector<std::uint8_t> mask = region_mask(table.labels, row);
    const glm::ivec3 extent = row.bbox_last - row.bbox_first + 1;
    EXPECT_EQ(extent, glm::ivec3(3, 2, 2));
    EXPECT_EQ(mask, (std::vector<std::uint8_t>{1, 1, 1, 0, 1, 0, 1, 1, 1, 0, 0, 0}));
    RegionCharacteristics beyond = row;
    beyond.bbox_last.x = 8;
    EXPECT_THROW(region_mask(table.labels, beyond), Error);
}

TEST(RegionMeshes, ACancelStopsTheMesher) {
    const Volume volume = volume_of<std::uint8_t>(grid({20, 20, 20}), [](int, int, int) { return 100; });
    const RegionTable table = regions_of(volume);
    std::stop_source source;
    const JobContext job{source.get_token(), [&](double f) {
                             if (f > 0.4) source.request_stop();
                         }};
    EXPECT_THROW(region_mesh(table.labels, table.rows.at(0), job), Error);
}

}  // namespace
}  // namespace lacuna::test
