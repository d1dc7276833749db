#include "core/render/sparse_casting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

struct Corners {
    std::array<std::size_t, 4> at;

    Corners(const Frame& cast, int bx, int by) {
        const int x1 = std::min(bx + 1, cast.size.x - 1), y1 = std::min(by + 1, cast.size.y - 1);
        const auto index = [&](int x, int y) { return std::size_t(y) * std::size_t(cast.size.x) + std::size_t(x); };
        at = {index(bx, by), index(x1, by), index(bx, y1), index(x1, y1)};
    }
};

}  // namespace

double corner_difference(const Frame& cast, int bx, int by, double depth_step_mm) {
    const Corners corners(cast, bx, by);
    constexpr double k_edge = std::numeric_limits<double>::infinity();
    glm::vec4 lo = cast.color[corners.at[0]], hi = lo;
    float near_mm = cast.depth_mm[corners.at[0]], far_mm = near_mm;
    for (std::size_t i : corners.at) {
        if (glm::any(glm::isnan(cast.color[i]))) return k_edge;
        lo = glm::min(lo, cast.color[i]);
        hi = glm::max(hi, cast.color[i]);
        near_mm = std::min(near_mm, cast.depth_mm[i]);
        far_mm = std::max(far_mm, cast.depth_mm[i]);
    }
    if (!std::isinf(near_mm) && !(far_mm - near_mm <= depth_step_mm)) return k_edge;
    const glm::vec4 d = hi - lo;
    return double(std::max({d.r, d.g, d.b, d.a}));
}

Frame interpolate(const Frame& cast, const SparseGrid& grid) {
    Frame frame;
    frame.size = grid.picture;
    frame.color.resize(frame.pixels());
    frame.depth_mm.resize(frame.pixels());
    parallel_for(0, grid.picture.y, [&](std::int64_t row) {
        const int y = int(row), by = y / grid.k;
        const float fy = float(y - by * grid.k) / float(grid.k);
        for (int x = 0; x < grid.picture.x; ++x) {
            const int bx = x / grid.k;
            const float fx = float(x - bx * grid.k) / float(grid.k);
            const Corners c(cast, bx, by);
            const auto mixed = [&](const auto& of) {
                const auto top = of[c.at[0]] * (1 - fx) + of[c.at[1]] * fx;
                const auto bottom = of[c.at[2]] * (1 - fx) + of[c.at[3]] * fx;
                return top * (1 - fy) + bottom * fy;
            };
            const std::size_t out = std::size_t(y) * std::size_t(grid.picture.x) + std::size_t(x);
            frame.color[out] = mixed(cast.color);
            const bool all =
                std::all_of(c.at.begin(), c.at.end(), [&](std::size_t i) { return std::isfinite(cast.depth_mm[i]); });
            const std::size_t nearest = c.at[std::size_t((fx < 0.5f ? 0 : 1) + (fy < 0.5f ? 0 : 2))];
            frame.depth_mm[out] = all ? mixed(cast.depth_mm) : cast.depth_mm[nearest];
        }
    });
    return frame;
}

std::vector<glm::ivec2> tiles_to_recast(const Frame& cast, const SparseGrid& grid, double gradient,
                                        double depth_step_mm, const std::vector<std::uint8_t>& marked) {
    const glm::ivec2 blocks = grid.blocks();
    std::vector<std::uint8_t> edge = marked;
    edge.resize(std::size_t(blocks.x) * std::size_t(blocks.y));
    parallel_for(0, blocks.y, [&](std::int64_t by) {
        for (int bx = 0; bx < blocks.x; ++bx)
            edge[std::size_t(by) * std::size_t(blocks.x) + std::size_t(bx)] |=
                !(corner_difference(cast, bx, int(by), depth_step_mm) <= gradient);
    });
    std::vector<glm::ivec2> tiles;
    for (int y = 0; y < grid.picture.y; y += SparseGrid::k_tile)
        for (int x = 0; x < grid.picture.x; x += SparseGrid::k_tile) {
            bool recast = false;
            for_blocks_of_tile(grid, {x, y}, [&](int bx, int by) {
                recast |= edge[std::size_t(by) * std::size_t(blocks.x) + std::size_t(bx)] != 0;
            });
            if (recast) tiles.push_back({x, y});
        }
    return tiles;
}

}  // namespace lacuna
