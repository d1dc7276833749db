#include "core/accuracy/image_error.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace lacuna {

namespace {

constexpr int k_window_radius = 5;  // 11 x 11, Wang et al. 2004
constexpr double k_window_sigma = 1.5;

using Plane = std::vector<double>;

/// What a user sees, unrounded: 0..255 over the background. NaN stays NaN.
glm::dvec3 seen(const glm::vec4& pixel, const glm::dvec3& background) {
    glm::dvec3 color = glm::dvec3(pixel) + (1 - double(pixel.a)) * background;
    for (int c = 0; c < 3; ++c) color[c] = color[c] < 0 ? 0 : color[c] > 1 ? 255 : 255 * color[c];
    return color;
}

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
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const int at = axis == 0 ? x : y, length = size[axis];
            const std::ptrdiff_t here = std::ptrdiff_t(y) * size.x + x;
            double sum = 0, weight_sum = 0;
            for (int d = std::max(-k_window_radius, -at); d <= std::min(k_window_radius, length - 1 - at); ++d) {
                const double weight = weights[std::size_t(d + k_window_radius)];
                sum += weight * in[std::size_t(here + d * stride)];
                weight_sum += weight;
            }
            out[std::size_t(here)] = sum / weight_sum;
        }
    }
    return out;
}

Plane smooth(const Plane& in, glm::ivec2 size) { return smooth(smooth(in, size, 0), size, 1); }

Plane product(const Plane& a, const Plane& b) {
    Plane out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] * b[i];
    return out;
}

double mean_ssim(const Plane& a, const Plane& b, glm::ivec2 size) {
    constexpr double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);
    const Plane mean_a = smooth(a, size), mean_b = smooth(b, size);
    const Plane aa = smooth(product(a, a), size), bb = smooth(product(b, b), size), ab = smooth(product(a, b), size);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double ma = mean_a[i], mb = mean_b[i];
        const double var_a = aa[i] - ma * ma, var_b = bb[i] - mb * mb, cov = ab[i] - ma * mb;
        sum += (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (var_a + var_b + c2));
    }
    return sum / double(a.size());
}

}  // namespace

ImageError compare(const Frame& frame, const Frame& reference, const glm::dvec3& background, double budget) {
    if (frame.size != reference.size || frame.color.size() != reference.color.size())
        throw Error(Errc::bad_usage, "Only pictures of the same size can be compared.");
    ImageError error;
    error.psnr = std::numeric_limits<double>::infinity();
    const std::size_t count = frame.color.size();
    if (count == 0) return error;

    Plane luma_a(count), luma_b(count);
    double squares = 0;
    bool unknown = false;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 a = seen(frame.color[i], background), b = seen(reference.color[i], background);
        luma_a[i] = luma(a);
        luma_b[i] = luma(b);
        bool over = false;
        for (int c = 0; c < 3; ++c) {
            const double difference = std::fabs(a[c] - b[c]);
            unknown = unknown || std::isnan(difference);
            over = over || !(difference <= budget);  // NaN is over every budget
            error.max = std::fmax(error.max, difference);
            error.mean += difference;
            squares += difference * difference;
        }
        error.pixels_over_budget += over;
    }
    error.mean /= 3 * double(count);
    squares /= 3 * double(count);
    if (unknown) {
        error.max = error.mean = std::numeric_limits<double>::infinity();
        error.psnr = error.ssim = 0;
        return error;
    }
    if (squares > 0) error.psnr = 10 * std::log10(255.0 * 255.0 / squares);
    error.ssim = mean_ssim(luma_a, luma_b, frame.size);
    return error;
}

}  // namespace lacuna
