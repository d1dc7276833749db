#pragma once

#include <vector>

#include "core/accel/bit_volume.h"
#include "core/accel/slice_direction.h"
#include "core/classify/classification.h"

namespace lacuna {

/// Keeps the half-space normal . p + offset >= 0 (mm), as the scene's cutting planes do.
struct SolidCut {
    glm::dvec3 normal{1, 0, 0};
    double offset = 0;
    bool cap = true;
    friend bool operator==(const SolidCut&, const SolidCut&) = default;
};

/// Bit set where the voxel belongs to the object: iso_measure >= 0 with these ranges. A voxel that is not finite is
/// empty. Cost: 256^3 u16 about 5 ms on 2 cores.
BitVolume threshold_bits(const Volume& volume, double iso, const std::vector<ValueRange>& ranges,
                         const JobContext& job = {});

/// The object before its cuts, and as the slices across x need it.
struct SolidBits {
    BitVolume material, interior;                ///< interior: all 26 neighbours set; empty where nothing is cut
    BitVolume material_turned, interior_turned;  ///< axes (y, z, x); made when first needed

    std::size_t bytes() const {
        return material.bytes() + interior.bytes() + material_turned.bytes() + interior_turned.bytes();
    }
};

/// A cutting plane's residual normal . p + offset in slice coordinates: a*u + b*v + (c*slice + d), the bracket once a
/// slice (Csebfalvi et al. 1999, section 4).
struct CutResidual {
    double a = 0, b = 0, c = 0, d = 0;
    bool cap = true;

    double at(double u, double v, double slice) const { return a * u + b * v + (c * slice + d); }
};

CutResidual residual_of(const SolidCut& cut, const GridGeometry& geometry, const SliceDirection& direction);

/// The rows of bits of the object's slices in one region of directions, cuts applied. Keeps references.
class SliceRows {
public:
    /// @pre for slices across x the turned bits are made
    SliceRows(const SolidBits& bits, const GridGeometry& geometry, const std::vector<SolidCut>& cuts,
              const SliceDirection& direction);

    const SliceDirection direction;
    const int columns, rows, slices;  ///< voxels
    const int words;                  ///< 64-bit words a row of voxels
    const int cell_words;             ///< the same of columns + 1 cells
    bool has_open_cut() const { return open_; }

    /// Row v of slice c: voxels left standing. Either a stored row or `scratch` (2 * words long), filled. With an open
    /// cut, inner voxels stand only where a capped cut lays them bare.
    const std::uint64_t* voxels(int v, int c, std::uint64_t* scratch) const;
    bool voxel(int u, int v, int c) const;
    /// True for a voxel that is none of the object's own surface, laid bare by a cut.
    bool inner(int u, int v, int c) const { return interior_ && bit(*interior_, u, v, c); }

    /// Cell i of cell row j has the corners (i-1, j-1) .. (i, j), those outside the volume taken from its border.
    /// any: a corner is set before the cuts; full: all corners are. Cells at the sides are never full: a ray may pass
    /// them outside the volume.
    void cells(int j, int c, std::uint64_t* any, std::uint64_t* full) const;
    /// Clears in `any` the cells of which the cuts keep nothing, in `full` those of which they do not keep all.
    void cut_cells(int j, int c, std::uint64_t* any, std::uint64_t* full) const;
    /// Clears the cells less than two voxels behind a capped cut.
    void far_from_caps(int j, int c, std::uint64_t* cells) const;

private:
    const std::uint64_t* row(const BitVolume& bits, int v, int c) const {
        return direction.axis == 1 ? bits.row(c, v) : bits.row(v, c);
    }
    bool bit(const BitVolume& bits, int u, int v, int c) const { return row(bits, v, c)[u >> 6] >> (u & 63) & 1; }

    const BitVolume& material_;
    const BitVolume* interior_;  ///< null where nothing is cut
    std::vector<CutResidual> cuts_;
    bool open_ = false;
};

/// Bits of the potentially visible voxels of the object: those of the first slice, at the sides the region's rays can
/// enter through, or behind one of the 3x3 (2x2 in a quarter) voxels before them that is visible and empty. Row v of
/// slice c lies at [(c*rows + v) * words].
std::vector<std::uint64_t> visible_voxel_bits(const SliceRows& slices, const JobContext& job);

/// Bits of the cells in which a ray's bilinear sample can be the first inside the object, by the same propagation over
/// cells: a ray passes a cell unless all its corners are set. With an open cut, instead, all cells between which and
/// the cells before them the object's surface or a capped cut can lie. Row j of slice c lies at
/// [(c*(rows + 1) + j) * cell_words].
std::vector<std::uint64_t> visible_cell_bits(const SliceRows& slices, const JobContext& job);

}  // namespace lacuna
