#include "core/volume/reslice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>

namespace lacuna {
namespace {

GridGeometry oblique_grid(glm::ivec3 size, glm::dvec3 spacing) {
    GridGeometry grid;
    grid.size = size;
    grid.spacing = spacing;
    grid.origin = {-12.5, 40, 7};
    grid.direction = glm::dmat3(glm::mat3_cast(glm::angleAxis(0.4, glm::normalize(glm::dvec3(1, -2, 0.5)))));
    return grid;
}

template <class T>
Volume noise(const GridGeometry& grid) {
    std::mt19937 random(7);
    return make_volume<T>(grid, [&](std::span<T> v) {
        for (T& x : v) x = T(int(random() % 200) - (std::numeric_limits<T>::is_signed ? 100 : 0));
    });
}

/// The picture of one slice along two grid axes, its pixels voxels.
SliceFrame grid_frame(const GridGeometry& grid, int u, int v, bool flip_u, bool flip_v, double index) {
    SliceFrame frame;
    frame.right = grid.direction[u] * (flip_u ? -1.0 : 1.0);
    frame.down = grid.direction[v] * (flip_v ? -1.0 : 1.0);
    frame.pixel_mm = {grid.spacing[u], grid.spacing[v]};
    frame.size = {grid.size[u], grid.size[v]};
    glm::dvec3 corner;
    corner[u] = flip_u ? grid.size[u] - 0.5 : -0.5;
    corner[v] = flip_v ? grid.size[v] - 0.5 : -0.5;
    corner[3 - u - v] = index;
    frame.corner_mm = grid.voxel_to_mm(corner);
    return frame;
}

template <class T>
void expect_exact_slices() {
    const GridGeometry grid = oblique_grid({5, 4, 3}, {0.7, 1.3, 5});
    const Volume volume = noise<T>(grid);
    for (const auto& [u, v] : {std::pair{0, 1}, {1, 0}, {0, 2}, {2, 1}})
        for (const bool flip_u : {false, true})
            for (const bool flip_v : {false, true}) {
                const int w = 3 - u - v;
                const SliceFrame frame = grid_frame(grid, u, v, flip_u, flip_v, grid.size[w] - 1);
                EXPECT_TRUE(voxel_walk(grid, frame).on_grid);
                const std::vector<float> values = reslice(volume, frame);
                for (int y = 0; y < frame.size.y; ++y)
                    for (int x = 0; x < frame.size.x; ++x) {
                        glm::ivec3 at;
                        at[u] = flip_u ? grid.size[u] - 1 - x : x;
                        at[v] = flip_v ? grid.size[v] - 1 - y : y;
                        at[w] = grid.size[w] - 1;
                        ASSERT_EQ(values[std::size_t(y * frame.size.x + x)], volume.value(at.x, at.y, at.z));
                    }
            }
}

TEST(Reslice, ASliceAlongTheGridIsItsVoxels) {
    expect_exact_slices<std::uint8_t>();
    expect_exact_slices<std::int8_t>();
    expect_exact_slices<std::uint16_t>();
    expect_exact_slices<std::int16_t>();
    expect_exact_slices<float>();
}

TEST(Reslice, SlabsAlongTheGridAreWholeSlices) {
    const GridGeometry grid = oblique_grid({3, 2, 9}, {1, 1, 2.5});
    const Volume volume = noise<std::int16_t>(grid);
    const SliceFrame frame = grid_frame(grid, 0, 1, false, false, 4);
    const auto expected = [&](int first, int last, SlabMode mode) {
        double sum = 0, largest = -1e9, smallest = 1e9;
        for (int z = first; z <= last; ++z) {
            const double value = volume.value(1, 1, z);
            sum += value, largest = std::max(largest, value), smallest = std::min(smallest, value);
        }
        return mode == SlabMode::mip ? largest : mode == SlabMode::minip ? smallest : sum / (last - first + 1);
    };
    for (const SlabMode mode : {SlabMode::mean, SlabMode::mip, SlabMode::minip}) {
        const auto at = [&](double mm) { return double(reslice(volume, frame, {mm, mode})[std::size_t(1 * 3 + 1)]); };
        EXPECT_EQ(at(0), volume.value(1, 1, 4));
        EXPECT_EQ(at(2.5), volume.value(1, 1, 4));
        EXPECT_EQ(at(0.1), volume.value(1, 1, 4));
        EXPECT_NEAR(at(5), expected(4, 5, mode), 1e-5);  // two: one of the two half-way planes
        EXPECT_NEAR(at(7.5), expected(3, 5, mode), 1e-5);
        EXPECT_NEAR(at(12.5), expected(2, 6, mode), 1e-5);
        EXPECT_NEAR(at(1000), expected(0, 8, mode), 1e-5);  // beyond the volume there is nothing
    }
    EXPECT_EQ(sheets_of(grid, frame.normal(), 7.4999999).count(), 3);
    EXPECT_EQ(sheets_of(grid, frame.normal(), std::nan("")).count(), 1);
}

TEST(Reslice, ATiltedPlaneOfALinearVolumeIsLinear) {
    // Trilinear interpolation is exact for a linear function, whatever the spacing.
    const GridGeometry grid = oblique_grid({24, 20, 6}, {0.5, 0.75, 4});
    const auto value = [](const glm::dvec3& mm) { return 3 * mm.x - 2 * mm.y + 0.5 * mm.z + 10; };
    const Volume volume = make_volume<float>(grid, [&](std::span<float> v) {
        for (int z = 0; z < grid.size.z; ++z)
            for (int y = 0; y < grid.size.y; ++y)
                for (int x = 0; x < grid.size.x; ++x)
                    v[std::size_t(grid.linear_index(x, y, z))] = float(value(grid.voxel_to_mm({x, y, z})));
    });
    const glm::dmat3 turn(glm::mat3_cast(glm::angleAxis(0.6, glm::normalize(glm::dvec3(0.3, 1, -0.4)))));
    SliceFrame frame;
    frame.right = turn * grid.direction[0];
    frame.down = turn * grid.direction[1];
    frame.pixel_mm = {0.4, 0.4};
    frame.size = {11, 9};
    frame.corner_mm = grid.centre_mm() - frame.right * 2.2 - frame.down * 1.8;
    EXPECT_FALSE(voxel_walk(grid, frame).on_grid);
    for (const Slab& slab : {Slab{}, Slab{3, SlabMode::mean}}) {
        // An even number of sheets is not centred on the plane: by half a sheet along the normal.
        const Sheets sheets = sheets_of(grid, frame.normal(), slab.thickness_mm);
        const double off = 0.5 * (sheets.first + sheets.last) * sheets.distance_mm;
        const std::vector<float> values = reslice(volume, frame, slab);
        for (int y = 0; y < frame.size.y; ++y)
            for (int x = 0; x < frame.size.x; ++x)
                EXPECT_NEAR(values[std::size_t(y * frame.size.x + x)],
                            value(frame.to_mm({x + 0.5, y + 0.5}) + frame.normal() * off), 1e-4);
    }
}

TEST(Reslice, OutsideTheCellsThereIsNothingAndABorderVoxelIsWhole) {
    GridGeometry grid;
    grid.size = {2, 1, 1};
    const Volume volume = make_volume<std::uint8_t>(grid, [](std::span<std::uint8_t> v) { v[0] = 10, v[1] = 20; });
    SliceFrame frame;
    frame.pixel_mm = {0.25, 0.25};
    frame.size = {16, 1};
    frame.corner_mm = {-1.5, -0.125, 0};
    const std::vector<float> values = reslice(volume, frame);
    for (int x = 0; x < 16; ++x) {
        const double at = -1.5 + 0.25 * (x + 0.5);
        if (at < -0.5 || at > 1.5)
            EXPECT_TRUE(std::isnan(values[std::size_t(x)])) << at;
        else
            EXPECT_NEAR(values[std::size_t(x)], 10 + 10 * std::clamp(at, 0.0, 1.0), 1e-5) << at;
    }
    frame.corner_mm.z = 0.6;
    for (const float value : reslice(volume, frame)) EXPECT_TRUE(std::isnan(value));
}

TEST(Reslice, NanStaysWhereItIs) {
    GridGeometry grid;
    grid.size = {3, 3, 3};
    const Volume volume = make_volume<float>(grid, [](std::span<float> v) {
        for (std::size_t i = 0; i < v.size(); ++i) v[i] = float(i);
        v[13] = std::nanf("");  // the middle
    });
    const SliceFrame middle = grid_frame(grid, 0, 1, false, false, 1);
    const std::vector<float> one = reslice(volume, middle);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(std::isnan(one[i]), i == 4);
    EXPECT_EQ(reslice(volume, middle, {3, SlabMode::mean})[4], 13);  // of 4 and 22
    EXPECT_EQ(reslice(volume, middle, {3, SlabMode::mip})[4], 22);
    EXPECT_EQ(reslice(volume, middle, {3, SlabMode::minip})[4], 4);
    SliceFrame half = middle;  // half a pixel to the right: neighbours without weight are not read
    half.corner_mm.x += 0.5;
    const std::vector<float> between = reslice(volume, half);
    EXPECT_EQ(between[0], 9.5F);
    EXPECT_TRUE(std::isnan(between[3]) && std::isnan(between[4]));
}

TEST(Reslice, LabelsAreThoseOfTheNearestVoxel) {
    const GridGeometry grid = oblique_grid({4, 3, 2}, {1, 2, 3});
    std::vector<std::uint32_t> labels(std::size_t(grid.voxel_count()));
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = std::uint32_t(100000 + i);
    SliceFrame frame = grid_frame(grid, 0, 1, false, true, 1);
    frame.corner_mm += 0.3 * frame.right + 0.4 * frame.normal();
    const auto found = reslice_nearest(grid, labels, frame);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(found[std::size_t(y * 4 + x)], labels[std::size_t(grid.linear_index(x, 2 - y, 1))]);
    frame.corner_mm += 10.0 * frame.normal();
    for (const std::uint32_t label : reslice_nearest(grid, labels, frame)) EXPECT_EQ(label, 0u);
}

TEST(Reslice, CanBeStopped) {
    const GridGeometry grid = oblique_grid({32, 32, 8}, {1, 1, 1});
    const Volume volume = noise<std::uint8_t>(grid);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(reslice(volume, grid_frame(grid, 0, 1, false, false, 0), {}, {stop.get_token(), nullptr}), Error);
}

TEST(SliceFrame, PositionsComeBack) {
    const GridGeometry grid = oblique_grid({4, 5, 6}, {1, 1, 5});
    const SliceFrame frame = grid_frame(grid, 1, 2, true, false, 2);
    const glm::dvec2 back = frame.to_picture(frame.to_mm({1.25, 2.5}) + 3.0 * frame.normal());
    EXPECT_NEAR(back.x, 1.25, 1e-12);
    EXPECT_NEAR(back.y, 2.5, 1e-12);
    EXPECT_NEAR(frame.depth_mm(frame.to_mm({3, 1}) + 3.0 * frame.normal()), 3, 1e-12);
}

}  // namespace
}  // namespace lacuna
