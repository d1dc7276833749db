#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Cells of a grid by the region they belong to, x fastest: 0 a border cell, which belongs to none; 1 and 2 two kinds
/// of region. What lies outside the grid belongs to every region: a ray there has left it.
struct RegionGrid {
    glm::ivec3 size{0};
    std::vector<std::uint8_t> region;
};

/// The distance fields of Es, Keles & Isler 2006 (Accelerated Volume Rendering with Homogeneous Region Encoding using
/// Extended Anisotropic Chessboard Distance). All count in cells, the cell itself included: 0 for a border cell, else
/// a box of d cells an axis from here on lies in the cell's region. They saturate, never wrap; the top bit of an entry
/// says that the region is of kind 2.
inline constexpr int k_cube_limit = 127;  ///< of pc and acd: 7 bits
inline constexpr int k_box_limit = 31;    ///< of eacd: 5 bits an axis

/// Octants as bits: octant o belongs to the set where bit o is 1.
using OctantSet = unsigned;
inline constexpr OctantSet k_all_octants = 0xff;
std::vector<int> octants_of(OctantSet set);

/// PC: the chessboard distance to the nearest cell of another region, one byte a cell: all cells nearer than d along
/// every axis, both ways, are of the region. Two sweeps over 3x3x3 masks, O(n), exact.
VoxelBuffer chessboard_field(const RegionGrid& grid, const JobContext& job = {});

/// ACD: for each of the eight octants the largest cube that starts in the cell and lies in its region. One byte a cell
/// and octant, octant by octant; bit a of the octant's number is set where it looks towards smaller coordinates
/// along axis a. Eight sweeps over 2x2x2 masks, O(n), exact; octants in parallel.
VoxelBuffer octant_field(const RegionGrid& grid, const JobContext& job = {});

/// Makes the entries of some octants of such a field anew and leaves the others: the rays of one view run into one to
/// four octants. @param field  8 entries a cell
void fill_cubes(const RegionGrid& grid, OctantSet octants, std::uint8_t* field, const JobContext& job = {});

/// Which kinds of region get boxes beyond their cubes.
enum class Extend { both, first_only };

/// EACD: for each octant a box that starts in the cell and lies in its region: the ACD cube, extended as far as it goes
/// along the axis that gains most, then along the better of the other two. 16 bits a cell and octant (ordered as
/// in ACD): x, y << 5, z << 10. From axial run lengths, whose minima over a cube's face come from tables of
/// power-of-two windows: O(n), at most about 70 bytes a cell of at most 64 slices and one a cell, a thread, for as long
/// as it takes.
VoxelBuffer box_field(const RegionGrid& grid, const JobContext& job = {}, Extend extend = Extend::both);

/// fill_cubes() for this field.
void fill_boxes(const RegionGrid& grid, OctantSet octants, std::uint16_t* field, const JobContext& job = {},
                Extend extend = Extend::both);

}  // namespace lacuna
