#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/accel/macrocells.h"
#include "core/base/job.h"
#include "core/classify/classification.h"

namespace lacuna {

/// Levoy 1988, section 3: a binary volume a level. Level 0 holds a bit for each cell between voxels: cell c along an
/// axis covers the positions [c, c+1), its corners are the voxels c and c+1 (clamped to the grid). A cell of level m is
/// the OR of its eight children; the last level is one cell. Padding to powers of two is not stored.
///
/// Levoy classified voxels, so that a cell was empty when its corners were transparent. Here reconstructed values are
/// classified (post-classification): between two invisible voxels visible values may lie. A bit is therefore 1 unless
/// no value of the closed range of the corners' values can matter.
struct BinaryPyramid {
    /// `visible`: a value in the cell can be visible. `gap`: one can be invisible, or NaN.
    enum class Kind { visible, gap };

    glm::ivec3 cells{0};             ///< of level 0
    std::vector<glm::ivec3> stored;  ///< cells stored an axis, a level; those beyond the volume are 0
    std::vector<std::size_t> first;  ///< first byte of each level
    std::vector<std::uint8_t> bits;  ///< level 0 in blocks of 8^3 cells (64 bytes: slices of rows of 8 bits), the
                                     ///< others as rows of bits, x fastest
    int top = -1;                    ///< where a walk starts: the coarsest of the levels 2 .. M-2 (2 at least)
                                     ///< that has an empty cell; -1: none has
    std::size_t bytes() const { return bits.size(); }
    int levels() const { return int(stored.size()); }
    /// @pre inside stored[level]
    bool operator()(int level, glm::ivec3 cell) const;
};

/// Builds the bits on all threads, into memory that is reused where `pyramid` has it. Blocks of 8^3 cells that the
/// macro-cells answer at once are filled; only the others look at their voxels.
/// @param blocks the volume's macro-cells of 8^3 @param table, slack what is visible, and how far values may round
/// @param values range of the volume's finite values
/// @throws Error(cancelled): what `pyramid` then holds is of no use. Cost: 256^3 about 10 ms, the first time memory too
void build_binary_pyramid(BinaryPyramid& pyramid, const Volume& volume, const MacrocellGrid& blocks,
                          const VisibilityTable& table, double slack, ValueRange values, BinaryPyramid::Kind kind,
                          const JobContext& job = {});

}  // namespace lacuna
