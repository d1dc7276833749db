#include "core/session/measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace lacuna {
namespace {

/// x-ramp: the value is 10 times the position along the grid's x axis, in mm from the first voxel's centre.
Volume ramp(const GridGeometry& grid) {
    return make_volume<float>(grid, [&](std::span<float> v) {
        for (int z = 0; z < grid.size.z; ++z)
            for (int y = 0; y < grid.size.y; ++y)
                for (int x = 0; x < grid.size.x; ++x)
                    v[std::size_t(grid.linear_index(x, y, z))] = float(10 * x * grid.spacing.x);
    });
}

GridGeometry grid(glm::ivec3 size, glm::dvec3 spacing, double turn_rad = 0) {
    GridGeometry g;
    g.size = size;
    g.spacing = spacing;
    g.origin = {3, -7, 100};
    g.direction = glm::dmat3(glm::mat3_cast(glm::angleAxis(turn_rad, glm::normalize(glm::dvec3(2, 1, -1)))));
    return g;
}

Measurement shape(MeasurementKind kind, const GridGeometry& g, glm::dvec3 a_voxel, glm::dvec3 b_voxel) {
    Measurement m;
    m.id = 1;
    m.kind = kind;
    m.points_mm = {g.voxel_to_mm(a_voxel), g.voxel_to_mm(b_voxel)};
    m.right = g.direction[0];
    m.down = g.direction[1];
    return m;
}

TEST(Measurement, LengthsAndAnglesAreThoseOfSpace) {
    Measurement m;
    m.points_mm = {{0, 0, 0}, {3, 4, 12}};
    EXPECT_DOUBLE_EQ(length_mm(m), 13);
    m.kind = MeasurementKind::angle;
    const auto angle = [&](glm::dvec3 a, glm::dvec3 b) {
        m.points_mm = {glm::dvec3(5, 5, 5) + a, {5, 5, 5}, glm::dvec3(5, 5, 5) + b};
        return angle_deg(m);
    };
    EXPECT_DOUBLE_EQ(angle({1, 0, 0}, {0, 0, 7}), 90);
    EXPECT_DOUBLE_EQ(angle({1, 0, 0}, {-2, 0, 0}), 180);
    EXPECT_NEAR(angle({1, 0, 0}, {1, 1e-9, 0}), 1e-9 * 180 / std::numbers::pi, 1e-13);
    EXPECT_NEAR(angle({1, 1, 0}, {1, 0, 0}), 45, 1e-12);
    EXPECT_EQ(angle({0, 0, 0}, {1, 0, 0}), 0);
}

struct SpacingCase {
    glm::dvec3 spacing;
    double turn_rad;
};
class Spacings : public testing::TestWithParam<SpacingCase> {};

TEST_P(Spacings, ARectanglesStatisticsAreTheClosedForm) {
    const GridGeometry g = grid({20, 16, 5}, GetParam().spacing, GetParam().turn_rad);
    const Volume volume = ramp(g);
    // Voxels 4..13 across, 2..6 down, on slice 3; the borders run between voxels.
    const Measurement m = shape(MeasurementKind::rectangle, g, {13.5, 1.5, 3.2}, {3.5, 6.5, 3.2});
    const RegionStatistics s = region_statistics(volume, m);
    const double unit = 10 * g.spacing.x;
    EXPECT_EQ(s.pixels, 50);
    EXPECT_NEAR(s.mean, 8.5 * unit, 1e-5 * unit);
    EXPECT_NEAR(s.stddev, unit * std::sqrt((10 * 10 - 1) / 12.0), 1e-5 * unit);  // discrete uniform distribution
    EXPECT_NEAR(s.min, 4 * unit, 1e-5 * unit);
    EXPECT_NEAR(s.max, 13 * unit, 1e-5 * unit);
    EXPECT_NEAR(area_mm2(m), 50 * g.spacing.x * g.spacing.y, 1e-9);
    EXPECT_NEAR(extent_mm(m).x, 10 * g.spacing.x, 1e-9);
}

TEST_P(Spacings, AnEllipseHoldsThePixelsWithTheirCentreInside) {
    const GridGeometry g = grid({40, 40, 3}, GetParam().spacing, GetParam().turn_rad);
    const Volume volume = ramp(g);
    const Measurement m = shape(MeasurementKind::ellipse, g, {4.3, 6.2, 1}, {33.1, 29.7, 1});
    std::int64_t pixels = 0;
    double sum = 0, squares = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const double u = (x - 18.7) / 14.4, v = (y - 17.95) / 11.75;
            if (u * u + v * v > 1) continue;
            const double value = volume.value(x, y, 1);
            ++pixels, sum += value, squares += value * value;
        }
    const RegionStatistics s = region_statistics(volume, m);
    EXPECT_EQ(s.pixels, pixels);
    EXPECT_NEAR(s.mean, sum / double(pixels), 1e-6 * s.max);
    EXPECT_NEAR(s.stddev, std::sqrt(squares / double(pixels) - s.mean * s.mean), 1e-5 * s.max);
    const double area = std::numbers::pi * 14.4 * 11.75 * g.spacing.x * g.spacing.y;
    EXPECT_NEAR(area_mm2(m), area, 1e-9 * area);
    EXPECT_NEAR(double(pixels) * g.spacing.x * g.spacing.y, area, 0.03 * area);
}
INSTANTIATE_TEST_SUITE_P(Grids, Spacings,
                         testing::Values(SpacingCase{{1, 1, 1}, 0}, SpacingCase{{1, 1, 5}, 0},
                                         SpacingCase{{0.4, 2, 5}, 0}, SpacingCase{{0.007, 0.007, 0.035}, 0.3},
                                         SpacingCase{{1, 5, 1}, 1.1}));

TEST(Measurement, RectanglesSideBySideShareNoPixel) {
    const GridGeometry g = grid({8, 8, 1}, {1, 1, 1});
    const Volume volume = ramp(g);
    const auto pixels = [&](glm::dvec3 a, glm::dvec3 b) {
        return region_statistics(volume, shape(MeasurementKind::rectangle, g, a, b)).pixels;
    };
    EXPECT_EQ(pixels({1, 1, 0}, {4, 3, 0}) + pixels({4, 1, 0}, {6, 3, 0}), pixels({1, 1, 0}, {6, 3, 0}));
    EXPECT_EQ(pixels({-20, -20, 0}, {20, 20, 0}), 64);  // beyond the volume nothing counts
    EXPECT_EQ(pixels({2.1, 2.1, 0}, {2.3, 2.4, 0}), 0);
}

TEST(Measurement, OnAnObliquePlaneTheMeanOfALinearVolumeIsThatOfTheMiddle) {
    const GridGeometry g = grid({40, 40, 20}, {0.5, 0.5, 1.5}, 0.2);
    const Volume volume = ramp(g);
    const glm::dmat3 turn(glm::mat3_cast(glm::angleAxis(0.5, glm::normalize(glm::dvec3(0.2, 1, 0.3)))));
    Measurement m;
    m.right = turn * g.direction[0];
    m.down = turn * g.direction[1];
    const glm::dvec3 middle = g.centre_mm();
    for (const MeasurementKind kind : {MeasurementKind::rectangle, MeasurementKind::ellipse}) {
        m.kind = kind;
        m.points_mm = {middle - 3.0 * m.right - 2.0 * m.down, middle + 3.0 * m.right + 2.0 * m.down};
        const RegionStatistics s = region_statistics(volume, m);
        const double expected = 10 * g.spacing.x * g.mm_to_voxel(middle).x;
        EXPECT_NEAR(s.mean, expected, 1e-3);
        EXPECT_NEAR(double(s.pixels) * 0.25, area_mm2(m), 0.1 * area_mm2(m));
        if (kind == MeasurementKind::rectangle) {
            // Spread of a uniform distribution along the ramp's direction, on 12 samples.
            const double slope = 10 * glm::dot(m.right, g.direction[0]), down = 10 * glm::dot(m.down, g.direction[0]);
            const double variance = slope * slope * 0.25 * (144 - 1) / 12 + down * down * 0.25 * (64 - 1) / 12;
            EXPECT_EQ(s.pixels, 12 * 8);
            EXPECT_NEAR(s.stddev, std::sqrt(variance), 1e-3);
        }
    }
}

TEST(Measurement, WithoutAValueThereAreNoStatistics) {
    const GridGeometry g = grid({4, 4, 1}, {1, 1, 1});
    const Volume volume = make_volume<float>(g, [](std::span<float> v) {
        std::fill(v.begin(), v.end(), std::nanf(""));
        v[5] = 7;
    });
    const RegionStatistics one =
        region_statistics(volume, shape(MeasurementKind::rectangle, g, {-1, -1, 0}, {5, 5, 0}));
    EXPECT_EQ(one.pixels, 1);
    EXPECT_EQ(one.mean, 7);
    EXPECT_EQ(one.stddev, 0);
    const RegionStatistics none =
        region_statistics(volume, shape(MeasurementKind::ellipse, g, {1.6, 1.6, 0}, {3.4, 3.4, 0}));
    EXPECT_EQ(none.pixels, 0);
    EXPECT_TRUE(std::isnan(none.mean) && std::isnan(none.stddev) && std::isnan(none.min) && std::isnan(none.max));
}

TEST(Measurement, LiesInItsPlaneAndInParallelOnesNearby) {
    const GridGeometry g = grid({8, 8, 8}, {1, 1, 2});
    SliceFrame frame;
    frame.right = g.direction[0];
    frame.down = g.direction[1];
    frame.corner_mm = g.voxel_to_mm({-0.5, -0.5, 3});
    const Measurement m = shape(MeasurementKind::rectangle, g, {1, 1, 3.4}, {4, 4, 3.4});
    EXPECT_TRUE(lies_in(m, frame, 1));
    EXPECT_FALSE(lies_in(m, frame, 0.7));
    SliceFrame across = frame;
    across.down = g.direction[2];
    EXPECT_FALSE(lies_in(m, across, 100));
    const Measurement line = shape(MeasurementKind::distance, g, {1, 0, 3}, {4, 0, 3});
    across.corner_mm = g.voxel_to_mm({-0.5, 0, -0.5});
    EXPECT_TRUE(lies_in(line, across, 0.5)) << "a distance shows in every plane it lies in";
}

TEST(Measurement, TableRowsHaveEveryFieldAndPlainNumbers) {
    const GridGeometry g = grid({8, 8, 1}, {1, 1, 1});
    Volume volume = ramp(g);
    volume.unit = "HU, \"raw\"";
    std::vector<Measurement> all = {shape(MeasurementKind::distance, g, {0, 0, 0}, {3, 4, 0}),
                                    shape(MeasurementKind::rectangle, g, {-0.5, -0.5, 0}, {1.5, 0.5, 0})};
    all[1].id = 2;
    EXPECT_EQ(next_measurement_id(all), 3u);
    EXPECT_EQ(next_measurement_id({}), 1u);
    const std::string csv = measurements_to_csv(volume, all);
    EXPECT_NE(csv.find("1,distance,5,,,,,,,,,,\"HU, \"\"raw\"\"\",3 -7 100; 6 -3 100\r\n"), std::string::npos) << csv;
    EXPECT_NE(csv.find("2,rectangle,,,2,1,2,2,5,5,0,10,"), std::string::npos) << csv;
}

}  // namespace
}  // namespace lacuna
