// Screen-space ambient occlusion from pairs of depth samples, after the paired samples of Loos & Sloan, "Volumetric
// Obscurance" (I3D 2010), and the interleaved patterns of Keller & Heidrich, "Interleaved Sampling" (2001).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/vector_clones.h"
#include "core/render/effect_passes.h"

namespace lacuna::effects {

namespace {

constexpr int k_tile = 4;  // patterns repeat every 4x4 pixels
constexpr int k_patterns = k_tile * k_tile;
constexpr int k_pairs = 8;                 // opposite samples a pixel
constexpr float k_bias = 0.02f;            // slope pairs below this are noise of the hits, not a crease
constexpr double k_gain = 2.5;             // strength 1 makes a right-angled crease about half dark
constexpr double k_default_radius = 0.04;  // of the volume's diameter
constexpr double k_largest_share = 0.25;   // of the picture's shorter side, in pixels

/// The relief with the pixels of each pattern side by side, so that one offset is one contiguous read for all pixels
/// that share a pattern. Each plane has a margin of nothing, wide enough for every offset.
class Interleaved {
public:
    Interleaved(const Relief& relief, int reach_px)
        : pad_(reach_px / k_tile + 1),
          width_((relief.size.x + k_tile - 1) / k_tile),
          stride_(width_ + 2 * pad_),
          rows_((relief.size.y + k_tile - 1) / k_tile + 2 * pad_),
          heights_(std::size_t(k_patterns) * std::size_t(rows_) * std::size_t(stride_), Relief::k_nothing) {}

    void fill_row(const Relief& relief, int y) {
        const float* from = &relief.height[std::size_t(y) * std::size_t(relief.size.x)];
        for (int phase = 0; phase < k_tile; ++phase) {
            float* to = &heights_[index(phase, y)];
            for (int x = phase, i = 0; x < relief.size.x; x += k_tile, ++i) to[i] = from[x];
        }
    }

    /// The pixel (x, y) and, behind it, those every 4 columns to its right. x and y may lie outside by the reach.
    const float* from(int x, int y) const { return &heights_[index(x, y)]; }
    int width() const { return width_; }

private:
    std::size_t index(int x, int y) const {
        const int cx = x >= 0 ? x / k_tile : -((k_tile - 1 - x) / k_tile);
        const int cy = y >= 0 ? y / k_tile : -((k_tile - 1 - y) / k_tile);
        const int plane = (y - cy * k_tile) * k_tile + (x - cx * k_tile);
        return (std::size_t(plane) * std::size_t(rows_) + std::size_t(cy + pad_)) * std::size_t(stride_) +
               std::size_t(cx + pad_);
    }

    int pad_, width_, stride_, rows_;
    std::vector<float> heights_;
};

struct Offset {
    int x = 1, y = 0;
    float per_mm = 1;  ///< 1 / its length in the plane through the centre
};

using Pattern = std::array<Offset, k_pairs>;

/// A spiral for each pixel of the tile: golden-angle turns, radii spread over the disc, both shifted by the pattern.
std::array<Pattern, k_patterns> make_patterns(double radius_px, double pixel_mm) {
    std::array<Pattern, k_patterns> patterns;
    for (int p = 0; p < k_patterns; ++p) {
        const double shift = double((p * 7) % k_patterns) / k_patterns;
        for (int i = 0; i < k_pairs; ++i) {
            // A pair covers two opposite directions: half a turn holds them all.
            const double angle = std::numbers::pi * std::fmod(i * 0.6180339887 + double(p) / k_patterns, 1.0);
            const double r = radius_px * (i + 0.25 + 0.75 * shift) / k_pairs;
            Offset& o = patterns[std::size_t(p)][std::size_t(i)];
            o.x = int(std::lround(r * std::cos(angle)));
            o.y = int(std::lround(r * std::sin(angle)));
            if (o.x == 0 && o.y == 0) (std::cos(angle) * std::cos(angle) > 0.5 ? o.x : o.y) = 1;
            o.per_mm = float(1 / (std::hypot(double(o.x), double(o.y)) * pixel_mm));
        }
    }
    return patterns;
}

/// Adds one pair's occlusion for n pixels: how much the two opposite slopes together rise above a plane (whose slopes
/// cancel), each saturating as t/(1+|t|); samples higher than the radius above the pixel fade out (range check).
LACUNA_VECTOR_CLONES void add_pair(const float* __restrict middle, const float* __restrict scale,
                                   const float* __restrict one, const float* __restrict other, int n, float per_mm,
                                   float per_radius, float* __restrict sum) {
    for (int i = 0; i < n; ++i) {
        const float a = (one[i] - middle[i]) * scale[i], b = (other[i] - middle[i]) * scale[i];
        const float slope_a = a * per_mm, slope_b = b * per_mm;
        float rise = slope_a / (1 + std::fabs(slope_a)) + slope_b / (1 + std::fabs(slope_b)) - k_bias;
        rise = rise > 0 ? rise : 0;
        float top = (a > b ? a : b) * per_radius;
        top = top > 0 ? top : 0;
        float near = 1 - top * top;
        near = near > 0 ? near : 0;
        sum[i] += rise * near;
    }
}

}  // namespace

void screen_space_occlusion(const Scene& scene, const ViewRays& rays, const Effect& effect, Frame& frame,
                            const JobContext& job) {
    const double strength = effect.value(0);
    if (strength == 0) return;
    const double asked = effect.value(1);
    const double wanted = asked > 0 ? asked : k_default_radius * scene.volume.geometry().diameter_mm();
    const double most_px = k_largest_share * std::min(frame.size.x, frame.size.y);
    const double radius_px = std::clamp(wanted / rays.pixel_mm, 1.5, std::max(1.5, most_px));
    const double radius_mm = radius_px * rays.pixel_mm;

    const Relief relief = make_relief(rays, frame, job);
    Interleaved planes(relief, int(std::ceil(radius_px)) + 1);
    for_rows(frame.size.y, job, [&](int y) { planes.fill_row(relief, y); });

    const auto patterns = make_patterns(radius_px, rays.pixel_mm);
    const auto per_radius = float(1 / radius_mm);
    std::vector<float> occlusion(frame.pixels());
    for_rows(frame.size.y, job, [&](int y) {
        const glm::ivec2 met = relief.met[std::size_t(y)];
        const std::size_t first = std::size_t(y) * std::size_t(frame.size.x);
        std::vector<float> sum(std::size_t(planes.width())), scale(sum.size());
        for (int phase = 0; phase < k_tile; ++phase) {
            const int begin = std::max(0, (met.x - phase + k_tile - 1) / k_tile);
            const int n = (met.y - phase + k_tile - 1) / k_tile - begin;
            if (n <= 0) continue;
            std::fill(sum.begin(), sum.end(), 0.0f);
            const std::size_t from = first + std::size_t(phase + begin * k_tile);
            for (int i = 0; i < n; ++i) scale[std::size_t(i)] = relief.scale[from + std::size_t(i * k_tile)];
            for (const Offset& o : patterns[std::size_t((y % k_tile) * k_tile + phase)])
                add_pair(planes.from(phase, y) + begin, scale.data(), planes.from(phase + o.x, y + o.y) + begin,
                         planes.from(phase - o.x, y - o.y) + begin, n, o.per_mm, per_radius, sum.data());
            for (int i = 0; i < n; ++i) occlusion[from + std::size_t(i * k_tile)] = sum[std::size_t(i)] / (2 * k_pairs);
        }
    });
    smooth_by_depth(relief, std::max(0.25 * radius_mm, 2 * rays.pixel_mm), occlusion, job);
    darken(occlusion, strength * k_gain, frame, job);
}

}  // namespace lacuna::effects
