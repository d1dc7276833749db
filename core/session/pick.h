#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/render/camera.h"
#include "core/render/frame.h"
#include "core/render/scene.h"

namespace lacuna {

/// How far away what a frame shows is, with the rays it was cast along: enough to tell what a position in the picture
/// is, whatever the camera has done since.
struct DepthPicture {
    ViewRays rays;
    std::vector<float> depth_mm;  ///< as Frame::depth_mm, rays.size pixels
};

/// Takes the depth out of a frame of a scene.
DepthPicture depth_picture(const Scene& scene, Frame& frame);

/// The point shown at a position of the picture, mm: the surface (iso, shear-warp, capped cuts), where half the light
/// is absorbed (ea), the sample that won (mip, minip, lmip); none where the ray met nothing, and for mean.
/// @param share  0..1 across and down the picture; the pixel under it is asked
std::optional<glm::dvec3> point_at(const DepthPicture& picture, glm::dvec2 share);

/// The focus of the effect depth of field (core/render/effects.h) that is sharpest at a point: a fraction of the way
/// through the volume's bounding sphere, 0..1.
double focus_at(const glm::dvec3& mm, const ViewRays& rays, const GridGeometry& geometry);

}  // namespace lacuna
