#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "core/render/frame.h"
#include "core/render/plan.h"
#include "core/render/reference_cubic.h"
#include "core/render/reference_ray.h"
#include "core/render/reference_sampler.h"
#include "core/render/scene.h"
#include "core/render/shading.h"

namespace lacuna::reference {

constexpr double k_nothing = std::numeric_limits<double>::infinity();

/// What one ray brings home.
struct Pixel {
    glm::dvec4 color{0};  ///< premultiplied
    double depth_mm = k_nothing;
};

/// The shortest true program for one ray in each mode. Counters grow with each call.
template <class T>
class Caster {
public:
    Caster(const Scene& scene, const Plan& plan)
        : scene_(scene),
          plan_(plan),
          field_(scene.volume),
          nearest_(plan.sampler == Sampler::nearest),
          sobel_(plan.gradient == GradientFilter::sobel),
          no_ranges_(scene.classification.ranges.empty()) {}

    Pixel trace(const LatticeRay& ray) {
        if (ray.hits_box) ++counters.rays;
        if (!ray.kept) return {};
        switch (scene_.mode) {
            case ViewMode::iso:
                return iso(ray);
            case ViewMode::ea:
                return emission_absorption(ray);
            case ViewMode::lmip:
                return local_maximum(ray);
            case ViewMode::mean:
                return mean(ray);
            default:
                return extreme(ray, scene_.mode == ViewMode::minip);
        }
    }

    Counters counters;

private:
    /// Walks the counted samples of the MIP family: neither NaN nor outside the ranges. visit(t, value) returns whether
    /// to go on.
    template <class Visit>
    void for_each_counted(const LatticeRay& ray, Visit&& visit) {
        for (std::int64_t k = ray.first; k < ray.end; ++k) {
            const double t = ray.sample_t(k), value = seen(ray, t);
            ++counters.samples;
            if (std::isnan(value) || !(no_ranges_ || scene_.classification.in_ranges(value))) continue;
            if (!visit(t, value)) return;
        }
    }

    double sample(const LatticeRay& ray, double t) const {
        const glm::dvec3 p = ray.at(t);
        return nearest_ ? field_.nearest(p) : field_.linear(p);
    }
    /// The class of the voxel nearest to a point on the ray.
    std::uint8_t class_at(const LatticeRay& ray, double t) const {
        if (!scene_.regions) return 0;
        const GridGeometry& grid = scene_.volume.geometry();
        const glm::ivec3 i(glm::clamp(ray.at(t), glm::dvec3(0), glm::dvec3(grid.size - 1)) + 0.5);
        return (*scene_.regions.of_voxel)[std::size_t(grid.linear_index(i.x, i.y, i.z))];
    }
    /// A sample as the view counts it: NaN where its voxel is hidden.
    double seen(const LatticeRay& ray, double t) const {
        return class_at(ray, t) == RegionClasses::k_hidden ? std::numeric_limits<double>::quiet_NaN() : sample(ray, t);
    }
    /// The function of a value: its region's, its range's, or the scene's.
    const TransferFunction& function_of(const LatticeRay& ray, double t, double value) const {
        if (const std::uint8_t c = class_at(ray, t); c > 0 && c < RegionClasses::k_hidden)
            return scene_.regions.functions[std::size_t(c) - 1];
        return scene_.classification.function_of(value);
    }
    ColorOpacity classified(const LatticeRay& ray, double t, double value) const {
        return scene_.classification.in_ranges(value) ? function_of(ray, t, value).at(value) : ColorOpacity{};
    }
    double inside(double value) const {
        return no_ranges_ ? value - scene_.iso : iso_measure(scene_.classification, scene_.iso, value);
    }
    double inside_at(const LatticeRay& ray, double t) const { return inside(sample(ray, t)); }

    /// c = |n.v| of a gradient per mm along the grid's axes; 0 for a gradient that is zero or NaN.
    static double facing(const LatticeRay& ray, const glm::dvec3& gradient) {
        const double length = glm::length(gradient);
        return length > 0 ? std::fmin(std::fabs(glm::dot(gradient, ray.direction_grid)) / length, 1) : 0;
    }

    Pixel opaque(const glm::dvec3& color, double t) const { return {glm::dvec4(color, 1), t}; }
    Pixel cap(const LatticeRay& ray, double value) const {
        return opaque(glm::dvec3(grey_level(scene_.window, value)), ray.from);
    }
    Pixel surface(double c, double t) const { return opaque(shade(scene_.shading, scene_.surface_color, c), t); }
    Pixel projected(double value, double t) const {
        return opaque(
            scene_.color_by_tf ? scene_.classification.at(value).color : glm::dvec3(grey_level(scene_.window, value)),
            t);
    }

    Pixel iso(const LatticeRay& ray);
    Pixel exact_iso(const LatticeRay& ray, bool in_object);
    double refine(const LatticeRay& ray, double a, double g_a, double b, double g_b, bool leaving);
    double regula_falsi(const LatticeRay& ray, double a, double h_a, double b, double h_b, double sign) const;
    double newton(const LatticeRay& ray, double a, double h_a, double b, double h_b);
    Pixel emission_absorption(const LatticeRay& ray);
    Pixel extreme(const LatticeRay& ray, bool smallest);
    Pixel local_maximum(const LatticeRay& ray);
    Pixel mean(const LatticeRay& ray);

    const Scene& scene_;
    const Plan& plan_;
    Field<T> field_;
    bool nearest_, sobel_, no_ranges_;
};

/// `lower_known` is false where the sample before the turn is NaN: then the sample itself is the hit.
template <class T>
Pixel Caster<T>::iso(const LatticeRay& ray) {
    double lower = ray.from;
    const double entry_value = seen(ray, lower);
    double g_lower = inside(entry_value);
    bool in_object = g_lower >= 0;
    if (in_object && !ray.entry_by_cut)
        return surface(ray.entry_axis < 0 ? 1.0 : std::fabs(ray.direction_grid[ray.entry_axis]), lower);
    if (in_object && ray.entry_capped) return cap(ray, entry_value);
    if (plan_.refine == Refinement::cubic) return exact_iso(ray, in_object);

    for (std::int64_t k = ray.first; k < ray.end; ++k) {
        const double t = ray.sample_t(k), g = inside(seen(ray, t));
        ++counters.samples;
        if (std::isnan(g)) {
            in_object = false;
        } else if (in_object ? g < 0 : g >= 0) {
            const double hit = std::isnan(g_lower) ? t : refine(ray, lower, g_lower, t, g, in_object);
            return surface(facing(ray, field_.gradient(ray.at(hit), sobel_)), hit);
        }
        lower = t;
        g_lower = g;
    }
    return {};
}

/// The first turn of the exact signal: every cell on the way, solved. After one that holds a NaN the ray counts as
/// outside.
template <class T>
Pixel Caster<T>::exact_iso(const LatticeRay& ray, bool in_object) {
    const std::vector<double> levels = turning_values(scene_.classification, scene_.iso);
    std::optional<double> hit;
    for_each_cell(ray, [&](double t0, double t1) {
        const CellCubic signal(field_, ray, t0, t1);
        ++counters.samples;
        if (signal.is_nan())
            in_object = false;
        else
            hit = signal.first_turn(levels, in_object, [&](double v) { return inside(v) >= 0; });
        return !hit;
    });
    return hit ? surface(facing(ray, field_.gradient(ray.at(*hit), sobel_)), *hit) : Pixel{};
}

/// Sharpens the turn between a (before it) and b (behind it). `leaving`: the turn is from inside to outside.
template <class T>
double Caster<T>::refine(const LatticeRay& ray, double a, double g_a, double b, double g_b, bool leaving) {
    const double sign = leaving ? -1 : 1;
    switch (plan_.refine) {
        case Refinement::none:
            return b;
        case Refinement::regula_falsi:
        case Refinement::regula_falsi_plain:
            return regula_falsi(ray, a, sign * g_a, b, sign * g_b, sign);
        case Refinement::newton:
            return newton(ray, a, g_a, b, g_b);
        case Refinement::bisect:
        case Refinement::cubic:
            break;
    }
    for (int i = 0; i < plan_.refine_steps; ++i) {
        const double middle = 0.5 * (a + b), g = inside_at(ray, middle);
        (leaving ? g < 0 : g >= 0) ? b = middle : a = middle;
    }
    return 0.5 * (a + b);
}

/// Regula falsi with the Illinois modification (Dowell & Jarratt 1971): an end kept twice in a row has its value
/// halved, unless the plan wants the plain rule.
template <class T>
double Caster<T>::regula_falsi(const LatticeRay& ray, double a, double h_a, double b, double h_b, double sign) const {
    const double share = plan_.refine == Refinement::regula_falsi_plain ? 1.0 : 0.5;
    double estimate = b;
    int kept_end = 0;  // -1: a was kept last, +1: b was
    for (int i = 0; i < plan_.refine_steps; ++i) {
        if (h_a == h_b) return estimate;
        estimate = a + (b - a) * (h_a / (h_a - h_b));
        const double h = sign * inside_at(ray, estimate);
        if (std::isnan(h)) return estimate;
        if (sign > 0 ? h >= 0 : h > 0) {
            b = estimate;
            h_b = h;
            if (kept_end == -1) h_a *= share;
            kept_end = -1;
        } else {
            a = estimate;
            h_a = h;
            if (kept_end == 1) h_b *= share;
            kept_end = 1;
        }
    }
    return estimate;
}

template <class T>
double Caster<T>::newton(const LatticeRay& ray, double a, double g_a, double b, double g_b) {
    double t = g_a == g_b ? b : a + (b - a) * (g_a / (g_a - g_b));
    const double h = 0.1 * ray.step_mm;
    for (int i = 0; i < plan_.refine_steps; ++i) {
        const double slope = (inside_at(ray, t + h) - inside_at(ray, t - h)) / (2 * h);
        t -= inside_at(ray, t) / slope;
        if (!(t >= a && t <= b)) {
            ++counters.not_converged;
            return 0.5 * (a + b);
        }
    }
    return t;
}

template <class T>
Pixel Caster<T>::emission_absorption(const LatticeRay& ray) {
    if (ray.entry_by_cut && ray.entry_capped) {
        const double value = seen(ray, ray.from);
        if (!std::isnan(value) && classified(ray, ray.from, value).opacity > 0) return cap(ray, value);
    }
    glm::dvec3 color(0);
    double alpha = 0, depth = k_nothing;
    for (std::int64_t k = ray.first; k < ray.end; ++k) {
        const double t = ray.sample_t(k), value = seen(ray, t);
        ++counters.samples;
        if (std::isnan(value)) continue;
        const ColorOpacity shown = classified(ray, t, value);
        if (!(shown.opacity > 0)) continue;
        const TransferFunction& tf = function_of(ray, t, value);

        ColorOpacity here = shown;
        double c = 0;
        if (scene_.shading != Shading::none || tf.uses_gradient()) {
            const glm::dvec3 gradient = field_.gradient(ray.at(t), sobel_);
            if (tf.uses_gradient()) here = tf.at(value, glm::length(gradient));
            c = facing(ray, gradient);
        }
        const double a = correct_opacity(here.opacity, ray.step_mm, tf.unit_distance_mm);
        color += (1 - alpha) * a * shade(scene_.shading, here.color, c);
        alpha += (1 - alpha) * a;
        if (alpha > 0.5 && depth == k_nothing) depth = t;
        if (plan_.ert > 0 && alpha > 1 - plan_.ert) break;
    }
    return {glm::dvec4(color, alpha), depth};
}

template <class T>
Pixel Caster<T>::extreme(const LatticeRay& ray, bool smallest) {
    double best = smallest ? k_nothing : -k_nothing, best_t = k_nothing;
    for_each_counted(ray, [&](double t, double value) {
        if (smallest ? value < best : value > best) {
            best = value;
            best_t = t;
        }
        return true;
    });
    return std::isinf(best) ? Pixel{} : projected(best, best_t);
}

template <class T>
Pixel Caster<T>::local_maximum(const LatticeRay& ray) {
    double largest = -k_nothing, largest_t = k_nothing, before = -k_nothing, before_t = k_nothing;
    for_each_counted(ray, [&](double t, double value) {
        if (before >= scene_.lmip_threshold && value < before) return false;
        if (value > largest) {
            largest = value;
            largest_t = t;
        }
        before = value;
        before_t = t;
        return true;
    });
    if (std::isinf(largest)) return {};
    return before >= scene_.lmip_threshold ? projected(before, before_t) : projected(largest, largest_t);
}

template <class T>
Pixel Caster<T>::mean(const LatticeRay& ray) {
    double sum = 0;
    std::int64_t count = 0;
    for_each_counted(ray, [&](double, double value) {
        sum += value;
        ++count;
        return true;
    });
    return count == 0 ? Pixel{} : projected(sum / double(count), k_nothing);
}

}  // namespace lacuna::reference
