#pragma once

#include <string>
#include <vector>

#include "core/chart/chart.h"

namespace lacuna {

/// Smallest and largest value put in; what is not finite is passed over.
struct Extent {
    double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
    bool has_zero = false;  ///< a value of 0 or below was put in: a log axis with a zero lane opens it

    bool empty() const { return !(lo <= hi); }
    void add(double value, Scale scale);
};

struct Tick {
    double value = 0;
    std::string label;  ///< empty: a minor tick
};

/// Where values of an axis fall between two positions on the page; a pure function of the axis and its data.
class AxisScale {
public:
    /// @param from, to  positions of the axis' low and high end on the page, points
    /// @param include_zero  a linear axis is widened to hold 0 (bars stand on it)
    /// @throws Error(bad_usage) for ends out of order, or not above 0 on a log axis
    AxisScale(const Axis& axis, const Extent& data, double from, double to, bool include_zero = false);

    double lo() const { return lo_; }
    double hi() const { return hi_; }
    bool has_lane() const { return lane_; }
    /// Where the lane ends and the scale proper begins.
    double lane_end() const { return start_; }
    /// NaN for a value that has no place on this axis.
    double at(double value) const;
    /// Ascending; about `wanted` of them labelled.
    std::vector<Tick> ticks(int wanted) const;

private:
    std::vector<Tick> linear_ticks(int wanted) const;
    std::vector<Tick> log_ticks(int wanted) const;

    Scale scale_;
    char decimal_mark_;
    std::vector<std::string> categories_;
    double lo_ = 0, hi_ = 1, from_, to_, start_;
    bool lane_ = false;
};

/// A number as a reader wants it: 0.25, 1500, 25 000, 10⁻⁷, 3·10⁹; a true minus sign.
std::string readable(double value);

}  // namespace lacuna
