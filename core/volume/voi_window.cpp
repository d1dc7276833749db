#include "core/volume/voi_window.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

/// A linear function between two values: 0 up to `black`, 1 beyond `white`, offset + slope * x between.
struct Ramp {
    double black, white, slope, offset;

    explicit Ramp(const VoiWindow& window) {
        const bool exact = window.function == VoiFunction::linear_exact;
        const double center = exact ? window.center : window.center - 0.5;
        const double width = exact ? std::max(window.width, 0.0) : std::max(window.width, 1.0) - 1;
        black = center - 0.5 * width;
        white = center + 0.5 * width;
        slope = width > 0 ? 1 / width : 0;  // of a step no value lies between
        offset = 0.5 - center * slope;
    }

    double operator()(double value) const {
        if (!(value > black)) return 0;  // NaN too
        return value > white ? 1 : offset + slope * value;
    }
};

struct Sigmoid {
    double center, slope;

    explicit Sigmoid(const VoiWindow& window)
        : center(window.center), slope(window.width > 0 ? -4 / window.width : 0) {}

    double operator()(double value) const {
        if (!(value == value)) return 0;
        if (slope == 0) return value > center ? 1 : 0;
        return 1 / (1 + std::exp(slope * (value - center)));
    }
};

template <class Function>
void grey_levels(const Function& share, std::span<const float> values, std::uint8_t* grey) {
    for (std::size_t i = 0; i < values.size(); ++i) grey[i] = std::uint8_t(share(double(values[i])) * 255 + 0.5);
}

}  // namespace

double voi_share(const VoiWindow& window, double value) {
    return window.function == VoiFunction::sigmoid ? Sigmoid(window)(value) : Ramp(window)(value);
}

void apply_voi(const VoiWindow& window, std::span<const float> values, std::span<std::uint8_t> grey) {
    if (window.function == VoiFunction::sigmoid)
        grey_levels(Sigmoid(window), values, grey.data());
    else
        grey_levels(Ramp(window), values, grey.data());
}

}  // namespace lacuna
