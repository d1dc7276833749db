#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/job.h"
#include "core/classify/classification.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Min-max macro-cells. Cell c along an axis covers the positions [c*B, (c+1)*B) in voxel coordinates, so its range is
/// taken over the voxels c*B .. c*B+B (both included, clamped to the grid): every voxel that nearest or trilinear
/// reconstruction at such a position can touch. Depends on the voxels only.
struct MacrocellGrid {
    int shift = 3;                  ///< log2 B
    glm::ivec3 cells{0};            ///< cells an axis; enough for positions 0 .. n-1
    std::vector<glm::vec2> ranges;  ///< smallest and largest finite value a cell; (inf, -inf) where there is none
    std::vector<std::uint8_t>
        has_nan;  ///< f32 volumes only, else empty: 1 where a NaN or infinite voxel lies in the cell

    std::size_t bytes() const { return ranges.size() * sizeof(glm::vec2) + has_nan.size(); }
};

/// Builds the cells on all threads. @param shift 1..6 (cell edges of 2..64 voxels)
/// Cost: one pass over the voxels (a 512^3 u16 volume: tens of milliseconds).
MacrocellGrid build_macrocells(const Volume& volume, int shift = 3, const JobContext& job = {});

/// One byte a cell: VisibilityTable::Answer for its range widened by `slack` on both sides (how far a renderer's own
/// value tables may round). A cell with NaN voxels is never `all`: NaN samples count as outside.
std::vector<std::uint8_t> classify_macrocells(const MacrocellGrid& grid, const VisibilityTable& table, double slack);

/// The same where a value counts as visible from `iso` on: two comparisons a cell instead of a table's look-ups.
std::vector<std::uint8_t> classify_macrocells(const MacrocellGrid& grid, double iso, double slack);

}  // namespace lacuna
