#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/render/frame.h"

namespace lacuna {

/// How far a picture is from the one it should be, over the 8-bit RGB pixels a user sees. NaN in either fails: max
/// becomes infinite, mean likewise, psnr and ssim 0, flip 1.
struct ImageError {
    std::string reference;                 ///< what it was compared with
    double max = 0;                        ///< largest difference in any channel, in 1/255
    double mean = 0;                       ///< mean absolute difference over channels and pixels, in 1/255
    glm::dvec3 channel_max{0};             ///< of red, green, blue alone, in 1/255
    glm::dvec3 channel_mean{0};            ///< likewise
    double psnr = 0;                       ///< dB; infinity for equal pictures
    double ssim = 1;                       ///< Wang et al. 2004 on luma, 11x11 Gaussian window sigma 1.5
    double flip = 0;                       ///< mean FLIP (Andersson et al. 2020), 0..1; see flip.h
    std::uint64_t pixels_over_budget = 0;  ///< pixels with any channel's difference above the budget
};

/// A picture others are held against; what the measures need of it is computed once. Colours are compared unrounded
/// over the background (scaled to 255), so that errors below one level are seen too. Thread-safe after construction.
class TruePicture {
public:
    TruePicture(Frame reference, const glm::dvec3& background);
    ~TruePicture();
    TruePicture(TruePicture&&) noexcept;
    TruePicture& operator=(TruePicture&&) noexcept;

    const Frame& frame() const { return frame_; }
    /// Cost: two passes over the pixels when the pictures are equal bit by bit, else SSIM and FLIP of the frame.
    /// @throws Error(bad_usage) if the sizes differ
    ImageError compare(const Frame& frame, double budget = 1.0) const;
    /// The `max` of compare() alone, in 1/255; infinite for NaN. Cost: a pass over the pixels.
    /// @throws Error(bad_usage) if the sizes differ
    double largest(const Frame& frame) const;

private:
    struct Measures;
    void require_alike(const Frame& frame) const;
    Frame frame_;
    glm::dvec3 background_;
    mutable std::unique_ptr<Measures> measures_;
};

/// The same for a single comparison. @throws Error(bad_usage) if the sizes differ
ImageError compare(const Frame& frame, const Frame& reference, const glm::dvec3& background, double budget = 1.0);

/// What a user sees of a pixel, unrounded: 0..255 over the background, clamped to that range. NaN stays NaN.
glm::dvec3 seen_color(const glm::vec4& pixel, const glm::dvec3& background);

}  // namespace lacuna
