#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/session/document.h"

namespace lacuna {

/// Cutting planes and the box in terms of a picture: where their outlines and handles fall, which of them a position
/// hits, and what plane or box a drag makes. Positions in the picture are in pixels of the ViewRays, from the top left
/// corner of the first pixel. Plain geometry; knows no widget.

/// Half the volume's extent along a unit direction, mm.
double half_extent_mm(const glm::dvec3& direction, const GridGeometry& geometry);

/// The convex polygon in which a plane meets the box of voxel cells, mm, in order around it; empty where they do not
/// meet, or meet in an edge or a corner alone.
std::vector<glm::dvec3> section_of(const CuttingPlane& plane, const GridGeometry& geometry);

/// A plane moved along its normal into the kept half; clamped so that it still meets the volume.
CuttingPlane moved(const CuttingPlane& plane, double mm, const GridGeometry& geometry);

/// A plane turned about an axis through a point, mm.
CuttingPlane turned(const CuttingPlane& plane, const glm::dvec3& axis, double degrees, const glm::dvec3& about);

/// The direction among the grid's axes and their diagonals (26 in all) nearest to a normal; a unit vector.
glm::dvec3 snapped(const glm::dvec3& normal, const GridGeometry& geometry);

/// Where a picture's position lies, pixels from its upper left corner; none behind a perspective eye.
std::optional<glm::dvec2> in_picture(const ViewRays& rays, const glm::dvec3& mm);

/// The handles of one plane as seen from a camera.
struct PlaneGizmo {
    std::vector<glm::dvec3> section;  ///< section_of()
    glm::dvec3 anchor{0};             ///< the section's centroid; of a plane beside the volume, its nearest point to it
    glm::dvec3 normal{1, 0, 0};       ///< unit, into the kept half
    glm::dvec3 tip{0};                ///< of the arrow, which points out of the kept half
    glm::dvec3 tilt[4];               ///< handles in the plane
};
PlaneGizmo gizmo_of(const CuttingPlane& plane, const GridGeometry& geometry, const ViewRays& rays);

/// What of a gizmo a position is on.
struct Grip {
    enum class Kind { none, outline, move, tilt, side, box };
    Kind kind = Kind::none;
    int index = 0;  ///< of the tilt handle, or of the box's side: 0, 1 lower and upper x, then y, z
    explicit operator bool() const { return kind != Kind::none; }
    friend bool operator==(const Grip&, const Grip&) = default;
};

/// @param reach_px  how far from a handle still counts as on it; half of it from a line
Grip grip_at(const PlaneGizmo& gizmo, const ViewRays& rays, glm::dvec2 at, double reach_px);

/// A plane being dragged by one of its handles.
class PlaneDrag {
public:
    /// @param at  where it was taken hold of, pixels
    PlaneDrag(const CuttingPlane& plane, const Grip& grip, const GridGeometry& geometry, const ViewRays& rays,
              glm::dvec2 at);
    /// The plane with the handle drawn to a position. Tilting turns it about its anchor as if that point of it were
    /// on a ball; moving keeps its normal.
    /// @param snap  tilt to the nearest axis or diagonal
    CuttingPlane to(glm::dvec2 at, bool snap = false) const;

private:
    glm::dvec3 arm_at(glm::dvec2 at) const;
    double shift_at(glm::dvec2 at) const;

    CuttingPlane plane_;
    Grip grip_;
    GridGeometry geometry_;
    ViewRays rays_;
    PlaneGizmo gizmo_;
    glm::dvec2 from_;
    double radius_mm_ = 1;
    bool behind_ = false;  ///< the handle taken lies on the far half of its ball
};

/// Corners of the box, mm: bit 0 of the index is the upper end of the grid's x, bit 1 of y, bit 2 of z.
glm::dvec3 corner_of(const BoxRoi& roi, int corner, const GridGeometry& geometry);
/// Middle of a side (as Grip::index), mm.
glm::dvec3 side_of(const BoxRoi& roi, int side, const GridGeometry& geometry);
glm::dvec3 middle_of(const BoxRoi& roi, const GridGeometry& geometry);

/// A side's handle or the middle's; a side nearer to the viewer goes before one behind it.
Grip grip_at(const BoxRoi& roi, const GridGeometry& geometry, const ViewRays& rays, glm::dvec2 at, double reach_px);

/// The box with one side moved by a share of the volume, at least one voxel left between it and the opposite one.
BoxRoi side_moved(const BoxRoi& roi, int side, double share, const GridGeometry& geometry);

/// A box being dragged by a side, or as a whole by its middle.
class BoxDrag {
public:
    BoxDrag(const BoxRoi& roi, const Grip& grip, const GridGeometry& geometry, const ViewRays& rays, glm::dvec2 at);
    BoxRoi to(glm::dvec2 at) const;

private:
    BoxRoi roi_;
    Grip grip_;
    GridGeometry geometry_;
    ViewRays rays_;
    glm::dvec2 from_;
};

}  // namespace lacuna
