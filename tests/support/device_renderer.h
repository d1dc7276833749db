#pragma once

#include <algorithm>
#include <memory>

#include "core/compute/device.h"
#include "core/render/opencl_renderer.h"

namespace lacuna::test {

/// The device kernel tests run on, opened once; null where there is none.
inline const std::shared_ptr<ComputeDevice>& device() {
    static const std::shared_ptr<ComputeDevice> opened = open_device();
    return opened;
}

/// A renderer with 16 rays or 1 ray a work-item. @pre device()
inline OpenClRenderer& renderer(int lanes = 16) {
    static OpenClRenderer packets(device(), 16), single(device(), 1);
    return lanes == 16 ? packets : single;
}

/// Share of pixels in which any channel differs by more than `levels`/255; NaN counts.
inline double share_over(const Frame& a, const Frame& b, double levels) {
    std::size_t over = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const glm::vec4 d = glm::abs(a.color[i] - b.color[i]) * 255.0f;
        over += !(std::max({d.r, d.g, d.b, d.a}) <= float(levels));
    }
    return double(over) / double(a.pixels());
}

}  // namespace lacuna::test

/// Skips the test, saying so, where no OpenCL device works.
#define LACUNA_NEEDS_DEVICE() \
    if (!::lacuna::test::device()) GTEST_SKIP() << "skipped: no usable OpenCL device"
