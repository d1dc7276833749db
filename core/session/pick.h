#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/render/camera.h"
#include "core/render/frame.h"
#include "core/render/scene.h"

namespace lacuna {

/// The point a frame shows at a position of the picture, mm, by the rays it was cast along: the surface (iso,
/// shear-warp, capped cuts), where half the light is absorbed (ea), the sample that won (mip, minip, lmip); none where
/// the ray met nothing, and for mean.
/// @param scene  the frame's own: its camera is asked, not the one there is now
/// @param share  0..1 across and down the picture; the pixel under it is asked
std::optional<glm::dvec3> point_at(const Frame& frame, const Scene& scene, glm::dvec2 share);

/// The focus of the effect depth of field (core/render/effects.h) that is sharpest at a point: a fraction of the way
/// through the volume's bounding sphere, 0..1.
double focus_at(const glm::dvec3& mm, const ViewRays& rays, const GridGeometry& geometry);

}  // namespace lacuna
