#include "core/classify/opacity_peaks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Local maxima of opacity with a fall to half on both sides.
void add_peaks(const TransferFunction& tf, std::vector<ValueRange>& peaks) {
    if (tf.is_2d()) {
        for (const TransferShape& shape : tf.shapes)
            if (shape.opacity > 0) peaks.push_back(shape.values());
        return;
    }
    const auto& p = tf.points;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double half = 0.5 * p[i].opacity;
        if (!(half > 0) || (i > 0 && p[i - 1].opacity > p[i].opacity)) continue;
        const auto crossing = [&](std::size_t inner, std::size_t outer) {
            const double fall = (p[inner].opacity - half) / (p[inner].opacity - p[outer].opacity);
            return p[inner].value + fall * (p[outer].value - p[inner].value);
        };
        double lo = -k_infinity, hi = k_infinity;
        bool highest = true;
        for (std::size_t k = i; k-- > 0 && highest && lo == -k_infinity;) {
            highest = p[k].opacity <= p[i].opacity;
            if (p[k].opacity <= half) lo = crossing(k + 1, k);
        }
        for (std::size_t k = i + 1; k < p.size() && highest && hi == k_infinity; ++k) {
            highest = p[k].opacity <= p[i].opacity;
            if (p[k].opacity <= half) hi = crossing(k - 1, k);
        }
        if (highest && std::isfinite(lo) && std::isfinite(hi)) peaks.push_back({lo, hi});
    }
}

}  // namespace

std::vector<ValueRange> opacity_peaks(const Classification& classification) {
    std::vector<ValueRange> peaks;
    add_peaks(classification.tf, peaks);
    for (const SegmentationRange& r : classification.ranges) {
        if (r.tf) add_peaks(*r.tf, peaks);
        const double middle = 0.5 * (r.range.lo + r.range.hi);
        if (std::isfinite(middle) && classification.at(middle).opacity > 0) peaks.push_back(r.range);
    }
    return peaks;
}

std::optional<double> narrowest_peak(const Classification& classification) {
    std::optional<double> narrowest;
    for (const ValueRange& peak : opacity_peaks(classification))
        narrowest = std::min(narrowest.value_or(k_infinity), peak.width());
    return narrowest;
}

}  // namespace lacuna
