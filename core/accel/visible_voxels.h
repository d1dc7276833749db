#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/accel/solid_bits.h"
#include "core/accel/voxel_normals.h"

namespace lacuna {

/// The object whose voxels are listed: voxels with iso_measure >= 0, less what the cuts take away. An `open` cut
/// leaves only the object's own surface voxels (those with an empty 26-neighbour or at the volume's border) standing.
struct Solid {
    double iso = 0;
    std::vector<ValueRange> ranges;
    std::vector<SolidCut> cuts;
    VoxelGradient gradient = VoxelGradient::sobel;
    friend bool operator==(const Solid&, const Solid&) = default;
};

/// How a listed voxel looks.
struct VoxelLook {
    enum Kind : std::uint8_t {
        surface,  ///< shaded with its normal
        cap       ///< inside the object, laid bare by a cut: drawn as its data value
    };
    std::array<std::int16_t, 3> normal{};  ///< unit vector * 32767 along the grid's axes (mm); 0: no gradient
    std::uint8_t kind = surface;
    /// Of a voxel that another one hides from the front: sides of the volume it lies at (low u 1, high u 2, low v 4,
    /// high v 8). A view that comes in through one of them sees that side, any other the surface.
    std::uint8_t sides = 0;
    float value = 0;
};

/// Positions listed slice by slice, sorted by row and column; the slice is implicit.
struct SliceLists {
    SliceDirection direction;
    int columns = 0, rows = 0, slices = 0;
    std::vector<std::uint32_t> row_begin;  ///< slices*rows + 1: row v of slice c is [row_begin[c*rows + v], next)
    std::vector<std::uint16_t> column;     ///< ascending within a row

    std::size_t bytes() const { return row_begin.size() * sizeof(row_begin[0]) + column.size() * sizeof(column[0]); }
    bool slice_empty(int c) const {
        return row_begin[std::size_t(c) * std::size_t(rows)] == row_begin[std::size_t(c + 1) * std::size_t(rows)];
    }
};

/// The object's voxels that can be seen from a region of directions (Csebfalvi, Konig, Groller 1999, section 2).
struct VisibleVoxels : SliceLists {
    std::vector<VoxelLook> look;  ///< of each listed voxel

    std::size_t bytes() const { return SliceLists::bytes() + look.size() * sizeof(look[0]); }
};

/// The cells in which bilinear samples can show the object: cell (i, j) of a slice has the voxels (i-1, j-1) .. (i, j)
/// at its corners, so columns and rows are one more than those of the voxels. See visible_cell_bits().
struct VisibleCells : SliceLists {};

/// Builds the lists when first asked for and keeps them for the last solid, one a region of directions. A new cut keeps
/// the thresholded volume. Keeps the volume's voxels alive until drop(). One caller at a time.
class VisibleVoxelCache {
public:
    /// @throws Error(cancelled); Error(unsupported) for an axis over 65534 voxels or over 2^32 - 2 visible voxels.
    /// Cost: 256^3 under 30 ms on 2 cores; one bit a voxel and 14 bytes a visible voxel.
    std::shared_ptr<const VisibleVoxels> get(const Volume& volume, const Solid& solid, const SliceDirection& direction,
                                             const JobContext& job = {});
    /// The same for bilinear sampling: 2 bytes a cell.
    std::shared_ptr<const VisibleCells> get_cells(const Volume& volume, const Solid& solid,
                                                  const SliceDirection& direction, const JobContext& job = {});
    /// True if get() would find its list ready.
    bool has(const Volume& volume, const Solid& solid, const SliceDirection& direction) const;
    bool has_cells(const Volume& volume, const Solid& solid, const SliceDirection& direction) const;
    std::size_t bytes_held() const;
    void drop() { *this = {}; }

private:
    bool serves(const Volume& volume, const Solid& solid) const;
    void use(const Volume& volume, const Solid& solid, const JobContext& job);
    SliceRows slices(const Volume& volume, const Solid& solid, const SliceDirection& direction, const JobContext& job);

    VoxelBuffer voxels_;
    std::optional<Solid> solid_;
    glm::dmat4 placed_{0};  ///< the geometry the cuts were applied in
    SolidBits bits_;
    std::array<std::shared_ptr<const VisibleVoxels>, SliceDirection::k_count> voxel_lists_;
    std::array<std::shared_ptr<const VisibleCells>, SliceDirection::k_count> cell_lists_;
};

}  // namespace lacuna
