// Monte-Carlo ambient occlusion at the hit: the share of the hemisphere, weighted by the cosine, that is free within a
// distance (the accessibility integral, methods.md section 1).

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/parallel.h"
#include "core/render/effect_passes.h"
#include "core/render/reference_sampler.h"

namespace lacuna::effects {

namespace {

constexpr double k_default_distance = 0.1;  // of the volume's diameter
constexpr int k_most_steps = 64;            // a ray
constexpr int k_first_samples = 2;          // of the first picture on the way
constexpr double k_lift_voxels = 0.75;      // off the surface, along its normal, against meeting it again
constexpr double k_opaque = 0.98;           // an EA ray this occluded is over
constexpr double k_face_voxels = 0.01;      // a hit this near to a cut or a side of the volume lies on it

/// Opacity of one step at a value, read from a table of the value axis between the ends of all points and ranges;
/// beyond them the classification does not change.
class StepOpacity {
public:
    StepOpacity(const Classification& classes, double step_mm) {
        double lo = std::numeric_limits<double>::infinity(), hi = -lo;
        const auto cover = [&](double v) {
            lo = std::min(lo, v);
            hi = std::max(hi, v);
        };
        const auto cover_points = [&](const TransferFunction& tf) {
            cover(tf.extent().lo);
            cover(tf.extent().hi);
        };
        cover_points(classes.tf);
        for (const SegmentationRange& range : classes.ranges) {
            if (std::isfinite(range.range.lo)) cover(range.range.lo);
            if (std::isfinite(range.range.hi)) cover(range.range.hi);
            if (range.tf) cover_points(*range.tf);
        }
        const double margin = std::max(1e-3 * (hi - lo), 1e-6 * std::max(std::fabs(lo), std::fabs(hi)) + 1e-9);
        lo_ = lo - margin;  // the first and last entry stand for all beyond
        per_value_ = (k_bins - 1) / (hi + margin - lo_);
        for (int i = 0; i < k_bins; ++i) {
            const double value = lo_ + i / per_value_;
            const double unit_mm = classes.function_of(value).unit_distance_mm;
            table_[std::size_t(i)] = float(correct_opacity(classes.at(value).opacity, step_mm, unit_mm));
        }
    }
    double at(double value) const {
        const double bin = std::clamp((value - lo_) * per_value_, 0.0, double(k_bins - 1));
        return double(table_[std::size_t(bin + 0.5)]);
    }

private:
    static constexpr int k_bins = 8192;
    double lo_ = 0, per_value_ = 1;
    std::vector<float> table_ = std::vector<float>(k_bins);
};

/// What stops light on its way, sampled in one type of voxel.
template <class T>
class Surroundings {
public:
    Surroundings(const Scene& scene, double step_mm)
        : scene_(scene),
          grid_(scene.volume.geometry()),
          field_(scene.volume),
          ea_(scene.mode == ViewMode::ea),
          no_ranges_(scene.classification.ranges.empty()),
          opacity_(ea_ ? std::optional<StepOpacity>(std::in_place, scene.classification, step_mm) : std::nullopt),
          box_hi_(glm::dvec3(grid_.size) - 0.5) {
        for (const CuttingPlane& cut : scene.cuts) {
            const double length = glm::length(cut.normal);
            cuts_.push_back({grid_.spacing * (glm::transpose(grid_.direction) * cut.normal) / length,
                             (glm::dot(cut.normal, grid_.origin) + cut.offset) / length, cut.normal / length});
        }
    }

    /// The unit normal at a hit (voxel coordinates), in mm along the grid's axes, towards the viewer.
    glm::dvec3 normal(const glm::dvec3& hit, const glm::dvec3& to_viewer) const {
        glm::dvec3 n = face_normal(hit);
        if (n == glm::dvec3(0)) n = field_.gradient(hit);
        const double length = glm::length(n);
        if (!(length > 0) || !std::isfinite(length)) return to_viewer;
        return n * ((glm::dot(n, to_viewer) < 0 ? -1 : 1) / length);
    }

    /// Share of light lost along from + t * per_mm for t in (0, distance], samples at (k + jitter) steps.
    double occlusion(const glm::dvec3& from, const glm::dvec3& per_mm, double step_mm, double distance_mm,
                     double jitter) const {
        double through = 1;
        for (double t = jitter * step_mm; t <= distance_mm; t += step_mm) {
            const glm::dvec3 p = from + t * per_mm;
            if (!kept(p)) break;  // the box and the cuts leave one convex part: no ray comes back
            const double value = field_.linear(p);
            if (std::isnan(value)) continue;
            if (ea_) {
                through *= 1 - opacity_->at(value);
                if (through < 1 - k_opaque) return 1;
            } else if (inside(value)) {
                return 1;
            }
        }
        return 1 - through;
    }

private:
    struct Cut {
        glm::dvec3 per_voxel;  ///< mm of signed distance a voxel step
        double at_origin;
        glm::dvec3 normal_mm;
        double distance_mm(const glm::dvec3& p) const { return glm::dot(per_voxel, p) + at_origin; }
    };

    bool inside(double value) const {
        return no_ranges_ ? value >= scene_.iso : iso_measure(scene_.classification, scene_.iso, value) >= 0;
    }
    bool kept(const glm::dvec3& p) const {
        for (int a = 0; a < 3; ++a)
            if (!(p[a] >= -0.5 && p[a] <= box_hi_[a])) return false;
        for (const Cut& cut : cuts_)
            if (!(cut.distance_mm(p) >= 0)) return false;
        return true;
    }
    /// The normal of the cut or the side of the volume the hit lies on, or 0.
    glm::dvec3 face_normal(const glm::dvec3& hit) const {
        for (const Cut& cut : cuts_)
            if (std::fabs(cut.distance_mm(hit)) < k_face_voxels * grid_.smallest_spacing_mm())
                return glm::transpose(grid_.direction) * cut.normal_mm;
        for (int a = 0; a < 3; ++a)
            if (hit[a] < -0.5 + k_face_voxels || hit[a] > box_hi_[a] - k_face_voxels) {
                glm::dvec3 n(0);
                n[a] = 1;
                return n;
            }
        return glm::dvec3(0);
    }

    const Scene& scene_;
    const GridGeometry& grid_;
    reference::Field<T> field_;
    bool ea_, no_ranges_;
    std::optional<StepOpacity> opacity_;  ///< ea alone
    glm::dvec3 box_hi_;
    std::vector<Cut> cuts_;
};

/// The sequence of Roberts (2018) in three dimensions, R3: any number of its points lie evenly.
const glm::dvec3 k_sequence(0.8191725134, 0.6710436067, 0.5497004779);
constexpr int k_patterns = 16;  // 4x4 pixels, over which occlusion is smoothed

/// Sample number i of a pixel with pattern p of 16, in [0, 1)^3: point p + 16 i of the sequence, so that neighbouring
/// pixels' samples fill each other's gaps and each further sample those of all before.
glm::dvec3 sample_point(int pattern, int i, double seed) {
    return glm::fract(k_sequence * (1.0 + pattern + double(k_patterns) * i) +
                      seed * glm::dvec3(0.7548776662, 0.5698402910, 0.3819660113));
}

struct Sampling {
    int samples = 16;
    double distance_mm = 1, step_mm = 1, seed = 1;
};

/// Occlusion summed over samples first .. until-1, in Malley's cosine-weighted directions.
template <class T>
double occlusion_at(const Surroundings<T>& around, const GridGeometry& grid, const Sampling& how, glm::ivec2 samples,
                    glm::dvec3 hit, const glm::dvec3& to_viewer, int pattern) {
    const glm::dvec3 n = around.normal(hit, to_viewer);
    const glm::dvec3 helper = std::fabs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, n)), v = glm::cross(n, u);
    hit += k_lift_voxels * glm::normalize(n / grid.spacing);
    double sum = 0;
    for (int i = samples.x; i < samples.y; ++i) {
        const glm::dvec3 point = sample_point(pattern, i, how.seed);
        const double turn = 2 * std::numbers::pi * point.y;
        const double r = std::sqrt(point.x), up = std::sqrt(std::max(0.0, 1 - point.x));
        const glm::dvec3 along = r * std::cos(turn) * u + r * std::sin(turn) * v + up * n;
        sum += around.occlusion(hit, along / grid.spacing, how.step_mm, how.distance_mm, point.z);
    }
    return sum;
}

/// Adds some of the samples to each pixel's sum.
template <class T>
void occlude_rows(const Scene& scene, const ViewRays& rays, const Sampling& how, glm::ivec2 samples, const Frame& frame,
                  std::vector<double>& occlusion, const JobContext& job) {
    const GridGeometry& grid = scene.volume.geometry();
    const Surroundings<T> around(scene, how.step_mm);
    parallel_for(
        0, frame.size.y,
        [&](std::int64_t y) {
            std::size_t i = std::size_t(y) * std::size_t(frame.size.x);
            for (int x = 0; x < frame.size.x; ++x, ++i) {
                const double depth = double(frame.depth_mm[i]);
                if (!std::isfinite(depth)) continue;
                job.check();
                const glm::dvec3 along = rays.direction(x, double(y));
                const glm::dvec3 hit = grid.mm_to_voxel(rays.origin(x, double(y)) + along * depth);
                occlusion[i] += occlusion_at(around, grid, how, samples, hit, -(glm::transpose(grid.direction) * along),
                                             int(y % 4) * 4 + x % 4);
            }
        },
        job);
}

}  // namespace

void ambient_occlusion(const Scene& scene, const ViewRays& rays, const Effect& effect, Frame& frame,
                       const JobContext& job, const FramePreview& on_the_way) {
    const double strength = effect.value(2);
    if (strength == 0) return;
    const GridGeometry& grid = scene.volume.geometry();
    Sampling how;
    how.samples = int(effect.value(0));
    how.distance_mm = effect.value(1) > 0 ? effect.value(1) : k_default_distance * grid.diameter_mm();
    how.step_mm = std::max(grid.smallest_spacing_mm(), how.distance_mm / k_most_steps);
    how.seed = effect.value(3);

    const Relief relief = make_relief(rays, frame, job);
    std::vector<double> sums(frame.pixels());
    const auto darkened = [&](Frame& target, int samples) {
        std::vector<float> occlusion(sums.size());
        for (std::size_t i = 0; i < sums.size(); ++i) occlusion[i] = float(sums[i] / samples);
        smooth_by_depth(relief, 3 * grid.smallest_spacing_mm(), occlusion, job);
        darken(occlusion, strength, target, job);
    };
    for (int done = 0; done < how.samples;) {
        const int until = on_the_way ? std::min(std::max(2 * done, k_first_samples), how.samples) : how.samples;
        visit_type(scene.volume.type(), [&](auto tag) {
            occlude_rows<decltype(tag)>(scene, rays, how, {done, until}, frame, sums, job);
        });
        done = until;
        if (done == how.samples) break;
        Frame so_far = frame;
        darkened(so_far, done);
        on_the_way(std::move(so_far));
    }
    darkened(frame, how.samples);
}

}  // namespace lacuna::effects
