#include "core/accel/visible_voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <tuple>

#include "core/base/error.h"

namespace lacuna {
namespace {

using Voxel = std::tuple<int, int, int>;

GridGeometry grid(glm::ivec3 size, glm::dvec3 spacing = glm::dvec3(1)) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return geometry;
}

/// Smooth blobs, so that there are caves, thin walls and loose voxels.
template <class T = float>
Volume blobs(glm::ivec3 size, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> phase(0, 6.3);
    const double a = phase(random), b = phase(random), c = phase(random);
    return make_volume<T>(grid(size), [&](std::span<T> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    voxels[i++] = T(50 + 20 * (std::sin(0.7 * x + a) + std::sin(0.9 * y + b) + std::cos(0.8 * z + c)));
    });
}

std::set<Voxel> set_of(const VisibleVoxels& lists) {
    std::set<Voxel> voxels;
    for (int c = 0; c < lists.slices; ++c) {
        for (int v = 0; v < lists.rows; ++v) {
            const std::size_t row = std::size_t(c) * lists.rows + v;
            for (std::uint32_t i = lists.row_begin[row]; i < lists.row_begin[row + 1]; ++i) {
                EXPECT_LT(int(lists.column[i]), lists.columns);
                if (i > lists.row_begin[row]) {
                    EXPECT_GT(lists.column[i], lists.column[i - 1]);
                }
                glm::ivec3 p;
                p[lists.direction.u_axis()] = lists.column[i];
                p[lists.direction.v_axis()] = v;
                p[lists.direction.axis] = c;
                EXPECT_TRUE(voxels.insert({p.x, p.y, p.z}).second);
            }
        }
    }
    return voxels;
}

/// First solid voxel met by a ray through the slices, or none; written without any of the structure's ideas.
template <class Solid>
bool first_hit(const Solid& solid, glm::ivec3 size, SliceDirection direction, glm::dvec2 start, glm::dvec2 slope,
               glm::ivec3& hit) {
    for (int k = 0; k < size[direction.axis]; ++k) {
        const int u = int(std::lround(start.x + slope.x * k)), v = int(std::lround(start.y + slope.y * k));
        if (u < 0 || v < 0 || u >= size[direction.u_axis()] || v >= size[direction.v_axis()]) continue;
        hit[direction.u_axis()] = u;
        hit[direction.v_axis()] = v;
        hit[direction.axis] = direction.from_low ? k : size[direction.axis] - 1 - k;
        if (solid(hit)) return true;
    }
    return false;
}

TEST(VisibleVoxels, HoldEveryVoxelAnyRayOfTheirDirectionsMeetsFirst) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1, 1);
    for (const glm::ivec3 size :
         {glm::ivec3(67, 9, 13), glm::ivec3(5, 130, 6), glm::ivec3(1, 1, 9), glm::ivec3(21, 20, 65)}) {
        const Volume volume = blobs(size);
        const auto solid = [&](glm::ivec3 p) { return volume.value(p.x, p.y, p.z) >= 45; };
        VisibleVoxelCache cache;
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool from_low : {true, false}) {
                const SliceDirection direction{axis, from_low};
                const auto lists = cache.get(volume, {45, {}, {}}, direction);
                const std::set<Voxel> listed = set_of(*lists);
                for (const auto& [x, y, z] : listed) ASSERT_TRUE(solid({x, y, z}));
                int hits = 0;
                for (int ray = 0; ray < 3000; ++ray) {
                    const glm::dvec2 slope(share(random), share(random));
                    const glm::dvec2 middle(0.5 * size[direction.u_axis()], 0.5 * size[direction.v_axis()]);
                    const double reach = size[axis] + 2.0;
                    const glm::dvec2 start =
                        middle + glm::dvec2(share(random) * (middle.x + reach), share(random) * (middle.y + reach));
                    glm::ivec3 hit;
                    if (!first_hit(solid, size, direction, start, slope, hit)) continue;
                    ++hits;
                    ASSERT_TRUE(listed.count({hit.x, hit.y, hit.z}))
                        << axis << from_low << ' ' << hit.x << ' ' << hit.y << ' ' << hit.z;
                }
                EXPECT_GT(hits, 10);
            }
        }
    }
}

TEST(VisibleVoxels, AFullBlockShowsItsFrontAndSidesAlone) {
    const Volume volume = make_volume<std::uint8_t>(grid({9, 8, 7}), [](auto voxels) {
        for (auto& v : voxels) v = 9;
    });
    VisibleVoxelCache cache;
    const auto lists = cache.get(volume, {5, {}, {}}, {2, true});
    EXPECT_EQ(lists->column.size(), 9u * 8 * 7 - 7u * 6 * 6);
    EXPECT_EQ(lists->look[0].normal, (std::array<std::int16_t, 3>{0, 0, 32767}));
    EXPECT_EQ(cache.get(volume, {10, {}, {}}, {2, true})->column.size(), 0u);
}

TEST(VisibleVoxels, RangesBoundTheObjectAndNaNIsEmpty) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Volume volume = make_volume<float>(grid({5, 1, 1}), [&](auto voxels) {
        const float row[] = {nan, 10, std::numeric_limits<float>::infinity(), 30, 20};
        std::copy(row, row + 5, voxels.begin());
    });
    VisibleVoxelCache cache;
    EXPECT_EQ(set_of(*cache.get(volume, {15, {}, {}}, {2, true})), (std::set<Voxel>{{3, 0, 0}, {4, 0, 0}}));
    EXPECT_EQ(set_of(*cache.get(volume, {5, {{0, 12}, {19, 21}}, {}}, {2, true})),
              (std::set<Voxel>{{1, 0, 0}, {4, 0, 0}}));
}

TEST(VisibleVoxels, IntegerTypesThresholdAsFloatsDo) {
    const glm::ivec3 size(13, 11, 9);
    VisibleVoxelCache cache;
    const auto u16 = blobs<std::uint16_t>(size);
    const Volume f32 = make_volume<float>(grid(size), [&](std::span<float> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = float(u16.view<std::uint16_t>().data[i]);
    });
    for (const double iso : {44.5, 50.0, -3.0, 1e6}) {
        for (const int axis : {0, 1, 2})
            EXPECT_EQ(set_of(*cache.get(u16, {iso, {}, {}}, {axis, false})),
                      set_of(*cache.get(f32, {iso, {}, {}}, {axis, false})));
        const std::vector<ValueRange> ranges{{40, 52}, {60, 64}};
        EXPECT_EQ(set_of(*cache.get(u16, {iso, ranges, {}}, {1, true})),
                  set_of(*cache.get(f32, {iso, ranges, {}}, {1, true})));
    }
    const Volume i8 = make_volume<std::int8_t>(grid({3, 1, 1}), [](auto voxels) {
        voxels[0] = -128;
        voxels[1] = -1;
        voxels[2] = 127;
    });
    EXPECT_EQ(set_of(*cache.get(i8, {-1, {}, {}}, {2, true})), (std::set<Voxel>{{1, 0, 0}, {2, 0, 0}}));
}

TEST(VisibleVoxels, CutsLayInnerVoxelsBareOrLeaveTheShell) {
    // A full block of 20^3 inside 24^3, spacing 1 x 1 x 2 mm; the cut keeps x >= 11.5.
    const Volume volume = make_volume<std::uint8_t>(grid({24, 24, 24}, {1, 1, 2}), [](auto voxels) {
        for (int i = 0; i < 24 * 24 * 24; ++i) {
            const int x = i % 24, y = i / 24 % 24, z = i / 576;
            voxels[std::size_t(i)] = std::min({x, y, z}) >= 2 && std::max({x, y, z}) < 22 ? 100 : 0;
        }
    });
    VisibleVoxelCache cache;
    Solid solid{50, {}, {{{2, 0, 0}, -23, true}}};
    const auto capped = cache.get(volume, solid, {0, true});
    std::size_t caps = 0;
    for (const VoxelLook& look : capped->look) {
        caps += look.kind == VoxelLook::cap;
        if (look.kind == VoxelLook::cap) {
            EXPECT_EQ(look.value, 100);
        }
    }
    EXPECT_EQ(caps, 18u * 18u);  // slice x = 12, less the rim, which is the object's own surface
    for (const auto& [x, y, z] : set_of(*capped)) EXPECT_GE(x, 12);

    solid.cuts[0].cap = false;
    const auto open = cache.get(volume, solid, {0, true});
    for (const VoxelLook& look : open->look) EXPECT_EQ(look.kind, VoxelLook::surface);
    EXPECT_TRUE(set_of(*open).count({21, 12, 12}));  // the far wall shows
    EXPECT_FALSE(set_of(*open).count({12, 12, 12}));

    solid.cuts.push_back({{0, 0, 1}, -20, true});  // a capped cut beside the open one: its face is closed again
    const auto mixed = cache.get(volume, solid, {2, true});
    EXPECT_TRUE(set_of(*mixed).count({16, 12, 10}));
    caps = 0;
    for (const VoxelLook& look : mixed->look) caps += look.kind == VoxelLook::cap;
    EXPECT_EQ(caps, 9u * 18u);  // x 12..20, y 3..20 of slice z = 10
}

TEST(VisibleVoxels, AreKeptForTheLastSolidAndDroppedWhole) {
    const Volume volume = blobs({20, 20, 20});
    VisibleVoxelCache cache;
    const Solid solid{45, {}, {}};
    EXPECT_FALSE(cache.has(volume, solid, {2, true}));
    const auto first = cache.get(volume, solid, {2, true});
    EXPECT_TRUE(cache.has(volume, solid, {2, true}));
    EXPECT_FALSE(cache.has(volume, solid, {2, false}));
    EXPECT_EQ(cache.get(volume, solid, {2, true}), first);
    EXPECT_GT(cache.bytes_held(), first->bytes());
    const auto other = cache.get(volume, {46, {}, {}}, {2, true});
    EXPECT_NE(other, first);
    EXPECT_FALSE(cache.has(volume, solid, {2, true}));
    cache.drop();
    EXPECT_EQ(cache.bytes_held(), 0u);
    EXPECT_EQ(set_of(*cache.get(volume, solid, {2, true})), set_of(*first));
}

TEST(VisibleVoxels, AStopLeavesNothingThatLooksWhole) {
    const Volume volume = blobs({20, 20, 20});
    VisibleVoxelCache cache;
    const Solid solid{45, {}, {{{1, 0, 0}, -8, true}}};
    std::stop_source source;
    source.request_stop();
    try {
        cache.get(volume, solid, {0, true}, {source.get_token()});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::cancelled);
    }
    EXPECT_FALSE(cache.has(volume, solid, {0, true}));
    VisibleVoxelCache fresh;
    EXPECT_EQ(set_of(*cache.get(volume, solid, {0, true})), set_of(*fresh.get(volume, solid, {0, true})));
}

}  // namespace
}  // namespace lacuna
