#include "core/inspect/stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/order_statistics.h"
#include "core/regions/part_outline.h"

namespace lacuna::inspect {

namespace {

constexpr int k_points = 17;
constexpr double k_first = 0.2, k_last = 0.8;  ///< of the contrast
constexpr double k_steady = 0.1;               ///< share by which a count may stray from the stretch's middle
constexpr double k_shortest = 0.15;            ///< of the contrast
constexpr double k_slope = 1.5;                ///< times the least slope of porosity

bool is_steady(const std::vector<double>& counts, std::size_t first, std::size_t last) {
    const auto [lo, hi] =
        std::minmax_element(counts.begin() + std::ptrdiff_t(first), counts.begin() + std::ptrdiff_t(last) + 1);
    const double middle = (*lo + *hi) / 2;
    return *hi - middle <= std::max(k_steady * middle, 0.5);
}

/// Slopes of porosity between neighbouring points, per point's width, each the median of five: a slope is a count of
/// the voxels between two thresholds, and the least of sixteen single ones would be a chance low, not the flattest
/// place.
std::vector<double> slopes_of(const std::vector<double>& porosity) {
    std::vector<double> raw, slopes;
    for (std::size_t k = 1; k < porosity.size(); ++k) raw.push_back(std::abs(porosity[k] - porosity[k - 1]));
    const int n = int(raw.size());
    for (int k = 0; k < n; ++k) {
        std::array<double, 5> near;
        for (int i = 0; i < 5; ++i) near[std::size_t(i)] = raw[std::size_t(std::clamp(k + i - 2, 0, n - 1))];
        slopes.push_back(median(near));
    }
    return slopes;
}

}  // namespace

double StabilitySweep::part_voxels_at(double threshold) const {
    const std::vector<double>& t = curve.threshold;
    if (t.empty()) return 0;
    if (!(threshold > t.front())) return part_voxels.front();
    if (!(threshold < t.back())) return part_voxels.back();
    const auto k = std::size_t(std::upper_bound(t.begin(), t.end(), threshold) - t.begin());
    const double share = (threshold - t[k - 1]) / (t[k] - t[k - 1]);
    return part_voxels[k - 1] + share * (part_voxels[k] - part_voxels[k - 1]);
}

ValueRange find_plateau(const StabilityCurve& curve, double contrast) {
    ValueRange best{0, -1};
    const std::vector<double> slopes = slopes_of(curve.porosity_percent);
    if (slopes.empty()) return best;
    const double limit = k_slope * *std::min_element(slopes.begin(), slopes.end()) + 1e-12;
    for (std::size_t first = 0; first < slopes.size(); ++first)
        for (std::size_t last = first + 1; last <= slopes.size() && slopes[last - 1] <= limit; ++last) {
            if (!is_steady(curve.count, first, last)) break;
            const double length = curve.threshold[last] - curve.threshold[first];
            // Of two equally long ones the first stands: rounding must not choose.
            if (length >= k_shortest * contrast * (1 - 1e-9) && length > best.width() + 1e-9 * contrast)
                best = {curve.threshold[first], curve.threshold[last]};
        }
    return best;
}

StabilitySweep sweep_thresholds(const Volume& volume, const GreyLevels& levels, bool filled, Connectivity connectivity,
                                std::int64_t min_voxels, const JobContext& job) {
    StabilitySweep sweep;
    for (int i = 0; i < k_points; ++i) {
        const JobContext step = job.part(double(i) / k_points, double(i + 1) / k_points);
        const double t = levels.air + levels.contrast() * (k_first + (k_last - k_first) * i / (k_points - 1));
        const outline::VoidScan scan = outline::scan_voids(volume, t, filled, connectivity, step.part(0, 0.7));
        const outline::PartRuns part = outline::find_part(scan, connectivity, step.part(0.7, 0.9));
        double count = 0, voids = 0;
        for (std::size_t c = 0; c < scan.kind.size(); ++c) {
            if (scan.kind[c] == outline::Space::outside || scan.components.voxels[c] < std::uint64_t(min_voxels))
                continue;
            count += 1;
            voids += double(scan.components.voxels[c]);
        }
        sweep.curve.threshold.push_back(t);
        sweep.curve.porosity_percent.push_back(part.voxels > 0 ? 100 * voids / double(part.voxels) : 0);
        sweep.curve.count.push_back(count);
        sweep.curve.euler.push_back(double(outline::euler_of_voids(scan, connectivity, min_voxels)));
        sweep.part_voxels.push_back(double(part.voxels));
    }
    sweep.curve.plateau = find_plateau(sweep.curve, levels.contrast());
    return sweep;
}

}  // namespace lacuna::inspect
