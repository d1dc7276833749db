#include "core/inspect/grey_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/order_statistics.h"
#include "core/base/parallel.h"

namespace lacuna::inspect {

namespace {

constexpr double k_mad_to_sigma = 1.4826;  // of a normal distribution

/// The histogram in at most 512 bins, smoothed by a triangle of 5, so that modes and valleys are no matter of chance.
struct CoarseHistogram {
    double lo = 0, width = 1;
    std::vector<double> count;

    explicit CoarseHistogram(const VolumeStatistics& s) {
        const std::size_t bins = std::min<std::size_t>(512, s.histogram.size());
        std::vector<double> raw(bins, 0);
        for (std::size_t b = 0; b < s.histogram.size(); ++b)
            raw[b * bins / s.histogram.size()] += double(s.histogram[b]);
        lo = s.histogram_range.lo;
        width = s.histogram_range.width() / double(bins);
        count = raw;
        if (bins < 128) return;  // coarse values: a bin is a value
        for (std::size_t b = 0; b < bins; ++b) {
            const auto at = [&](std::int64_t k) {
                return raw[std::size_t(std::clamp<std::int64_t>(k, 0, std::int64_t(bins) - 1))];
            };
            const auto k = std::int64_t(b);
            count[b] = (at(k - 2) + 2 * at(k - 1) + 3 * at(k) + 2 * at(k + 1) + at(k + 2)) / 9;
        }
    }
    std::size_t bin_of(double v) const {
        return std::size_t(std::clamp((v - lo) / width, 0.0, double(count.size() - 1)));
    }
    double centre(std::size_t b) const { return lo + (double(b) + 0.5) * width; }
    std::size_t mode(std::size_t first, std::size_t last) const {  // of bins [first, last]
        return std::size_t(
            std::max_element(count.begin() + std::ptrdiff_t(first), count.begin() + std::ptrdiff_t(last) + 1) -
            count.begin());
    }
};

/// The mean of the histogram's values within `half` of a mode: finer than a bin.
double refined(const VolumeStatistics& s, double mode, double half) {
    double n = 0, sum = 0;
    for (std::size_t b = 0; b < s.histogram.size(); ++b)
        if (std::abs(s.bin_centre(b) - mode) <= half) {
            n += double(s.histogram[b]);
            sum += double(s.histogram[b]) * s.bin_centre(b);
        }
    return n > 0 ? sum / n : mode;
}

double share_beyond(const VolumeStatistics& s, double limit, bool below, double* mean) {
    double n = 0, sum = 0;
    for (std::size_t b = 0; b < s.histogram.size(); ++b) {
        const double v = s.bin_centre(b);
        if (below ? v < limit : v > limit) n += double(s.histogram[b]), sum += double(s.histogram[b]) * v;
    }
    if (mean) *mean = n > 0 ? sum / n : 0;
    return n;
}

/// One population and what sticks out of it.
GreyLevels one_population(const VolumeStatistics& s, const CoarseHistogram& h) {
    GreyLevels levels;
    const std::size_t peak = h.mode(0, h.count.size() - 1);
    const double mode = h.centre(peak);
    double half = h.width;  // half width at 60 % of the peak: one standard deviation
    for (std::size_t b = peak; b < h.count.size() && h.count[b] > 0.6 * h.count[peak]; ++b)
        half = std::max(half, h.centre(b) - mode + h.width);
    double deep = 0;
    const double below = share_beyond(s, mode - 6 * half, true, &deep);
    const double above = share_beyond(s, mode + 6 * half, false, nullptr);
    levels.material = refined(s, mode, half);
    if (below >= 8 && below > above) {
        levels.has_material = true;
        levels.air = std::min(deep, s.range.lo + 0.2 * (mode - s.range.lo));
        levels.threshold = (levels.air + levels.material) / 2;
        levels.noise = half;
        return levels;
    }
    levels.air = levels.material;
    levels.threshold = s.range.hi;
    levels.why_not = "The values form one population: there is no material that stands out from air.";
    return levels;
}

/// The median of the histogram's values on one side: where a detector's or a file's range clips, the mode is the
/// clipped end, and the median still the middle.
double side_median(const VolumeStatistics& s, double threshold, bool below) {
    double total = 0, seen = 0;
    const auto on_side = [&](std::size_t b) { return (s.bin_centre(b) < threshold) == below; };
    for (std::size_t b = 0; b < s.histogram.size(); ++b)
        if (on_side(b)) total += double(s.histogram[b]);
    for (std::size_t b = 0; b < s.histogram.size(); ++b)
        if (on_side(b) && (seen += double(s.histogram[b])) >= total / 2) return s.bin_centre(b);
    return threshold;
}

}  // namespace

GreyLevels find_levels(const Volume& volume, const VolumeStatistics& statistics) {
    GreyLevels levels;
    if (!(statistics.range.width() > 0)) {
        levels.why_not = statistics.histogram.empty() ? "The volume holds no finite value."
                                                      : "All values of the volume are the same.";
        levels.air = levels.material = levels.threshold = statistics.range.lo;
        return levels;
    }
    const CoarseHistogram h(statistics);
    const double otsu = otsu_threshold(statistics);
    const std::size_t cut = std::clamp<std::size_t>(h.bin_of(otsu), 1, h.count.size() - 1);
    const std::size_t low = h.mode(0, cut - 1), high = h.mode(cut, h.count.size() - 1);
    const double valley =
        *std::min_element(h.count.begin() + std::ptrdiff_t(low), h.count.begin() + std::ptrdiff_t(high) + 1);
    const bool two_values = statistics.histogram.size() == 2;
    if (!two_values && valley > 0.7 * std::min(h.count[low], h.count[high])) return one_population(statistics, h);
    levels.has_material = true;
    const double near = std::max(0.05 * (h.centre(high) - h.centre(low)), h.width);
    levels.air = refined(statistics, h.centre(low), near);
    levels.material = refined(statistics, h.centre(high), near);
    if (low < 2) levels.air = side_median(statistics, otsu, true);
    if (high + 2 >= h.count.size()) levels.material = side_median(statistics, otsu, false);
    levels.threshold = otsu;
    if (!(otsu > levels.air && otsu < levels.material)) levels.threshold = (levels.air + levels.material) / 2;
    levels.noise = measure_noise(volume, levels.threshold);
    return levels;
}

double measure_noise(const Volume& volume, double threshold) {
    const glm::ivec3 size = volume.geometry().size;
    constexpr std::int64_t k_samples = 2'000'000;
    constexpr int k_apart = 3;
    const std::int64_t rows = std::int64_t(size.y) * size.z;
    // Whole rows in an even stride, so that the same ones are taken every time.
    const std::int64_t stride = std::max<std::int64_t>(1, rows * size.x / (4 * k_samples));
    std::vector<double> differences;
    visit_type(volume.type(), [&](auto tag) {
        const auto view = volume.view<decltype(tag)>();
        for (std::int64_t r = 0; r < rows && std::int64_t(differences.size()) < k_samples; r += stride) {
            const auto* row = view.row(int(r % size.y), int(r / size.y));
            int inside = 0;  // material voxels in a row so far
            for (int x = 0; x < size.x; ++x) {
                inside = double(row[x]) >= threshold && std::isfinite(double(row[x])) ? inside + 1 : 0;
                // Two more on each side keep the blurred edge out.
                if (inside < k_apart + 5) continue;
                differences.push_back(std::abs(double(row[x - 2]) - double(row[x - 2 - k_apart])));
            }
        }
    });
    if (differences.size() < 16) return 0;
    return k_mad_to_sigma * median(std::move(differences)) / std::sqrt(2.0);
}

namespace {

struct EdgeProbe {
    const GreyLevels& levels;
    glm::dvec3 spacing;
    glm::ivec3 size;
    std::vector<double> squared_sigma_mm2;

    /// An edge between voxel p and p + step along an axis; `at` reads a value, the border's beyond it.
    template <class At>
    void look(const glm::ivec3& p, int axis, const At& at) {
        glm::ivec3 step(0);
        step[axis] = 1;
        const double cosine_here = cosine(p, axis, at);
        if (!(cosine_here > 0.95)) return;
        const bool rising = at(p + step) > at(p);
        const glm::ivec3 low = rising ? p : p + step, high = rising ? p + step : p;
        const double down = walk(low, low - high, levels.air + 0.1587 * levels.contrast(), -1, high, at);
        const double up = walk(high, high - low, levels.air + 0.8413 * levels.contrast(), 1, low, at);
        const double h = spacing[axis], half = 0.5 * (down + up - 1) * h * cosine_here;
        if (!(half > 0)) return;
        squared_sigma_mm2.push_back(half * half - h * h / 6);  // linear interpolation is a triangle of that variance
    }

    /// Samples from `before`, the voxel across the edge, to where the level is passed, straight on from p without
    /// turning back; NaN if that is not within 5.
    template <class At>
    static double walk(glm::ivec3 p, const glm::ivec3& step, double level, double sign, const glm::ivec3& before,
                       const At& at) {
        double last = at(before);
        for (int k = 0; k < 5; ++k, p += step) {
            const double value = at(p);
            if (!(sign * (value - last) >= 0)) break;
            if (sign * (value - level) >= 0) return k + (level - last) / (value - last);
            last = value;
        }
        return std::numeric_limits<double>::quiet_NaN();
    }

    template <class At>
    double cosine(const glm::ivec3& p, int axis, const At& at) const {
        glm::dvec3 gradient(0);
        for (int a = 0; a < 3; ++a) {
            if (size[a] == 1) continue;
            glm::ivec3 step(0), across(0);
            step[a] = 1, across[axis] = 1;
            if (a == axis)
                gradient[a] = (at(p + step) - at(p)) / spacing[a];
            else
                gradient[a] =
                    (at(p + step) + at(p + step + across) - at(p - step) - at(p - step + across)) / (4 * spacing[a]);
        }
        return std::abs(gradient[axis]) / glm::length(gradient);
    }
};

}  // namespace

double measure_edge_width(const Volume& volume, const GreyLevels& levels, const JobContext& job) {
    const glm::ivec3 size = volume.geometry().size;
    EdgeProbe probe{levels, volume.geometry().spacing, size, {}};
    constexpr std::size_t k_enough = 200'000;
    constexpr int k_slices = 48;  // spread evenly; edges across z are looked at between each and the next
    const double level = (levels.air + levels.material) / 2;
    visit_type(volume.type(), [&](auto tag) {
        const auto view = volume.view<decltype(tag)>();
        const auto at = [&](const glm::ivec3& p) {
            const glm::ivec3 q = glm::clamp(p, glm::ivec3(0), size - 1);
            return double(view(q.x, q.y, q.z));
        };
        for (int i = 0; i < std::min(size.z, k_slices) && probe.squared_sigma_mm2.size() < k_enough; ++i) {
            const int z = int((std::int64_t(2 * i + 1) * size.z) / (2 * std::min(size.z, k_slices)));
            job.check();
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const bool here = at({x, y, z}) >= level;
                    if (x + 1 < size.x && (at({x + 1, y, z}) >= level) != here) probe.look({x, y, z}, 0, at);
                    if (y + 1 < size.y && (at({x, y + 1, z}) >= level) != here) probe.look({x, y, z}, 1, at);
                    if (z + 1 < size.z && (at({x, y, z + 1}) >= level) != here) probe.look({x, y, z}, 2, at);
                }
        }
    });
    if (probe.squared_sigma_mm2.empty()) return std::numeric_limits<double>::quiet_NaN();
    return std::sqrt(std::max(0.0, median(std::move(probe.squared_sigma_mm2))));
}

}  // namespace lacuna::inspect
