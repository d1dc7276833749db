#include "core/classify/transfer_function.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

bool in_unit(double v) { return v >= 0 && v <= 1; }  // false for NaN

ColorOpacity on_points(const std::vector<TransferPoint>& points, double value) {
    // The first point above the value: of two points at one value the later one is then the left neighbour.
    const auto above = std::upper_bound(points.begin(), points.end(), value,
                                        [](double v, const TransferPoint& p) { return v < p.value; });
    if (above == points.begin()) return {above->color, above->opacity};
    const TransferPoint& left = *(above - 1);
    if (above == points.end()) return {left.color, left.opacity};
    const double t = (value - left.value) / (above->value - left.value);
    return {left.color + t * (above->color - left.color), left.opacity + t * (above->opacity - left.opacity)};
}

[[noreturn]] void refuse(const TransferFunction& tf, const std::string& fault) {
    throw Error(Errc::bad_input, "The transfer function \"" + tf.name + "\" is not usable: " + fault + ".");
}

}  // namespace

double TransferShape::opacity_at(double value, double m) const {
    const double t = (m - magnitude.lo) / (magnitude.hi - magnitude.lo);
    if (!(t >= 0 && t <= 1)) return 0;
    const double left = at_lo.lo + t * (at_hi.lo - at_lo.lo), right = at_lo.hi + t * (at_hi.hi - at_lo.hi);
    if (!(value >= left && value <= right)) return 0;
    const double from_side = std::min(value - left, right - value), ramp = softness * 0.5 * (right - left);
    return from_side >= ramp ? opacity : opacity * (from_side / ramp);
}

// The distance from the nearer side over the half width is a ratio of functions linear in the magnitude, but for the
// one magnitude at which the value lies in the middle: the largest is there, or at an end.
double TransferShape::most_opacity_at(double value) const {
    double most = std::max(opacity_at(value, magnitude.lo), opacity_at(value, magnitude.hi));
    const double middle_lo = 0.5 * (at_lo.lo + at_lo.hi), middle_hi = 0.5 * (at_hi.lo + at_hi.hi);
    const double t = (value - middle_lo) / (middle_hi - middle_lo);  // not a number where the middle does not move
    if (t > 0 && t < 1) most = std::max(most, opacity_at(value, magnitude.lo + t * magnitude.width()));
    return most;
}

ColorOpacity TransferFunction::at(double value) const {
    if (std::isnan(value) || points.empty()) return {};
    if (is_2d()) {
        double clear = 1;
        for (const TransferShape& shape : shapes) clear *= 1 - shape.most_opacity_at(value);
        return {on_points(points, value).color, 1 - clear};
    }
    return on_points(points, value);
}

ColorOpacity TransferFunction::at(double value, double magnitude) const {
    if (std::isnan(magnitude)) magnitude = 0;
    ColorOpacity seen = at(value);
    if (!is_2d()) {
        seen.opacity *= gradient_factor(magnitude);
        return seen;
    }
    double clear = 1, weight = 0;
    glm::dvec3 color(0);
    for (const TransferShape& shape : shapes) {
        const double opacity = shape.opacity_at(value, magnitude);
        clear *= 1 - opacity;
        weight += opacity;
        color += opacity * shape.color;
    }
    return weight > 0 ? ColorOpacity{color / weight, 1 - clear} : ColorOpacity{seen.color, 0};
}

ValueRange TransferFunction::extent() const {
    ValueRange all{points.front().value, points.back().value};
    if (is_2d())
        for (const TransferShape& shape : shapes)
            all = {std::min(all.lo, shape.values().lo), std::max(all.hi, shape.values().hi)};
    return all;
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

double correct_opacity(double opacity, double step_mm, double unit_distance_mm) {
    if (!(opacity > 0)) return 0;
    if (opacity >= 1) return 1;
    return -std::expm1(std::log1p(-opacity) * (step_mm / unit_distance_mm));
}

namespace {

void check_shape(const TransferFunction& tf, std::size_t i) {
    const TransferShape& shape = tf.shapes[i];
    const std::string at = "shapes[" + std::to_string(i) + "]";
    const auto finite = [](ValueRange range) { return std::isfinite(range.lo) && std::isfinite(range.hi); };
    if (!finite(shape.magnitude) || !(shape.magnitude.lo >= 0) || !(shape.magnitude.lo < shape.magnitude.hi))
        refuse(tf, at + ".magnitude must be two numbers of 0 or more, the first below the second");
    if (!finite(shape.at_lo) || !(shape.at_lo.lo <= shape.at_lo.hi))
        refuse(tf, at + ".values_at_lo must be two numbers, the first not above the second");
    if (!finite(shape.at_hi) || !(shape.at_hi.lo <= shape.at_hi.hi))
        refuse(tf, at + ".values_at_hi must be two numbers, the first not above the second");
    if (!in_unit(shape.opacity)) refuse(tf, at + ".opacity lies outside 0..1");
    if (!in_unit(shape.softness)) refuse(tf, at + ".softness lies outside 0..1");
    for (int c = 0; c < 3; ++c)
        if (!in_unit(shape.color[c])) refuse(tf, at + ".color lies outside 0..1");
}

}  // namespace

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
    if (tf.shapes.size() > TransferFunction::k_max_shapes)
        refuse(tf, "shapes holds more than " + std::to_string(TransferFunction::k_max_shapes));
    for (std::size_t i = 0; i < tf.shapes.size(); ++i) check_shape(tf, i);
}

}  // namespace lacuna
