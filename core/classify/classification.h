#pragma once

#include <optional>
#include <vector>

#include "core/classify/transfer_function.h"

namespace lacuna {

/// A segmentation range: values inside [lo, hi] are kept, both ends included.
struct SegmentationRange {
    std::string name;
    ValueRange range;
    std::optional<TransferFunction> tf;  ///< its own inside the range; else the scene's
    friend bool operator==(const SegmentationRange&, const SegmentationRange&) = default;
};

/// What of the values is visible, and how: a transfer function and segmentation ranges. With ranges, values outside
/// all of them are transparent; where ranges overlap, the first in the list counts.
struct Classification {
    TransferFunction tf;
    std::vector<SegmentationRange> ranges;  ///< at most k_max_ranges

    static constexpr std::size_t k_max_ranges = 8;

    /// Index of the first range that contains the value, or -1; with no ranges always -1.
    int range_of(double value) const;
    /// True if the ranges (not the opacity) let this value through. NaN: false.
    bool in_ranges(double value) const;
    /// Whether what is seen of a value depends on the gradient there, by any of the functions.
    bool uses_gradient() const;
    /// The function that counts for a value: its range's own, else the scene's.
    const TransferFunction& function_of(double value) const;
    /// TransferFunction::at of the function that counts; opacity 0 outside the ranges and for NaN.
    ColorOpacity at(double value) const;
    friend bool operator==(const Classification&, const Classification&) = default;
};

/// Signed "inside" measure of an isosurface under ranges: inside where >= 0. Without ranges value - iso; with them the
/// largest over the ranges of min(value - max(iso, lo), hi - value). Continuous in the value; NaN stays NaN.
double iso_measure(const Classification& classification, double iso, double value);

/// O(1) answers about closed value ranges, from prefix sums over a table of the value axis (Levoy 1988 and Lesar 2015
/// use the same idea). Conservative: quantisation may turn "none" or "all" into "some", never the reverse.
class VisibilityTable {
public:
    enum class Answer : std::uint8_t { none = 0, all = 1, some = 2 };

    /// A value counts as visible when its opacity under the classification is above 0, at some gradient magnitude.
    static VisibilityTable of_opacity(const Classification& classification, ValueRange values);
    /// A value counts as visible when it lies inside the isosurface: iso_measure >= 0.
    static VisibilityTable of_iso(const Classification& classification, double iso, ValueRange values);
    /// A value counts as visible when the ranges let it through (MIP family).
    static VisibilityTable of_ranges(const Classification& classification, ValueRange values);

    /// How much of [range.lo, range.hi] is visible; an empty range (lo > hi: only NaN voxels) is none.
    Answer query(ValueRange range) const;

private:
    template <class Visible>
    static VisibilityTable build(ValueRange values, Visible&& any_and_all);
    ValueRange values_;
    double bins_per_unit_ = 0;
    std::vector<std::uint32_t> any_, gap_;  ///< prefix counts of bins holding something visible / something invisible
};

}  // namespace lacuna
