// The pyramid of binary volumes against the voxels: every bit by brute force.
#include "core/accel/binary_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using Kind = BinaryPyramid::Kind;

struct Corners {
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    bool nan = false;
};

Corners corners_of(const Volume& volume, glm::ivec3 cell) {
    Corners c;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 v = glm::min(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2), volume.geometry().size - 1);
        const double value = volume.value(v.x, v.y, v.z);
        if (!std::isfinite(value)) {
            c.nan = true;
            continue;
        }
        c.lo = std::min(c.lo, value);
        c.hi = std::max(c.hi, value);
    }
    return c;
}

template <class Each>
void for_cells(glm::ivec3 n, Each&& each) {
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) each(glm::ivec3(x, y, z));
}

BinaryPyramid built(const Volume& volume, const VisibilityTable& table, Kind kind = Kind::visible) {
    BinaryPyramid pyramid;
    build_binary_pyramid(pyramid, volume, build_macrocells(volume), table, 0, compute_statistics(volume).range, kind);
    return pyramid;
}

/// Invisible below, between and above two bands.
Classification bands(const Volume& volume) {
    const VolumeStatistics all = compute_statistics(volume);
    const double lo = all.range.lo, w = all.range.width();
    Classification c;
    c.tf.points = {{lo + 0.3 * w, {1, 1, 1}, 0}, {lo + 0.35 * w, {1, 1, 1}, 1}, {lo + 0.4 * w, {1, 1, 1}, 0},
                   {lo + 0.8 * w, {1, 1, 1}, 0}, {lo + 0.85 * w, {1, 1, 1}, 1}, {lo + 0.9 * w, {1, 1, 1}, 0}};
    return c;
}

TEST(BinaryPyramid, ACellIsEmptyExactlyWhenNoValueBetweenItsCornersShows) {
    for (const auto& [name, volume] : test::ugly_volumes()) {
        const Classification c = bands(volume);
        const VisibilityTable table = VisibilityTable::of_opacity(c, compute_statistics(volume).range);
        const BinaryPyramid pyramid = built(volume, table);
        int looser = 0, full = 0;
        for_cells(volume.geometry().size, [&](glm::ivec3 cell) {
            const Corners corners = corners_of(volume, cell);
            bool shows = false;
            for (int s = 0; s <= 64 && corners.lo <= corners.hi; ++s)
                shows = shows || c.at(corners.lo + (corners.hi - corners.lo) * s / 64).opacity > 0;
            const bool bit = pyramid(0, cell);
            if (shows) {
                ASSERT_TRUE(bit) << name << " " << cell.x << " " << cell.y << " " << cell.z;
            }
            const bool asked = table.query({corners.lo, corners.hi}) != VisibilityTable::Answer::none;
            if (volume.type() != VoxelType::f32) {
                ASSERT_EQ(bit, asked) << name;
            }
            looser += bit && !asked;
            full += bit;
        });
        EXPECT_LE(looser, full / 50) << name;
    }
}

TEST(BinaryPyramid, GapsAreWhereAValueOrANanIsOutside) {
    for (const auto& [name, volume] : test::ugly_volumes()) {
        const ValueRange range = compute_statistics(volume).range;
        const double iso = 0.5 * (range.lo + range.hi);
        const BinaryPyramid pyramid = built(volume, VisibilityTable::of_iso({}, iso, range), Kind::gap);
        for_cells(volume.geometry().size, [&](glm::ivec3 cell) {
            const Corners corners = corners_of(volume, cell);
            if (corners.nan || corners.lo < iso) {
                ASSERT_TRUE(pyramid(0, cell)) << name;
            }
        });
    }
}

TEST(BinaryPyramid, EachLevelIsTheOrOfItsChildren) {
    for (const auto& [name, volume] : test::ugly_volumes()) {
        const BinaryPyramid pyramid =
            built(volume, VisibilityTable::of_opacity(bands(volume), compute_statistics(volume).range));
        for (int level = 1; level < pyramid.levels(); ++level)
            for_cells(pyramid.stored[std::size_t(level)], [&](glm::ivec3 cell) {
                bool any = false;
                for (int i = 0; i < 8; ++i) {
                    const glm::ivec3 child = cell * 2 + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
                    if (glm::all(glm::lessThan(child, pyramid.stored[std::size_t(level - 1)])))
                        any = any || pyramid(level - 1, child);
                }
                ASSERT_EQ(pyramid(level, cell), any) << name << " level " << level;
            });
        EXPECT_EQ(pyramid.stored.back(), glm::ivec3(1)) << name;
    }
}

TEST(BinaryPyramid, TakesLevoysBits) {
    const Volume ball = test::bumpy_ball<std::uint8_t>({64, 64, 64}, {1, 1, 1}, 240);
    const BinaryPyramid pyramid = built(ball, VisibilityTable::of_iso({}, 120, {0, 240}));
    const std::size_t bits = (std::size_t(1) << 21) / 7;  // (8^(M+1) - 1) / 7 with M = 6
    EXPECT_NEAR(double(pyramid.bytes()) * 8, double(bits), 16);
    EXPECT_EQ(pyramid.top, 4);  // M - 2
}

TEST(BinaryPyramid, WithoutAnEmptyCellThereIsNothingToWalk) {
    const Volume ball = test::bumpy_ball<std::uint8_t>({40, 40, 40}, {1, 1, 1}, 240);
    EXPECT_EQ(built(ball, VisibilityTable::of_iso({}, -1, {0, 240})).top, -1);
}

TEST(BinaryPyramid, BuiltAgainInPlaceItIsTheSame) {
    const Volume ball = test::bumpy_ball<std::int16_t>({50, 35, 61}, {1, 1, 1}, 3000, -1000);
    const ValueRange range = compute_statistics(ball).range;
    BinaryPyramid pyramid;
    const MacrocellGrid blocks = build_macrocells(ball);
    for (const double iso : {-500.0, 1500.0, 200.0}) {
        const VisibilityTable table = VisibilityTable::of_iso({}, iso, range);
        build_binary_pyramid(pyramid, ball, blocks, table, 0, range, Kind::visible);
        EXPECT_EQ(pyramid.bits, built(ball, table).bits) << iso;
    }
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(build_binary_pyramid(pyramid, ball, blocks, VisibilityTable::of_iso({}, 0, range), 0, range,
                                      Kind::visible, {source.get_token(), nullptr}),
                 Error);
    const VisibilityTable table = VisibilityTable::of_iso({}, 700, range);
    build_binary_pyramid(pyramid, ball, blocks, table, 0, range, Kind::visible);
    EXPECT_EQ(pyramid.bits, built(ball, table).bits);
}

TEST(BinaryPyramid, MoreBandsThanLabelsStaySound) {
    const Volume ball = test::bumpy_ball<std::uint16_t>({24, 24, 24}, {1, 1, 1}, 60000);
    Classification comb;
    for (int i = 0; i < 400; ++i) {
        const double v = 150.0 * i;
        for (const auto& [at, opacity] : {std::pair(0.0, 0.0), {5.0, 0.5}, {10.0, 0.0}})
            comb.tf.points.push_back({v + at, {1, 1, 1}, opacity});
    }
    const ValueRange range = compute_statistics(ball).range;
    const VisibilityTable table = VisibilityTable::of_opacity(comb, range);
    const BinaryPyramid pyramid = built(ball, table);
    for_cells(ball.geometry().size, [&](glm::ivec3 cell) {
        const Corners corners = corners_of(ball, cell);
        if (table.query({corners.lo, corners.hi}) != VisibilityTable::Answer::none) {
            ASSERT_TRUE(pyramid(0, cell));
        }
    });
}

}  // namespace
}  // namespace lacuna
