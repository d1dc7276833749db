#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "core/volume/reslice.h"

namespace lacuna::ui {

enum class SliceKind { axial, coronal, sagittal };
inline constexpr std::array<SliceKind, 3> k_slice_kinds{SliceKind::axial, SliceKind::coronal, SliceKind::sagittal};

/// How one family of slices lies along the grid. Slices run along the grid axis closest to the anatomical one, in the
/// radiological convention: axial seen from the feet (patient's left on the picture's right, front on top), coronal
/// from the front (left on the right, head on top), sagittal from the left (front on the left, head on top).
struct SlicePlane {
    int u = 0, v = 1, w = 2;                   ///< grid axes across, down and through the picture
    bool flip_u = false, flip_v = false;       ///< the picture runs against the grid axis
    glm::dvec3 right{1, 0, 0}, down{0, 1, 0};  ///< the picture's directions in space
    glm::dvec3 normal() const { return glm::cross(right, down); }
};

SlicePlane slice_plane(const GridGeometry& geometry, SliceKind kind);

/// Where a slice of one family lies in space and what a view says of it.
struct SlicePose {
    SlicePlane plane;                      ///< of the family where it is not tilted
    SliceFrame frame;                      ///< the picture; its pixels are voxels where it lies along the grid
    bool oblique = false;                  ///< it does not lie along the grid
    int index = 0;                         ///< along the grid: of the slice, along plane.w
    double page_mm = 1;                    ///< between this slice and the next, along the frame's normal
    std::string left, right, top, bottom;  ///< what lies at the picture's edges, as sides_of() says
};

/// The slice of a family through the cross-hair: along the grid the nearest one, tilted the plane through it. A turn
/// about a family's own normal leaves its pictures as they are; only the two others turn. So does a turn of all three
/// leave each picture as upright as it can be. Tilted pictures show the whole box of voxels, in pixels as large as the
/// smallest spacing (larger where that would be more than k_most_pixels along a side).
/// @param tilt  turns the three normals, in patient space (SliceSettings::tilt)
SlicePose slice_pose(const GridGeometry& geometry, SliceKind kind, const glm::dquat& tilt, const glm::dvec3& cursor_mm);
inline constexpr int k_most_pixels = 2048;

/// The normals of the three families after the tilt, by SliceKind: orthonormal.
std::array<glm::dvec3, 3> slice_normals(const GridGeometry& geometry, const glm::dquat& tilt);

/// A tilt that turns nothing (within a rounding error).
bool is_upright(const glm::dquat& tilt);

}  // namespace lacuna::ui
