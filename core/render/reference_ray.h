#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/render/camera.h"
#include "core/render/scene.h"

namespace lacuna::reference {

/// One ray with its sample lattice, clipped to the box of voxel cells and to the cuts. Distances t are in mm from the
/// ray's origin.
struct LatticeRay {
    glm::dvec3 origin_vox{0}, per_mm_vox{0};  ///< position at t is origin_vox + t * per_mm_vox
    glm::dvec3 direction_grid{0, 0, 1};       ///< unit, along the grid's own axes, mm
    double box_in = 0, box_out = 0;           ///< where the ray enters and leaves the box
    double from = 0, to = 0;                  ///< the part of [box_in, box_out] the cuts keep
    int entry_axis = -1;                      ///< axis of the box face at box_in; -1: the ray starts inside the box
    bool hits_box = false, kept = false;      ///< kept: [from, to] is not empty
    bool entry_by_cut = false, entry_capped = false;  ///< what limits `from`
    double step_mm = 1;
    std::int64_t first = 0, end = 0;  ///< lattice samples k in [first, end) lie in [from, to]

    glm::dvec3 at(double t) const { return origin_vox + t * per_mm_vox; }
    double sample_t(std::int64_t k) const { return box_in + (double(k) + 0.5) * step_mm; }
};

/// The ray of a direction (unit) from an origin, mm.
LatticeRay cast(const glm::dvec3& origin_mm, const glm::dvec3& direction, const GridGeometry& geometry,
                const std::vector<CuttingPlane>& cuts, double step_mm);

}  // namespace lacuna::reference
