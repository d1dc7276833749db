#pragma once

#include <array>

#include "core/volume/grid_geometry.h"

namespace lacuna::ui {

enum class SliceKind { axial, coronal, sagittal };

/// How one family of slices lies on the screen. Slices run along the grid axis closest to the anatomical one, in the
/// radiological convention: axial seen from the feet (patient's left on the picture's right, front on top), coronal
/// from the front (left on the right, head on top), sagittal from the left (front on the left, head on top).
struct SlicePlane {
    SliceKind kind = SliceKind::axial;
    int u = 0, v = 1, w = 2;                                ///< grid axes across, down and through the picture
    bool flip_u = false, flip_v = false;                    ///< the picture runs against the grid axis
    char left = 'R', right = 'L', top = 'A', bottom = 'P';  ///< letters of the dominant patient axis at each edge

    /// Voxel coordinates (continuous, centres at whole numbers) of a picture position in voxels from the picture's
    /// upper left corner, on slice `index`; and back.
    glm::dvec3 to_voxel(const glm::dvec2& picture, double index, const glm::ivec3& size) const;
    glm::dvec2 to_picture(const glm::dvec3& voxel, const glm::ivec3& size) const;
};

/// Which grid axis serves which patient axis (x, y, z): the assignment with the largest total agreement.
std::array<int, 3> closest_grid_axes(const GridGeometry& geometry);

SlicePlane slice_plane(const GridGeometry& geometry, SliceKind kind);

}  // namespace lacuna::ui
