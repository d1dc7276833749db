#pragma once

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// The volume convolved with a Gaussian of standard deviation sigma_mm along every axis: in mm, so that anisotropic
/// voxels are smoothed by one ball. Separable, weights sampled to 4 sigma and normalised; where the kernel reaches
/// beyond the border or over voxels that are not finite, the weights left are normalised anew (normalised convolution,
/// Knutsson & Westin 1993). Voxels that are not finite stay NaN. The type stays; whole numbers are rounded to nearest.
/// Cost: all threads, gaussian_smooth_bytes() beside both volumes.
/// @throws Error(bad_usage) for sigma not positive or above k_most_sigma_voxels of the finest axis; Error(cancelled)
Volume gaussian_smooth(const Volume& volume, double sigma_mm, const JobContext& job = {});

inline constexpr double k_most_sigma_voxels = 256;

/// Bytes taken while smoothing, beside the volume itself: the result, and 4 bytes a voxel (8 for f32).
std::uint64_t gaussian_smooth_bytes(const Volume& volume);

}  // namespace lacuna
