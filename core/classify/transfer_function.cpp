#include "core/classify/transfer_function.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

bool in_unit(double v) { return v >= 0 && v <= 1; }  // false for NaN

[[noreturn]] void refuse(const TransferFunction& tf, const std::string& fault) {
    throw Error(Errc::bad_input, "The transfer function \"" + tf.name + "\" is not usable: " + fault + ".");
}

}  // namespace

ColorOpacity TransferFunction::at(double value) const {
    if (std::isnan(value) || points.empty()) return {};
    // The first point above the value: of two points at one value the later one is then the left neighbour.
    const auto above = std::upper_bound(points.begin(), points.end(), value,
                                        [](double v, const TransferPoint& p) { return v < p.value; });
    if (above == points.begin()) return {above->color, above->opacity};
    const TransferPoint& left = *(above - 1);
    if (above == points.end()) return {left.color, left.opacity};
    const double t = (value - left.value) / (above->value - left.value);
    return {left.color + t * (above->color - left.color), left.opacity + t * (above->opacity - left.opacity)};
}

double TransferFunction::gradient_factor(double magnitude) const {
    if (gradient_opacity.empty()) return 1;
    if (std::isnan(magnitude)) return 0;
    const auto above = std::upper_bound(gradient_opacity.begin(), gradient_opacity.end(), magnitude,
                                        [](double v, const GradientOpacityPoint& p) { return v < p.magnitude; });
    if (above == gradient_opacity.begin()) return above->opacity;
    const GradientOpacityPoint& left = *(above - 1);
    if (above == gradient_opacity.end()) return left.opacity;
    const double t = (magnitude - left.magnitude) / (above->magnitude - left.magnitude);
    return left.opacity + t * (above->opacity - left.opacity);
}

bool TransferFunction::any_visible(ValueRange range) const {
    if (!(range.lo <= range.hi) || points.empty()) return false;
    if (at(range.lo).opacity > 0 || at(range.hi).opacity > 0) return true;
    // The ends are invisible. What is left are the points inside, and the open segments between two points, on which
    // the opacity is above 0 everywhere if it is at either end.
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double v = points[i].value;
        if (range.contains(v) && at(v).opacity > 0) return true;
        if (i + 1 == points.size() || !(v < points[i + 1].value)) continue;
        const bool overlaps = std::max(v, range.lo) < std::min(points[i + 1].value, range.hi);
        if (overlaps && (points[i].opacity > 0 || points[i + 1].opacity > 0)) return true;
    }
    return false;
}

double correct_opacity(double opacity, double step_mm, double unit_distance_mm) {
    if (!(opacity > 0)) return 0;
    if (opacity >= 1) return 1;
    return -std::expm1(std::log1p(-opacity) * (step_mm / unit_distance_mm));
}

void check(const TransferFunction& tf) {
    if (!(tf.unit_distance_mm > 0) || !std::isfinite(tf.unit_distance_mm))
        refuse(tf, "unit_distance_mm must be a positive number");
    if (tf.points.empty()) refuse(tf, "points must hold at least one point");
    for (std::size_t i = 0; i < tf.points.size(); ++i) {
        const TransferPoint& p = tf.points[i];
        const std::string at = "points[" + std::to_string(i) + "]";
        if (!std::isfinite(p.value)) refuse(tf, at + ".value is not a finite number");
        if (!in_unit(p.opacity)) refuse(tf, at + ".opacity lies outside 0..1");
        for (int c = 0; c < 3; ++c)
            if (!in_unit(p.color[c])) refuse(tf, at + ".color lies outside 0..1");
        if (i > 0 && tf.points[i - 1].value > p.value) refuse(tf, at + ".value lies below the point before it");
        if (i > 1 && tf.points[i - 2].value == p.value)
            refuse(tf, at + ".value is the third at one value (two make a jump)");
    }
    for (std::size_t i = 0; i < tf.gradient_opacity.size(); ++i) {
        const GradientOpacityPoint& p = tf.gradient_opacity[i];
        const std::string at = "gradient_opacity[" + std::to_string(i) + "]";
        if (!std::isfinite(p.magnitude) || p.magnitude < 0) refuse(tf, at + ".magnitude is not a number of 0 or more");
        if (!in_unit(p.opacity)) refuse(tf, at + ".opacity lies outside 0..1");
        if (i > 0 && tf.gradient_opacity[i - 1].magnitude > p.magnitude)
            refuse(tf, at + ".magnitude lies below the one before it");
    }
}

}  // namespace lacuna
