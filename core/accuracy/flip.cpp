#include "core/accuracy/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {

// The paper's constants: section 4.1 (contrast sensitivity), 4.2 (colour metric), 4.3 (feature detection).
constexpr double k_luminance_b = 0.0047, k_red_green_b = 0.0053;
constexpr double k_blue_yellow_a[2] = {34.1, 13.5}, k_blue_yellow_b[2] = {0.04, 0.025};
constexpr double k_color_exponent = 0.7, k_feature_exponent = 0.5;
constexpr double k_compress_at = 0.4, k_compress_to = 0.95;
constexpr double k_feature_width_deg = 0.082;

using Plane = std::vector<float>;
using Kernel = std::vector<float>;  // 2 * radius + 1 taps

double linear_of(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

/// sRGB primaries to XYZ and back, D65; the white's own XYZ is the sum of the columns.
const glm::dmat3& to_xyz() {
    static const glm::dmat3 matrix = glm::transpose(glm::dmat3(
        10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794, 2613072.0 / 12288897, 8788810.0 / 12288897,
        887015.0 / 12288897, 1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382));
    return matrix;
}
const glm::dvec3& white() {
    static const glm::dvec3 xyz = to_xyz() * glm::dvec3(1);
    return xyz;
}

/// Linear RGB to the opponent space YCxCz, in which the contrast sensitivity is given.
glm::dvec3 opponent_of(const glm::dvec3& linear) {
    const glm::dvec3 n = to_xyz() * linear / white();
    return {116 * n.y - 16, 500 * (n.x - n.y), 200 * (n.y - n.z)};
}

glm::dvec3 linear_of_opponent(const glm::dvec3& c) {
    static const glm::dmat3 from_xyz = glm::inverse(to_xyz());
    const double y = (c.x + 16) / 116;
    return from_xyz * (glm::dvec3(y + c.y / 500, y, y - c.z / 200) * white());
}

/// L*a*b* of a linear RGB colour, its a* and b* scaled with the lightness (Hunt effect).
glm::dvec3 hunt_lab_of(const glm::dvec3& linear) {
    const glm::dvec3 n = to_xyz() * linear / white();
    const auto f = [](double t) {
        constexpr double k_delta = 6.0 / 29;
        return t > k_delta * k_delta * k_delta ? std::cbrt(t) : t / (3 * k_delta * k_delta) + 4.0 / 29;
    };
    const double l = 116 * f(n.y) - 16, a = 500 * (f(n.x) - f(n.y)), b = 200 * (f(n.y) - f(n.z));
    return {l, 0.01 * l * a, 0.01 * l * b};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b) {
    return std::fabs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

/// The largest distance of two colours a screen can show: green and blue.
double largest_distance() {
    static const double value = std::pow(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), k_color_exponent);
    return value;
}

/// One pass along x or y; beyond the border the border's pixels go on.
Plane filter(const Plane& in, glm::ivec2 size, int axis, const Kernel& kernel) {
    const int radius = int(kernel.size() / 2);
    Plane out(in.size());
    parallel_bands(0, size.y, 4 * thread_count(), [&](std::int64_t first, std::int64_t last) {
        std::vector<float> row(std::size_t(size.x + 2 * radius));
        for (std::int64_t y = first; y < last; ++y) {
            float* target = &out[std::size_t(y * size.x)];
            if (axis == 0) {
                const float* source = &in[std::size_t(y * size.x)];
                for (int x = 0; x < int(row.size()); ++x)
                    row[std::size_t(x)] = source[std::clamp(x - radius, 0, size.x - 1)];
            }
            for (int d = 0; d < int(kernel.size()); ++d) {
                const std::int64_t from = std::clamp<std::int64_t>(y + d - radius, 0, size.y - 1);
                const float* source = axis == 0 ? &row[std::size_t(d)] : &in[std::size_t(from * size.x)];
                const float weight = kernel[std::size_t(d)];
                for (int x = 0; x < size.x; ++x) target[x] += weight * source[x];
            }
        }
    });
    return out;
}

Plane filter(const Plane& in, glm::ivec2 size, const Kernel& along_x, const Kernel& along_y) {
    return filter(filter(in, size, 0, along_x), size, 1, along_y);
}

Kernel gaussian(int radius, double b, double pixels_per_degree) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixels_per_degree;
        kernel.push_back(float(std::exp(-std::numbers::pi * std::numbers::pi * x * x / b)));
    }
    return kernel;
}

double sum_of(const Kernel& kernel) {
    double sum = 0;
    for (const float w : kernel) sum += w;
    return sum;
}

Kernel scaled(Kernel kernel, double by) {
    for (float& w : kernel) w = float(w * by);
    return kernel;
}

/// Positive weights sum to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
    double positive = 0, negative = 0;
    for (const float w : kernel) (w > 0 ? positive : negative) += w;
    for (float& w : kernel) w = float(w > 0 ? w / positive : w / -negative);
    return kernel;
}

/// The three opponent planes as contrast sensitivity leaves them.
void blur_as_seen(std::vector<Plane>& planes, glm::ivec2 size, double pixels_per_degree) {
    constexpr double k_pi = std::numbers::pi;
    const int radius = int(std::ceil(3 * std::sqrt(k_blue_yellow_b[0] / (2 * k_pi * k_pi)) * pixels_per_degree));
    const auto one = [&](double b) {
        const Kernel kernel = gaussian(radius, b, pixels_per_degree);
        return scaled(kernel, 1 / sum_of(kernel));
    };
    const Kernel luminance = one(k_luminance_b), red_green = one(k_red_green_b);
    planes[0] = filter(planes[0], size, luminance, luminance);
    planes[1] = filter(planes[1], size, red_green, red_green);
    Plane sum(planes[2].size());
    double weight_sum = 0;
    for (int i = 0; i < 2; ++i) {
        const Kernel kernel = gaussian(radius, k_blue_yellow_b[i], pixels_per_degree);
        const double weight = k_blue_yellow_a[i] * std::sqrt(k_pi / k_blue_yellow_b[i]);
        const Plane part = filter(planes[2], size, kernel, kernel);
        for (std::size_t p = 0; p < part.size(); ++p) sum[p] += float(weight) * part[p];
        weight_sum += weight * sum_of(kernel) * sum_of(kernel);
    }
    for (float& value : sum) value = float(value / weight_sum);
    planes[2] = std::move(sum);
}

Plane length_of(const Plane& x, const Plane& y) {
    Plane out(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) out[i] = std::hypot(x[i], y[i]);
    return out;
}

}  // namespace

FlipPicture::FlipPicture(const Frame& frame, const glm::dvec3& background, double pixels_per_degree)
    : size_(frame.size), color_(frame.pixels()) {
    if (!(pixels_per_degree > 0)) throw Error(Errc::bad_usage, "FLIP needs more than 0 pixels a degree.");
    const std::size_t count = frame.pixels();
    if (count == 0) return;
    std::vector<Plane> planes(3, Plane(count));
    Plane luminance(count);
    parallel_for(0, size_.y, [&](std::int64_t y) {
        for (std::size_t i = std::size_t(y * size_.x), end = i + std::size_t(size_.x); i < end; ++i) {
            const glm::vec4& pixel = frame.color[i];
            glm::dvec3 c = glm::dvec3(pixel) + (1 - double(pixel.a)) * background;
            for (int k = 0; k < 3; ++k) c[k] = linear_of(c[k] < 0 ? 0 : c[k] > 1 ? 1 : c[k]);
            const glm::dvec3 opponent = opponent_of(c);
            for (int k = 0; k < 3; ++k) planes[std::size_t(k)][i] = float(opponent[k]);
            luminance[i] = float((opponent.x + 16) / 116);
        }
    });
    blur_as_seen(planes, size_, pixels_per_degree);
    parallel_for(0, size_.y, [&](std::int64_t y) {
        for (std::size_t i = std::size_t(y * size_.x), end = i + std::size_t(size_.x); i < end; ++i) {
            const glm::dvec3 linear = linear_of_opponent({planes[0][i], planes[1][i], planes[2][i]});
            color_[i] = glm::vec3(hunt_lab_of(glm::clamp(linear, 0.0, 1.0)));
        }
    });

    const double deviation = 0.5 * k_feature_width_deg * pixels_per_degree;
    const int radius = int(std::ceil(3 * deviation));
    Kernel smooth, edge, point;
    for (int x = -radius; x <= radius; ++x) {
        const double g = std::exp(-0.5 * x * x / (deviation * deviation));
        smooth.push_back(float(g));
        edge.push_back(float(-x * g));
        point.push_back(float((x * x / (deviation * deviation) - 1) * g));
    }
    smooth = scaled(smooth, 1 / sum_of(smooth));
    edge = balanced(edge);
    point = balanced(point);
    edge_ = length_of(filter(luminance, size_, edge, smooth), filter(luminance, size_, smooth, edge));
    point_ = length_of(filter(luminance, size_, point, smooth), filter(luminance, size_, smooth, point));
}

std::vector<float> flip_map(const FlipPicture& a, const FlipPicture& b) {
    if (a.size_ != b.size_) throw Error(Errc::bad_usage, "Only pictures of the same size can be compared.");
    std::vector<float> map(a.color_.size());
    const double most = largest_distance(), knee = k_compress_at * most;
    parallel_for(0, a.size_.y, [&](std::int64_t y) {
        for (std::size_t i = std::size_t(y * a.size_.x), end = i + std::size_t(a.size_.x); i < end; ++i) {
            const double distance = std::pow(hyab(a.color_[i], b.color_[i]), k_color_exponent);
            const double color = distance < knee
                                     ? distance * k_compress_to / knee
                                     : k_compress_to + (distance - knee) / (most - knee) * (1 - k_compress_to);
            const float feature = std::max(std::fabs(a.edge_[i] - b.edge_[i]), std::fabs(a.point_[i] - b.point_[i]));
            const double weight = std::pow(feature * std::numbers::sqrt2 / 2, k_feature_exponent);
            map[i] = float(std::pow(color, 1 - std::fmin(weight, 1)));
        }
    });
    return map;
}

double mean_flip(const FlipPicture& a, const FlipPicture& b) {
    const std::vector<float> map = flip_map(a, b);
    if (map.empty()) return 0;
    double sum = 0;
    for (const float f : map) sum += f;
    const double mean = sum / double(map.size());
    return mean <= 1 ? mean : 1;  // NaN is the worst
}

}  // namespace lacuna
