#pragma once

namespace lacuna {

/// A measured value and the interval its true value is taken to lie in; lo <= value <= hi. What widens the interval is
/// said where the value is made. All three NaN: it cannot be measured.
struct Measured {
    double value = 0, lo = 0, hi = 0;
    friend bool operator==(const Measured&, const Measured&) = default;
};

}  // namespace lacuna
