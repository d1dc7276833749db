#pragma once

#include <cmath>

#include "core/render/frame.h"

namespace lacuna::test {

inline Frame flat(glm::ivec2 size, glm::vec4 color) {
    Frame frame;
    frame.size = size;
    frame.color.assign(frame.pixels(), color);
    frame.depth_mm.assign(frame.pixels(), 0);
    return frame;
}

/// A picture with structure: waves of the amplitude about mid grey.
inline Frame waves(glm::ivec2 size, double amplitude, double phase = 0, double frequency = 0.7) {
    Frame frame = flat(size, glm::vec4(0));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            frame.color[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] =
                glm::vec4(glm::vec3(0.5 + amplitude * std::sin(frequency * x + phase) * std::cos(0.4 * y)), 1);
    return frame;
}

}  // namespace lacuna::test
