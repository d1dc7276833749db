#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/render/frame.h"

namespace lacuna {

/// How far a picture is from the one it should be, over the 8-bit RGB pixels a user sees. NaN in either fails: max
/// becomes infinite.
struct ImageError {
    std::string reference;               ///< what it was compared with
    double max = 0;                      ///< largest difference in any channel, in 1/255
    double mean = 0;                     ///< mean absolute difference over channels and pixels, in 1/255
    double psnr = 0;                     ///< dB; infinity for equal pictures
    double ssim = 1;                     ///< Wang et al. 2004 on luma, 11x11 Gaussian window sigma 1.5
    std::uint64_t pixels_over_budget = 0;///< pixels with any channel's difference above the budget
};

/// Compares unrounded colours over the background (scaled to 255), so that errors below one level are seen too.
/// @throws Error(bad_usage) if the sizes differ
ImageError compare(const Frame& frame, const Frame& reference, const glm::dvec3& background, double budget = 1.0);

}  // namespace lacuna
