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

bool Classification::uses_gradient() const {
    return tf.uses_gradient() || std::any_of(ranges.begin(), ranges.end(), [](const SegmentationRange& range) {
               return range.tf && range.tf->uses_gradient();
           });
}

const TransferFunction& Classification::function_of(double value) const {
    const int index = range_of(value);
    return index >= 0 && ranges[std::size_t(index)].tf ? *ranges[std::size_t(index)].tf : tf;
}

ColorOpacity Classification::at(double value) const {
    if (ranges.empty()) return tf.at(value);
    return range_of(value) < 0 ? ColorOpacity{} : function_of(value).at(value);
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
