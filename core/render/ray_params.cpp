#include "core/render/ray_params.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lacuna {

static_assert(LACUNA_MAX_CUTS == Scene::k_max_cuts && LACUNA_MAX_RANGES == Classification::k_max_ranges &&
              LACUNA_MAX_ROWS == Classification::k_max_ranges + 1);

namespace {

void put(s_float (&out)[3], const glm::dvec3& v) {
    for (int a = 0; a < 3; ++a) out[a] = float(v[a]);
}

/// Rays as functions of the pixel. Orthographic rays are given from the plane through the target, not from the eye far
/// away: coordinates stay small, which is what single precision needs.
void put_rays(RayParams& p, const ViewRays& rays, const GridGeometry& grid) {
    const glm::dvec3 dx = grid.vector_to_voxel(rays.offset(1, 0) - rays.offset(0, 0));
    const glm::dvec3 dy = grid.vector_to_voxel(rays.offset(0, 1) - rays.offset(0, 0));
    if (rays.perspective) {
        put(p.origin, grid.mm_to_voxel(rays.eye));
        put(p.dir, grid.vector_to_voxel(rays.forward * rays.distance_mm + rays.offset(0, 0)));
        put(p.dir_dx, dx);
        put(p.dir_dy, dy);
        p.t_min_mm = 0;
        p.depth_bias_mm = 0;
    } else {
        put(p.origin, grid.mm_to_voxel(rays.target + rays.offset(0, 0)));
        put(p.origin_dx, dx);
        put(p.origin_dy, dy);
        put(p.dir, grid.vector_to_voxel(rays.forward));
        p.t_min_mm = float(-rays.distance_mm);
        p.depth_bias_mm = float(rays.distance_mm);
    }
}

void put_cuts(RayParams& p, const Scene& scene, const GridGeometry& grid) {
    p.cut_count = int(scene.cuts.size());
    for (int i = 0; i < p.cut_count; ++i) {
        const CuttingPlane& cut = scene.cuts[std::size_t(i)];
        // normal . voxel_to_mm(v) + offset, as a function of v
        const glm::dvec3 n = glm::transpose(grid.direction) * cut.normal * grid.spacing;
        for (int a = 0; a < 3; ++a) p.cut[i][a] = float(n[a]);
        p.cut[i][3] = float(glm::dot(cut.normal, grid.origin) + cut.offset);
        p.cut_cap[i] = cut.cap ? 1 : 0;
    }
}

void put_tables(RayParams& p, const TransferTables& tables) {
    p.lut_size = tables.entries;
    p.row_count = int(tables.rows()) - 1;
    for (std::size_t r = 0; r < tables.rows(); ++r) {
        p.lut_scale[r] = tables.scale[r];
        p.lut_lo[r] = tables.lo[r];
        p.exponent[r] = tables.exponent[r];
        if (tables.uses_gradient) p.grad_scale[r] = tables.gradient_scale[r];
    }
}

}  // namespace

namespace {

/// For exact intersection: the values inside the object as intervals that do not meet, so that each end is a turn.
void put_merged_ranges(RayParams& p, const Scene& scene) {
    std::vector<ValueRange> merged;
    for (const SegmentationRange& r : scene.classification.ranges)
        if (const double lo = std::max(scene.iso, r.range.lo); lo <= r.range.hi) merged.push_back({lo, r.range.hi});
    std::sort(merged.begin(), merged.end(), [](const ValueRange& a, const ValueRange& b) { return a.lo < b.lo; });
    p.range_count = 0;
    for (const ValueRange& r : merged) {
        const int last = p.range_count - 1;
        if (last >= 0 && float(r.lo) <= p.range[last][1]) {
            p.range[last][1] = std::max(p.range[last][1], float(r.hi));
            continue;
        }
        p.range[p.range_count][0] = float(r.lo);
        p.range[p.range_count++][1] = float(r.hi);
    }
}

}  // namespace

void put_volume(RayParams& p, glm::ivec3 size, glm::ivec3 stored_size) {
    put(p.last, glm::dvec3(size - 1));
    for (int a = 0; a < 3; ++a) p.size[a] = stored_size[a];
    p.stride_y = s_uint(stored_size.x);
    p.stride_z = s_uint(std::int64_t(stored_size.x) * stored_size.y);
}

RayParams make_ray_params(const Scene& scene, const Plan& plan, glm::ivec3 stored_size, const TransferTables* tables) {
    const GridGeometry& grid = scene.volume.geometry();
    RayParams p{};
    put_rays(p, resolve(scene.camera, grid, scene.size), grid);
    put(p.spacing, grid.spacing);
    put_volume(p, grid.size, stored_size);
    p.step_mm = float(plan.step * grid.smallest_spacing_mm());
    p.width = scene.size.x;
    p.height = scene.size.y;
    put_cuts(p, scene, grid);
    p.range_count = int(scene.classification.ranges.size());
    for (int i = 0; i < p.range_count; ++i) {
        p.range[i][0] = float(scene.classification.ranges[std::size_t(i)].range.lo);
        p.range[i][1] = float(scene.classification.ranges[std::size_t(i)].range.hi);
    }
    if (tables) put_tables(p, *tables);
    p.iso = float(scene.iso);
    p.refine = int(plan.refine);
    if (scene.mode == ViewMode::iso && plan.refine == Refinement::cubic) put_merged_ranges(p, scene);
    p.refine_steps = plan.refine_steps;
    p.shading = int(scene.shading);
    put(p.surface_color, scene.surface_color);
    p.min_transmittance = float(plan.ert);
    p.window_lo = float(scene.window.lo);
    p.window_scale = float(scene.window.width() > 0 ? 1 / scene.window.width() : 0);
    p.color_by_tf = scene.color_by_tf ? 1 : 0;
    p.lmip_threshold = float(scene.lmip_threshold);
    return p;
}

}  // namespace lacuna
