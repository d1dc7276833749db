#pragma once

#include <cmath>

#include "core/render/scene.h"

namespace lacuna {

/// A headlight's c = |n.v| turned into a colour, as scene.h defines it.
inline glm::dvec3 shade(Shading shading, const glm::dvec3& color, double c) {
    switch (shading) {
        case Shading::none:
            return color;
        case Shading::lambert:
            return color * (0.2 + 0.8 * c);
        case Shading::phong:
            break;
    }
    const double c4 = c * c * c * c, c16 = c4 * c4 * c4 * c4;
    return color * (0.2 + 0.7 * c) + 0.3 * (c16 * c4);
}

/// A value's grey through the window, 0..1.
inline double grey_level(const ValueRange& window, double value) {
    return std::fmin(std::fmax((value - window.lo) / window.width(), 0), 1);
}

}  // namespace lacuna
