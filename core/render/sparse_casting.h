#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/job.h"
#include "core/render/frame.h"

namespace lacuna {

/// Sparse casting (Lesar 2015): cast every k-th pixel of every k-th row, interpolate the others, cast again where the
/// colours of neighbouring cast pixels differ. Objects thinner than k pixels can vanish between cast pixels: the
/// error-aware part re-casts beside every hit-or-miss edge and every step in depth as well, which finds what any cast
/// ray touched; what all of them missed only min-max cells know (sparse_cells.h).
struct SparseGrid {
    static constexpr int k_tile = 4;  ///< pixels a side of what is cast again

    int k = 2;              ///< pixels between cast pixels, at least 2
    glm::ivec2 picture{0};  ///< the full picture
    /// Cast pixels an axis: every k-th, the last at or beyond the picture's edge, so that each pixel lies between four.
    glm::ivec2 size() const { return (picture - 2 + k) / k + 1; }
    /// Blocks of k x k pixels between cast ones an axis.
    glm::ivec2 blocks() const { return glm::max(size() - 1, glm::ivec2(1)); }
};

/// Fills the picture from a frame of cast pixels (grid.size() of them): bilinear colours; depth where all four have
/// one, else that of the nearest.
Frame interpolate(const Frame& cast, const SparseGrid& grid);

/// How far the four corners of a block are apart in any channel (0..1); infinite where one is NaN, or where they differ
/// by more than `depth_step_mm` in depth (infinite against finite counts).
double corner_difference(const Frame& cast, int bx, int by, double depth_step_mm);

/// Depth between cast pixels from which on it is an edge: a slope of four to one.
inline double edge_depth_mm(const SparseGrid& grid, double pixel_mm) { return 4 * grid.k * pixel_mm; }

/// Calls use(bx, by) for the blocks that a 4x4 tile with this upper left pixel touches.
template <class Use>
void for_blocks_of_tile(const SparseGrid& grid, const glm::ivec2& tile, const Use& use) {
    const glm::ivec2 last = glm::min((tile + SparseGrid::k_tile - 1) / grid.k, grid.blocks() - 1);
    for (int by = tile.y / grid.k; by <= last.y; ++by)
        for (int bx = tile.x / grid.k; bx <= last.x; ++bx) use(bx, by);
}

/// The 4x4 tiles (upper left pixels) that must be cast again: those touching a k x k block whose four corners differ by
/// more than `gradient` in any channel (0..1), or by more than `depth_step_mm` in depth (infinite against finite
/// counts), and those touching a block of `marked` (grid.blocks() of them; empty: none).
std::vector<glm::ivec2> tiles_to_recast(const Frame& cast, const SparseGrid& grid, double gradient,
                                        double depth_step_mm, const std::vector<std::uint8_t>& marked = {});

}  // namespace lacuna
