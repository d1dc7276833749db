#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/classify/classification.h"

namespace lacuna {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_most_bins = 65536;
constexpr double k_float_bins = 16384;

/// Bins of the table's own range. Volumes of whole numbers get a whole number of bins a value (at most 16: beyond
/// that nothing is gained and the table leaves the cache), all others a fixed number.
double bins_for(ValueRange values) {
    const double width = values.width();
    if (!(width > 0)) return 1;
    const bool whole = std::floor(values.lo) == values.lo && std::floor(values.hi) == values.hi;
    if (!whole || width > k_most_bins) return k_float_bins;
    return width * std::clamp(std::floor(k_most_bins / width), 1.0, 16.0);
}

/// The value axis cut at every place where visibility can change. Between two cuts it is constant, so that the cuts
/// and one value between each two tell everything there is to know.
template <class Visible>
struct CutAxis {
    std::vector<double> cuts;
    Visible visible;

    /// Calls piece(lo, hi, visible) for pieces that cover the whole axis.
    template <class Piece>
    void for_each_piece(Piece&& piece) {
        std::erase_if(cuts, [](double v) { return !std::isfinite(v); });
        std::sort(cuts.begin(), cuts.end());
        cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
        if (cuts.empty()) return piece(-k_infinity, k_infinity, visible(0.0));
        const auto beyond = [](double v) { return std::max(1.0, std::abs(v)); };
        piece(-k_infinity, cuts.front(), visible(cuts.front() - beyond(cuts.front())));
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            piece(cuts[i], cuts[i], visible(cuts[i]));
            if (i + 1 == cuts.size()) break;
            const double middle = cuts[i] + 0.5 * (cuts[i + 1] - cuts[i]);
            if (middle > cuts[i] && middle < cuts[i + 1]) piece(cuts[i], cuts[i + 1], visible(middle));
        }
        piece(cuts.back(), k_infinity, visible(cuts.back() + beyond(cuts.back())));
    }
};

void add_range_cuts(std::vector<double>& cuts, const Classification& classification) {
    for (const SegmentationRange& r : classification.ranges) {
        cuts.push_back(r.range.lo);
        cuts.push_back(r.range.hi);
    }
}

void add_point_cuts(std::vector<double>& cuts, const TransferFunction& tf) {
    for (const TransferPoint& p : tf.points) cuts.push_back(p.value);
    if (!tf.is_2d()) return;
    for (const TransferShape& shape : tf.shapes) {
        // Seen is one stretch of values. With soft sides its ends are open; a side that meets another in a point can
        // open or close it there, so that all corners are cuts.
        for (const ValueRange& side : {shape.at_lo, shape.at_hi}) cuts.insert(cuts.end(), {side.lo, side.hi});
    }
}

}  // namespace

// Slot 0 stands for everything below values_.lo, slots 1..n for the n bins of the range, slot n+1 for everything above
// values_.hi: a query outside the range is answered soundly, if coarsely.
template <class Visible>
VisibilityTable VisibilityTable::build(ValueRange values, Visible&& axis) {
    VisibilityTable table;
    const bool sound =
        std::isfinite(values.lo) && std::isfinite(values.hi) && values.lo <= values.hi && std::isfinite(values.width());
    table.values_ = sound ? values : ValueRange{0, 0};
    const double bins = bins_for(table.values_);
    table.bins_per_unit_ = table.values_.width() > 0 ? bins / table.values_.width() : 0;
    const std::size_t slots = std::size_t(bins) + 2;
    table.any_.assign(slots + 1, 0);
    table.gap_.assign(slots + 1, 0);

    const double lo = table.values_.lo, hi = table.values_.hi;
    const auto slot_of = [&](double v) {
        return std::size_t(1 + std::clamp(std::floor((v - lo) * table.bins_per_unit_), 0.0, bins - 1));
    };
    axis.for_each_piece([&](double from, double to, bool visible) {
        std::vector<std::uint32_t>& marks = visible ? table.any_ : table.gap_;
        if (from < lo) marks[1] = 1;
        if (to > hi) marks[slots] = 1;
        if (to < lo || from > hi) return;
        // An open piece that only touches the range from outside has no value in it.
        if (from < to && (to <= lo || from >= hi)) return;
        const std::size_t first = slot_of(std::max(from, lo)), last = slot_of(std::min(to, hi));
        std::fill(marks.begin() + std::ptrdiff_t(first + 1), marks.begin() + std::ptrdiff_t(last + 2), 1u);
    });
    for (std::size_t s = 0; s < slots; ++s) {
        table.any_[s + 1] += table.any_[s];
        table.gap_[s + 1] += table.gap_[s];
    }
    return table;
}

VisibilityTable VisibilityTable::of_opacity(const Classification& classification, ValueRange values) {
    CutAxis axis{{}, [&](double v) { return classification.at(v).opacity > 0; }};
    add_range_cuts(axis.cuts, classification);
    add_point_cuts(axis.cuts, classification.tf);
    for (const SegmentationRange& r : classification.ranges)
        if (r.tf) add_point_cuts(axis.cuts, *r.tf);
    return build(values, axis);
}

VisibilityTable VisibilityTable::of_iso(const Classification& classification, double iso, ValueRange values) {
    CutAxis axis{{}, [&](double v) { return iso_measure(classification, iso, v) >= 0; }};
    add_range_cuts(axis.cuts, classification);
    axis.cuts.push_back(iso);
    return build(values, axis);
}

VisibilityTable VisibilityTable::of_ranges(const Classification& classification, ValueRange values) {
    CutAxis axis{{}, [&](double v) { return classification.in_ranges(v); }};
    add_range_cuts(axis.cuts, classification);
    return build(values, axis);
}

VisibilityTable::Answer VisibilityTable::query(ValueRange range) const {
    if (range.lo > range.hi || any_.empty()) return Answer::none;
    if (!(range.lo <= range.hi)) return Answer::some;  // a NaN bound: nothing is certain
    const std::size_t slots = any_.size() - 1;
    const double bins = double(slots - 2);
    // One bin wider on either side: interpolation and the bin's own arithmetic round.
    const auto slot_of = [&](double v, double widen) {
        return std::size_t(1 + std::clamp(std::floor((v - values_.lo) * bins_per_unit_) + widen, 0.0, bins - 1));
    };
    const std::size_t first = range.lo < values_.lo ? 0 : range.lo > values_.hi ? slots - 1 : slot_of(range.lo, -1);
    const std::size_t last = range.hi > values_.hi ? slots - 1 : range.hi < values_.lo ? 0 : slot_of(range.hi, 1);
    if (any_[last + 1] == any_[first]) return Answer::none;
    if (gap_[last + 1] == gap_[first]) return Answer::all;
    return Answer::some;
}

}  // namespace lacuna
