#include "core/render/reference_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna::reference {

namespace {

void clip_to_box(LatticeRay& ray, const GridGeometry& geometry) {
    double in = 0, out = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin_vox[axis], d = ray.per_mm_vox[axis];
        const double lo = -0.5, hi = geometry.size[axis] - 0.5;
        if (d == 0) {
            if (!(o >= lo && o <= hi)) return;
            continue;
        }
        const double near = ((d > 0 ? lo : hi) - o) / d, far = ((d > 0 ? hi : lo) - o) / d;
        if (near > in) {
            in = near;
            ray.entry_axis = axis;
        }
        out = std::min(out, far);
    }
    ray.box_in = in;
    ray.box_out = out;
    ray.hits_box = out > in;
}

void clip_to_cuts(LatticeRay& ray, const glm::dvec3& origin_mm, const glm::dvec3& direction,
                  const std::vector<CuttingPlane>& cuts) {
    ray.from = ray.box_in;
    ray.to = ray.box_out;
    for (const CuttingPlane& cut : cuts) {
        const double at_origin = glm::dot(cut.normal, origin_mm) + cut.offset;
        const double slope = glm::dot(cut.normal, direction);
        if (slope == 0) {
            if (!(at_origin >= 0)) return;
            continue;
        }
        const double t = -at_origin / slope;
        if (slope < 0) {
            ray.to = std::min(ray.to, t);
        } else if (t > ray.from) {
            ray.from = t;
            ray.entry_by_cut = true;
            ray.entry_capped = cut.cap;
        }
    }
    ray.kept = ray.to > ray.from;
}

void place_samples(LatticeRay& ray) {
    const auto count =
        std::max<std::int64_t>(0, std::int64_t(std::ceil((ray.box_out - ray.box_in) / ray.step_mm - 0.5)));
    ray.first =
        std::clamp<std::int64_t>(std::int64_t(std::ceil((ray.from - ray.box_in) / ray.step_mm - 0.5)), 0, count);
    while (ray.first > 0 && ray.sample_t(ray.first - 1) >= ray.from) --ray.first;
    while (ray.first < count && ray.sample_t(ray.first) < ray.from) ++ray.first;
    ray.end =
        std::clamp<std::int64_t>(std::int64_t(std::floor((ray.to - ray.box_in) / ray.step_mm - 0.5)) + 1, 0, count);
    while (ray.end > 0 && ray.sample_t(ray.end - 1) > ray.to) --ray.end;
    while (ray.end < count && ray.sample_t(ray.end) <= ray.to) ++ray.end;
}

}  // namespace

LatticeRay cast(const glm::dvec3& origin_mm, const glm::dvec3& direction, const GridGeometry& geometry,
                const std::vector<CuttingPlane>& cuts, double step_mm) {
    LatticeRay ray;
    ray.origin_vox = geometry.mm_to_voxel(origin_mm);
    ray.per_mm_vox = geometry.vector_to_voxel(direction);
    ray.direction_grid = glm::transpose(geometry.direction) * direction;
    ray.step_mm = step_mm;
    clip_to_box(ray, geometry);
    if (!ray.hits_box) return ray;
    clip_to_cuts(ray, origin_mm, direction, cuts);
    if (ray.kept) place_samples(ray);
    return ray;
}

}  // namespace lacuna::reference
