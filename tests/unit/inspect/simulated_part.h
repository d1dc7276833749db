#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "core/inspect/part_analysis.h"

namespace lacuna::test {

using Solid = std::function<bool(const glm::dvec3& mm)>;  ///< true inside

inline Solid solid_ball(const glm::dvec3& centre, double radius) {
    return [=](const glm::dvec3& p) { return glm::length(p - centre) <= radius; };
}
inline Solid solid_box(const glm::dvec3& lo, const glm::dvec3& hi) {
    return
        [=](const glm::dvec3& p) { return glm::all(glm::greaterThanEqual(p, lo)) && glm::all(glm::lessThan(p, hi)); };
}
inline Solid solid_torus(const glm::dvec3& centre, double ring, double tube) {
    return [=](const glm::dvec3& at) {
        const glm::dvec3 p = at - centre;
        return std::hypot(std::hypot(p.x, p.y) - ring, p.z) <= tube;
    };
}
inline Solid solid_shell(const glm::dvec3& centre, double inner, double outer) {
    return [=](const glm::dvec3& p) {
        const double d = glm::length(p - centre);
        return d >= inner && d <= outer;
    };
}
inline Solid solid_disc(const glm::dvec3& centre, const glm::dvec3& normal, double radius, double thickness) {
    const glm::dvec3 n = glm::normalize(normal);
    return [=](const glm::dvec3& p) {
        const double height = glm::dot(p - centre, n);
        return std::abs(height) <= thickness / 2 && glm::length(p - centre - height * n) <= radius;
    };
}

/// Values of a part without defects: 20 in air, 220 in material.
inline constexpr double k_air = 20, k_material = 220;

struct PartOptions {
    glm::ivec3 size{48};
    glm::dvec3 spacing{1};
    int margin = 5;          ///< voxels of air on every side
    int samples = 4;         ///< per axis and voxel: partial volumes; 1: the voxel's centre decides, values are binary
    double blur_voxels = 0;  ///< sigma of a Gaussian, truly convolved
    double noise = 0;
    std::uint64_t seed = 1;
};

/// Convolves along one axis with a sampled Gaussian; the border repeats.
inline void blur_along(std::vector<float>& v, const glm::ivec3& n, int axis, double sigma) {
    const int reach = int(std::ceil(4 * sigma));
    std::vector<double> kernel;
    double sum = 0;
    for (int k = -reach; k <= reach; ++k)
        kernel.push_back(std::exp(-k * k / (2 * sigma * sigma))), sum += kernel.back();
    const std::int64_t step = axis == 0 ? 1 : (axis == 1 ? n.x : std::int64_t(n.x) * n.y);
    const std::vector<float> from = v;
    std::int64_t i = 0;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x, ++i) {
                const int at = axis == 0 ? x : (axis == 1 ? y : z);
                double value = 0;
                for (int k = -reach; k <= reach; ++k) {
                    const int other = std::min(std::max(at + k, 0), n[axis] - 1);
                    value += kernel[std::size_t(k + reach)] * double(from[std::size_t(i + (other - at) * step)]);
                }
                v[std::size_t(i)] = float(value / sum);
            }
}

/// A block with voids cut out of it, voxel values by partial volume, then blurred and noisy. Voxel centres at whole
/// multiples of the spacing.
inline Volume part_with(const Solid& is_void, const PartOptions& o = {}) {
    GridGeometry g;
    g.size = o.size;
    g.spacing = o.spacing;
    std::vector<float> v;
    v.reserve(std::size_t(g.voxel_count()));
    for (int z = 0; z < g.size.z; ++z)
        for (int y = 0; y < g.size.y; ++y)
            for (int x = 0; x < g.size.x; ++x) {
                const glm::ivec3 p(x, y, z);
                const bool block = glm::all(glm::greaterThanEqual(p, glm::ivec3(o.margin))) &&
                                   glm::all(glm::lessThan(p, g.size - o.margin));
                int solid = 0;
                const int n = o.samples;
                for (int k = 0; block && k < n * n * n; ++k) {
                    const glm::dvec3 sub((k % n + 0.5) / n - 0.5, (k / n % n + 0.5) / n - 0.5,
                                         (k / n / n + 0.5) / n - 0.5);
                    solid += !is_void((glm::dvec3(p) + sub) * o.spacing);
                }
                v.push_back(float(k_air + (k_material - k_air) * solid / (n * n * n)));
            }
    if (o.blur_voxels > 0)
        for (int axis = 0; axis < 3; ++axis) blur_along(v, g.size, axis, o.blur_voxels);
    std::uint64_t state = o.seed * 2654435761u + 88172645463325252ull;
    const auto uniform = [&state] {
        state ^= state << 13, state ^= state >> 7, state ^= state << 17;
        return (double(state >> 11) + 0.5) * 0x1p-53;
    };
    if (o.noise > 0)
        for (float& value : v)
            value += float(o.noise * std::sqrt(-2 * std::log(uniform())) * std::cos(2 * M_PI * uniform()));
    return make_volume<float>(g, [&](std::span<float> out) { std::copy(v.begin(), v.end(), out.begin()); });
}

inline bool holds(const Measured& m, double truth) { return m.lo <= truth && truth <= m.hi; }

}  // namespace lacuna::test
