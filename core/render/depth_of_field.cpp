// Depth of field in two phases: the picture blurred with several radii, then blended by distance from the focal plane
// (as Lesar et al. 2015 do), with weights that keep sharp pixels out of every blur.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/render/effect_passes.h"

namespace lacuna::effects {

namespace {

constexpr int k_levels = 3;       // radii R/4, R/2, R
constexpr double k_share = 0.03;  // blur radius at strength 1, half a diameter from the focus, of the shorter side
constexpr double k_largest_share = 0.06;
constexpr float k_sharp_px = 0.1f;        // smaller circles are left alone
constexpr float k_least_opacity = 1e-3f;  // of a blurred texel: less is what running sums leave behind
constexpr int k_strip = 16;               // columns blurred together

/// The circle of confusion's radius of each pixel, in pixels, and its blur levels' weights.
struct Circles {
    std::vector<float> radius_px;
    std::vector<float> distance;  ///< from the focal plane, in half diameters, at most 1
    std::array<float, k_levels> level_px{};
};

Circles make_circles(const Scene& scene, const ViewRays& rays, const Effect& effect, const Frame& frame,
                     const JobContext& job) {
    const double half_mm = 0.5 * scene.volume.geometry().diameter_mm();
    const double focus = effect.value(0), strength = effect.value(1);
    const double centre_mm = glm::dot(scene.volume.geometry().centre_mm() - rays.eye, rays.forward);
    const double focus_mm = focus <= 1 ? centre_mm + (2 * focus - 1) * half_mm : focus;
    const double side = std::min(frame.size.x, frame.size.y);
    const double largest_px = std::min(k_largest_share, 1.5 * k_share * strength) * side;
    const double px_per_distance = k_share * strength * side;

    Circles circles{std::vector<float>(frame.pixels()), std::vector<float>(frame.pixels()), {}};
    for (int k = 0; k < k_levels; ++k) circles.level_px[std::size_t(k)] = float(largest_px / (1 << (k_levels - 1 - k)));
    for_rows(frame.size.y, job, [&](int y) {
        std::size_t i = std::size_t(y) * std::size_t(frame.size.x);
        for (int x = 0; x < frame.size.x; ++x, ++i) {
            if (!(frame.color[i].a > 0)) continue;
            const double depth = rays.perspective ? plane_depth_mm(rays, frame, x, y) : double(frame.depth_mm[i]);
            const double away = std::fabs(depth - focus_mm) / half_mm;
            if (!(away <= std::numeric_limits<float>::max())) continue;
            circles.radius_px[i] = float(std::min(away * px_per_distance, largest_px));
            circles.distance[i] = float(std::min(away, 1.0));
        }
    });
    return circles;
}

/// One blur at half resolution: premultiplied colour and opacity, both weighted; colour / opacity is the blurred
/// colour.
struct Level {
    glm::ivec2 size{0};
    std::vector<glm::vec4> texels;

    glm::vec4 at(int x, int y) const { return texels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)]; }
    /// Bilinear, for a pixel of the full picture.
    glm::vec4 sample(int x, int y) const {
        const int x0 = std::max((x - 1) >> 1, 0), y0 = std::max((y - 1) >> 1, 0);
        const int x1 = std::min((x + 1) >> 1, size.x - 1), y1 = std::min((y + 1) >> 1, size.y - 1);
        // Pixel x lies a quarter of a texel from its own texel's centre, towards the neighbour (x even: left).
        const float fx = x & 1 ? 0.25f : 0.75f, fy = y & 1 ? 0.25f : 0.75f;
        const glm::vec4 top = at(x0, y0) * (1 - fx) + at(x1, y0) * fx;
        const glm::vec4 bottom = at(x0, y1) * (1 - fx) + at(x1, y1) * fx;
        return top * (1 - fy) + bottom * fy;
    }
};

/// Running mean with the given half width (a fraction weighs the texels at both ends) over a line of n texels, `stride`
/// apart, `lanes` of them side by side. Beyond the line's ends there is nothing.
void box_line(const glm::vec4* in, glm::vec4* out, int n, std::size_t stride, int lanes,
                                   float half_width) {
    const int half = int(half_width);
    const float part = half_width - float(half), per_count = 1 / (2 * half_width + 1);
    glm::vec4 sums[k_strip] = {};
    const auto texel = [&](int i, int l) { return in[std::size_t(i) * stride + std::size_t(l)]; };
    for (int i = 0; i < std::min(half, n); ++i)
        for (int l = 0; l < lanes; ++l) sums[l] += texel(i, l);
    for (int i = 0; i < n; ++i) {
        glm::vec4* to = out + std::size_t(i) * stride;
        if (i + half < n)
            for (int l = 0; l < lanes; ++l) sums[l] += texel(i + half, l);
        for (int l = 0; l < lanes; ++l) to[l] = sums[l] * per_count;
        if (i + half + 1 < n)
            for (int l = 0; l < lanes; ++l) to[l] += texel(i + half + 1, l) * (part * per_count);
        if (i - half - 1 >= 0)
            for (int l = 0; l < lanes; ++l) to[l] += texel(i - half - 1, l) * (part * per_count);
        if (i - half >= 0)
            for (int l = 0; l < lanes; ++l) sums[l] -= texel(i - half, l);
    }
}

using Levels = std::array<Level, k_levels>;

/// Half the resolution, each level holding only pixels about as blurred as it is: a sharp pixel weighs nothing.
void gather_row(const Frame& frame, const Circles& circles, int row, Levels& levels) {
    const int w = frame.size.x, h = frame.size.y;
    std::array<float, k_levels> per_px;
    std::array<glm::vec4*, k_levels> out;
    for (std::size_t k = 0; k < k_levels; ++k) {
        per_px[k] = 1 / circles.level_px[k];
        out[k] = &levels[k].texels[std::size_t(row) * std::size_t(levels[0].size.x)];
    }
    for (int y = 2 * row; y < std::min(h, 2 * row + 2); ++y)
        for (int x = 0; x < w; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(w) + std::size_t(x);
            const float radius = circles.radius_px[i];
            if (!(radius > 0)) continue;
            const glm::vec4 c = frame.color[i];
            if (!std::isfinite(c.r + c.g + c.b + c.a)) continue;
            for (std::size_t k = 0; k < k_levels; ++k)
                out[k][x >> 1] += c * std::clamp(2 * radius * per_px[k] - 0.5f, 0.0f, 1.0f);
        }
}

/// Two boxes one after the other each way: a tent whose half width is the level's radius.
void blur(const Circles& circles, Levels& levels, const JobContext& job) {
    const glm::ivec2 size = levels[0].size;
    const auto half = [&](int k) { return circles.level_px[std::size_t(k)] / 4; };  // texels are two pixels
    parallel_for(
        0, size.y,
        [&](std::int64_t y) {
            std::vector<glm::vec4> line(static_cast<std::size_t>(size.x));
            for (int k = 0; k < k_levels; ++k) {
                glm::vec4* row = &levels[std::size_t(k)].texels[std::size_t(y) * std::size_t(size.x)];
                box_line(row, line.data(), size.x, 1, 1, half(k));
                box_line(line.data(), row, size.x, 1, 1, half(k));
            }
        },
        job);
    parallel_for(
        0, (size.x + k_strip - 1) / k_strip,
        [&](std::int64_t strip) {
            const int first = int(strip) * k_strip, lanes = std::min(k_strip, size.x - first);
            std::vector<glm::vec4> copy(std::size_t(size.y) * k_strip), blurred(copy.size());
            for (int k = 0; k < k_levels; ++k) {
                Level& level = levels[std::size_t(k)];
                for (int y = 0; y < size.y; ++y)
                    std::copy_n(&level.texels[std::size_t(y) * std::size_t(size.x) + std::size_t(first)], lanes,
                                &copy[std::size_t(y) * k_strip]);
                box_line(copy.data(), blurred.data(), size.y, k_strip, lanes, half(k));
                box_line(blurred.data(), copy.data(), size.y, k_strip, lanes, half(k));
                for (int y = 0; y < size.y; ++y)
                    std::copy_n(&copy[std::size_t(y) * k_strip], lanes,
                                &level.texels[std::size_t(y) * std::size_t(size.x) + std::size_t(first)]);
            }
        },
        job);
}

/// The colour of a pixel at one level, with the pixel's own opacity; level -1 is the picture itself.
glm::vec3 color_at(const Levels& levels, int level, int x, int y, const glm::vec4& own) {
    if (level < 0) return glm::vec3(own);
    const glm::vec4 sum = levels[std::size_t(level)].sample(x, y);
    return sum.a > k_least_opacity ? glm::vec3(sum) * (own.a / sum.a) : glm::vec3(own);
}

}  // namespace

void depth_of_field(const Scene& scene, const ViewRays& rays, const Effect& effect, Frame& frame,
                    const JobContext& job) {
    const float dimming = float(effect.value(2));
    const Circles circles = make_circles(scene, rays, effect, frame, job);
    const bool blurs = circles.level_px.back() > k_sharp_px;
    Levels levels;
    if (blurs) {
        for (Level& level : levels) {
            level.size = (frame.size + 1) / 2;
            level.texels.resize(std::size_t(level.size.x) * std::size_t(level.size.y));
        }
        for_rows(levels[0].size.y, job, [&](int y) { gather_row(frame, circles, y, levels); });
        blur(circles, levels, job);
    }
    for_rows(frame.size.y, job, [&](int y) {
        std::size_t i = std::size_t(y) * std::size_t(frame.size.x);
        for (int x = 0; x < frame.size.x; ++x, ++i) {
            glm::vec4& pixel = frame.color[i];
            const float radius = circles.radius_px[i];
            if (blurs && radius > k_sharp_px) {
                int above = 0;
                while (above < k_levels - 1 && radius > circles.level_px[std::size_t(above)]) ++above;
                const float low = above > 0 ? circles.level_px[std::size_t(above - 1)] : 0;
                const float share = std::min(1.0f, (radius - low) / (circles.level_px[std::size_t(above)] - low));
                const glm::vec3 color = color_at(levels, above - 1, x, y, pixel) * (1 - share) +
                                        color_at(levels, above, x, y, pixel) * share;
                pixel = glm::vec4(color, pixel.a);
            }
            if (dimming > 0 && circles.distance[i] > 0)
                pixel = glm::vec4(glm::vec3(pixel) * (1 - dimming * circles.distance[i]), pixel.a);
        }
    });
}

}  // namespace lacuna::effects
