#include "core/accuracy/scene_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/base/parallel.h"
#include "core/classify/opacity_peaks.h"

namespace lacuna {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_spot_levels = 2;  // of 255: what stands out by less is not called a spot

/// Values at which a classification changes its course.
std::vector<double> corners_of(const Classification& classes) {
    std::vector<double> corners;
    const auto add = [&](const TransferFunction& tf) {
        for (const TransferPoint& p : tf.points) corners.push_back(p.value);
        for (const TransferShape& shape : tf.shapes)
            for (const double value : {shape.at_lo.lo, shape.at_lo.hi, shape.at_hi.lo, shape.at_hi.hi})
                corners.push_back(value);
    };
    add(classes.tf);
    for (const SegmentationRange& r : classes.ranges) {
        if (r.tf) add(*r.tf);
        for (const double end : {r.range.lo, r.range.hi})
            if (std::isfinite(end)) corners.push_back(end);
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// The values with opacity, as few intervals: between two corners all or none have it.
std::vector<ValueRange> visible_values(const Classification& classes) {
    const std::vector<double> corners = corners_of(classes);
    std::vector<ValueRange> visible;
    const auto add = [&](double lo, double hi, double inside) {
        if (!(classes.at(inside).opacity > 0)) return;
        if (!visible.empty() && visible.back().hi == lo)
            visible.back().hi = hi;
        else
            visible.push_back({lo, hi});
    };
    if (corners.empty()) return visible;
    const double reach = 1 + std::fabs(corners.front()) + std::fabs(corners.back());
    add(-k_infinity, corners.front(), corners.front() - reach);
    for (std::size_t i = 1; i < corners.size(); ++i)
        add(corners[i - 1], corners[i], 0.5 * (corners[i - 1] + corners[i]));
    add(corners.back(), k_infinity, corners.back() + reach);
    return visible;
}

const ValueRange* range_holding(const std::vector<ValueRange>& ranges, double value) {
    for (const ValueRange& r : ranges)
        if (r.contains(value)) return &r;
    return nullptr;
}

void join(ThicknessCounts& all, const ThicknessCounts& part) {
    for (std::size_t i = 0; i < all.thin.size(); ++i) all.thin[i] += part.thin[i];
    all.places += part.places;
}

/// What is counted in one slice, by the scene's mode.
template <class T>
class Counter {
public:
    Counter(const Scene& scene)
        : scene_(scene),
          view_(scene.volume.view<T>()),
          size_(view_.size),
          spacing_(scene.volume.geometry().spacing / scene.volume.geometry().smallest_spacing_mm()),
          peaks_(opacity_peaks(scene.classification)),
          visible_(visible_values(scene.classification)),
          level_(std::fabs(scene.window.width()) / 255) {}

    void slice(int z, SceneFacts& facts) const {
        const bool surface = scene_.mode == ViewMode::iso || scene_.mode == ViewMode::shear_warp;
        const bool opacity = scene_.mode == ViewMode::ea;
        const bool extremes =
            scene_.mode == ViewMode::mip || scene_.mode == ViewMode::lmip || scene_.mode == ViewMode::minip;
        for (int y = 0; y < size_.y; ++y)
            for (int x = 0; x < size_.x; ++x) {
                const double value = double(view_(x, y, z));
                ++facts.voxels;
                if (!std::isfinite(value)) {
                    ++facts.not_finite;
                    continue;
                }
                facts.range.lo = std::min(facts.range.lo, value);
                facts.range.hi = std::max(facts.range.hi, value);
                if (x + 1 < size_.x) facts.equal_pairs += view_(x + 1, y, z) == view_(x, y, z);
                const glm::ivec3 at(x, y, z);
                if (surface) wall(at, iso_measure(scene_.classification, scene_.iso, value), facts);
                if (opacity) {
                    layer(at, value, facts);
                    shell(at, value, facts);
                }
                if (extremes) spot(at, value, facts);
            }
    }

private:
    /// The neighbour's value, NaN where there is none or it is none.
    double beside(glm::ivec3 at, int axis, int way) const {
        at[axis] += way;
        if (at[axis] < 0 || at[axis] >= size_[axis]) return k_nan;
        const double value = double(view_(at.x, at.y, at.z));
        return std::isfinite(value) ? value : k_nan;
    }

    /// Along an axis the signal is linear from voxel to voxel; beyond the volume and beside voxels that are no numbers
    /// half a spacing counts.
    void wall(const glm::ivec3& at, double inside, SceneFacts& facts) const {
        if (!(inside >= 0)) return;
        ++facts.shown;
        double thinnest = k_infinity;
        int across = 0;
        bool at_surface = false;
        for (int axis = 0; axis < 3; ++axis) {
            double reach = 0;
            int sides = 0;
            for (const int way : {-1, 1}) {
                const double next = iso_measure(scene_.classification, scene_.iso, beside(at, axis, way));
                if (next >= 0) continue;
                reach += next < 0 ? inside / (inside - next) : 0.5;
                ++sides;
            }
            at_surface = at_surface || sides > 0;
            if (sides < 2) continue;
            ++across;
            thinnest = std::min(thinnest, reach * spacing_[axis]);
        }
        facts.walls.places += at_surface;
        if (across > 0) facts.walls.add(thinnest);
        facts.wires += across >= 2;
    }

    /// How far from the voxel towards its neighbour values stay visible, as a share of their distance.
    double visible_reach(const ValueRange& visible, double value, double next) const {
        if (next < visible.lo) return (value - visible.lo) / (value - next);
        if (next > visible.hi) return (visible.hi - value) / (next - value);
        return 0.5;  // the volume's end, or no number
    }

    void layer(const glm::ivec3& at, double value, SceneFacts& facts) const {
        const ValueRange* visible = range_holding(visible_, value);
        if (!visible) return;
        ++facts.shown;
        double thinnest = k_infinity;
        int across = 0;
        bool at_surface = false;
        for (int axis = 0; axis < 3; ++axis) {
            const double before = beside(at, axis, -1), behind = beside(at, axis, 1);
            const int sides = !range_holding(visible_, before) + !range_holding(visible_, behind);
            at_surface = at_surface || sides > 0;
            if (sides < 2) continue;
            ++across;
            thinnest = std::min(thinnest, spacing_[axis] * (visible_reach(*visible, value, before) +
                                                            visible_reach(*visible, value, behind)));
        }
        facts.walls.places += at_surface;
        if (across > 0) facts.walls.add(thinnest);
        facts.wires += across >= 2;
    }

    void shell(const glm::ivec3& at, double value, SceneFacts& facts) const {
        for (int axis = 0; axis < 3; ++axis) {
            const double next = beside(at, axis, 1);
            if (!(next < value) && !(next > value)) continue;
            const double lo = std::min(value, next), hi = std::max(value, next);
            for (const ValueRange& peak : peaks_) {
                if (!(hi > peak.lo && lo < peak.hi)) continue;
                ++facts.shells.places;
                if (lo < peak.lo && hi > peak.hi) facts.shells.add(peak.width() / (hi - lo) * spacing_[axis]);
            }
        }
    }

    void spot(const glm::ivec3& at, double value, SceneFacts& facts) const {
        const double sign = scene_.mode == ViewMode::minip ? -1 : 1;
        if (!scene_.classification.in_ranges(value)) return;
        double height = k_infinity;
        int across = 0;
        for (int axis = 0; axis < 3; ++axis) {
            double least = k_infinity;
            for (const int way : {-1, 1}) {
                const double next = beside(at, axis, way);
                if (!std::isnan(next)) least = std::min(least, sign * (value - next));
            }
            across += least > k_spot_levels * level_ && least < k_infinity;
            height = std::min(height, least);
        }
        facts.wires += across >= 2;
        if (!(height > k_spot_levels * level_) || height == k_infinity) return;
        ++facts.spots;
        facts.spot_height = std::max(facts.spot_height, height);
    }

    const Scene& scene_;
    VolumeView<T> view_;
    glm::ivec3 size_;
    glm::dvec3 spacing_;  // in smallest spacings
    std::vector<ValueRange> peaks_, visible_;
    double level_;
};

void join(SceneFacts& all, const SceneFacts& part) {
    all.voxels += part.voxels;
    all.not_finite += part.not_finite;
    all.range = {std::min(all.range.lo, part.range.lo), std::max(all.range.hi, part.range.hi)};
    join(all.walls, part.walls);
    join(all.shells, part.shells);
    all.shown += part.shown;
    all.wires += part.wires;
    all.spots += part.spots;
    all.spot_height = std::max(all.spot_height, part.spot_height);
    all.equal_pairs += part.equal_pairs;
}

template <class T>
void count(const Scene& scene, SceneFacts& facts, const JobContext& job) {
    const Counter<T> counter(scene);
    std::mutex mutex;
    parallel_for(
        0, scene.volume.geometry().size.z,
        [&](std::int64_t z) {
            SceneFacts part;
            part.range = {k_infinity, -k_infinity};
            counter.slice(int(z), part);
            const std::scoped_lock lock(mutex);
            join(facts, part);
        },
        job);
}

}  // namespace

void ThicknessCounts::add(double thickness) {
    const double bin = thickness / k_bin;
    if (bin < k_bins) ++thin[std::size_t(std::max(0.0, bin))];
}

double ThicknessCounts::missed(double step) const {
    if (places == 0) return 0;
    double count = 0;
    for (int i = 0; i < k_bins; ++i)
        count += double(thin[std::size_t(i)]) * std::max(0.0, 1 - (i + 0.5) * k_bin / step);
    return count / double(places);
}

std::int64_t ThicknessCounts::thinner_than(double step) const {
    std::int64_t count = 0;
    for (int i = 0; i < k_bins && (i + 1) * k_bin <= step + 1e-9; ++i) count += thin[std::size_t(i)];
    return count;
}

SceneFacts measure_facts(const Scene& scene, const JobContext& job) {
    SceneFacts facts;
    const glm::dvec3 spacing = scene.volume.geometry().spacing;
    facts.anisotropy = std::max({spacing.x, spacing.y, spacing.z}) / scene.volume.geometry().smallest_spacing_mm();
    facts.narrowest = narrowest_peak(scene.classification);
    const std::vector<double> corners = corners_of(scene.classification);
    if (!corners.empty()) facts.peaks_span = corners.back() - corners.front();
    if (!scene.volume.in_memory()) return facts;
    facts.voxels_seen = true;
    facts.range = {k_infinity, -k_infinity};
    switch (scene.volume.type()) {
        case VoxelType::u8:
            count<std::uint8_t>(scene, facts, job);
            break;
        case VoxelType::i8:
            count<std::int8_t>(scene, facts, job);
            break;
        case VoxelType::u16:
            count<std::uint16_t>(scene, facts, job);
            break;
        case VoxelType::i16:
            count<std::int16_t>(scene, facts, job);
            break;
        case VoxelType::f32:
            count<float>(scene, facts, job);
            break;
    }
    if (!(facts.range.hi >= facts.range.lo)) facts.range = {0, 0};
    return facts;
}

}  // namespace lacuna
