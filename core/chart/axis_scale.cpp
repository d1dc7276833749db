#include "core/chart/axis_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace lacuna {

namespace {

constexpr double k_lane_points = 22;
constexpr double k_pad = 0.04;  // of the axis, beyond the data at either end
constexpr double k_rounding = 1e-12;

/// Digits as superscripts.
std::string raised(int number) {
    static const char* const k_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = number < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(number))) out += k_digits[c - '0'];
    return out;
}

/// The step of a linear axis: 1, 2 or 5 times a power of ten, for about `wanted` ticks.
double tick_step(double width, int wanted) {
    const double rough = width / std::max(1, wanted), power = std::pow(10, std::floor(std::log10(rough)));
    const double mantissa = rough / power;
    return power * (mantissa <= 1.5 ? 1 : mantissa <= 3.5 ? 2 : mantissa <= 7.5 ? 5 : 10);
}

/// Ticks of one axis have equally many decimals, as many as its step needs.
std::string with_decimals(double value, double step) {
    const int decimals = std::max(0, int(std::ceil(-std::log10(step) - 1e-9)));
    if (decimals == 0 || decimals > 4 || std::fabs(value) >= 1000) return readable(value);
    return (value < 0 ? "\u2212" : "") + fmt::format("{:.{}f}", std::fabs(value), decimals);
}

}  // namespace

std::string readable(double value) {
    if (value == 0) return "0";
    const double size = std::fabs(value);
    const std::string sign = value < 0 ? "\u2212" : "";
    if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : sign + "∞";
    if (size < 1e-4 || size >= 1e6) {
        int exponent = int(std::floor(std::log10(size)));
        double mantissa = size / std::pow(10, exponent);
        if (mantissa > 9.9995) mantissa = 1, ++exponent;
        const std::string digits = fmt::format("{:.4g}", mantissa);
        return sign + (digits == "1" ? "" : digits + "·") + "10" + raised(exponent);
    }
    std::string text = fmt::format("{:.6g}", size);
    std::size_t end = text.find('.');
    if (end == std::string::npos) end = text.size();
    if (end > 4) text.insert(end - 3, "\u2009");
    return sign + text;
}

void Extent::add(double value, Scale scale) {
    if (!std::isfinite(value)) return;
    if (scale == Scale::log && !(value > 0)) {
        has_zero = true;
        return;
    }
    lo = std::min(lo, value);
    hi = std::max(hi, value);
}

AxisScale::AxisScale(const Axis& axis, const Extent& data, double from, double to, bool include_zero)
    : scale_(axis.scale),
      decimal_mark_(axis.decimal_mark),
      categories_(axis.categories),
      from_(from),
      to_(to),
      start_(from) {
    if (!categories_.empty()) {
        lo_ = -0.5;
        hi_ = double(categories_.size()) - 0.5;
        return;
    }
    lo_ = data.empty() ? (scale_ == Scale::log ? 0.1 : 0) : data.lo;
    hi_ = data.empty() ? 1 : data.hi;
    const bool fit_lo = !axis.lo, fit_hi = !axis.hi;
    if (axis.lo) lo_ = *axis.lo;
    if (axis.hi) hi_ = *axis.hi;
    if (scale_ == Scale::log) {
        if (!(lo_ > 0 && hi_ > 0)) throw Error(Errc::bad_usage, "The ends of a logarithmic axis must lie above 0.");
        if (fit_lo && fit_hi && !(hi_ > 1.5 * lo_)) lo_ /= 1.6, hi_ *= 1.6;
        const double pad = std::pow(hi_ / lo_, k_pad);
        if (fit_lo) lo_ /= pad;
        if (fit_hi) hi_ *= pad;
        lane_ = axis.zero_lane && data.has_zero;
        if (lane_) start_ = from_ + (to_ > from_ ? k_lane_points : -k_lane_points);
    } else {
        if (include_zero && fit_lo) lo_ = std::min(lo_, 0.0);
        if (include_zero && fit_hi) hi_ = std::max(hi_, 0.0);
        // Apart by rounding alone is the same, and too little to count ticks in.
        if (fit_lo && fit_hi && !(hi_ - lo_ > k_rounding * std::max(std::fabs(lo_), std::fabs(hi_)))) {
            const double half = lo_ == 0 ? 0.5 : 0.1 * std::fabs(lo_);
            lo_ -= half;
            hi_ += half;
        }
        const double pad = k_pad * (hi_ - lo_);
        if (fit_lo && !(include_zero && lo_ == 0)) lo_ -= pad;
        if (fit_hi && !(include_zero && hi_ == 0)) hi_ += pad;
    }
    if (!(std::isfinite(lo_) && std::isfinite(hi_) && lo_ < hi_))
        throw Error(Errc::bad_usage, "The low end of an axis must lie below its high end.");
}

double AxisScale::at(double value) const {
    if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
    if (scale_ == Scale::linear) return start_ + (to_ - start_) * ((value - lo_) / (hi_ - lo_));
    if (!(value > 0)) return lane_ ? 0.5 * (from_ + start_) : std::numeric_limits<double>::quiet_NaN();
    return start_ + (to_ - start_) * (std::log(value / lo_) / std::log(hi_ / lo_));
}

std::vector<Tick> AxisScale::ticks(int wanted) const {
    if (!categories_.empty()) {
        std::vector<Tick> named;
        for (std::size_t i = 0; i < categories_.size(); ++i) named.push_back({double(i), categories_[i]});
        return named;
    }
    std::vector<Tick> made = scale_ == Scale::log ? log_ticks(wanted) : linear_ticks(wanted);
    if (lane_) made.insert(made.begin(), {0, "0"});
    for (Tick& tick : made) std::replace(tick.label.begin(), tick.label.end(), '.', decimal_mark_);
    return made;
}

std::vector<Tick> AxisScale::linear_ticks(int wanted) const {
    const double step = tick_step(hi_ - lo_, wanted), slack = 1e-9 * (hi_ - lo_);
    std::vector<Tick> made;
    for (double k = std::ceil((lo_ - slack) / step); k * step <= hi_ + slack; ++k)
        made.push_back({k * step, with_decimals(std::fabs(k * step) < slack ? 0 : k * step, step)});
    return made;
}

std::vector<Tick> AxisScale::log_ticks(int wanted) const {
    const double decades = std::log10(hi_ / lo_);
    const int first = int(std::floor(std::log10(lo_) - 1e-9)), last = int(std::ceil(std::log10(hi_) + 1e-9));
    const int every = std::max(1, int(std::ceil(decades / std::max(1, wanted))));
    // Few decades leave room for the digits between them.
    const std::vector<int> labelled = decades < 1.3   ? std::vector<int>{1, 2, 3, 5, 7}
                                      : decades < 2.2 ? std::vector<int>{1, 2, 5}
                                      : decades < 3.3 ? std::vector<int>{1, 3}
                                                      : std::vector<int>{1};
    std::vector<Tick> made;
    for (int e = first; e <= last; ++e)
        for (int digit = 1; digit <= 9; ++digit) {
            const double value = digit * std::pow(10, e);
            if (value < lo_ * (1 - 1e-9) || value > hi_ * (1 + 1e-9)) continue;
            const bool named = std::find(labelled.begin(), labelled.end(), digit) != labelled.end();
            const bool shown = named && (every == 1 || (digit == 1 && (e % every + every) % every == 0));
            if (shown || every == 1) made.push_back({value, shown ? readable(value) : ""});
        }
    return made;
}

}  // namespace lacuna
