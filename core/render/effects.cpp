#include "core/render/effects.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/render/effect_passes.h"

namespace lacuna {

namespace effects {

double plane_depth_mm(const ViewRays& rays, const Frame& frame, int x, int y) {
    const double depth = double(frame.depth_mm[std::size_t(y) * std::size_t(frame.size.x) + std::size_t(x)]);
    if (!std::isfinite(depth)) return std::numeric_limits<double>::infinity();
    if (!rays.perspective) return depth;
    const double dx = (x + 0.5 - 0.5 * rays.size.x) * rays.pixel_mm, dy = (0.5 * rays.size.y - y - 0.5) * rays.pixel_mm;
    const double d = rays.distance_mm;
    return depth * d / std::sqrt(d * d + dx * dx + dy * dy);
}

Relief make_relief(const ViewRays& rays, const Frame& frame, const JobContext& job) {
    Relief relief{frame.size, std::vector<float>(frame.pixels()), std::vector<float>(frame.pixels())};
    const double d = rays.distance_mm;
    parallel_for(
        0, frame.size.y,
        [&](std::int64_t y) {
            std::size_t i = std::size_t(y) * std::size_t(frame.size.x);
            for (int x = 0; x < frame.size.x; ++x, ++i) {
                const double z = plane_depth_mm(rays, frame, x, int(y));
                const bool met = std::isfinite(z);
                // An eye inside the object would divide by 0: nearer than a thousandth of the distance is that near.
                const double near = rays.perspective ? std::max(z, 1e-3 * d) : z;
                relief.height[i] = met ? float(rays.perspective ? d * d / near : -near) : Relief::k_nothing;
                relief.scale[i] = met ? float(rays.perspective ? near / d : 1) : 0.0f;
            }
        },
        job);
    return relief;
}

namespace {

constexpr int k_reach = 2;
constexpr float k_tap[2 * k_reach + 1] = {0.5f, 1, 1, 1, 0.5f};  // over any 4 neighbours in a row: their mean

/// One tap of the bilateral filter for a row of n pixels.
void add_tap(const float* __restrict value, const float* __restrict height, const float* __restrict middle,
             const float* __restrict scale, int n, float per_reach, float weight, float* __restrict sum,
             float* __restrict weights) {
    for (int x = 0; x < n; ++x) {
        const float u = (height[x] - middle[x]) * scale[x] * per_reach;
        float w = 1 - u * u;
        w = w > 0 ? w * weight : 0;
        sum[x] += w * value[x];
        weights[x] += w;
    }
}

struct RowSums {
    std::vector<float> sum, weights;
    explicit RowSums(int n) : sum(std::size_t(n)), weights(std::size_t(n)) {}
    void clear() {
        std::fill(sum.begin(), sum.end(), 0.0f);
        std::fill(weights.begin(), weights.end(), 0.0f);
    }
    void write(float* out) const {
        for (std::size_t x = 0; x < sum.size(); ++x) out[x] = sum[x] / (weights[x] > 0 ? weights[x] : 1.0f);
    }
};

/// Where a tap at offset o along a line of n finds its pixels: out[begin, end) reads in[begin + o, end + o).
struct Overlap {
    int begin, end;
    Overlap(int o, int n) : begin(std::max(0, -o)), end(std::min(n, n - o)) {}
};

}  // namespace

void smooth_by_depth(const Relief& relief, double reach_mm, std::vector<float>& image, const JobContext& job) {
    const int w = relief.size.x, h = relief.size.y;
    const float per_reach = float(1 / reach_mm);
    std::vector<float> rows_done(image.size());
    parallel_for(
        0, h,
        [&](std::int64_t y) {
            RowSums sums(w);
            sums.clear();
            const std::size_t row = std::size_t(y) * std::size_t(w);
            for (int o = -k_reach; o <= k_reach; ++o) {
                const Overlap at(o, w);
                if (at.begin >= at.end) continue;
                add_tap(&image[row] + at.begin + o, &relief.height[row] + at.begin + o, &relief.height[row] + at.begin,
                        &relief.scale[row] + at.begin, at.end - at.begin, per_reach, k_tap[o + k_reach],
                        sums.sum.data() + at.begin, sums.weights.data() + at.begin);
            }
            sums.write(&rows_done[row]);
        },
        job);
    parallel_for(
        0, h,
        [&](std::int64_t y) {
            RowSums sums(w);
            sums.clear();
            const std::size_t row = std::size_t(y) * std::size_t(w);
            for (std::int64_t other = std::max<std::int64_t>(0, y - k_reach);
                 other <= std::min<std::int64_t>(h - 1, y + k_reach); ++other) {
                const std::size_t from = std::size_t(other) * std::size_t(w);
                add_tap(&rows_done[from], &relief.height[from], &relief.height[row], &relief.scale[row], w, per_reach,
                        k_tap[other - y + k_reach], sums.sum.data(), sums.weights.data());
            }
            sums.write(&image[row]);
        },
        job);
}

void darken(const std::vector<float>& occlusion, double strength, Frame& frame, const JobContext& job) {
    parallel_for(
        0, frame.size.y,
        [&](std::int64_t y) {
            std::size_t i = std::size_t(y) * std::size_t(frame.size.x);
            for (int x = 0; x < frame.size.x; ++x, ++i) {
                const float light = std::max(0.0f, 1 - float(strength) * occlusion[i]);
                glm::vec4& pixel = frame.color[i];
                pixel = glm::vec4(pixel.r * light, pixel.g * light, pixel.b * light, pixel.a);
            }
        },
        job);
}

}  // namespace effects

void apply_effects(const Scene& scene, Frame& frame, const JobContext& job) {
    if (scene.effects.empty()) return;
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), frame.size);
    const JobContext silent{job.stop, nullptr};
    for (const Effect& effect : scene.effects) {
        silent.check();
        switch (effect.kind) {
            case EffectKind::ssao:
                effects::screen_space_occlusion(scene, rays, effect, frame, silent);
                break;
            case EffectKind::ao:
                effects::ambient_occlusion(scene, rays, effect, frame, silent);
                break;
            case EffectKind::dof:
                effects::depth_of_field(scene, rays, effect, frame, silent);
                break;
            default:
                effects::tone(effect, frame, silent);
        }
    }
}

}  // namespace lacuna
