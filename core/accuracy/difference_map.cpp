#include "core/accuracy/difference_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/accuracy/image_error.h"
#include "core/base/error.h"

namespace lacuna {

namespace {

constexpr std::array<std::uint8_t, 3> k_unknown{0, 255, 255};

// Stations of even lightness steps, in the manner of "inferno" (Smith & van der Walt 2015).
constexpr std::array<glm::dvec3, 9> k_stations{glm::dvec3(0, 0, 0.016), {0.122, 0.047, 0.283}, {0.333, 0.059, 0.427},
                                               {0.534, 0.134, 0.415},   {0.736, 0.216, 0.330}, {0.891, 0.350, 0.200},
                                               {0.978, 0.558, 0.035},   {0.975, 0.790, 0.258}, {0.988, 0.998, 0.645}};

}  // namespace

glm::dvec3 heat_color(double t) {
    const double at = std::clamp(t, 0.0, 1.0) * double(k_stations.size() - 1);
    const std::size_t i = std::min(std::size_t(at), k_stations.size() - 2);
    return glm::mix(k_stations[i], k_stations[i + 1], at - double(i));
}

DifferenceMap difference_map(const Frame& frame, const Frame& reference, const glm::dvec3& background,
                             double full_scale) {
    if (frame.size != reference.size || frame.color.size() != reference.color.size())
        throw Error(Errc::bad_usage, "Only pictures of the same size can be compared.");
    std::vector<double> difference(frame.color.size());
    double largest = 0;
    for (std::size_t i = 0; i < difference.size(); ++i) {
        const glm::dvec3 d =
            glm::abs(seen_color(frame.color[i], background) - seen_color(reference.color[i], background));
        const bool known = !std::isnan(d.x + d.y + d.z);
        difference[i] = known ? std::max({d.x, d.y, d.z}) : std::nan("");
        if (known) largest = std::max(largest, difference[i]);
    }
    DifferenceMap map{frame.size, std::vector<std::uint8_t>(3 * difference.size()),
                      full_scale > 0 ? full_scale : largest};
    for (std::size_t i = 0; i < difference.size(); ++i) {
        std::uint8_t* pixel = &map.rgb[3 * i];
        if (std::isnan(difference[i])) {
            std::copy(k_unknown.begin(), k_unknown.end(), pixel);
            continue;
        }
        const glm::dvec3 color = difference[i] > 0 ? heat_color(difference[i] / map.full_scale) : glm::dvec3(0);
        for (int c = 0; c < 3; ++c) pixel[c] = std::uint8_t(std::lround(255 * color[c]));
    }
    return map;
}

}  // namespace lacuna
