#include "core/classify/classification.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {

int Classification::range_of(double value) const {
    for (std::size_t i = 0; i < ranges.size(); ++i)
        if (ranges[i].range.contains(value)) return int(i);
    return -1;
}

bool Classification::in_ranges(double value) const {
    return ranges.empty() ? !std::isnan(value) : range_of(value) >= 0;
}

ColorOpacity Classification::at(double value) const {
    if (ranges.empty()) return tf.at(value);
    const int index = range_of(value);
    if (index < 0) return {};
    const std::optional<TransferFunction>& own = ranges[std::size_t(index)].tf;
    return own ? own->at(value) : tf.at(value);
}

double iso_measure(const Classification& classification, double iso, double value) {
    if (std::isnan(value) || std::isnan(iso)) return std::numeric_limits<double>::quiet_NaN();
    if (classification.ranges.empty()) return value - iso;
    double best = -std::numeric_limits<double>::infinity();
    for (const SegmentationRange& r : classification.ranges)
        best = std::max(best, std::min(value - std::max(iso, r.range.lo), r.range.hi - value));
    return best;
}

}  // namespace lacuna
