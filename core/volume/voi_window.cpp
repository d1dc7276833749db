#include "core/volume/voi_window.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

/// A linear function between two values: 0 up to `black`, 1 beyond `white`, offset + slope * x between.
struct Ramp {
    double black, white, slope, offset;

    explicit Ramp(const VoiWindow& window) {
        const bool exact = window.function != VoiFunction::linear;
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

/// A table stretched over the window.
struct Table {
    const std::vector<std::uint16_t>& share;
    double black, scale, white, last;

    explicit Table(const VoiWindow& window)
        : share(window.table->share),
          black(window.center - 0.5 * window.width),
          scale(window.width > 0 ? double(share.size() - 1) / window.width : 0),
          white(double((1 << window.table->bits) - 1)),
          last(double(share.size() - 1)) {}

    double operator()(double value) const {
        if (!(value == value)) return 0;
        const double at = scale > 0 ? std::clamp((value - black) * scale, 0.0, last) : value > black ? last : 0;
        const auto below = std::size_t(at);
        const double next = share[std::min(below + 1, share.size() - 1)];
        return std::min(1.0, (share[below] + (at - double(below)) * (next - share[below])) / white);
    }
};

bool has_table(const VoiWindow& window) {
    return window.function == VoiFunction::table && window.table && !window.table->share.empty();
}

template <class Function>
void grey_levels(const Function& share, std::span<const float> values, std::uint8_t* grey) {
    for (std::size_t i = 0; i < values.size(); ++i) grey[i] = std::uint8_t(share(double(values[i])) * 255 + 0.5);
}

}  // namespace

double voi_share(const VoiWindow& window, double value) {
    if (has_table(window)) return Table(window)(value);
    return window.function == VoiFunction::sigmoid ? Sigmoid(window)(value) : Ramp(window)(value);
}

void apply_voi(const VoiWindow& window, std::span<const float> values, std::span<std::uint8_t> grey) {
    if (has_table(window))
        grey_levels(Table(window), values, grey.data());
    else if (window.function == VoiFunction::sigmoid)
        grey_levels(Sigmoid(window), values, grey.data());
    else
        grey_levels(Ramp(window), values, grey.data());
}

}  // namespace lacuna
