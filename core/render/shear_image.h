#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/job.h"
#include "core/render/frame.h"
#include "core/render/shear_factor.h"

namespace lacuna {

/// The intermediate image of shear-warp: what shows in each pixel, how deep it lies, and its colour.
struct ShearImage {
    static constexpr float k_nothing = std::numeric_limits<float>::infinity();
    struct Painted {
        std::uint32_t key = 0;       ///< what the painter left: a voxel's number, its baked shade, or a slice
        float depth_mm = k_nothing;  ///< infinite: nothing is painted here
    };
    glm::ivec2 size{0};
    std::vector<Painted> painted;
    std::vector<glm::vec4> color;  ///< of every pixel; 0 where nothing is painted

    /// Makes room. Contents are not kept; memory is, so that a moving camera allocates nothing.
    void resize(glm::ivec2 image_size) {
        size = image_size;
        const std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
        if (painted.size() < pixels) {
            painted.resize(pixels);
            color.resize(pixels);
        }
    }
    std::size_t row(int y) const { return std::size_t(y) * std::size_t(size.x); }
    std::size_t bytes() const { return painted.size() * sizeof(painted[0]) + color.size() * sizeof(color[0]); }
};

/// Warps the image to a frame whose pixels are all empty: bilinear in colour and, within one surface, in depth; else
/// the depth is that of the nearest covered corner. Pixels less than half covered have none. Adds to the frame's rays
/// those that meet the image.
void warp(const ShearImage& image, const Shear& shear, Frame& frame, const JobContext& job);

}  // namespace lacuna
