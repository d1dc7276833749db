#include "core/accuracy/view_facts.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/base/parallel.h"
#include "core/render/reference_ray.h"
#include "core/render/reference_sampler.h"

namespace lacuna {

namespace {

constexpr double k_opaque = 0.998;

void add(RayFacts& sum, const RayFacts& part, double weight) {
    sum.samples += weight * part.samples;
    sum.shown += weight * part.shown;
    sum.stretches += weight * part.stretches;
}

struct Sums {
    RayFacts whole, seen;
    double rays = 0, change = 0, changes = 0, lo = INFINITY, hi = -INFINITY;
};

/// What of a sample shows, and how much it hides.
class Judge {
public:
    Judge(const Scene& scene, double step_mm) : scene_(scene), step_mm_(step_mm) {}
    void begin() { outside_ = true, through_ = 1; }
    /// @return whether the sample can show something
    bool shows(double value) {
        const Classification& classes = scene_.classification;
        if (scene_.mode == ViewMode::iso) {
            const bool outside = !(iso_measure(classes, scene_.iso, value) >= 0);
            const bool turned = outside_ && !outside;
            outside_ = outside;
            if (turned) through_ = 0;
            return turned;
        }
        if (scene_.mode != ViewMode::ea) return classes.ranges.empty() ? !std::isnan(value) : classes.in_ranges(value);
        const double opacity = classes.at(value).opacity;
        if (opacity > 0)
            through_ *= std::pow(1 - std::min(opacity, 1.0), step_mm_ / classes.function_of(value).unit_distance_mm);
        return opacity > 0;
    }
    bool done() const { return through_ < 1 - k_opaque; }

private:
    const Scene& scene_;
    double step_mm_, through_ = 1;
    bool outside_ = true;
};

template <class T>
void follow(const reference::Field<T>& field, const reference::LatticeRay& ray, Judge& judge, Sums& sums) {
    RayFacts facts, seen;
    bool in_stretch = false, ended = false;
    double before = std::nan("");
    judge.begin();
    for (std::int64_t k = ray.first; k < ray.end; ++k) {
        const double value = field.linear(ray.at(ray.sample_t(k)));
        if (!std::isnan(value)) {
            sums.lo = std::min(sums.lo, value);
            sums.hi = std::max(sums.hi, value);
            if (!std::isnan(before)) sums.change += std::fabs(value - before), sums.changes += 1;
        }
        before = value;
        const bool shown = judge.shows(value);
        facts.samples += 1;
        facts.shown += shown;
        facts.stretches += !shown && !in_stretch;
        in_stretch = !shown;
        if (!ended) seen = facts;
        ended = ended || judge.done();
    }
    add(sums.whole, facts, 1);
    add(sums.seen, seen, 1);
    sums.rays += 1;
}

template <class T>
Sums follow_rays(const Scene& scene, glm::ivec2 grid, double step_mm, const JobContext& job) {
    const reference::Field<T> field(scene.volume);
    const GridGeometry& geometry = scene.volume.geometry();
    const ViewRays rays = resolve(scene.camera, geometry, scene.size);
    std::vector<Sums> rows(std::size_t(grid.y));
    parallel_for(
        0, grid.y,
        [&](std::int64_t row) {
            Judge judge(scene, step_mm);
            for (int column = 0; column < grid.x; ++column) {
                const double x = (column + 0.5) * scene.size.x / grid.x - 0.5;
                const double y = (double(row) + 0.5) * scene.size.y / grid.y - 0.5;
                const reference::LatticeRay ray =
                    reference::cast(rays.origin(x, y), rays.direction(x, y), geometry, scene.cuts, step_mm);
                if (ray.kept) follow(field, ray, judge, rows[std::size_t(row)]);
            }
        },
        job);
    Sums all;
    for (const Sums& row : rows) {  // in order: the result does not depend on the threads
        add(all.whole, row.whole, 1);
        add(all.seen, row.seen, 1);
        all.rays += row.rays;
        all.change += row.change;
        all.changes += row.changes;
        all.lo = std::min(all.lo, row.lo);
        all.hi = std::max(all.hi, row.hi);
    }
    return all;
}

}  // namespace

ViewFacts measure_view_facts(const Scene& scene, double step, int rays, const JobContext& job) {
    check(scene);
    const double pixels = double(scene.size.x) * scene.size.y;
    const double apart = std::max(1.0, std::sqrt(pixels / std::max(1, rays)));
    const glm::ivec2 grid = glm::max(glm::ivec2(glm::dvec2(scene.size) / apart), glm::ivec2(1));
    const double step_mm = step * scene.volume.geometry().smallest_spacing_mm();
    const Sums sums = visit_type(scene.volume.type(),
                                 [&](auto tag) { return follow_rays<decltype(tag)>(scene, grid, step_mm, job); });
    const double weight = pixels / (double(grid.x) * grid.y);
    ViewFacts facts;
    facts.pixels = pixels;
    facts.rays = weight * sums.rays;
    add(facts.whole, sums.whole, weight);
    add(facts.seen, sums.seen, weight);
    if (sums.changes > 0 && sums.hi > sums.lo) facts.value_change = sums.change / sums.changes / (sums.hi - sums.lo);
    return facts;
}

}  // namespace lacuna
