#include "core/accel/visible_voxels.h"

#include <gtest/gtest.h>

#include <algorithm>
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
                    voxels[i++] = T(std::max(
                        0.0, 50 + 20 * (std::sin(0.7 * x + a) + std::sin(0.9 * y + b) + std::cos(0.8 * z + c))));
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

/// Whole multiples of 2^-16, so that positions along a ray are exact.
double dyadic(double value) { return std::round(value * 65536) / 65536; }

/// A volume as the tests' own search sees it.
struct Small {
    explicit Small(const Volume& volume) : size(volume.geometry().size) {
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) values.push_back(volume.value(x, y, z));
    }
    double at(const SliceDirection& direction, int u, int v, int c) const {
        glm::ivec3 p;
        p[direction.u_axis()] = u;
        p[direction.v_axis()] = v;
        p[direction.axis] = c;
        return values[std::size_t((std::int64_t(p.z) * size.y + p.y) * size.x + p.x)];
    }
    /// Bilinear in slice c; NaN beside the volume.
    double sample(const SliceDirection& direction, double u, double v, int c) const {
        const int nu = size[direction.u_axis()], nv = size[direction.v_axis()];
        if (!(u >= -0.5 && u <= nu - 0.5 && v >= -0.5 && v <= nv - 0.5)) return std::nan("");
        u = std::fmin(std::fmax(u, 0), nu - 1);
        v = std::fmin(std::fmax(v, 0), nv - 1);
        const int u0 = int(u), v0 = int(v), u1 = std::min(u0 + 1, nu - 1), v1 = std::min(v0 + 1, nv - 1);
        const double fu = u - u0, fv = v - v0;
        return (1 - fv) * ((1 - fu) * at(direction, u0, v0, c) + fu * at(direction, u1, v0, c)) +
               fv * ((1 - fu) * at(direction, u0, v1, c) + fu * at(direction, u1, v1, c));
    }
    glm::ivec3 size;
    std::vector<double> values;
};

/// A ray through the slices: where it meets the k-th from the front.
struct Ray {
    glm::dvec2 start, slope;
    glm::dvec2 at(int k) const { return start + double(k) * slope; }
};

/// Rays of a region, exact zeros and diagonals among them. `slope` is per slice away from the eye.
class RegionRays {
public:
    RegionRays(const SliceDirection& direction, glm::ivec3 size, unsigned seed)
        : direction_(direction), size_(size), random_(seed) {}
    Ray operator()() {
        const auto component = [&](int lean) {
            const double kind = unit_(random_), size = kind < 0.04 ? 0 : kind < 0.08 ? 1 : dyadic(unit_(random_));
            return lean != 0 ? lean * size : unit_(random_) < 0.5 ? size : -size;
        };
        const glm::dvec2 slope(component(direction_.u_lean), component(direction_.v_lean));
        const glm::dvec2 middle(0.5 * size_[direction_.u_axis()], 0.5 * size_[direction_.v_axis()]);
        const double reach = size_[direction_.axis] + 2.0;
        const auto within = [&](double m) { return dyadic(m + (2 * unit_(random_) - 1) * (m + reach)); };
        return {{within(middle.x), within(middle.y)}, slope};
    }

private:
    SliceDirection direction_;
    glm::ivec3 size_;
    std::mt19937 random_;
    std::uniform_real_distribution<double> unit_{0, 1};
};

int slice_of(const SliceDirection& direction, glm::ivec3 size, int k) {
    return direction.from_low ? k : size[direction.axis] - 1 - k;
}

std::vector<SliceDirection> all_regions() {
    std::vector<SliceDirection> all = slice_directions(6);
    for (const SliceDirection& direction : slice_directions(24)) all.push_back(direction);
    return all;
}

Volume noise(glm::ivec3 size, glm::dvec3 spacing, unsigned seed) {
    std::mt19937 random(seed);
    return make_volume<std::uint8_t>(grid(size, spacing), [&](auto voxels) {
        for (auto& v : voxels) v = std::uint8_t(random() % 100);
    });
}

/// Two walls one voxel thick with holes, across each axis.
Volume walls(glm::ivec3 size) {
    return make_volume<std::uint8_t>(grid(size), [&](auto voxels) {
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const bool wall = x == size.x / 3 || y == size.y / 2 || z == size.z / 3 || z == size.z - 2;
                    voxels[i++] = wall && (3 * x + 5 * y + 7 * z) % 11 != 0 ? 90 : 3;
                }
    });
}

/// Volumes with something to see everywhere, and the isovalue that shows it.
std::vector<std::pair<Volume, double>> search_volumes() {
    return {{blobs({67, 9, 13}), 45},
            {blobs({5, 130, 6}), 45},
            {noise({1, 1, 9}, {1, 1, 5}, 3), 60},
            {noise({21, 20, 65}, {1, 1, 5}, 4), 75},
            {noise({64, 3, 7}, {1, 1, 1}, 5), 90},
            {walls({19, 17, 23}), 45}};
}

TEST(VisibleVoxels, HoldEveryVoxelThatTenThousandDirectionsOfTheirRegionSee) {
    for (const auto& [volume, iso] : search_volumes()) {
        const Small small(volume);
        VisibleVoxelCache cache;
        for (const SliceDirection& direction : all_regions()) {
            const auto lists = cache.get(volume, {iso, {}, {}}, direction);
            const std::set<Voxel> listed = set_of(*lists);
            for (const auto& [x, y, z] : listed) ASSERT_GE(volume.value(x, y, z), iso);
            const int nu = small.size[direction.u_axis()], nv = small.size[direction.v_axis()];
            RegionRays rays(direction, small.size, 7);
            std::set<Voxel> seen;
            for (int n = 0; n < 10000; ++n) {
                const Ray ray = rays();
                for (int k = 0; k < small.size[direction.axis]; ++k) {
                    const int u = int(std::floor(ray.at(k).x + 0.5)), v = int(std::floor(ray.at(k).y + 0.5));
                    if (u < 0 || v < 0 || u >= nu || v >= nv) continue;
                    const int c = slice_of(direction, small.size, k);
                    if (!(small.at(direction, u, v, c) >= iso)) continue;
                    glm::ivec3 p;
                    p[direction.u_axis()] = u;
                    p[direction.v_axis()] = v;
                    p[direction.axis] = c;
                    seen.insert({p.x, p.y, p.z});
                    break;
                }
            }
            EXPECT_GE(seen.size(), 1u);
            for (const auto& [x, y, z] : seen)
                ASSERT_TRUE(listed.count({x, y, z}))
                    << direction.index() << " size " << small.size.x << ": " << x << ' ' << y << ' ' << z;
        }
    }
}

/// Cells (i, j, slice) of a list.
std::set<Voxel> set_of(const VisibleCells& cells) {
    std::set<Voxel> all;
    for (int c = 0; c < cells.slices; ++c)
        for (int j = 0; j < cells.rows; ++j) {
            const std::size_t row = std::size_t(c) * std::size_t(cells.rows) + std::size_t(j);
            for (std::uint32_t n = cells.row_begin[row]; n < cells.row_begin[row + 1]; ++n) {
                EXPECT_LT(int(cells.column[n]), cells.columns);
                all.insert({cells.column[n], j, c});
            }
        }
    return all;
}

Voxel cell_at(const glm::dvec2& at, int c) { return {int(std::floor(at.x)) + 1, int(std::floor(at.y)) + 1, c}; }

TEST(VisibleVoxels, CellsHoldEveryFirstBilinearSampleOfTheirRegion) {
    for (const auto& [volume, iso] : search_volumes()) {
        const Small small(volume);
        VisibleVoxelCache cache;
        for (const SliceDirection& direction : all_regions()) {
            const std::set<Voxel> listed = set_of(*cache.get_cells(volume, {iso, {}, {}}, direction));
            RegionRays rays(direction, small.size, 8);
            int hits = 0;
            for (int n = 0; n < 10000; ++n) {
                const Ray ray = rays();
                for (int k = 0; k < small.size[direction.axis]; ++k) {
                    const int c = slice_of(direction, small.size, k);
                    if (!(small.sample(direction, ray.at(k).x, ray.at(k).y, c) >= iso)) continue;
                    ++hits;
                    ASSERT_TRUE(listed.count(cell_at(ray.at(k), c)))
                        << direction.index() << " size " << small.size.x << " k " << k;
                    break;
                }
            }
            EXPECT_GT(hits, 0);
        }
    }
}

/// With an open cut every turn a ray can meet must be among the cells, not only the first.
TEST(VisibleVoxels, CellsBehindAnOpenCutHoldEveryTurn) {
    const Volume volume = walls({19, 17, 23}), dense = blobs({20, 21, 22});
    for (const auto& [picked, iso] : {std::pair(volume, 45.0), std::pair(dense, 40.0)}) {
        const Small small(picked);
        const Solid solid{iso, {}, {{{0.3, 1, -0.2}, -5, false}, {{1, 0, 0}, -4.5, true}}};
        VisibleVoxelCache cache;
        for (const SliceDirection& direction : all_regions()) {
            const std::set<Voxel> listed = set_of(*cache.get_cells(picked, solid, direction));
            std::vector<CutResidual> cuts;
            for (const SolidCut& cut : solid.cuts) cuts.push_back(residual_of(cut, picked.geometry(), direction));
            RegionRays rays(direction, small.size, 9);
            int turns = 0;
            for (int n = 0; n < 3000; ++n) {
                const Ray ray = rays();
                double before = std::nan("");
                bool capped_before = false;
                for (int k = 0; k < small.size[direction.axis]; ++k) {
                    const int c = slice_of(direction, small.size, k);
                    const glm::dvec2 at = ray.at(k);
                    const double here = small.sample(direction, at.x, at.y, c) - iso;
                    bool kept = true;
                    for (const CutResidual& cut : cuts) kept = kept && cut.at(at.x, at.y, c) >= 0;
                    const bool turn = std::isnan(before) || capped_before ? here >= 0 : (before < 0) != (here < 0);
                    if (kept && turn && !std::isnan(here)) {
                        ++turns;
                        ASSERT_TRUE(listed.count(cell_at(at, c))) << direction.index() << " k " << k;
                    }
                    before = here;
                    capped_before = cuts[1].at(at.x, at.y, c) < 0;
                }
            }
            EXPECT_GT(turns, 100);
        }
    }
}

TEST(VisibleVoxels, AQuarterListsNoMoreThanItsSixthAndBothNeighboursHoldTheirBorder) {
    const Volume volume = blobs({33, 31, 29});
    VisibleVoxelCache cache;
    for (const SliceDirection& quarter : slice_directions(24)) {
        const auto part = set_of(*cache.get(volume, {45, {}, {}}, quarter));
        const auto whole = set_of(*cache.get(volume, {45, {}, {}}, {quarter.axis, quarter.from_low}));
        EXPECT_TRUE(std::includes(whole.begin(), whole.end(), part.begin(), part.end()));
        EXPECT_LT(part.size(), whole.size());
        // Straight along the axis: what is met first lies in all four quarters.
        const Small small(volume);
        for (int v = 0; v < small.size[quarter.v_axis()]; ++v)
            for (int u = 0; u < small.size[quarter.u_axis()]; ++u)
                for (int k = 0; k < small.size[quarter.axis]; ++k) {
                    glm::ivec3 p;
                    p[quarter.u_axis()] = u;
                    p[quarter.v_axis()] = v;
                    p[quarter.axis] = slice_of(quarter, small.size, k);
                    if (!(volume.value(p.x, p.y, p.z) >= 45)) continue;
                    ASSERT_TRUE(part.count({p.x, p.y, p.z}));
                    break;
                }
    }
}

TEST(VisibleVoxels, RegionsFollowTheLargestComponentAndTheSigns) {
    EXPECT_EQ(slice_direction({0.2, -3, 1}, 6), (SliceDirection{1, false}));
    EXPECT_EQ(slice_direction({0.2, -3, -1}, 24), (SliceDirection{1, false, 1, -1}));
    EXPECT_EQ(slice_direction({0, 0, 2}, 24), (SliceDirection{2, true, 1, 1}));
    EXPECT_EQ(slice_direction({-1, 1, 1}, 24), (SliceDirection{0, false, 1, 1}));
    std::set<std::size_t> indices;
    for (const SliceDirection& direction : all_regions()) indices.insert(direction.index());
    EXPECT_EQ(indices.size(), SliceDirection::k_count);
    EXPECT_EQ(*indices.rbegin(), SliceDirection::k_count - 1);
}

TEST(VisibleVoxels, EveryFilterFindsTheNormalOfASlope) {
    // Value 3x - 2y + z per voxel at spacing 1 x 2 x 5 mm, flat beyond the middle so that there is something to list.
    const glm::ivec3 size(15, 15, 15);
    const glm::dvec3 spacing(1, 2, 5), per_mm = glm::dvec3(3, -2, 1) / spacing;
    const Volume volume = make_volume<float>(grid(size, spacing), [&](std::span<float> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < 15; ++z)
            for (int y = 0; y < 15; ++y)
                for (int x = 0; x < 15; ++x) voxels[i++] = float(3 * x - 2 * y + z);
    });
    for (const VoxelGradient filter : {VoxelGradient::central, VoxelGradient::sobel, VoxelGradient::gaussian}) {
        VisibleVoxelCache cache;
        const auto lists = cache.get(volume, {20, {}, {}, filter}, {2, true});
        int compared = 0;
        for (int v = 3; v < 12; ++v) {
            const std::size_t row = std::size_t(7) * std::size_t(lists->rows) + std::size_t(v);
            for (std::uint32_t n = lists->row_begin[row]; n < lists->row_begin[row + 1]; ++n) {
                if (lists->column[n] < 3 || lists->column[n] > 11) continue;
                ++compared;
                const glm::dvec3 normal(lists->look[n].normal[0], lists->look[n].normal[1], lists->look[n].normal[2]);
                EXPECT_NEAR(glm::distance(normal / 32767.0, glm::normalize(per_mm)), 0, 1e-3);
            }
        }
        EXPECT_GT(compared, 3);
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
