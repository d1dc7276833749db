#include "core/render/effects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/vector_clones.h"
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
    Relief relief{frame.size, std::vector<float>(frame.pixels()), std::vector<float>(frame.pixels()),
                  std::vector<glm::ivec2>(std::size_t(frame.size.y))};
    const double d = rays.distance_mm;
    const int w = frame.size.x;
    for_rows(frame.size.y, job, [&](int y) {
        const std::size_t row = std::size_t(y) * std::size_t(w);
        float *height = &relief.height[row], *scale = &relief.scale[row];
        if (!rays.perspective) {
            const float* depth = &frame.depth_mm[row];
            for (int x = 0; x < w; ++x) {
                const bool met = std::fabs(depth[x]) <= std::numeric_limits<float>::max();
                height[x] = met ? -depth[x] : Relief::k_nothing;
                scale[x] = met ? 1.0f : 0.0f;
            }
        } else {
            for (int x = 0; x < w; ++x) {
                const double z = plane_depth_mm(rays, frame, x, y);
                const bool met = std::isfinite(z);
                // An eye inside the object would divide by 0: nearer than a thousandth of the distance is that near.
                const double near = std::max(z, 1e-3 * d);
                height[x] = met ? float(d * d / near) : Relief::k_nothing;
                scale[x] = met ? float(near / d) : 0.0f;
            }
        }
        int begin = 0, end = w;
        while (begin < end && !(scale[begin] > 0)) ++begin;
        while (begin < end && !(scale[end - 1] > 0)) --end;
        relief.met[std::size_t(y)] = {begin, end};
    });
    return relief;
}

namespace {

constexpr int k_reach = 2;
constexpr float k_tap[2 * k_reach + 1] = {0.5f, 1, 1, 1, 0.5f};  // over any 4 neighbours in a row: their mean

/// One tap of the bilateral filter for a row of n pixels.
LACUNA_VECTOR_CLONES void add_tap(const float* __restrict value, const float* __restrict height,
                                  const float* __restrict middle, const float* __restrict scale, int n, float per_reach,
                                  float weight, float* __restrict sum, float* __restrict weights) {
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
    void write(const float* __restrict scale, int n, float* __restrict out) const {
        for (int x = 0; x < n; ++x) {
            const auto i = std::size_t(x);
            const float mean = sum[i] / (weights[i] > 0 ? weights[i] : 1.0f);
            out[x] = scale[x] > 0 ? mean : 0.0f;
        }
    }
};

}  // namespace

void smooth_by_depth(const Relief& relief, double reach_mm, std::vector<float>& image, const JobContext& job) {
    const int w = relief.size.x, h = relief.size.y;
    const float per_reach = float(1 / reach_mm);
    std::vector<float> rows_done(image.size());
    for_rows(h, job, [&](int y) {
        const glm::ivec2 met = relief.met[std::size_t(y)];
        if (met.x == met.y) return;
        RowSums sums(met.y - met.x);
        const std::size_t row = std::size_t(y) * std::size_t(w);
        for (int o = -k_reach; o <= k_reach; ++o) {
            // The tap's pixels within the picture: out[begin, end) reads in[begin + o, end + o).
            const int begin = std::max(met.x, -o), end = std::min(met.y, w - o);
            if (begin >= end) continue;
            add_tap(&image[row] + begin + o, &relief.height[row] + begin + o, &relief.height[row] + begin,
                    &relief.scale[row] + begin, end - begin, per_reach, k_tap[o + k_reach],
                    sums.sum.data() + (begin - met.x), sums.weights.data() + (begin - met.x));
        }
        sums.write(&relief.scale[row] + met.x, met.y - met.x, &rows_done[row] + met.x);
    });
    for_rows(h, job, [&](int y) {
        const glm::ivec2 met = relief.met[std::size_t(y)];
        if (met.x == met.y) return;
        const int n = met.y - met.x;
        RowSums sums(n);
        const std::size_t row = std::size_t(y) * std::size_t(w) + std::size_t(met.x);
        for (int other = std::max(0, y - k_reach); other <= std::min(h - 1, y + k_reach); ++other) {
            const std::size_t from = std::size_t(other) * std::size_t(w) + std::size_t(met.x);
            add_tap(&rows_done[from], &relief.height[from], &relief.height[row], &relief.scale[row], n, per_reach,
                    k_tap[other - y + k_reach], sums.sum.data(), sums.weights.data());
        }
        sums.write(&relief.scale[row], n, &image[row]);
    });
}

void darken(const std::vector<float>& occlusion, double strength, Frame& frame, const JobContext& job) {
    for_rows(frame.size.y, job, [&](int y) {
        std::size_t i = std::size_t(y) * std::size_t(frame.size.x);
        for (int x = 0; x < frame.size.x; ++x, ++i) {
            const float light = std::max(0.0f, 1 - float(strength) * occlusion[i]);
            frame.color[i] *= glm::vec4(light, light, light, 1);  // by exactly 1 where nothing is occluded
        }
    });
}

}  // namespace effects

namespace {

/// Applies effect number `first` and those behind it.
void apply_from(std::size_t first, const Scene& scene, const ViewRays& rays, Frame& frame, const JobContext& silent,
                const FramePreview& preview) {
    for (std::size_t i = first; i < scene.effects.size(); ++i) {
        const Effect& effect = scene.effects[i];
        silent.check();
        switch (effect.kind) {
            case EffectKind::ssao:
                effects::screen_space_occlusion(scene, rays, effect, frame, silent);
                break;
            case EffectKind::ao:
                effects::ambient_occlusion(scene, rays, effect, frame, silent,
                                           preview ? FramePreview([&](Frame so_far) {
                                               apply_from(i + 1, scene, rays, so_far, silent, nullptr);
                                               preview(std::move(so_far));
                                           })
                                                   : nullptr);
                break;
            case EffectKind::dof:
                effects::depth_of_field(scene, rays, effect, frame, silent);
                break;
            default:
                effects::tone(effect, frame, silent);
        }
    }
}

}  // namespace

void apply_effects(const Scene& scene, Frame& frame, const JobContext& job, const FramePreview& preview) {
    if (scene.effects.empty()) return;
    apply_from(0, scene, resolve(scene.camera, scene.volume.geometry(), frame.size), frame, {job.stop, nullptr},
               preview);
}

}  // namespace lacuna
