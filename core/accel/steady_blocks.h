#pragma once

#include <cstdint>
#include <vector>

#include "core/accel/macrocells.h"

namespace lacuna {

/// Which closed ranges of values are drawn in one way throughout: all invisible, or all in one colour and opacity.
/// Exact, from the classification's points.
class PlateauTable {
public:
    explicit PlateauTable(const Classification& classification);
    bool level(ValueRange range) const;

private:
    void join(const Classification& classification);

    std::vector<double> ends_;  ///< where one way of drawing ends and the next begins, ascending
    std::vector<bool> level_;   ///< ends_.size() + 1 pieces between them: drawn in one way
};

/// A byte a block of 4^3 cells (positions [4c, 4c+4) an axis): 1 where every value a sample can have there is drawn
/// alike and no voxel is NaN, so that the nearest voxel's value serves as well as the trilinear one.
/// @param grid  cells of shift 2. @param slack  how far the renderer's tables round
std::vector<std::uint8_t> steady_blocks_of_opacity(const MacrocellGrid& grid, const PlateauTable& table, double slack);
/// The same for an isosurface: no turn between inside and outside.
std::vector<std::uint8_t> steady_blocks_of_iso(const MacrocellGrid& grid, const VisibilityTable& inside, double slack);
/// The same for projections, which tell any two values apart: blocks of one value, or outside all ranges.
std::vector<std::uint8_t> steady_blocks_of_values(const MacrocellGrid& grid, const VisibilityTable& shown,
                                                  double slack);

}  // namespace lacuna
