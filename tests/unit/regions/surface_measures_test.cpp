// What measure_surfaces() adds to a row, against bodies whose measures are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/parallel.h"
#include "core/regions/part_outline.h"
#include "core/regions/surface_mesher.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

constexpr double k_pi = std::numbers::pi, k_air = 1000, k_metal = 9000;

struct Ball {
    glm::dvec3 centre;
    double radius;
};

double gaussian_share(double distance, double sigma) { return 0.5 * std::erfc(distance / (std::sqrt(2.0) * sigma)); }

/// A block of metal in air with balls of air in it, its edges blurred by sigma (mm).
Volume block_with_balls(const GridGeometry& g, double margin_mm, const std::vector<Ball>& balls, double sigma) {
    const glm::dvec3 half = 0.5 * glm::dvec3(g.size - 1) * g.spacing;
    return volume_of<std::uint16_t>(g, [&](int x, int y, int z) {
        const glm::dvec3 p = glm::dvec3(x, y, z) * g.spacing;
        const glm::dvec3 out = glm::abs(p - half) - (half - margin_mm);
        double metal = gaussian_share(std::max({out.x, out.y, out.z}), sigma);
        for (const Ball& b : balls) metal -= gaussian_share(glm::length(p - b.centre) - b.radius, sigma);
        return std::lround(k_air + (k_metal - k_air) * std::max(0.0, metal));
    });
}

RegionTable voids_of(const Volume& volume) {
    RegionOptions options;
    options.threshold = ValueRange{0, (k_air + k_metal) / 2};
    RegionTable table = find_regions(volume, options);
    measure_surfaces(volume, table);
    return table;
}

const RegionCharacteristics& row_at(const RegionTable& table, const glm::dvec3& mm) {
    const glm::ivec3 p(glm::round(table.labels.geometry.mm_to_voxel(mm)));
    const std::uint32_t id = table.labels(p.x, p.y, p.z);
    EXPECT_GT(id, 0u);
    return table.rows[id - 1];
}

TEST(RegionSurfaces, MeasureBallsInABlock) {
    for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(0.5, 0.5, 1)}) {
        const glm::ivec3 size(glm::round(glm::dvec3(48, 44, 40) / spacing));
        const GridGeometry g = grid(size, spacing);
        const glm::dvec3 end = glm::dvec3(size - 1) * spacing;
        const Ball a{{16, 20, 20}, 5}, b{{31, 20, 20}, 4};
        const RegionTable table = voids_of(block_with_balls(g, 4, {a, b}, 0.6));
        ASSERT_EQ(table.rows.size(), 3u);
        for (const Ball& ball : {a, b}) {
            const RegionCharacteristics& row = row_at(table, ball.centre);
            const double r = ball.radius, area = 4 * k_pi * r * r;
            // An edge kept at 50 % by the distance to it holds that much more than the ball: by parts, to first order.
            const double volume = area * r / 3 + 4 * k_pi * r * 0.36;
            EXPECT_NEAR(row.surface_mesh_mm2, area, 0.03 * area);
            EXPECT_NEAR(row.surface_crofton_mm2, area, 0.06 * area);
            EXPECT_NEAR(row.diameter_mm, 2 * r, 0.12);
            EXPECT_NEAR(row.integral_volume_mm3, volume, 0.01 * volume) << "blur takes nothing of partial volumes";
            EXPECT_GE(row.diameter_mm, row.equivalent_diameter_mm);
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(row.projected_area_mm2[axis], k_pi * r * r, 0.06 * k_pi * r * r);
            EXPECT_NEAR(row.gap_mm, 15 - 9, 0.1);
            for (const std::string& flag : row.flags)
                EXPECT_EQ(flag, "surface_clamped") << "a ball may read below its own surface";
        }
        EXPECT_NEAR(row_at(table, a.centre).surface_distance_mm, 16 - 5 - 4, 0.1);
        EXPECT_NEAR(row_at(table, b.centre).surface_distance_mm, end.x - 4 - 31 - 4, 0.1);
        EXPECT_EQ(row_at(table, {0, 0, 0}).surface_distance_mm, 0) << "the air round the part";
        EXPECT_NEAR(row_at(table, {0, 0, 0}).gap_mm, std::min(7.0, end.x - 39), 0.1);
    }
}

TEST(RegionSurfaces, IntervalsHoldTheTrueVolumesAndGaps) {
    for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(0.5, 0.5, 1), glm::dvec3(0.4, 0.4, 2)})
        for (const double sigma : {0.05, 0.4, 0.8}) {
            const glm::ivec3 size(glm::round(glm::dvec3(64, 40, 36) / spacing));
            const Ball balls[] = {{{14.3, 20.2, 18.4}, 6}, {{28.6, 20.4, 18.1}, 4.2}, {{40.2, 19.7, 17.6}, 3}};
            const Volume volume = block_with_balls(grid(size, spacing), 4, {balls[0], balls[1], balls[2]}, sigma);
            const RegionTable table = voids_of(volume);
            for (const Ball& ball : balls) {
                const RegionCharacteristics& row = row_at(table, ball.centre);
                const double truth = 4.0 / 3 * k_pi * std::pow(ball.radius, 3);
                EXPECT_LE(row.volume_lo_mm3, truth) << spacing.z << " " << sigma << " " << ball.radius;
                EXPECT_GE(row.volume_hi_mm3, truth) << spacing.z << " " << sigma << " " << ball.radius;
                EXPECT_LE(row.volume_lo_mm3, row.volume_mm3);
                EXPECT_GE(row.volume_hi_mm3, row.volume_mm3);
                EXPECT_LE(row.volume_hi_mm3 - row.volume_lo_mm3, (ball.radius > 4 ? 0.6 : 1.0) * truth);
            }
            const auto between = [&](int a, int b) {
                return glm::length(balls[a].centre - balls[b].centre) - balls[a].radius - balls[b].radius;
            };
            const RegionCharacteristics& last = row_at(table, balls[2].centre);
            EXPECT_LE(last.gap_lo_mm, between(1, 2));
            EXPECT_GE(last.gap_hi_mm, between(1, 2));
            EXPECT_LE(last.gap_lo_mm, last.gap_mm);
            EXPECT_GE(last.gap_hi_mm, last.gap_mm);
        }
}

TEST(RegionSurfaces, OfWhatHasNoThresholdHaveNoVolumeInterval) {
    const Volume volume = block_with_balls(grid({24, 24, 24}), 4, {{{12, 12, 12}, 5}}, 0.5);
    RegionTable table = grown(volume, 0.2);
    measure_surfaces(volume, table);
    for (const RegionCharacteristics& row : table.rows) {
        EXPECT_TRUE(std::isnan(row.volume_lo_mm3) && std::isnan(row.volume_hi_mm3));
        EXPECT_EQ(row.gap_lo_mm, 0) << "grown regions touch";
        EXPECT_EQ(row.gap_hi_mm, 1) << "by half a voxel on either side";
    }
    // Between two thresholds there is no one level on the other side.
    RegionOptions options;
    options.threshold = ValueRange{3000, 7000};
    table = find_regions(volume, options);
    measure_surfaces(volume, table);
    for (const RegionCharacteristics& row : table.rows) EXPECT_TRUE(std::isnan(row.volume_lo_mm3));
}

TEST(RegionSurfaces, KeepTheirDigitsFarFromTheOrigin) {
    GridGeometry g = grid({32, 30, 28}, glm::dvec3(0.01));
    RegionOptions options;
    options.threshold = ValueRange{0, (k_air + k_metal) / 2};
    Volume volume = block_with_balls(grid({32, 30, 28}), 5, {{{12, 15, 14}, 2}, {{19, 15, 14}, 2}}, 0.5);
    std::vector<RegionTable> tables;
    for (const glm::dvec3& origin : {glm::dvec3(0), glm::dvec3(1e6, -1e6, 3e5)}) {
        g.origin = origin;
        volume = Volume(g, volume.type(), volume.buffer());
        tables.push_back(find_regions(volume, options));
        measure_surfaces(volume, tables.back());
    }
    ASSERT_EQ(tables[0].rows.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(tables[1].rows[i].gap_mm, tables[0].rows[i].gap_mm, 1e-5);
        EXPECT_NEAR(tables[1].rows[i].surface_distance_mm, tables[0].rows[i].surface_distance_mm, 1e-5);
        EXPECT_NEAR(tables[1].rows[i].diameter_mm, tables[0].rows[i].diameter_mm, 1e-5);
    }
}

TEST(RegionSurfaces, OfMaterialReachThePartsSurface) {
    const GridGeometry g = grid({32, 30, 28});
    RegionOptions options;
    options.threshold = ValueRange{(k_air + k_metal) / 2, 65535};
    const Ball pore{{15, 15, 14}, 4};
    RegionTable table = find_regions(block_with_balls(g, 5, {pore}, 0.5), options);
    measure_surfaces(block_with_balls(g, 5, {pore}, 0.5), table);
    ASSERT_EQ(table.rows.size(), 1u);
    const RegionCharacteristics& row = table.rows[0];
    const glm::dvec3 side(21, 19, 17);
    const double volume = side.x * side.y * side.z - 4.0 / 3 * k_pi * 64 - 4 * k_pi * 4 * 0.25;
    EXPECT_EQ(row.surface_distance_mm, 0);
    EXPECT_EQ(row.gap_mm, std::numeric_limits<double>::infinity()) << "there is no other region";
    EXPECT_NEAR(row.integral_volume_mm3, volume, 0.02 * volume);
    EXPECT_NEAR(row.diameter_mm, glm::length(side), 1.5) << "the corners are blurred";
    EXPECT_NEAR(row.projected_area_mm2.z, side.x * side.y, 1.05 * (side.x + side.y)) << "half a voxel all round";
}

TEST(RegionSurfaces, OfGrownRegionsTakeTheirSurroundingsAsTheyAre) {
    const GridGeometry g = grid({40, 40, 40});
    const Ball pore{{20, 20, 20}, 7};
    const Volume volume = block_with_balls(g, 4, {pore}, 0.6);
    RegionTable table = grown(volume, 0.1);
    measure_surfaces(volume, table);
    const RegionCharacteristics& row = row_at(table, pore.centre);
    const double ball = 4.0 / 3 * k_pi * 343 + 4 * k_pi * 7 * 0.36;
    EXPECT_NEAR(row.integral_volume_mm3, ball, 0.02 * ball) << "the blurred edge is made of other regions";
    EXPECT_LT(row.volume_mm3, 0.9 * ball);
    EXPECT_EQ(row.gap_mm, 0) << "grown regions touch";
    std::size_t unclear = 0;
    for (const RegionCharacteristics& r : table.rows) {
        const bool flagged = std::find(r.flags.begin(), r.flags.end(), "sides_unclear") != r.flags.end();
        EXPECT_EQ(flagged, std::isnan(r.integral_volume_mm3));
        unclear += flagged;
    }
    EXPECT_GT(unclear, 0u) << "shells between two levels have no outside of one level";
}

TEST(RegionSurfaces, AreTheSameForAnyNumberOfThreads) {
    const GridGeometry g = grid({40, 36, 33}, {0.3, 0.3, 0.5});
    std::mt19937 dice(7);
    const Volume volume = volume_of<std::uint16_t>(g, [&](int x, int y, int z) {
        return 500 + 300 * std::sin(x * 0.4) * std::cos(y * 0.5 + z * 0.3) + dice() % 90;
    });
    std::string first;
    for (const int threads : {1, 2, 5}) {
        set_thread_count(threads);
        RegionOptions options;
        options.threshold = ValueRange{0, 430};
        RegionTable table = find_regions(volume, options);
        measure_surfaces(volume, table);
        const std::string csv = regions_to_csv(table);
        if (first.empty()) first = csv;
        EXPECT_EQ(csv, first) << threads;
    }
    set_thread_count(0);
}

TEST(RegionSurfaces, NeverSayWhatCannotBe) {
    std::mt19937 dice(3);
    const Volume volume = volume_of<float>(
        grid({30, 1, 27}, {1, 1, 5}), [&](int x, int, int z) { return (x * z) % 11 == 0 ? NAN : float(dice() % 100); });
    for (const bool growing : {false, true}) {
        RegionOptions options;
        if (growing)
            options.range_width = 0.2;
        else
            options.threshold = ValueRange{-INFINITY, 50};
        RegionTable table = find_regions(volume, options);
        measure_surfaces(volume, table);
        ASSERT_GT(table.rows.size(), 10u);
        for (const RegionCharacteristics& r : table.rows) {
            EXPECT_GE(r.diameter_mm, r.equivalent_diameter_mm);
            EXPECT_GT(r.surface_mesh_mm2, 0);
            EXPECT_FALSE(r.integral_volume_mm3 <= 0);
            EXPECT_GE(r.surface_distance_mm, 0);
            EXPECT_GE(r.gap_mm, 0);
            EXPECT_LE(r.projected_area_mm2.y, double(r.voxels) * 5 + 1e-9);
        }
    }
}

TEST(RegionSurfaces, OfOneValueHaveNoPart) {
    const Volume volume = volume_of<std::uint8_t>(grid({5, 4, 3}), [](int, int, int) { return 7; });
    RegionTable table = grown(volume, 0.5);
    measure_surfaces(volume, table);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_TRUE(std::isnan(table.rows[0].surface_distance_mm));
    EXPECT_TRUE(std::isnan(table.rows[0].integral_volume_mm3)) << "there is nothing to tell it from";
    EXPECT_NEAR(table.rows[0].diameter_mm, glm::length(glm::dvec3(5, 4, 3)), 1);
}

TEST(RegionSurfaces, WantTheVolumeTheLabelsWereMadeFrom) {
    RegionTable table = regions_of(mask_volume(grid({8, 8, 8}), ball({4, 4, 4}, 2)));
    EXPECT_THROW(measure_surfaces(mask_volume(grid({8, 8, 9}), ball({4, 4, 4}, 2)), table), Error);
}

TEST(SurfaceMesher, TakenPieceByPieceIsTheSameSurface) {
    const Volume volume = block_with_balls(grid({20, 19, 18}), 3, {{{9, 9, 8}, 4}}, 0.7);
    const glm::ivec3 extent = volume.geometry().size + 2;
    SurfaceMesher whole(extent, glm::ivec3(-1), volume.geometry(), {5000, 70000}), pieces = whole;
    const std::size_t plane = std::size_t(extent.x) * std::size_t(extent.y);
    double area = 0;
    std::size_t triangles = 0, most = 0;
    for (int z = 0; z < extent.z; ++z) {
        std::vector<std::uint8_t> inside(plane);
        std::vector<float> values(plane, NAN);
        for (int y = 1; y + 1 < extent.y && z > 0 && z + 1 < extent.z; ++y)
            for (int x = 1; x + 1 < extent.x; ++x) {
                const double v = volume.value(x - 1, y - 1, z - 1);
                const std::size_t i = std::size_t(y) * std::size_t(extent.x) + std::size_t(x);
                values[i] = float(v);
                inside[i] = v >= 5000;
            }
        whole.push(inside.data(), values.data());
        pieces.push(inside.data(), values.data());
        const TriangleMesh piece = pieces.take();
        area += area_mm2(piece);
        triangles += piece.triangles.size();
        most = std::max(most, piece.triangles.size());
        for (const auto& t : piece.triangles)
            for (const std::uint32_t v : t) ASSERT_LT(v, piece.vertices.size());
    }
    const TriangleMesh mesh = whole.finish();
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_EQ(triangles, mesh.triangles.size());
    EXPECT_NEAR(area, area_mm2(mesh), 1e-9 * area);
    EXPECT_LT(most, triangles / 4);
    EXPECT_TRUE(pieces.finish().triangles.empty());
}

}  // namespace
}  // namespace lacuna::test
