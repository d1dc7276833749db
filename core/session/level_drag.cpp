#include "core/session/level_drag.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

constexpr double k_least_share = 1e-4, k_most_share = 20;  // of the values' width that a width may come to
constexpr double k_furthest = 10;                          // widths of the values a level may lie off them

struct Levels {
    double middle, width;
};

Levels changed(Levels levels, ValueRange values, double higher, double wider) {
    const double all = values.width() > 0 ? values.width() : 1;
    levels.middle =
        std::clamp(levels.middle + higher * levels.width, values.lo - k_furthest * all, values.hi + k_furthest * all);
    levels.width =
        std::clamp(levels.width * std::exp(std::clamp(wider, -20.0, 20.0)), k_least_share * all, k_most_share * all);
    return levels;
}

TransferFunction with_levels(TransferFunction function, ValueRange values, double higher, double wider) {
    if (function.points.empty()) return function;
    const double first = function.points.front().value, last = function.points.back().value;
    const bool wide = last > first;  // a single point has a place, but no width of its own
    const Levels before{0.5 * (first + last), wide ? last - first : std::max(values.width(), 1e-9)};
    const Levels after = changed(before, values, higher, wider);
    const double factor = wide ? after.width / before.width : 1;
    for (TransferPoint& point : function.points) point.value = after.middle + (point.value - before.middle) * factor;
    // Rounding must not turn the order of points that lie together.
    for (std::size_t i = 1; i < function.points.size(); ++i)
        function.points[i].value = std::max(function.points[i].value, function.points[i - 1].value);
    return function;
}

}  // namespace

ViewSettings with_levels(const ViewSettings& settings, ValueRange values, double higher, double wider) {
    ViewSettings next = settings;
    if (!std::isfinite(higher) || !std::isfinite(wider)) return next;
    if (settings.mode == ViewMode::iso || settings.mode == ViewMode::shear_warp) {
        next.iso = std::clamp(settings.iso + higher * values.width(), values.lo, std::max(values.lo, values.hi));
    } else if (settings.mode == ViewMode::ea || settings.color_by_tf) {
        next.tf = with_levels(settings.tf, values, higher, wider);
    } else {
        const ValueRange window = settings.projection_window;
        const Levels after = changed({0.5 * (window.lo + window.hi), window.width()}, values, higher, wider);
        next.projection_window = {after.middle - 0.5 * after.width, after.middle + 0.5 * after.width};
    }
    return next;
}

}  // namespace lacuna
