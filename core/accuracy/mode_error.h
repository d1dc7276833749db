#pragma once

#include <cstdint>

#include "core/render/frame.h"
#include "core/volume/statistics.h"

namespace lacuna {

/// How far an isosurface is from where it should be, from the depths of two frames of one view.
struct SurfaceError {
    double max_voxels = 0;   ///< largest difference of depth along the ray; infinite when a depth is NaN
    double mean_voxels = 0;  ///< mean absolute difference over the pixels both hit
    double rms_voxels = 0;
    std::uint64_t both = 0;            ///< pixels that hit in both
    std::uint64_t missed = 0;          ///< silhouette pixels the reference hits and the frame does not
    std::uint64_t false_hits = 0;      ///< pixels the frame hits and the reference does not
    std::uint64_t over_one_voxel = 0;  ///< of `both`: another surface was hit
};

/// @param voxel_mm  the smallest voxel spacing @throws Error(bad_usage) if the sizes differ
SurfaceError compare_surfaces(const Frame& frame, const Frame& reference, double voxel_mm);

/// How far projected values fall short, from the grey levels of two frames drawn through the same window. A ray's
/// maximum over samples can only be too small, its minimum only too large: both are counted as undershoot. Beyond it go
/// the first local maximum (another one may be stopped at), nearest voxels and interpolated pixels: that is overshoot.
struct ProjectionError {
    double max_undershoot = 0;   ///< in the volume's unit; infinite when a value is NaN
    double mean_undershoot = 0;  ///< over all pixels
    double max_overshoot = 0;    ///< the other way
    std::uint64_t pixels = 0;    ///< pixels with an undershoot above one 65535th of the window
};

/// @param window  of both frames; values outside it are taken as its ends, so it should span the values
/// @param smallest  the frames are minimum projections @throws Error(bad_usage) if the sizes differ
ProjectionError compare_projections(const Frame& frame, const Frame& reference, const ValueRange& window,
                                    bool smallest = false);

}  // namespace lacuna
