#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/classify/classification.h"
#include "core/render/reference_ray.h"
#include "core/render/reference_sampler.h"

namespace lacuna::reference {

/// The values at which iso_measure can change its sign, ascending.
inline std::vector<double> turning_values(const Classification& classification, double iso) {
    std::vector<double> levels;
    if (classification.ranges.empty()) levels = {iso};
    for (const SegmentationRange& r : classification.ranges) {
        levels.push_back(std::max(iso, r.range.lo));
        levels.push_back(r.range.hi);
    }
    std::erase_if(levels, [](double v) { return !std::isfinite(v); });
    std::sort(levels.begin(), levels.end());
    return levels;
}

/// Calls visit(t0, t1) for the stretches of the kept ray between planes through voxel centres, in order, until it
/// returns false.
template <class Visit>
void for_each_cell(const LatticeRay& ray, Visit&& visit) {
    std::vector<double> cuts{ray.from, ray.to};
    const glm::dvec3 a = ray.at(ray.from), b = ray.at(ray.to);
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.per_mm_vox[axis] == 0) continue;
        const double lo = std::ceil(std::min(a[axis], b[axis])), hi = std::floor(std::max(a[axis], b[axis]));
        for (double plane = lo; plane <= hi; ++plane) {
            const double t = (plane - ray.origin_vox[axis]) / ray.per_mm_vox[axis];
            if (t > ray.from && t < ray.to) cuts.push_back(t);
        }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i)
        if (cuts[i] > cuts[i - 1] && !visit(cuts[i - 1], cuts[i])) return;
}

/// The trilinear signal along a ray inside one cell: a cubic in s = (t - t0)/(t1 - t0), through four of its values.
class CellCubic {
public:
    template <class T>
    CellCubic(const Field<T>& field, const LatticeRay& ray, double t0, double t1) : t0_(t0), t1_(t1) {
        // Away from the ends, where rounding could read another cell's voxels. Newton's divided differences.
        for (int i = 0; i < 4; ++i) newton_[std::size_t(i)] = field.linear(ray.at(t0 + (t1 - t0) * node(i)));
        for (int order = 1; order < 4; ++order)
            for (int i = 3; i >= order; --i)
                newton_[std::size_t(i)] = (newton_[std::size_t(i)] - newton_[std::size_t(i - 1)]) / (order * 0.25);
    }

    bool is_nan() const { return std::isnan(newton_[3]); }

    double at(double s) const {
        double value = newton_[3];
        for (int i = 2; i >= 0; --i) value = value * (s - node(i)) + newton_[std::size_t(i)];
        return value;
    }

    /// The first t at which the signal changes between inside and outside, if it does.
    template <class Inside>
    std::optional<double> first_turn(const std::vector<double>& levels, bool in_object, Inside&& inside) const {
        std::vector<double> roots{0, 1};
        for (const double level : levels) add_roots(level, roots);
        std::sort(roots.begin(), roots.end());
        for (std::size_t i = 1; i < roots.size(); ++i) {
            if (roots[i] - roots[i - 1] < 1e-13) continue;
            if (inside(at(0.5 * (roots[i - 1] + roots[i]))) != in_object) return t0_ + (t1_ - t0_) * roots[i - 1];
        }
        return std::nullopt;
    }

private:
    static double node(int i) { return 0.125 + 0.25 * i; }

    void add_roots(double level, std::vector<double>& roots) const {
        // Between its extrema a cubic is monotone: a parabola through three slopes gives them.
        const auto slope = [&](double s) { return (at(s + 0.25) - at(s - 0.25)) / 0.5; };
        // For a cubic, central differences err by a constant: the third divided difference times h^2.
        const double bias = newton_[3] * 0.0625;
        const double d0 = slope(0) - bias, dh = slope(0.5) - bias, d1 = slope(1) - bias;
        const double a = 2 * (d0 - 2 * dh + d1), b = -3 * d0 + 4 * dh - d1, c = d0;
        std::vector<double> ends{0, 1};
        const double discriminant = b * b - 4 * a * c;
        if (discriminant > 0)
            for (const double sign : {-1.0, 1.0}) {
                const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
                const double e = sign < 0 ? q / a : c / q;
                if (e > 0 && e < 1) ends.push_back(e);
            }
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 1; i < ends.size(); ++i) {
            double lo = ends[i - 1], hi = ends[i];
            const bool rises = at(lo) < level;
            if (rises == (at(hi) < level)) continue;
            for (int step = 0; step < 60; ++step) {
                const double middle = 0.5 * (lo + hi);
                ((at(middle) < level) == rises ? lo : hi) = middle;
            }
            roots.push_back(0.5 * (lo + hi));
        }
    }

    double t0_, t1_;
    std::array<double, 4> newton_{};
};

}  // namespace lacuna::reference
