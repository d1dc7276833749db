#include "core/accuracy/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {

std::string_view name_of(Guard guard) {
    switch (guard) {
        case Guard::refused:
            return "refused";
        case Guard::detected:
            return "detected";
        case Guard::corrected:
            return "corrected";
        case Guard::bounded:
            return "bounded";
    }
    return "";
}

std::string_view title_of(LimitTopic topic) {
    switch (topic) {
        case LimitTopic::surfaces:
            return "Isosurfaces";
        case LimitTopic::emission_absorption:
            return "Emission-absorption";
        case LimitTopic::projections:
            return "Projections";
        case LimitTopic::shear_warp:
            return "Shear-warp";
        case LimitTopic::structures:
            return "Structures";
        case LimitTopic::sparse:
            return "Sparse casting";
        case LimitTopic::effects:
            return "Effects";
        case LimitTopic::volumes:
            return "Rays and voxels";
        case LimitTopic::regions:
            return "Regions";
        case LimitTopic::measures:
            return "Measures";
    }
    return "";
}

std::vector<const Limit*> limits_of(const Scene& scene, const Plan& plan) {
    std::vector<const Limit*> all;
    for (const Limit& limit : limits())
        if (limit.concerns && limit.concerns(scene, plan)) all.push_back(&limit);
    return all;
}

std::vector<MetLimit> limits_met(const SceneFacts& facts, const Scene& scene, const Plan& plan) {
    std::vector<MetLimit> found;
    for (const Limit* limit : limits_of(scene, plan)) {
        if (!limit->met) continue;
        LimitMet met = limit->met(facts, scene, plan);
        if (met.extent > 0) found.push_back({limit, met.extent, std::move(met.how)});
    }
    return found;
}

std::string refused_by_limits(const SceneFacts& facts, const Scene& scene, const Plan& plan, const Plan& least,
                              double levels) {
    const std::vector<MetLimit> anyway = limits_met(facts, scene, least);
    for (const MetLimit& met : limits_met(facts, scene, plan)) {
        if (!(met.extent > std::max(levels / 255, 1e-3))) continue;
        const auto same =
            std::find_if(anyway.begin(), anyway.end(), [&](const MetLimit& a) { return a.limit == met.limit; });
        if (same != anyway.end() && !(met.extent > 2 * same->extent)) continue;
        return fmt::format("it fails on this scene ({}). {}", met.limit->name, met.how);
    }
    return {};
}

double spot_loss(const Scene& scene, double step) {
    const GridGeometry& grid = scene.volume.geometry();
    const ViewRays rays = resolve(scene.camera, grid, scene.size);
    // Along each axis by the ray that runs most along it; the picture's corners are farthest from its middle.
    const double spread = std::acos(std::min(1.0, glm::dot(rays.forward, rays.direction(0, 0))));
    const glm::dvec3 middle = glm::abs(glm::transpose(grid.direction) * rays.forward);
    double left = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double along =
            rays.perspective ? std::cos(std::max(0.0, std::acos(std::min(1.0, middle[axis])) - spread)) : middle[axis];
        left *= std::max(0.0, 1 - 0.5 * step * grid.smallest_spacing_mm() * along / grid.spacing[axis]);
    }
    return 1 - left;
}

std::string to_markdown(const Limit& limit) {
    std::string guard(name_of(limit.guard));
    guard.front() = char(guard.front() - 'a' + 'A');
    return fmt::format("- **{}.** {} *{}:* {} *Bound:* {} *Shown by* `{}`", limit.name, limit.fails, guard,
                       limit.guarded, limit.bound, limit.test);
}

}  // namespace lacuna
