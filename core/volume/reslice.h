#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Where a flat picture lies in space. Picture positions are in pixels from the upper left corner of the picture;
/// pixel (i, j)'s centre is at (i + 0.5, j + 0.5).
struct SliceFrame {
    glm::dvec3 corner_mm{0};    ///< the picture's upper left corner
    glm::dvec3 right{1, 0, 0};  ///< unit vector along a row
    glm::dvec3 down{0, 1, 0};   ///< unit vector down a column, at right angles to `right`
    glm::dvec2 pixel_mm{1};     ///< width and height of a pixel
    glm::ivec2 size{0};         ///< pixels
    glm::dvec3 normal() const { return glm::cross(right, down); }
    glm::dvec3 to_mm(const glm::dvec2& picture) const {
        return corner_mm + right * (picture.x * pixel_mm.x) + down * (picture.y * pixel_mm.y);
    }
    /// Of the foot of the perpendicular from a position onto the picture's plane.
    glm::dvec2 to_picture(const glm::dvec3& mm) const {
        return glm::dvec2(glm::dot(mm - corner_mm, right), glm::dot(mm - corner_mm, down)) / pixel_mm;
    }
    /// How far a position lies in front of the plane, along normal(), mm.
    double depth_mm(const glm::dvec3& mm) const { return glm::dot(mm - corner_mm, normal()); }
    friend bool operator==(const SliceFrame&, const SliceFrame&) = default;
};

/// How the slices of a slab become one picture.
enum class SlabMode { mean, mip, minip };

/// A slab about a plane; of thickness 0 it is the plane alone.
struct Slab {
    double thickness_mm = 0;
    SlabMode mode = SlabMode::mean;
    friend bool operator==(const Slab&, const Slab&) = default;
};

/// The distance between the sheets a slab is sampled in: one voxel along its normal, which is the spacing of the slices
/// where the plane lies along the grid. mm
double sheet_distance_mm(const GridGeometry& geometry, const glm::dvec3& normal);

/// The sheets of a slab: at j * sheet_distance_mm() for the whole j from first() to last(), those in the half-open
/// interval (-thickness/2, thickness/2] and always j = 0. So a slab n slices thick along the grid is n slices.
struct Sheets {
    double distance_mm = 1;
    int first = 0, last = 0;
    int count() const { return last - first + 1; }
};
Sheets sheets_of(const GridGeometry& geometry, const glm::dvec3& normal, double thickness_mm);

/// A volume's values in a picture, row by row from the top. Where the picture lies on the grid (its pixels are voxels)
/// they are the voxels' values exactly; else they are trilinear, constant in the outer half of the border voxels. NaN
/// outside the box of voxel cells. Sheets of a slab with no value (outside, NaN) take no part; the mean is that of the
/// others. Cost: 1 to 4 ns a pixel and sheet along the grid, 10 else, on one thread; works on all.
/// @pre the volume is in memory. @throws Error(cancelled)
std::vector<float> reslice(const Volume& volume, const SliceFrame& frame, const Slab& slab = {},
                           const JobContext& job = {});

/// The values of a whole-number volume (labels) of the nearest voxel; 0 outside. @pre voxels has the geometry's size
std::vector<std::uint32_t> reslice_nearest(const GridGeometry& geometry, std::span<const std::uint32_t> voxels,
                                           const SliceFrame& frame, const JobContext& job = {});

/// How a picture's pixels walk through the grid, in voxels.
struct VoxelWalk {
    glm::dvec3 first, across, down;  ///< pixel (0, 0)'s centre, one pixel to the right, one down
    /// Every pixel is a voxel: steps are single grid steps, the first lies on a voxel (within 1e-6 voxels).
    bool on_grid = false;
};
VoxelWalk voxel_walk(const GridGeometry& geometry, const SliceFrame& frame);

}  // namespace lacuna
