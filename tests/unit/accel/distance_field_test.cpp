// Distance fields against brute force on small grids.
#include "core/accel/distance_field.h"

#include <gtest/gtest.h>

#include <random>

namespace lacuna {
namespace {

/// Lumpy random regions: mostly `filling`, with spots of the other kinds.
RegionGrid random_grid(glm::ivec3 size, int filling, double spots, unsigned seed) {
    std::mt19937 random(seed);
    RegionGrid grid{size, std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z))};
    std::uniform_int_distribution<int> other(0, 2);
    std::bernoulli_distribution spot(spots), split(0.5);
    const bool halves = split(random);
    for (std::size_t i = 0; i < grid.region.size(); ++i) {
        const bool left = int(i % std::size_t(size.x)) < size.x / 2;
        grid.region[i] = std::uint8_t(spot(random) ? other(random) : halves && left ? 3 - filling : filling);
    }
    return grid;
}

std::vector<RegionGrid> ugly_grids() {
    std::vector<RegionGrid> all;
    unsigned seed = 7;
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), glm::ivec3(1, 1, 9), glm::ivec3(7, 1, 3), glm::ivec3(9, 8, 7),
                                  glm::ivec3(17, 5, 36), glm::ivec3(12, 13, 11)})
        for (const double spots : {0.0, 0.004, 0.03, 0.5})
            for (const int filling : {1, 2}) all.push_back(random_grid(size, filling, spots, ++seed));
    return all;
}

struct At {
    const RegionGrid& grid;
    bool inside(glm::ivec3 c) const {
        return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, grid.size));
    }
    std::size_t index(glm::ivec3 c) const {
        return (std::size_t(c.z) * std::size_t(grid.size.y) + std::size_t(c.y)) * std::size_t(grid.size.x) +
               std::size_t(c.x);
    }
    /// Whether all cells from lo to hi (both included) that lie in the grid are of the region.
    bool all_of(glm::ivec3 lo, glm::ivec3 hi, int region) const {
        lo = glm::max(lo, glm::ivec3(0));
        hi = glm::min(hi, grid.size - 1);
        for (int z = lo.z; z <= hi.z; ++z)
            for (int y = lo.y; y <= hi.y; ++y)
                for (int x = lo.x; x <= hi.x; ++x)
                    if (grid.region[index({x, y, z})] != region) return false;
        return true;
    }
    template <class Visit>
    void each(Visit&& visit) const {
        for (int z = 0; z < grid.size.z; ++z)
            for (int y = 0; y < grid.size.y; ++y)
                for (int x = 0; x < grid.size.x; ++x) visit(glm::ivec3(x, y, z));
    }
};

glm::ivec3 towards(int octant) { return {octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1}; }

/// The box of `extent` cells from c on towards the octant.
bool box_is(const At& at, glm::ivec3 c, int octant, glm::ivec3 extent, int region) {
    const glm::ivec3 far = c + towards(octant) * (extent - 1);
    return at.all_of(glm::min(c, far), glm::max(c, far), region);
}

TEST(DistanceField, ChessboardIsExact) {
    for (const RegionGrid& grid : ugly_grids()) {
        const At at{grid};
        const VoxelBuffer made = chessboard_field(grid);
        ASSERT_EQ(made.size(), grid.region.size());
        const auto* field = reinterpret_cast<const std::uint8_t*>(made.data());
        at.each([&](glm::ivec3 c) {
            const int region = grid.region[at.index(c)], entry = field[at.index(c)], d = entry & 127;
            ASSERT_EQ(region == 0, entry == 0);
            if (region == 0) return;
            ASSERT_EQ(entry >= 128, region == 2);
            ASSERT_TRUE(at.all_of(c - (d - 1), c + (d - 1), region)) << "too far";
            if (d < k_cube_limit) {
                ASSERT_FALSE(at.all_of(c - d, c + d, region)) << "too near";
            }
        });
    }
}

TEST(DistanceField, OctantCubesAreExact) {
    for (const RegionGrid& grid : ugly_grids()) {
        const At at{grid};
        const VoxelBuffer made = octant_field(grid);
        ASSERT_EQ(made.size(), 8 * grid.region.size());
        const auto* field = reinterpret_cast<const std::uint8_t*>(made.data());
        for (int octant = 0; octant < 8; ++octant)
            at.each([&](glm::ivec3 c) {
                const int region = grid.region[at.index(c)];
                const int entry = field[std::size_t(octant) * grid.region.size() + at.index(c)], d = entry & 127;
                ASSERT_EQ(region == 0, entry == 0);
                if (region == 0) return;
                ASSERT_EQ(entry >= 128, region == 2);
                ASSERT_TRUE(box_is(at, c, octant, glm::ivec3(d), region)) << "too far";
                if (d < k_cube_limit) {
                    ASSERT_FALSE(box_is(at, c, octant, glm::ivec3(d + 1), region)) << "too near";
                }
            });
    }
}

TEST(DistanceField, BoxesLieInTheRegionAndHoldTheCube) {
    int grown = 0;
    for (const RegionGrid& grid : ugly_grids()) {
        const At at{grid};
        const VoxelBuffer cubes = octant_field(grid), made = box_field(grid);
        ASSERT_EQ(made.size(), 16 * grid.region.size());
        const auto* cube = reinterpret_cast<const std::uint8_t*>(cubes.data());
        const auto* field = reinterpret_cast<const std::uint16_t*>(made.data());
        for (int octant = 0; octant < 8; ++octant)
            at.each([&](glm::ivec3 c) {
                const std::size_t i = std::size_t(octant) * grid.region.size() + at.index(c);
                const int region = grid.region[at.index(c)], entry = field[i];
                ASSERT_EQ(region == 0, entry == 0);
                if (region == 0) return;
                ASSERT_EQ(entry >= 0x8000, region == 2);
                const glm::ivec3 box(entry & 31, entry >> 5 & 31, entry >> 10 & 31);
                const int d = std::min(cube[i] & 127, k_box_limit);
                ASSERT_TRUE(glm::all(glm::greaterThanEqual(box, glm::ivec3(d))));
                ASSERT_TRUE(box_is(at, c, octant, box, region));
                // Two axes were extended as far as they go: at most one can still grow.
                int growing = 0;
                for (int a = 0; a < 3; ++a) {
                    glm::ivec3 more = box;
                    ++more[a];
                    growing += box[a] < k_box_limit && box_is(at, c, octant, more, region);
                }
                ASSERT_LE(growing, 1);
                grown += box != glm::ivec3(d);
            });
    }
    EXPECT_GT(grown, 1000);  // boxes, not cubes under another name
}

TEST(DistanceField, OctantsMadeOneByOneAreThoseOfAll) {
    for (const RegionGrid& grid : ugly_grids()) {
        const std::size_t cells = grid.region.size();
        const VoxelBuffer cubes = octant_field(grid), boxes = box_field(grid);
        std::vector<std::uint8_t> some(8 * cells, 99);
        fill_cubes(grid, 1u << 3 | 1u << 6, some.data());
        std::vector<std::uint16_t> large(8 * cells, 99);
        fill_boxes(grid, 1u << 5, large.data());
        const auto* cube = reinterpret_cast<const std::uint8_t*>(cubes.data());
        const auto* box = reinterpret_cast<const std::uint16_t*>(boxes.data());
        for (std::size_t octant = 0; octant < 8; ++octant)
            for (std::size_t c = 0, i = octant * cells; c < cells; ++c, ++i) {
                ASSERT_EQ(some[i], octant == 3 || octant == 6 ? cube[i] : 99);
                ASSERT_EQ(large[i], octant == 5 ? box[i] : 99);
            }
    }
}

TEST(DistanceField, SaturatesAndNeverWraps) {
    // One border cell at the end of a long rod; the rest is one region.
    RegionGrid rod{{1, 2, 300}, std::vector<std::uint8_t>(600, 2)};
    rod.region[0] = rod.region[1] = 0;
    const VoxelBuffer pc = chessboard_field(rod), acd = octant_field(rod), eacd = box_field(rod);
    const auto* c = reinterpret_cast<const std::uint8_t*>(pc.data());
    const auto* o = reinterpret_cast<const std::uint8_t*>(acd.data()) + std::size_t(4) * 600;  // towards smaller z
    const auto* b = reinterpret_cast<const std::uint16_t*>(eacd.data()) + std::size_t(4) * 600;
    for (int z = 1; z < 300; ++z) {
        const auto i = std::size_t(z) * 2;
        EXPECT_EQ(c[i], 128 + std::min(z, 127));
        EXPECT_EQ(o[i], 128 + std::min(z, 127));
        EXPECT_EQ(b[i] >> 10 & 31, std::min(z, 31)) << z;
    }
}

TEST(DistanceField, AStoppedBuildThrows) {
    const RegionGrid grid = random_grid({40, 40, 40}, 1, 0.01, 3);
    std::stop_source source;
    source.request_stop();
    const JobContext job{source.get_token(), nullptr};
    EXPECT_THROW(chessboard_field(grid, job), Error);
    EXPECT_THROW(octant_field(grid, job), Error);
    EXPECT_THROW(box_field(grid, job), Error);
}

}  // namespace
}  // namespace lacuna
