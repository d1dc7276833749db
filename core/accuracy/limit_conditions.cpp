#include "core/accuracy/limit_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/accel/distance_field.h"
#include "core/render/segment_tables.h"

namespace lacuna::limit {

namespace {

/// Expected share of places missed by samples `plan.step` apart.
LimitMet missed_places(const ThicknessCounts& counts, const Plan& plan, const char* what) {
    const std::int64_t thin = counts.thinner_than(plan.step);
    if (thin == 0) return {};
    const double missed = counts.missed(plan.step);
    return {std::max(missed, 1e-9),
            fmt::format("{} of {} {} are thinner than the step of {:g} voxels; {:.2g} % would be missed square on.",
                        thin, counts.places, what, plan.step, 100 * missed)};
}

glm::dvec3 direction_in_voxels(const Scene& scene) {
    const GridGeometry& grid = scene.volume.geometry();
    const glm::dvec3 forward = resolve(scene.camera, grid, scene.size).forward;
    return glm::abs(glm::transpose(grid.direction) * forward / grid.spacing);
}

/// The two largest components of the direction in voxels, the second as a share of the first.
double second_component(const Scene& scene) {
    glm::dvec3 d = direction_in_voxels(scene);
    if (d.x < d.y) std::swap(d.x, d.y);
    if (d.y < d.z) std::swap(d.y, d.z);
    if (d.x < d.y) std::swap(d.x, d.y);
    return d.y / d.x;
}

}  // namespace

LimitMet thin_walls(const SceneFacts& facts, const Scene&, const Plan& plan) {
    return missed_places(facts.walls, plan, "voxels at the surface lie in walls that");
}

LimitMet narrow_peaks(const SceneFacts& facts, const Scene&, const Plan& plan) {
    return missed_places(facts.shells, plan,
                         "places where values pass a peak of the transfer function make shells that");
}

LimitMet smeared_peaks(const SceneFacts& facts, const Scene&, const Plan&) {
    const double entry = facts.peaks_span / (SegmentTables::k_nodes - 3);
    if (!facts.narrowest || !(*facts.narrowest < entry)) return {};
    return {0.01, fmt::format("The transfer function has a peak {:.3g} wide; an entry of the table covers {:.3g}.",
                              *facts.narrowest, entry)};
}

LimitMet thin_layers(const SceneFacts& facts, const Scene&, const Plan& plan) {
    return missed_places(facts.walls, plan, "voxels at visible borders lie in layers that");
}

LimitMet hidden_light(const SceneFacts& facts, const Scene& scene, const Plan& plan) {
    const double levels = hidden_levels(plan.ert, scene.shading);
    if (!(levels > 1)) return {};
    return {levels / 255, fmt::format("Up to {:.3g} of 255 grey levels may be hidden.", levels)};
}

LimitMet spots(const SceneFacts& facts, const Scene& scene, const Plan& plan) {
    if (facts.spots == 0 || plan.sampler == Sampler::nearest) return {};
    const double levels =
        255 * spot_loss(scene, plan.step) * facts.spot_height / std::max(std::fabs(scene.window.width()), 1e-300);
    if (!(levels > 1)) return {};
    return {std::min(1.0, levels / 255),
            fmt::format("{} voxels stand out from all their neighbours, by up to {:.4g}; up to {:.0f} of 255 grey "
                        "levels of that are lost at this step.",
                        facts.spots, facts.spot_height, std::min(levels, 255.0))};
}

LimitMet axis_switch(const SceneFacts&, const Scene& scene, const Plan&) {
    if (!(second_component(scene) > 0.99)) return {};
    return {0.01, "This view lies within a third of a degree of where the principal axis switches."};
}

LimitMet slanted_nearest(const SceneFacts&, const Scene& scene, const Plan&) {
    const double slant = second_component(scene);
    if (!(slant > 0.7)) return {};
    return {0.3 * slant,
            fmt::format("This view is slanted by {:.0f} degrees to the slices.", glm::degrees(std::atan(slant)))};
}

LimitMet flattened_peak(const SceneFacts& facts, const Scene&, const Plan& plan) {
    if (!facts.narrowest || !(*facts.narrowest < plan.homogeneity)) return {};
    return {1, fmt::format("The transfer function has a peak {:.3g} wide, the threshold is {:.3g}: nodes as flat as "
                           "that may hold the whole peak.",
                           *facts.narrowest, plan.homogeneity)};
}

LimitMet wide_threshold(const SceneFacts&, const Scene&, const Plan& plan) {
    if (!(plan.homogeneity > 0.02)) return {};
    return {
        std::min(1.0, 10 * plan.homogeneity),
        fmt::format("The threshold of {:.3g} lets regions differ visibly from what they stand for.", plan.homogeneity)};
}

LimitMet saturated_distances(const SceneFacts& facts, const Scene& scene, const Plan&) {
    const glm::ivec3 size = scene.volume.geometry().size;
    const int longest = std::max({size.x, size.y, size.z});
    if (longest <= 2 * k_box_limit || !facts.voxels_seen || 2 * facts.shown > facts.voxels) return {};
    return {1e-6, fmt::format("Most of {} voxels along an axis is empty, and a box reaches {}.", longest, k_box_limit)};
}

LimitMet fog(const SceneFacts& facts, const Scene&, const Plan&) {
    if (!facts.voxels_seen || !(double(facts.shown) > 0.5 * double(facts.voxels))) return {};
    return {1e-6, fmt::format("{:.0f} % of the voxels are visible: there is little to skip.",
                              100 * double(facts.shown) / double(facts.voxels))};
}

LimitMet fooled_leaps(const SceneFacts& facts, const Scene&, const Plan&) {
    if (facts.equal_pairs == 0) return {};
    return {1, fmt::format("{:.0f} % of the voxels equal their neighbour, and not all of these lie in regions.",
                           100 * double(facts.equal_pairs) / double(facts.voxels))};
}

LimitMet flattened_regions(const SceneFacts&, const Scene&, const Plan& plan) {
    if (!(plan.homogeneity > 0)) return {};
    return {
        std::min(1.0, plan.homogeneity),
        fmt::format("Regions span up to {:.3g} % of the values and are drawn as their mean.", 100 * plan.homogeneity)};
}

LimitMet nothing_to_leap(const SceneFacts& facts, const Scene&, const Plan& plan) {
    if (!facts.voxels_seen || plan.homogeneity > 0 || !(double(facts.equal_pairs) < 0.2 * double(facts.voxels)))
        return {};
    return {1e-6, fmt::format("Only {:.0f} % of the voxels equal their neighbour: regions of one value are few.",
                              100 * double(facts.equal_pairs) / double(facts.voxels))};
}

LimitMet thin_wires(const SceneFacts& facts, const Scene& scene, const Plan& plan) {
    const bool unguarded = scene.mode == ViewMode::lmip || scene.mode == ViewMode::mean;
    if (facts.wires == 0 || (plan.sparse_aware && !unguarded)) return {};
    const GridGeometry& grid = scene.volume.geometry();
    const double pixel = resolve(scene.camera, grid, scene.size).pixel_mm;
    const double pixels = grid.smallest_spacing_mm() / pixel;
    if (!(pixels < plan.sparse)) return {};
    return {1, fmt::format("{} voxels stand alone across two axes or three; a voxel is {:.2g} pixels wide, and every "
                           "{}. pixel is cast.",
                           facts.wires, pixels, plan.sparse)};
}

LimitMet not_finite(const SceneFacts& facts, const Scene&, const Plan&) {
    if (facts.not_finite == 0) return {};
    return {1e-6, fmt::format("{} voxels are no numbers.", facts.not_finite)};
}

LimitMet far_away(const SceneFacts&, const Scene& scene, const Plan&) {
    const GridGeometry& grid = scene.volume.geometry();
    const double voxels = resolve(scene.camera, grid, scene.size).distance_mm / grid.smallest_spacing_mm();
    if (!(voxels > 5000)) return {};
    return {1e-6, fmt::format("The eye is {:.0f} voxels away.", voxels)};
}

LimitMet flat_or_thin(const SceneFacts& facts, const Scene& scene, const Plan&) {
    const glm::ivec3 size = scene.volume.geometry().size;
    if (facts.constant()) return {1e-6, "All voxels are equal."};
    if (std::min({size.x, size.y, size.z}) == 1) return {1e-6, "The volume is one voxel thick."};
    return {};
}

}  // namespace lacuna::limit
