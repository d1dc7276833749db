#include "core/render/segment_tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr int k_nodes = SegmentTables::k_nodes, k_bins = k_nodes - 1;
constexpr double k_most_opacity = 1 - 1e-14;  // per unit distance: extinction stays finite

/// Emission and extinction, per mm.
struct Medium {
    glm::dvec3 glow{0};  // extinction times colour
    double extinction = 0;

    Medium& operator+=(const Medium& m) {
        glow += m.glow;
        extinction += m.extinction;
        return *this;
    }
};
Medium operator*(double f, const Medium& m) { return {f * m.glow, f * m.extinction}; }

Medium medium_at(const Classification& classes, double value) {
    const ColorOpacity seen = classes.at(value);
    if (!(seen.opacity > 0)) return {};
    const int range = classes.range_of(value);
    const auto at = std::size_t(std::max(range, 0));
    const TransferFunction& tf = range >= 0 && classes.ranges[at].tf ? *classes.ranges[at].tf : classes.tf;
    const double extinction = -std::log1p(-std::min(seen.opacity, k_most_opacity)) / tf.unit_distance_mm;
    return {extinction * seen.color, extinction};
}

/// Values at which the classification has a corner or a jump.
std::vector<double> corners_of(const Classification& classes) {
    std::vector<double> corners;
    const auto add = [&](const TransferFunction& tf) {
        for (const TransferPoint& p : tf.points) corners.push_back(p.value);
    };
    add(classes.tf);
    for (const SegmentationRange& r : classes.ranges) {
        if (r.tf) add(*r.tf);
        corners.push_back(r.range.lo);
        corners.push_back(r.range.hi);
    }
    std::erase_if(corners, [](double v) { return !std::isfinite(v); });
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// Mean over [lo, hi]: Gauss' four points on each piece without a corner.
Medium mean_medium(const Classification& classes, const std::vector<double>& corners, double lo, double hi) {
    constexpr std::array<double, 4> k_at{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                         0.9305681557970263};
    constexpr std::array<double, 4> k_weight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                             0.1739274225687269};
    Medium mean;
    auto next = std::upper_bound(corners.begin(), corners.end(), lo);
    for (double from = lo; from < hi;) {
        const double to = next != corners.end() && *next < hi ? *next++ : hi;
        for (std::size_t i = 0; i < 4; ++i)
            mean += ((to - from) / (hi - lo) * k_weight[i]) * medium_at(classes, from + k_at[i] * (to - from));
        from = to;
    }
    return mean;
}

/// Premultiplied colour and what is let through.
struct Layer {
    glm::vec3 color{0};
    float clear = 1;
};
Layer over(const Layer& front, const Layer& back) {
    return {front.color + front.clear * back.color, front.clear * back.clear};
}

std::uint32_t pack(const glm::vec3& c) {
    const auto level = [](float v, float top) { return std::uint32_t(std::clamp(v, 0.0f, 1.0f) * top + 0.5f); };
    return level(c.r, 2047) | level(c.g, 2047) << 11 | level(c.b, 1023) << 22;
}

struct Bins {
    std::vector<Medium> mean;    // k_bins
    std::vector<double> before;  // k_nodes: extinction of all bins in front of a node
};

/// Entries whose front and back lie `m` bins apart, both ways round. Windows of m bins are the suffix of one block of m
/// bins and the prefix of the next (van Herk 1992), for any associative operator.
void fill_diagonal(const Bins& bins, int m, double step_mm, SegmentTables& tables) {
    const double length = step_mm / m;
    std::array<Layer, k_bins> bin, prefix, suffix, prefix_back, suffix_back;
    for (int i = 0; i < k_bins; ++i) {
        const Medium& medium = bins.mean[std::size_t(i)];
        Layer& layer = bin[std::size_t(i)] = {};
        if (!(medium.extinction > 0)) continue;
        layer.clear = float(std::exp(-medium.extinction * length));
        layer.color = glm::vec3(medium.glow / medium.extinction) * (1 - layer.clear);
    }
    for (int i = 0; i < k_bins; ++i) {
        const auto at = std::size_t(i);
        prefix[at] = i % m ? over(prefix[at - 1], bin[at]) : bin[at];
        prefix_back[at] = i % m ? over(bin[at], prefix_back[at - 1]) : bin[at];
    }
    for (int i = k_bins - 1; i >= 0; --i) {
        const auto at = std::size_t(i);
        const bool last = i == k_bins - 1 || i % m == m - 1;
        suffix[at] = last ? bin[at] : over(bin[at], suffix[at + 1]);
        suffix_back[at] = last ? bin[at] : over(suffix_back[at + 1], bin[at]);
    }
    for (int i = 0; i + m <= k_bins; ++i) {
        const auto lo = std::size_t(i), hi = std::size_t(i + m - 1);
        const double way = (bins.before[hi + 1] - bins.before[lo]) * length;
        if (!(way > 0)) continue;
        const bool whole = i % m == 0;
        const Layer up = whole ? prefix[hi] : over(suffix[lo], prefix[hi]);
        const Layer down = whole ? prefix_back[hi] : over(prefix_back[hi], suffix_back[lo]);
        const auto opacity = float(-std::expm1(-way));
        const std::size_t rising = lo * k_nodes + hi + 1, falling = (hi + 1) * k_nodes + lo;
        const float share = 1 / std::max(opacity, 1e-30f);
        tables.opacity[rising] = tables.opacity[falling] = opacity;
        tables.color[rising] = pack(up.color * share);
        tables.color[falling] = pack(down.color * share);
    }
}

/// Between its outermost corners a classification changes.
ValueRange span_of(const std::vector<double>& corners, ValueRange values) {
    const double lo = std::max(corners.front(), values.lo), hi = std::min(corners.back(), values.hi);
    return {lo, hi > lo ? hi : lo + std::max({1.0, std::fabs(lo) * 1e-6, values.width()})};
}

double node_distance(ValueRange span) { return span.width() / (k_bins - 2); }

}  // namespace

double segment_slack(const Classification& classes, ValueRange values) {
    return node_distance(span_of(corners_of(classes), values));
}

SegmentTables make_segment_tables(const Classification& classes, ValueRange values, double step_mm) {
    const std::vector<double> corners = corners_of(classes);
    SegmentTables tables;
    const ValueRange span = span_of(corners, values);
    const double bin = node_distance(span);
    tables.lo = span.lo - bin;  // beyond the span nothing changes: a bin of that at either end
    tables.nodes_per_unit = 1 / bin;
    const std::size_t entries = std::size_t(k_nodes) * k_nodes;
    tables.opacity.assign(entries, 0);
    tables.color.assign(entries, 0);
    tables.visible.assign(k_nodes, 0);

    Bins bins{std::vector<Medium>(k_bins), std::vector<double>(k_nodes, 0)};
    for (int i = 0; i < k_bins; ++i) {
        const auto at = std::size_t(i);
        const double from = tables.lo + i * bin;
        bins.mean[at] = mean_medium(classes, corners, from, from + bin);
        bins.before[at + 1] = bins.before[at] + bins.mean[at].extinction;
        tables.visible[at + 1] = tables.visible[at] + (bins.mean[at].extinction > 0);
    }
    for (int i = 0; i < k_nodes; ++i) {
        const Medium here = medium_at(classes, tables.lo + i * bin);
        if (!(here.extinction > 0)) continue;
        const std::size_t at = std::size_t(i) * (k_nodes + 1);
        tables.opacity[at] = float(-std::expm1(-here.extinction * step_mm));
        tables.color[at] = pack(glm::vec3(here.glow / here.extinction));
    }
    // Long and short windows cost alike; dealing them out one by one keeps the threads even.
    parallel_for(1, k_nodes, [&](std::int64_t m) { fill_diagonal(bins, int(m), step_mm, tables); });
    return tables;
}

}  // namespace lacuna
