#include "core/regions/bounding_sphere.h"

#include <cmath>
#include <limits>
#include <vector>

namespace lacuna {

namespace {

constexpr double k_slack = 1e-12;  ///< relative: what rounding may leave outside

/// The sphere through 1 to 4 points with its centre in their affine hull; radius NaN where they are dependent.
Sphere through(const std::vector<glm::dvec3>& p) {
    if (p.size() == 1) return {p[0], 0};
    const std::size_t n = p.size() - 1;
    double m[3][4] = {};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) m[i][j] = 2 * glm::dot(p[i + 1] - p[0], p[j + 1] - p[0]);
        m[i][3] = glm::dot(p[i + 1] - p[0], p[i + 1] - p[0]);
    }
    for (std::size_t c = 0; c < n; ++c) {  // Gauss with pivoting, a system of at most three
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < n; ++r)
            if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
        if (!(std::abs(m[pivot][c]) > 1e-300)) return {p[0], std::numeric_limits<double>::quiet_NaN()};
        std::swap(m[c], m[pivot]);
        for (std::size_t r = 0; r < n; ++r) {
            if (r == c) continue;
            const double f = m[r][c] / m[c][c];
            for (std::size_t k = c; k < 4; ++k) m[r][k] -= f * m[c][k];
        }
    }
    glm::dvec3 offset(0);
    for (std::size_t i = 0; i < n; ++i) offset += m[i][3] / m[i][i] * (p[i + 1] - p[0]);
    return {p[0] + offset, glm::length(offset)};
}

bool encloses(const Sphere& sphere, const std::vector<glm::dvec3>& points, double scale) {
    if (!std::isfinite(sphere.radius)) return false;
    for (const glm::dvec3& p : points)
        if (!(glm::length(p - sphere.centre) <= sphere.radius + k_slack * scale)) return false;
    return true;
}

/// The smallest sphere round at most five points, by trying every subset; keeps the ones it stands on.
Sphere smallest_of_few(std::vector<glm::dvec3>& points, double scale) {
    Sphere best{points.front(), std::numeric_limits<double>::infinity()};
    std::vector<glm::dvec3> supports = points;
    for (unsigned set = 1; set < 1u << points.size(); ++set) {
        std::vector<glm::dvec3> subset;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (set >> i & 1u) subset.push_back(points[i]);
        if (subset.size() > 4) continue;
        const Sphere sphere = through(subset);
        if (sphere.radius < best.radius && encloses(sphere, points, scale)) best = sphere, supports = subset;
    }
    points = std::move(supports);
    return best;
}

}  // namespace

Sphere smallest_enclosing_sphere(std::span<const glm::dvec3> points) {
    if (points.empty()) return {};
    const glm::dvec3 base = points.front();  // a small body far from the origin keeps its digits
    Sphere sphere{glm::dvec3(0), 0};
    std::vector<glm::dvec3> supports{glm::dvec3(0)};
    for (int pass = 0; pass < 1000; ++pass) {
        double farthest = -1;
        glm::dvec3 out(0);
        for (const glm::dvec3& point : points) {
            const glm::dvec3 p = point - base;
            const double d = glm::dot(p - sphere.centre, p - sphere.centre);
            if (d > farthest) farthest = d, out = p;
        }
        farthest = std::sqrt(farthest);
        if (!(farthest > sphere.radius * (1 + k_slack))) break;
        supports.push_back(out);
        const Sphere next = smallest_of_few(supports, farthest);
        if (!(next.radius > sphere.radius) || !std::isfinite(next.radius)) {  // rounding only: no progress left
            sphere.radius = farthest;
            break;
        }
        sphere = next;
    }
    sphere.centre += base;
    return sphere;
}

}  // namespace lacuna
