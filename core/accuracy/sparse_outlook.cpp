#include "core/accuracy/sparse_outlook.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/accuracy/image_error.h"
#include "core/base/parallel.h"
#include "core/render/sparse_casting.h"

namespace lacuna {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// The pixels the first pass casts; those beyond the picture's edge are taken for its last ones.
Frame every_kth(const Frame& picture, const SparseGrid& grid) {
    Frame cast;
    cast.size = grid.size();
    cast.color.reserve(cast.pixels());
    cast.depth_mm.reserve(cast.pixels());
    for (int y = 0; y < cast.size.y; ++y)
        for (int x = 0; x < cast.size.x; ++x) {
            const glm::ivec2 at = glm::min(glm::ivec2(x, y) * grid.k, picture.size - 1);
            const std::size_t i = std::size_t(at.y) * std::size_t(picture.size.x) + std::size_t(at.x);
            cast.color.push_back(picture.color[i]);
            cast.depth_mm.push_back(picture.depth_mm[i]);
        }
    return cast;
}

}  // namespace

SparseOutlook::SparseOutlook(const Frame& picture, const glm::dvec3& background, int k, double pixel_mm) {
    const SparseGrid grid{k, picture.size};
    const Frame cast = every_kth(picture, grid);
    const Frame between = interpolate(cast, grid);
    const double step_mm = edge_depth_mm(grid, pixel_mm);
    const glm::ivec2 tiles = (picture.size + SparseGrid::k_tile - 1) / SparseGrid::k_tile;
    tiles_.resize(std::size_t(tiles.x) * std::size_t(tiles.y));
    pixels_ = double(picture.pixels());
    cast_ = double(cast.pixels());
    parallel_for(0, tiles.y, [&](std::int64_t row) {
        for (int column = 0; column < tiles.x; ++column) {
            Tile& tile = tiles_[std::size_t(row) * std::size_t(tiles.x) + std::size_t(column)];
            const glm::ivec2 from = glm::ivec2(column, int(row)) * SparseGrid::k_tile;
            const glm::ivec2 to = glm::min(from + SparseGrid::k_tile, picture.size);
            for_blocks_of_tile(grid, from, [&](int bx, int by) {
                tile.difference = std::max(tile.difference, corner_difference(cast, bx, by, step_mm));
            });
            for (int y = from.y; y < to.y; ++y)
                for (int x = from.x; x < to.x; ++x) {
                    const std::size_t i = std::size_t(y) * std::size_t(picture.size.x) + std::size_t(x);
                    const glm::dvec3 d =
                        seen_color(between.color[i], background) - seen_color(picture.color[i], background);
                    for (int c = 0; c < 3; ++c)
                        tile.error = std::isnan(d[c]) ? k_infinity : std::max(tile.error, std::fabs(d[c]));
                }
        }
    });
}

double SparseOutlook::share(double gradient) const {
    if (!(pixels_ > 0)) return 1;
    const auto again =
        std::count_if(tiles_.begin(), tiles_.end(), [&](const Tile& tile) { return !(tile.difference <= gradient); });
    return (cast_ + double(SparseGrid::k_tile * SparseGrid::k_tile) * double(again)) / pixels_;
}

double SparseOutlook::error(double gradient) const {
    double largest = 0;
    for (const Tile& tile : tiles_)
        if (tile.difference <= gradient) largest = std::max(largest, tile.error);
    return largest;
}

double SparseOutlook::widest(double error) const {
    constexpr double k_below = 0.999;  // the tile in question is cast again
    double widest = 1;
    for (const Tile& tile : tiles_)
        if (!(tile.error <= error)) widest = std::min(widest, k_below * tile.difference);
    return widest > 0 ? widest : -1;
}

}  // namespace lacuna
