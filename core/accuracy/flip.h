#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/render/frame.h"

namespace lacuna {

/// Pixels a degree of vision on a 0.7 m wide screen of 3840 pixels seen from 0.7 m, as in the paper.
inline constexpr double k_flip_pixels_per_degree = 67.0206432765823;

/// What FLIP needs of one picture (Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom & Fairchild 2020, "FLIP: A
/// Difference Evaluator for Alternating Images", the version for low dynamic range): colours as the eye's contrast
/// sensitivity leaves them, in Hunt-adjusted L*a*b*, and the strength of edges and points.
/// Cost: 13 separable filters of about 20 taps.
class FlipPicture {
public:
    FlipPicture() = default;
    /// @param background  what the picture is shown over; colours are clamped to 0..1
    FlipPicture(const Frame& frame, const glm::dvec3& background, double pixels_per_degree = k_flip_pixels_per_degree);

    glm::ivec2 size() const { return size_; }

private:
    friend std::vector<float> flip_map(const FlipPicture& a, const FlipPicture& b);
    glm::ivec2 size_{0};
    std::vector<glm::vec3> color_;  // Hunt-adjusted L*a*b*
    std::vector<float> edge_, point_;
};

/// The perceived difference of each pixel when one flips between the pictures, 0 to 1; symmetric. NaN where either
/// picture is. @throws Error(bad_usage) if the sizes differ
std::vector<float> flip_map(const FlipPicture& a, const FlipPicture& b);
/// Its mean; 1 where any pixel is NaN.
double mean_flip(const FlipPicture& a, const FlipPicture& b);

}  // namespace lacuna
