#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lacuna {

/// Work done for one frame. Counting costs time, so renderers fill these only when asked to (see Engine::render).
struct Counters {
    std::uint64_t rays = 0;             ///< rays that meet the volume's box
    std::uint64_t samples = 0;          ///< lattice samples reconstructed (refinement cubic: cells solved)
    std::uint64_t skipped = 0;          ///< lattice samples a structure jumped over (not those after termination)
    std::uint64_t structure_reads = 0;  ///< look-ups in the structure
    std::uint64_t trilinear = 0;        ///< of the samples, those made from eight voxels
    std::uint64_t copied = 0;           ///< entries of blocks copied for them (kernels/include/block.clh), a cell each
    std::uint64_t not_converged = 0;    ///< iso hits whose Newton refinement left its bracket (reference renderer only)

    Counters& operator+=(const Counters& other) {
        rays += other.rays;
        samples += other.samples;
        skipped += other.skipped;
        structure_reads += other.structure_reads;
        trilinear += other.trilinear;
        copied += other.copied;
        not_converged += other.not_converged;
        return *this;
    }
};

/// What casting a volume brick by brick came to.
struct BrickCounts {
    int total = 0;                 ///< bricks of the volume
    int empty = 0;                 ///< of these with nothing to see
    int hidden = 0;                ///< not looked at: outside the picture, or behind what no ray sees through
    int uniform = 0;               ///< cast without their voxels: one value all through
    int loaded = 0;                ///< read for this picture; others were still there
    int cast = 0;                  ///< gone through by rays
    std::uint64_t bytes_read = 0;  ///< of voxels, for this picture
    std::uint64_t bytes_peak = 0;  ///< bricks and structures held at once, the most
};

/// A picture as rendered: floats, row 0 on top.
struct Frame {
    glm::ivec2 size{0};
    std::vector<glm::vec4> color;  ///< size.x*size.y, sRGB, premultiplied by opacity, over nothing
    std::vector<float> depth_mm;   ///< along the ray from its origin; infinity where nothing opaque was met
    Counters counters;
    double ms = 0;  ///< from the call to the pixels on the host, structure builds not counted

    std::size_t pixels() const { return std::size_t(size.x) * std::size_t(size.y); }
};

/// 8-bit RGB over a background colour, 3 bytes a pixel: round(255 * clamp(c)).
std::vector<std::uint8_t> to_rgb8(const Frame& frame, const glm::dvec3& background);

}  // namespace lacuna
