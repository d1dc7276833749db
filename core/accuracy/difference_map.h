#pragma once

#include <cstdint>
#include <vector>

#include "core/render/frame.h"

namespace lacuna {

/// Where two pictures differ, as a picture.
struct DifferenceMap {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel, row 0 on top
    double full_scale = 0;          ///< the difference drawn in the brightest colour, in 1/255
};

/// The largest difference of each pixel's channels, from black (equal) through violet, red and orange to pale yellow
/// (full scale and above), as light as it is large; cyan where either picture is NaN.
/// @param full_scale  in 1/255; 0: the largest difference there is
/// @throws Error(bad_usage) if the sizes differ
DifferenceMap difference_map(const Frame& frame, const Frame& reference, const glm::dvec3& background,
                             double full_scale = 0);

/// The map's colour for 0..1.
glm::dvec3 heat_color(double t);

}  // namespace lacuna
