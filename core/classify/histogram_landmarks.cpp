#include "core/classify/histogram_landmarks.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

constexpr std::size_t k_bins = 256;
constexpr double k_prominence = 0.08;

std::vector<double> smoothed_heights(const std::vector<std::uint64_t>& counts) {
    const std::size_t bins = std::min(k_bins, counts.size());
    std::vector<double> heights(bins, 0.0);
    for (std::size_t i = 0; i < counts.size(); ++i) heights[i * bins / counts.size()] += double(counts[i]);
    for (double& h : heights) h = std::log1p(h);
    for (int pass = 0; pass < 2; ++pass) {
        std::vector<double> next = heights;
        for (std::size_t i = 0; i < bins; ++i)
            next[i] = 0.25 * (heights[i ? i - 1 : 0] + 2 * heights[i] + heights[std::min(i + 1, bins - 1)]);
        heights = std::move(next);
    }
    return heights;
}

}  // namespace

// Goes along the heights and turns round whenever they have come back by the prominence from the last extreme.
std::vector<double> histogram_landmarks(const std::vector<std::uint64_t>& counts, ValueRange range) {
    if (counts.empty() || !(range.width() > 0)) return {};
    const std::vector<double> heights = smoothed_heights(counts);
    const double least = k_prominence * *std::max_element(heights.begin(), heights.end());
    std::vector<double> found;
    if (!(least > 0)) return found;
    const auto value_of = [&](std::size_t i) {
        return range.lo + (double(i) + 0.5) / double(heights.size()) * range.width();
    };
    std::size_t highest = 0, lowest = 0;
    bool rising = true, seen_peak = false;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (heights[i] > heights[highest]) highest = i;
        if (heights[i] < heights[lowest]) lowest = i;
        if (rising && heights[i] <= heights[highest] - least) {
            found.push_back(value_of(highest));
            seen_peak = true;
            rising = false;
            lowest = i;
        } else if (!rising && heights[i] >= heights[lowest] + least) {
            found.push_back(value_of(lowest));
            rising = true;
            highest = i;
        }
    }
    if (rising && seen_peak) found.push_back(value_of(highest));  // a peak at the upper end
    return found;
}

}  // namespace lacuna
