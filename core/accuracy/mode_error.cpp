#include "core/accuracy/mode_error.h"

#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace lacuna {

namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();

void check_sizes(const Frame& frame, const Frame& reference) {
    if (frame.size != reference.size || frame.color.size() != reference.color.size() ||
        frame.depth_mm.size() != reference.depth_mm.size())
        throw Error(Errc::bad_usage, "Only pictures of the same size can be compared.");
}

}  // namespace

SurfaceError compare_surfaces(const Frame& frame, const Frame& reference, double voxel_mm) {
    check_sizes(frame, reference);
    if (!(voxel_mm > 0)) throw Error(Errc::bad_usage, "A voxel's size must be above 0.");
    SurfaceError error;
    double sum = 0, squares = 0;
    bool unknown = false;
    for (std::size_t i = 0; i < frame.depth_mm.size(); ++i) {
        const double depth = frame.depth_mm[i], truth = reference.depth_mm[i];
        unknown = unknown || std::isnan(depth) || std::isnan(truth);
        const bool hit = depth < k_infinite, hit_truly = truth < k_infinite;
        error.missed += hit_truly && !hit;
        error.false_hits += hit && !hit_truly;
        if (!hit || !hit_truly) continue;
        const double difference = std::fabs(depth - truth) / voxel_mm;
        ++error.both;
        error.over_one_voxel += difference > 1;
        error.max_voxels = std::fmax(error.max_voxels, difference);
        sum += difference;
        squares += difference * difference;
    }
    if (error.both > 0) {
        error.mean_voxels = sum / double(error.both);
        error.rms_voxels = std::sqrt(squares / double(error.both));
    }
    if (unknown) error.max_voxels = error.mean_voxels = error.rms_voxels = k_infinite;
    return error;
}

ProjectionError compare_projections(const Frame& frame, const Frame& reference, const ValueRange& window,
                                    bool smallest) {
    check_sizes(frame, reference);
    ProjectionError error;
    bool unknown = false;
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        // A ray without a sample is clear; where only one of the pictures is, it counts as the window's black.
        const double value = frame.color[i].r, truth = reference.color[i].r;
        const double short_by = window.width() * (smallest ? value - truth : truth - value);
        unknown = unknown || std::isnan(short_by);
        error.max_undershoot = std::fmax(error.max_undershoot, short_by);
        error.max_overshoot = std::fmax(error.max_overshoot, -short_by);
        error.mean_undershoot += std::fmax(short_by, 0) / double(frame.color.size());
        error.pixels += short_by > window.width() / 65535;
    }
    if (unknown) error.max_undershoot = error.mean_undershoot = error.max_overshoot = k_infinite;
    return error;
}

}  // namespace lacuna
