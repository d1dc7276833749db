#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// How a window makes grey levels of values: the VOI LUT functions of DICOM PS3.3 C.11.2.1.2 and C.11.2.1.3, or a table
/// that a file brings (C.11.2.1.1).
enum class VoiFunction { linear, linear_exact, sigmoid, table };

/// A table of grey levels for values: an item of the VOI LUT Sequence, PS3.3 C.11.2.1.1.
struct VoiTable {
    std::string name;                  ///< the file's explanation; empty: it gives none
    double first = 0;                  ///< the value the first entry is for; each further one is for a value 1 higher
    std::vector<std::uint16_t> share;  ///< at least one; 0 black, 2^bits - 1 white
    int bits = 16;                     ///< 8 to 16
    double last() const { return first + double(share.size()) - 1; }
};

/// A window on values: what is shown between black and white.
struct VoiWindow {
    double center = 128, width = 256;
    VoiFunction function = VoiFunction::linear_exact;
    std::shared_ptr<const VoiTable> table = nullptr;  ///< of VoiFunction::table
    friend bool operator==(const VoiWindow&, const VoiWindow&) = default;

    /// The window whose values run from `lo` to `hi`: centre (lo + hi) / 2, width hi - lo.
    static VoiWindow of(double lo, double hi, VoiFunction function) {
        return {0.5 * (lo + hi), hi - lo, function, nullptr};
    }
};

/// The share of white, 0..1, a value is shown with, by the formulas of PS3.3 C.11.2 with y from 0 to 1:
///   LINEAR        x <= c - 0.5 - (w-1)/2: 0;  x > c - 0.5 + (w-1)/2: 1;  else (x - (c - 0.5)) / (w - 1) + 0.5
///   LINEAR_EXACT  x <= c - w/2: 0;  x > c + w/2: 1;  else (x - c) / w + 0.5
///   SIGMOID       1 / (1 + exp(-4 (x - c) / w))
///   table         its first entry at c - w/2 and below, its last at c + w/2 and above, linear between entries; with a
///                 window from the table's first value to its last this is C.11.2.1.1.
///                 No table: LINEAR_EXACT
/// The standard forbids a width under 1 for LINEAR, which is taken as 1, and one of 0 or less else, taken as a step.
/// NaN is shown black.
double voi_share(const VoiWindow& window, double value);

/// The same for a row of values in 256 grey levels, rounded to the nearest. Cost: about 1 ns a value; sigmoid 10.
/// @pre grey.size() >= values.size()
void apply_voi(const VoiWindow& window, std::span<const float> values, std::span<std::uint8_t> grey);

}  // namespace lacuna
