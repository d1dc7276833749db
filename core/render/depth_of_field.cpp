// Depth of field in two phases: the picture blurred with several radii, then blended by distance from the focal plane
// (as Lesar et al. 2015 do), with weights that keep sharp pixels out of every blur.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/vector_clones.h"
#include "core/render/effect_passes.h"

namespace lacuna::effects {

namespace {

constexpr int k_levels = 3;       // radii R/4, R/2, R
constexpr double k_share = 0.03;  // blur radius at strength 1, half a diameter from the focus, of the shorter side
constexpr double k_largest_share = 0.06;
constexpr float k_sharp_px = 0.1f;        // smaller circles are left alone
constexpr float k_least_opacity = 1e-3f;  // of a blurred texel: less is what running sums leave behind
constexpr int k_strip = 8;                // lines blurred together: their running sums need not wait for each other

/// The circle of confusion's radius of each pixel, in pixels, and its blur levels' weights.
struct Circles {
    std::vector<float> radius_px;
    std::vector<float> distance;  ///< from the focal plane, in half diameters, at most 1
    std::array<float, k_levels> level_px{};
    std::size_t used = 0;  ///< levels that some pixel needs: 0 if all are sharp
};

/// From depth to circle, for the focal plane and the scale in hand.
struct Lens {
    float focus_mm, per_half_mm, px_per_distance, largest_px;

    /// A row of n pixels, those seen through or without a depth left at 0. @return the largest radius
    LACUNA_VECTOR_CLONES static float circles(Lens lens, const float* __restrict depth_mm,
                                              const float* __restrict color, int n, float* __restrict radius_px,
                                              float* __restrict distance) {
        float largest = 0;
        for (int x = 0; x < n; ++x) {
            const float away = std::fabs(depth_mm[x] - lens.focus_mm) * lens.per_half_mm;
            const bool met = (away <= std::numeric_limits<float>::max()) & (color[4 * x + 3] > 0);
            const float radius = away * lens.px_per_distance;
            const float bounded = radius < lens.largest_px ? radius : lens.largest_px;
            radius_px[x] = met ? bounded : 0.0f;
            distance[x] = met ? (away < 1 ? away : 1.0f) : 0.0f;
            largest = radius_px[x] > largest ? radius_px[x] : largest;
        }
        return largest;
    }
};

Circles make_circles(const Scene& scene, const ViewRays& rays, const Effect& effect, const Frame& frame,
                     const JobContext& job) {
    const double half_mm = 0.5 * scene.volume.geometry().diameter_mm();
    const double focus = effect.value(0), strength = effect.value(1);
    const double centre_mm = glm::dot(scene.volume.geometry().centre_mm() - rays.eye, rays.forward);
    const double focus_mm = focus <= 1 ? centre_mm + (2 * focus - 1) * half_mm : focus;
    const double side = std::min(frame.size.x, frame.size.y);
    const double largest_px = std::min(k_largest_share, 1.5 * k_share * strength) * side;
    const Lens lens{float(focus_mm), float(1 / half_mm), float(k_share * strength * side), float(largest_px)};

    Circles circles{std::vector<float>(frame.pixels()), std::vector<float>(frame.pixels()), {}};
    for (int k = 0; k < k_levels; ++k) circles.level_px[std::size_t(k)] = float(largest_px / (1 << (k_levels - 1 - k)));
    std::vector<float> largest(std::size_t(frame.size.y));
    for_rows(frame.size.y, job, [&](int y) {
        const std::size_t row = std::size_t(y) * std::size_t(frame.size.x);
        const float* depth = &frame.depth_mm[row];
        std::vector<float> plane;
        if (rays.perspective) {
            plane.resize(std::size_t(frame.size.x));
            for (int x = 0; x < frame.size.x; ++x) plane[std::size_t(x)] = float(plane_depth_mm(rays, frame, x, y));
            depth = plane.data();
        }
        largest[std::size_t(y)] = Lens::circles(lens, depth, &frame.color[row].x, frame.size.x, &circles.radius_px[row],
                                                &circles.distance[row]);
    });
    const float most = *std::max_element(largest.begin(), largest.end());
    if (most > k_sharp_px) {
        circles.used = 1;
        while (circles.used < k_levels && most > circles.level_px[circles.used - 1]) ++circles.used;
    }
    return circles;
}

/// One blur at half resolution: premultiplied colour and opacity, both weighted; colour / opacity is the blurred
/// colour. Rows are a few texels apart, so that those of pictures whose width is a power of two keep out of each
/// other's places in the cache.
struct Level {
    glm::ivec2 size{0};
    std::size_t stride = 0;  ///< texels from row to row
    std::vector<glm::vec4> texels;

    explicit Level(glm::ivec2 picture = glm::ivec2(0))
        : size((picture + 1) / 2), stride(std::size_t(size.x) + 8), texels(stride * std::size_t(size.y)) {}
    glm::vec4* row(int y) { return &texels[std::size_t(y) * stride]; }
    const glm::vec4* row(int y) const { return &texels[std::size_t(y) * stride]; }
};

/// A running mean's half width: a fraction weighs the texels at both ends.
struct BoxWidth {
    int half;
    float per_count, ends;
    explicit BoxWidth(float half_width)
        : half(int(half_width)), per_count(1 / (2 * half_width + 1)), ends((half_width - float(half)) * per_count) {}
};

/// Running means along k_strip lines of n texels, side by side as floats. Beyond their ends there is nothing.
LACUNA_VECTOR_CLONES void box_lines(const float* __restrict in, float* __restrict out, int n, BoxWidth box) {
    constexpr int k_floats = 4 * k_strip;
    float sums[k_floats] = {};
    const auto texels = [&](int i) { return in + std::ptrdiff_t(i) * k_floats; };
    for (int i = 0; i < std::min(box.half, n); ++i) {
        const float* first = texels(i);
        for (int f = 0; f < k_floats; ++f) sums[f] += first[f];
    }
    for (int i = 0; i < n; ++i) {
        float* to = out + std::ptrdiff_t(i) * k_floats;
        if (i + box.half < n) {
            const float* entering = texels(i + box.half);
            for (int f = 0; f < k_floats; ++f) sums[f] += entering[f];
        }
        for (int f = 0; f < k_floats; ++f) to[f] = sums[f] * box.per_count;
        if (i + box.half + 1 < n) {
            const float* after = texels(i + box.half + 1);
            for (int f = 0; f < k_floats; ++f) to[f] += after[f] * box.ends;
        }
        if (i - box.half - 1 >= 0) {
            const float* before = texels(i - box.half - 1);
            for (int f = 0; f < k_floats; ++f) to[f] += before[f] * box.ends;
        }
        if (i - box.half >= 0) {
            const float* leaving = texels(i - box.half);
            for (int f = 0; f < k_floats; ++f) sums[f] -= leaving[f];
        }
    }
}

using Levels = std::array<Level, k_levels>;

/// k_strip lines of n texels side by side, as box_lines takes them.
struct Strip {
    int n;
    std::vector<glm::vec4> texels, between;
    explicit Strip(int length) : n(length), texels(std::size_t(n) * k_strip), between(texels.size()) {}

    glm::vec4& at(int i, int line) { return texels[std::size_t(i) * k_strip + std::size_t(line)]; }
    /// Two boxes one after the other: a tent of this half width in texels.
    void blur(float half_width) {
        box_lines(&texels[0].x, &between[0].x, n, BoxWidth(half_width / 2));
        box_lines(&between[0].x, &texels[0].x, n, BoxWidth(half_width / 2));
    }
};

/// What a pixel weighs in a level: nothing below a quarter of its radius, all from three quarters on.
LACUNA_VECTOR_CLONES void weigh(const float* __restrict radius_px, int n, float per_px, float* __restrict weight) {
    for (int x = 0; x < n; ++x) {
        const float w = 2 * radius_px[x] * per_px - 0.5f;
        weight[x] = w > 0 ? (w < 1 ? w : 1.0f) : 0.0f;
    }
}

/// Adds one row of the picture, at half the resolution, to line `line` of each level's strip: each level holds only
/// pixels about as blurred as it is, a sharp pixel weighs nothing.
void gather_row(const Frame& frame, const Circles& circles, int y, int line, std::vector<Strip>& strips,
                std::vector<float>& weights) {
    const int w = frame.size.x;
    const std::size_t row = std::size_t(y) * std::size_t(w);
    for (std::size_t k = 0; k < strips.size(); ++k)
        weigh(&circles.radius_px[row], w, 1 / circles.level_px[k], &weights[k * std::size_t(w)]);
    for (int x = 0; x < w; ++x) {
        const std::size_t i = row + std::size_t(x);
        const glm::vec4 c = frame.color[i];
        if (!(circles.radius_px[i] > 0) || !std::isfinite(c.r + c.g + c.b + c.a)) continue;
        for (std::size_t k = 0; k < strips.size(); ++k)
            strips[k].at(x >> 1, line) += c * weights[k * std::size_t(w) + std::size_t(x)];
    }
}

/// The levels that are used, blurred: gathered and blurred along rows, then along columns.
Levels make_levels(const Frame& frame, const Circles& circles, const JobContext& job) {
    Levels levels;
    for (std::size_t k = 0; k < circles.used; ++k) levels[k] = Level(frame.size);
    const glm::ivec2 size = levels[0].size;
    const auto half_width = [&](std::size_t k) { return circles.level_px[k] / 2; };  // texels are two pixels
    const auto strips_of = [](int lines) { return (lines + k_strip - 1) / k_strip; };
    parallel_for(
        0, strips_of(size.y),
        [&](std::int64_t index) {
            const int first = int(index) * k_strip, lines = std::min(k_strip, size.y - first);
            std::vector<Strip> strips(circles.used, Strip(size.x));
            std::vector<float> weights(circles.used * std::size_t(frame.size.x));
            for (int y = 2 * first; y < std::min(frame.size.y, 2 * (first + lines)); ++y)
                gather_row(frame, circles, y, y / 2 - first, strips, weights);
            for (std::size_t k = 0; k < circles.used; ++k) {
                strips[k].blur(half_width(k));
                for (int line = 0; line < lines; ++line)
                    for (int x = 0; x < size.x; ++x) levels[k].row(first + line)[x] = strips[k].at(x, line);
            }
        },
        job);
    parallel_for(
        0, strips_of(size.x),
        [&](std::int64_t index) {
            const int first = int(index) * k_strip, lines = std::min(k_strip, size.x - first);
            Strip strip(size.y);
            for (std::size_t k = 0; k < circles.used; ++k) {
                for (int y = 0; y < size.y; ++y) std::copy_n(levels[k].row(y) + first, lines, &strip.at(y, 0));
                strip.blur(half_width(k));
                for (int y = 0; y < size.y; ++y) std::copy_n(&strip.at(y, 0), lines, levels[k].row(y) + first);
            }
        },
        job);
    return levels;
}

LACUNA_VECTOR_CLONES void mix_rows(const float* __restrict a, const float* __restrict b, float of_b, int n,
                                   float* __restrict out) {
    for (int i = 0; i < n; ++i) out[i] = a[i] * (1 - of_b) + b[i] * of_b;
}

/// out[2t] = 1/4 in[t-1] + 3/4 in[t], out[2t+1] = 3/4 in[t] + 1/4 in[t+1] of vectors of four.
LACUNA_VECTOR_CLONES void widen(const float* __restrict in, int texels, float* __restrict out) {
    for (int t = 0; t < texels; ++t)
        for (int c = 0; c < 4; ++c) {
            const float own = 0.75f * in[4 * t + c];
            out[8 * t + c] = own + 0.25f * in[4 * t + c - 4];
            out[8 * t + 4 + c] = own + 0.25f * in[4 * t + c + 4];
        }
}

/// One row of the picture, of every level: bilinear between its texels.
class LevelRow {
public:
    LevelRow(const Levels& levels, std::size_t used)
        : levels_(levels), used_(used), between_(std::size_t(levels[0].size.x) + 2) {
        for (auto& row : rows_) row.resize(2 * std::size_t(levels[0].size.x));
    }
    void set(int y) {
        const glm::ivec2 size = levels_[0].size;
        // Pixel y lies a quarter of a texel from its own texel's centre, towards the neighbour (y even: above).
        const int above = std::max((y - 1) >> 1, 0), below = std::min((y + 1) >> 1, size.y - 1);
        for (std::size_t k = 0; k < used_; ++k) {
            mix_rows(&levels_[k].row(above)->x, &levels_[k].row(below)->x, y & 1 ? 0.25f : 0.75f, 4 * size.x,
                     &between_[1].x);
            between_.front() = between_[1];
            between_.back() = between_[between_.size() - 2];
            widen(&between_[1].x, size.x, &rows_[k][0].x);
        }
    }
    /// The colour of pixel x at a level, with the pixel's own opacity; level -1 is the picture itself.
    glm::vec3 color_at(int level, int x, const glm::vec4& own) const {
        if (level < 0) return glm::vec3(own);
        const glm::vec4& sum = rows_[std::size_t(level)][std::size_t(x)];
        return sum.a > k_least_opacity ? glm::vec3(sum) * (own.a / sum.a) : glm::vec3(own);
    }

private:
    const Levels& levels_;
    std::size_t used_;
    std::vector<glm::vec4> between_;  ///< texels between two rows, one more at each end
    std::array<std::vector<glm::vec4>, k_levels> rows_;
};

/// The blend of two levels for a pixel whose circle is blurred.
glm::vec4 blended(const Circles& circles, const LevelRow& blurred, float radius, int x, const glm::vec4& pixel) {
    const int above = (radius > circles.level_px[0]) + (radius > circles.level_px[1]);
    const float low = above > 0 ? circles.level_px[std::size_t(above - 1)] : 0;
    const float share = std::min(1.0f, (radius - low) / (circles.level_px[std::size_t(above)] - low));
    return {blurred.color_at(above - 1, x, pixel) * (1 - share) + blurred.color_at(above, x, pixel) * share, pixel.a};
}

}  // namespace

void depth_of_field(const Scene& scene, const ViewRays& rays, const Effect& effect, Frame& frame,
                    const JobContext& job) {
    const float dimming = float(effect.value(2));
    const Circles circles = make_circles(scene, rays, effect, frame, job);
    const bool blurs = circles.used > 0;
    const Levels levels = blurs ? make_levels(frame, circles, job) : Levels();
    parallel_bands(
        0, frame.size.y, 4 * thread_count(),
        [&](std::int64_t first, std::int64_t last) {
            LevelRow blurred(levels, circles.used);
            for (int y = int(first); y < int(last); ++y) {
                job.check();
                if (blurs) blurred.set(y);
                std::size_t i = std::size_t(y) * std::size_t(frame.size.x);
                for (int x = 0; x < frame.size.x; ++x, ++i) {
                    glm::vec4& pixel = frame.color[i];
                    const float radius = circles.radius_px[i];
                    if (blurs && radius > k_sharp_px) pixel = blended(circles, blurred, radius, x, pixel);
                    if (dimming > 0 && circles.distance[i] > 0)
                        pixel = glm::vec4(glm::vec3(pixel) * (1 - dimming * circles.distance[i]), pixel.a);
                }
            }
        },
        job);
}

}  // namespace lacuna::effects
