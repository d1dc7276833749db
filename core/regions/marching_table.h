#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lacuna {

/// The surface inside one cube between 8 voxel centres, for each of the 256 sets of inside corners.
/// Corner bits: 1 x, 2 y, 4 z. Edge = 4 * axis + the base corner's two other bits, lower axis first.
struct MarchingCase {
    /// Closed loops of edge ids, counter-clockwise seen from outside; those to be fanned from their first vertex.
    std::vector<std::vector<std::uint8_t>> fans;
    /// Loops that have no fan without a diagonal on a cube face: they get a vertex in their middle.
    std::vector<std::vector<std::uint8_t>> wheels;
};

/// Built by rule instead of copied (Lorensen and Cline 1987 left holes): on a face with two inside corners across, the
/// two are cut off apart, whichever cube looks at it; no diagonal lies on a face. So every edge of the surface has
/// exactly two triangles, for any mask.
const std::array<MarchingCase, 256>& marching_cases();

/// The two corners of an edge, the lower one first.
std::array<int, 2> corners_of_edge(int edge);

}  // namespace lacuna
