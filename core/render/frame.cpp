#include "core/render/frame.h"

#include <cmath>

namespace lacuna {

std::vector<std::uint8_t> to_rgb8(const Frame& frame, const glm::dvec3& background) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(frame.color.size() * 3);
    for (const glm::vec4& pixel : frame.color) {
        const double through = 1 - double(pixel.a);
        for (int c = 0; c < 3; ++c) {
            const double value = double(pixel[c]) + through * background[c];
            // Written so that NaN becomes black rather than an undefined conversion.
            rgb.push_back(value > 0 ? std::uint8_t(std::lround(255 * std::fmin(value, 1))) : std::uint8_t(0));
        }
    }
    return rgb;
}

}  // namespace lacuna
