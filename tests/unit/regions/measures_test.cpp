#include <gtest/gtest.h>

#include <numbers>

#include "core/regions/neighbourhood.h"
#include "core/regions/principal_axes.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

constexpr double pi = std::numbers::pi;

/// The grid with a box of the given extent in mm round the origin.
GridGeometry grid_round_origin(const glm::dvec3& half_mm, const glm::dvec3& spacing) {
    GridGeometry geometry;
    const glm::ivec3 half(glm::ceil(half_mm / spacing) + 2.0);
    geometry.size = 2 * half + 1;
    geometry.spacing = spacing;
    geometry.origin = -glm::dvec3(half) * spacing;
    return geometry;
}

TEST(DirectionWeights, SumToOneAndKnowTheIsotropicGrid) {
    const auto w = neighbourhood::direction_weights(glm::dvec3(1));
    double sum = 0;
    for (int k = 0; k < 13; ++k) {
        const glm::ivec3 d = glm::abs(neighbourhood::earlier_offset(k));
        const int steps = d.x + d.y + d.z;  // Lehmann & Legland 2012, table 2
        EXPECT_NEAR(w[std::size_t(k)],
                    steps == 1   ? 0.04577789 * 2
                    : steps == 2 ? 0.03698062 * 2
                                 : 0.03519563 * 2,
                    2e-4);
        sum += w[std::size_t(k)];
    }
    EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(Surface, OfEveryPlaneStaysWithinTheStatedBound) {
    // The estimate of a plane across n is 2 * sum w |n.d|: exact counting, so this is the method's own error.
    struct Row {
        glm::dvec3 spacing;
        double worst, sd;
    };
    for (const Row& row : {Row{{1, 1, 1}, 0.074, 0.0165}, Row{{1, 1, 2}, 0.126, 0.057}, Row{{1, 1, 5}, 0.233, 0.074}}) {
        const auto w = neighbourhood::direction_weights(row.spacing);
        const auto error_of = [&](const glm::dvec3& normal) {
            double estimate = 0;
            for (int k = 0; k < 13; ++k)
                estimate += 2 * w[std::size_t(k)] *
                            std::abs(glm::dot(
                                normal, glm::normalize(glm::dvec3(neighbourhood::earlier_offset(k)) * row.spacing)));
            return estimate - 1;
        };
        double worst = 0, square = 0, sum = 0;
        constexpr int k_normals = 4000;
        for (int i = 0; i < k_normals; ++i) {
            const double z = (i + 0.5) / k_normals, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
            const double error = error_of({r * std::cos(a), r * std::sin(a), z});
            worst = std::max(worst, std::abs(error));
            square += error * error;
            sum += error;
        }
        // The faces of boxes along the grid, which no lattice of normals meets: the worst there are.
        for (const glm::dvec3 face : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
            worst = std::max(worst, std::abs(error_of(face)));
        EXPECT_LE(worst, row.worst) << "spacing z " << row.spacing.z;
        EXPECT_GE(worst, 0.98 * row.worst) << "the bound stated is the true one, spacing z " << row.spacing.z;
        EXPECT_LE(std::sqrt(square / k_normals), row.sd) << "spacing z " << row.spacing.z;
        EXPECT_NEAR(sum / k_normals, 0, 2e-3) << "right on average, spacing z " << row.spacing.z;
    }
}

/// Both estimates of a body's surface against the true one, as shares of it: what docs/regions.md states.
struct SurfaceCase {
    const char* name;
    double slice_mm;
    bool is_box;
    double crofton, mesh, off;  // expected deviations, and how far they may be off
};
class SurfaceEstimates : public testing::TestWithParam<SurfaceCase> {};
TEST_P(SurfaceEstimates, DeviateByWhatTheDocsSay) {
    const auto& [name, slice_mm, is_box, crofton, mesh, off] = GetParam();
    const glm::dvec3 spacing(1, 1, slice_mm);
    double sum_crofton = 0, sum_mesh = 0;
    int count = 0;
    for (const double size : {40.0, 60.0}) {
        // Moved against the grid: of a box the faces keep their place half way between voxels.
        for (const glm::dvec3 moved : {glm::dvec3(0), glm::dvec3(0.3, 0.4, 0.2), glm::dvec3(0.1, 0.7, 0.4)}) {
            const glm::dvec3 centre = spacing * (is_box ? glm::dvec3(0.5) : moved);
            const Volume volume =
                mask_volume(grid_round_origin(glm::dvec3(size / 2 + 1), spacing), [&](const glm::dvec3& p) {
                    const glm::dvec3 d = glm::abs(p - centre);
                    return is_box ? std::max({d.x, d.y, d.z}) < size / 2 : glm::length(d) <= size / 2;
                });
            RegionTable table = regions_of(volume);
            measure_surfaces(volume, table);
            ASSERT_EQ(table.rows.size(), 1u);
            const double truth = is_box ? 6 * size * size : pi * size * size;
            if (is_box) EXPECT_NEAR(table.rows[0].volume_mm3, size * size * size, 1e-6);
            sum_crofton += table.rows[0].surface_crofton_mm2 / truth - 1;
            sum_mesh += table.rows[0].surface_mesh_mm2 / truth - 1;
            ++count;
            if (is_box) break;
        }
    }
    RecordProperty("crofton", std::to_string(sum_crofton / count));
    RecordProperty("mesh", std::to_string(sum_mesh / count));
    EXPECT_NEAR(sum_crofton / count, crofton, off);
    EXPECT_NEAR(sum_mesh / count, mesh, off);
}
INSTANTIATE_TEST_SUITE_P(Measures, SurfaceEstimates,
                         testing::Values(SurfaceCase{"ball_1", 1, false, 0, 0.085, 0.01},
                                         SurfaceCase{"ball_2", 2, false, 0, 0.125, 0.01},
                                         SurfaceCase{"ball_5", 5, false, 0, 0.235, 0.01},
                                         SurfaceCase{"box_1", 1, true, -0.08, -0.01, 0.01},
                                         SurfaceCase{"box_2", 2, true, -0.11, -0.01, 0.01},
                                         SurfaceCase{"box_5", 5, true, -0.18, -0.015, 0.01}),
                         [](const auto& row) { return std::string(row.param.name); });

struct BallCase {
    const char* name;
    double radius;
    glm::dvec3 spacing;
    double volume_bound, surface_bound;  // relative, against the ideal ball
};
class BallMeasures : public testing::TestWithParam<BallCase> {};
TEST_P(BallMeasures, LieWithinTheStatedBounds) {
    const auto& [name, radius, spacing, volume_bound, surface_bound] = GetParam();
    const RegionTable table =
        regions_of(mask_volume(grid_round_origin(glm::dvec3(radius), spacing), ball(glm::dvec3(0), radius)));
    ASSERT_EQ(table.rows.size(), 1u);
    const RegionCharacteristics& row = table.rows[0];
    const double volume = 4 * pi / 3 * std::pow(radius, 3), surface = 4 * pi * radius * radius;
    EXPECT_LE(std::abs(row.volume_mm3 / volume - 1), volume_bound) << row.volume_mm3 / volume - 1;
    EXPECT_LE(std::abs(row.surface_mm2 / surface - 1), surface_bound) << row.surface_mm2 / surface - 1;
    EXPECT_GE(row.shape_factor, 36 * pi * (1 - 1e-12));
    EXPECT_LE(row.sphericity, 1);
    EXPECT_LE(glm::length(row.centroid_mm), 1e-9);
    // Equal axes: the ball's diameter, as far as the voxels have its volume.
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(row.principal_lengths_mm[axis], 2 * radius, 0.75 * spacing.z);
    EXPECT_NEAR(row.equivalent_diameter_mm, std::cbrt(6 * row.volume_mm3 / pi), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(
    Measures, BallMeasures,
    testing::Values(BallCase{"r1", 1, {1, 1, 1}, 0.70, 0.45}, BallCase{"r2", 2, {1, 1, 1}, 0.05, 0.12},
                    BallCase{"r3", 3, {1, 1, 1}, 0.10, 0.08}, BallCase{"r4", 4, {1, 1, 1}, 0.05, 0.05},
                    BallCase{"r6", 6, {1, 1, 1}, 0.03, 0.03}, BallCase{"r9", 9, {1, 1, 1}, 0.02, 0.02},
                    BallCase{"r12", 12, {1, 1, 1}, 0.015, 0.02}, BallCase{"r12_fine", 12, {0.5, 0.5, 0.5}, 0.01, 0.02},
                    BallCase{"r15_slices5", 15, {1, 1, 5}, 0.05, 0.08},
                    BallCase{"r25_slices5", 25, {1, 1, 5}, 0.02, 0.05},
                    BallCase{"r12_rows2", 12, {1, 2, 1}, 0.02, 0.03}),
    [](const auto& row) { return std::string(row.param.name); });

struct CrackCase {
    const char* name;
    glm::dvec3 normal, spacing;
    double thickness, bound;  // bound of the surface, relative
};
class CrackSurface : public testing::TestWithParam<CrackCase> {};
TEST_P(CrackSurface, OfAFlatTiltedDiscIsRight) {
    const auto& [name, normal, spacing, thickness, bound] = GetParam();
    const double radius = 30;
    const RegionTable table = regions_of(mask_volume(grid_round_origin(glm::dvec3(radius + thickness), spacing),
                                                     disc(glm::dvec3(0), normal, radius, thickness)),
                                         Connectivity::c26);
    ASSERT_EQ(table.rows.size(), 1u);
    const double surface = 2 * pi * radius * radius + 2 * pi * radius * thickness;
    EXPECT_LE(std::abs(table.rows[0].surface_mm2 / surface - 1), bound) << table.rows[0].surface_mm2 / surface - 1;
    EXPECT_NEAR(table.rows[0].volume_mm3, pi * radius * radius * thickness, 0.05 * pi * radius * radius * thickness);
    EXPECT_NEAR(table.rows[0].principal_lengths_mm.x, 2 * radius * std::sqrt(5.0 / 4), 1.5);
    EXPECT_EQ(table.rows[0].holes, 0);
    EXPECT_EQ(table.rows[0].tunnels, 0);
}
INSTANTIATE_TEST_SUITE_P(Measures, CrackSurface,
                         testing::Values(CrackCase{"flat", {0, 0, 1}, {1, 1, 1}, 5, 0.09},
                                         CrackCase{"along_x", {1, 0, 0}, {1, 1, 1}, 5, 0.09},
                                         CrackCase{"tilt_30", {0.5, 0, 0.866}, {1, 1, 1}, 5, 0.05},
                                         CrackCase{"tilt_odd", {0.31, 0.52, 0.79}, {1, 1, 1}, 5, 0.05},
                                         CrackCase{"flat_slices5", {0, 0, 1}, {1, 1, 5}, 15, 0.225},
                                         CrackCase{"upright_slices5", {1, 0, 0}, {1, 1, 5}, 15, 0.225},
                                         CrackCase{"tilt_30_slices5", {0.5, 0, 0.866}, {1, 1, 5}, 15, 0.225},
                                         CrackCase{"tilt_60_slices5", {0.866, 0, 0.5}, {1, 1, 5}, 15, 0.225},
                                         CrackCase{"tilt_odd_slices5", {0.31, 0.52, 0.79}, {1, 1, 5}, 15, 0.225}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Surface, ASheetOneVoxelThickCountsBothSides) {
    const RegionTable table =
        regions_of(volume_of<std::uint8_t>(grid({64, 64, 9}), [](int, int, int z) { return z == 4 ? 100 : 0; }));
    // Both faces and the rim's four narrow ones; planes along the axes are the method's worst, and the rim is rounded.
    EXPECT_NEAR(table.rows[0].surface_mm2, 2 * 64 * 64 + 4 * 64, 0.10 * 2 * 64 * 64);
}

TEST(Surface, CountsTheFrameAsARegionsEnd) {
    const RegionTable table =
        regions_of(volume_of<std::uint8_t>(grid({40, 40, 40}), [](int, int, int) { return 100; }));
    EXPECT_NEAR(table.rows[0].surface_mm2, 6 * 1600, 0.09 * 6 * 1600);
    EXPECT_TRUE(table.rows[0].touches_border);
}

TEST(Measures, AnAxisOfOneVoxelHasNoBorder) {
    // A block with two specks: one in the middle, one that reaches an end of the plane.
    for (int thin = 0; thin < 3; ++thin) {
        glm::ivec3 size(21);
        size[thin] = 1;
        const RegionTable table = regions_of(volume_of<std::uint8_t>(grid(size, {1, 1, 5}), [&](int x, int y, int z) {
            const int a = thin == 0 ? y : x, b = thin == 2 ? y : z;
            const auto speck = [&](int u, int v) { return std::abs(a - u) + std::abs(b - v) <= 2; };
            return speck(10, 10) ? 100 : speck(1, 15) ? 100 : 0;
        }));
        ASSERT_EQ(table.rows.size(), 2u);
        EXPECT_FALSE(table.rows[0].touches_border) << "thin along " << thin;
        EXPECT_TRUE(table.rows[1].touches_border) << "thin along " << thin;
    }
    const RegionTable row = regions_of(
        volume_of<std::uint8_t>(grid({1, 1, 9}), [](int, int, int z) { return z == 0 || z == 4 || z == 5 ? 100 : 0; }));
    ASSERT_EQ(row.rows.size(), 2u);
    EXPECT_FALSE(row.rows[0].touches_border);
    EXPECT_TRUE(row.rows[1].touches_border);
}

TEST(Surface, IsNeverLessThanTheBallsAndSaysWhenItWas) {
    const RegionTable table = regions_of(mask_volume(grid({5, 5, 5}), ball({2, 2, 2}, 0.5)));
    const RegionCharacteristics& row = table.rows.at(0);
    EXPECT_EQ(row.voxels, 1);
    EXPECT_EQ(row.sphericity, 1);
    EXPECT_DOUBLE_EQ(row.shape_factor, 36 * pi);
    EXPECT_NEAR(std::pow(row.surface_mm2, 3) / std::pow(row.volume_mm3, 2), 36 * pi, 1e-9);
    ASSERT_EQ(row.flags.size(), 1u);
    EXPECT_EQ(row.flags[0], "surface_clamped");
}

TEST(Measures, OfATorusMatchItsClosedForm) {
    const RegionTable table =
        regions_of(mask_volume(grid_round_origin(glm::dvec3(28, 28, 8), glm::dvec3(1)), torus(glm::dvec3(0), 20, 6)));
    const RegionCharacteristics& row = table.rows.at(0);
    EXPECT_NEAR(row.volume_mm3, 2 * pi * pi * 20 * 36, 0.03 * row.volume_mm3);
    EXPECT_NEAR(row.surface_mm2, 4 * pi * pi * 20 * 6, 0.03 * row.surface_mm2);
    EXPECT_EQ(row.tunnels, 1);
}

TEST(Measures, OfABoxAreExactInPositionExtentAndMoments) {
    const glm::dvec3 spacing(0.5, 0.25, 2);
    GridGeometry geometry = grid({20, 30, 10}, spacing);
    geometry.origin = {-7, 3, 11};
    const Volume volume = volume_of<std::uint8_t>(geometry, [](int x, int y, int z) {
        return x >= 3 && x < 13 && y >= 4 && y < 24 && z >= 2 && z < 7 ? 100 : 0;
    });
    const RegionCharacteristics row = regions_of(volume).rows.at(0);
    EXPECT_EQ(row.voxels, 10 * 20 * 5);
    EXPECT_DOUBLE_EQ(row.volume_mm3, 1000 * 0.25);
    const auto expect_near = [](const glm::dvec3& a, const glm::dvec3& b) {
        EXPECT_LE(glm::length(a - b), 1e-9) << a.x << ' ' << a.y << ' ' << a.z;
    };
    expect_near(row.bbox_min_mm, geometry.voxel_to_mm({2.5, 3.5, 1.5}));
    expect_near(row.bbox_max_mm, geometry.voxel_to_mm({12.5, 23.5, 6.5}));
    expect_near(row.centroid_mm, geometry.voxel_to_mm({7.5, 13.5, 4}));
    // A box of edge a has the moment a^2/12: its ellipsoid's axis is a * sqrt(5/3).
    expect_near(row.principal_lengths_mm, std::sqrt(5.0 / 3) * glm::dvec3(10, 5, 5));
    EXPECT_EQ(row.bbox_first, glm::ivec3(3, 4, 2));
    EXPECT_EQ(row.bbox_last, glm::ivec3(12, 23, 6));
    EXPECT_FALSE(row.touches_border);
}

TEST(Measures, FollowAnObliqueDirection) {
    GridGeometry geometry = grid({21, 21, 21}, {1, 1, 2});
    const double c = std::cos(0.5), s = std::sin(0.5);
    geometry.direction = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1);
    geometry.origin = {100, -50, 25};
    const Volume volume = volume_of<std::uint8_t>(
        geometry, [](int x, int y, int z) { return x >= 5 && x <= 14 && y == 10 && z == 10 ? 100 : 0; });
    const RegionCharacteristics row = regions_of(volume).rows.at(0);
    EXPECT_LE(glm::length(row.centroid_mm - geometry.voxel_to_mm({9.5, 10, 10})), 1e-9);
    EXPECT_NEAR(row.bbox_max_mm.x - row.bbox_min_mm.x, 10 * c + 1 * s, 1e-9);
    EXPECT_NEAR(row.bbox_max_mm.y - row.bbox_min_mm.y, 10 * s + 1 * c, 1e-9);
    EXPECT_NEAR(row.bbox_max_mm.z - row.bbox_min_mm.z, 2, 1e-9);
    EXPECT_NEAR(row.principal_lengths_mm.x, 10 * std::sqrt(5.0 / 3), 1e-9);
}

TEST(Measures, ValueStatisticsKeepTheirDigitsUnderALargeOffset) {
    const Volume volume =
        volume_of<float>(grid({64, 64, 16}), [](int x, int y, int z) { return 1e6f + float((x + y + z) % 4); });
    RegionOptions options;
    options.threshold = ValueRange{1e6, 1e6 + 10};
    const RegionCharacteristics row = find_regions(volume, options).rows.at(0);
    EXPECT_DOUBLE_EQ(row.mean, 1e6 + 1.5);
    EXPECT_NEAR(row.stddev, std::sqrt(1.25), 1e-12);
    EXPECT_EQ(row.min, 1e6);
    EXPECT_EQ(row.max, 1e6 + 3);
}

TEST(Measures, FractionsOfAPartitionSumToOne) {
    Noise noise(2);
    const Volume volume = volume_of<std::uint8_t>(grid({20, 20, 20}), [&](int, int, int) { return noise.below(9); });
    double sum = 0;
    for (const RegionCharacteristics& row : grown(volume, 0.3).rows) sum += row.fraction;
    EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(PrincipalAxes, EigenvaluesOfKnownMatrices) {
    const auto expect = [](const SymmetricMatrix& m, const glm::dvec3& values) {
        EXPECT_LE(glm::length(eigenvalues_descending(m) - values), 1e-12 * (1 + glm::length(values)));
    };
    expect({}, {0, 0, 0});
    expect({.xx = 1, .yy = 3, .zz = 2, .xy = 0, .xz = 0, .yz = 0}, {3, 2, 1});
    expect({.xx = 2, .yy = 2, .zz = 2, .xy = 1, .xz = 1, .yz = 1}, {4, 1, 1});
    expect({.xx = 1e12, .yy = 1, .zz = 1, .xy = 0, .xz = 0, .yz = 0.5}, {1e12, 1.5, 0.5});
}

}  // namespace
}  // namespace lacuna::test
