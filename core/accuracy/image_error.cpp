#include "core/accuracy/image_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

#include "core/accuracy/flip.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr int k_window_radius = 5;  // 11 x 11, Wang et al. 2004
constexpr double k_window_sigma = 1.5;

using Plane = std::vector<double>;

double luma(const glm::dvec3& rgb) { return 0.299 * rgb.x + 0.587 * rgb.y + 0.114 * rgb.z; }

std::array<double, 2 * k_window_radius + 1> gaussian() {
    std::array<double, 2 * k_window_radius + 1> weights{};
    for (int i = -k_window_radius; i <= k_window_radius; ++i)
        weights[std::size_t(i + k_window_radius)] = std::exp(-0.5 * i * i / (k_window_sigma * k_window_sigma));
    return weights;
}

/// One pass of the window along x or y; weights falling outside the picture are dropped and the rest rescaled.
Plane smooth(const Plane& in, glm::ivec2 size, int axis) {
    static const auto weights = gaussian();
    Plane out(in.size());
    const std::ptrdiff_t stride = axis == 0 ? 1 : size.x;
    parallel_for(0, size.y, [&](std::int64_t y) {
        for (int x = 0; x < size.x; ++x) {
            const int at = axis == 0 ? x : int(y), length = size[axis];
            const std::ptrdiff_t here = y * size.x + x;
            double sum = 0, weight_sum = 0;
            for (int d = std::max(-k_window_radius, -at); d <= std::min(k_window_radius, length - 1 - at); ++d) {
                const double weight = weights[std::size_t(d + k_window_radius)];
                sum += weight * in[std::size_t(here + d * stride)];
                weight_sum += weight;
            }
            out[std::size_t(here)] = sum / weight_sum;
        }
    });
    return out;
}

Plane smooth(const Plane& in, glm::ivec2 size) { return smooth(smooth(in, size, 0), size, 1); }

Plane product(const Plane& a, const Plane& b) {
    Plane out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] * b[i];
    return out;
}

/// What SSIM needs of one picture.
struct LumaStatistics {
    Plane luma, mean, mean_of_squares;

    LumaStatistics() = default;
    LumaStatistics(const Frame& frame, const glm::dvec3& background) : luma(frame.pixels()) {
        for (std::size_t i = 0; i < luma.size(); ++i) luma[i] = lacuna::luma(seen_color(frame.color[i], background));
        mean = smooth(luma, frame.size);
        mean_of_squares = smooth(product(luma, luma), frame.size);
    }
};

double mean_ssim(const LumaStatistics& a, const LumaStatistics& b, glm::ivec2 size) {
    constexpr double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);
    const Plane ab = smooth(product(a.luma, b.luma), size);
    double sum = 0;
    for (std::size_t i = 0; i < ab.size(); ++i) {
        const double ma = a.mean[i], mb = b.mean[i];
        const double var_a = a.mean_of_squares[i] - ma * ma, var_b = b.mean_of_squares[i] - mb * mb,
                     cov = ab[i] - ma * mb;
        sum += (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (var_a + var_b + c2));
    }
    return sum / double(ab.size());
}

bool equal_bits(const Frame& a, const Frame& b) {
    return std::memcmp(a.color.data(), b.color.data(), a.color.size() * sizeof(a.color[0])) == 0;
}

}  // namespace

glm::dvec3 seen_color(const glm::vec4& pixel, const glm::dvec3& background) {
    glm::dvec3 color = glm::dvec3(pixel) + (1 - double(pixel.a)) * background;
    for (int c = 0; c < 3; ++c) color[c] = color[c] < 0 ? 0 : color[c] > 1 ? 255 : 255 * color[c];
    return color;
}

/// Computed when the first picture that differs comes.
struct TruePicture::Measures {
    std::once_flag once;
    LumaStatistics luma;
    FlipPicture flip;
};

TruePicture::TruePicture(Frame reference, const glm::dvec3& background)
    : frame_(std::move(reference)), background_(background), measures_(std::make_unique<Measures>()) {}
TruePicture::~TruePicture() = default;
TruePicture::TruePicture(TruePicture&&) noexcept = default;
TruePicture& TruePicture::operator=(TruePicture&&) noexcept = default;

void TruePicture::require_alike(const Frame& frame) const {
    if (frame.size != frame_.size || frame.color.size() != frame_.color.size())
        throw Error(Errc::bad_usage, "Only pictures of the same size can be compared.");
}

double TruePicture::largest(const Frame& frame) const {
    require_alike(frame);
    double largest = 0;
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        if (frame.color[i] == frame_.color[i]) continue;  // never where a NaN is
        const glm::dvec3 d = seen_color(frame.color[i], background_) - seen_color(frame_.color[i], background_);
        for (int c = 0; c < 3; ++c) {
            if (std::isnan(d[c])) return std::numeric_limits<double>::infinity();
            largest = std::max(largest, std::fabs(d[c]));
        }
    }
    return largest;
}

ImageError TruePicture::compare(const Frame& frame, double budget) const {
    require_alike(frame);
    ImageError error;
    error.psnr = std::numeric_limits<double>::infinity();
    const std::size_t count = frame.color.size();
    if (count == 0) return error;

    double squares = 0;
    bool unknown = false;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 a = seen_color(frame.color[i], background_), b = seen_color(frame_.color[i], background_);
        bool over = false;
        for (int c = 0; c < 3; ++c) {
            const double difference = std::fabs(a[c] - b[c]);
            unknown = unknown || std::isnan(difference);
            over = over || !(difference <= budget);  // NaN is over every budget
            error.channel_max[c] = std::fmax(error.channel_max[c], difference);
            error.channel_mean[c] += difference / double(count);
            squares += difference * difference;
        }
        error.pixels_over_budget += over;
    }
    if (unknown) {
        error.max = error.mean = std::numeric_limits<double>::infinity();
        error.channel_max = error.channel_mean = glm::dvec3(error.max);
        error.psnr = error.ssim = 0;
        error.flip = 1;
        return error;
    }
    error.max = std::max({error.channel_max.x, error.channel_max.y, error.channel_max.z});
    error.mean = (error.channel_mean.x + error.channel_mean.y + error.channel_mean.z) / 3;
    squares /= 3 * double(count);
    if (squares > 0) error.psnr = 10 * std::log10(255.0 * 255.0 / squares);
    if (equal_bits(frame, frame_) || error.max == 0) return error;
    std::call_once(measures_->once, [&] {
        measures_->luma = LumaStatistics(frame_, background_);
        measures_->flip = FlipPicture(frame_, background_);
    });
    error.ssim = mean_ssim(LumaStatistics(frame, background_), measures_->luma, frame.size);
    error.flip = mean_flip(FlipPicture(frame, background_), measures_->flip);
    return error;
}

ImageError compare(const Frame& frame, const Frame& reference, const glm::dvec3& background, double budget) {
    return TruePicture(reference, background).compare(frame, budget);
}

}  // namespace lacuna
