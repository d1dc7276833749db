#include "core/accuracy/error_bound.h"

#include <algorithm>

namespace lacuna {

namespace {

bool by_gradient(const Scene& scene) {
    const std::vector<TransferFunction>& of_regions = scene.regions.functions;
    return scene.classification.uses_gradient() ||
           std::any_of(of_regions.begin(), of_regions.end(),
                       [](const auto& function) { return function.uses_gradient(); });
}

/// Whether a gradient is taken anywhere.
bool needs_gradients(const Scene& scene) {
    if (scene.mode == ViewMode::iso) return scene.shading != Shading::none;
    return scene.mode == ViewMode::ea && (scene.shading != Shading::none || by_gradient(scene));
}

/// Structures that take values which differ by less than a threshold for equal.
bool takes_for_equal(const Plan& plan) {
    switch (plan.structure) {
        case Structure::octree:
        case Structure::leap:
            return plan.homogeneity > 0 || plan.homogeneity_angle_deg > 0;
        case Structure::pc:
        case Structure::acd:
        case Structure::eacd:
            return plan.homogeneity > 0 || (plan.homogeneity_angle_deg > 0 && plan.cells == 1);
        default:
            return false;
    }
}

bool same_refinement(const Plan& a, const Plan& b) {
    return a.refine == b.refine &&
           (a.refine_steps == b.refine_steps || a.refine == Refinement::none || a.refine == Refinement::cubic);
}

}  // namespace

Plan brute_force(const Scene& scene, double step) {
    Plan like = default_plan(scene);
    like.step = step;
    return reference_plan(scene, like);
}

std::vector<Loss> losses(const Plan& plan, const Scene& scene, const Plan& brute) {
    if (scene.mode == ViewMode::shear_warp) return {Loss::shear_warp};
    const bool iso = scene.mode == ViewMode::iso, ea = scene.mode == ViewMode::ea, gradients = needs_gradients(scene);
    const bool leap = plan.structure == Structure::leap;
    std::vector<Loss> found;
    const auto add_if = [&](bool lost, Loss loss) {
        if (lost) found.push_back(loss);
    };
    add_if(ea && plan.ert > brute.ert, Loss::termination);
    add_if(plan.step != brute.step, Loss::step);
    add_if(plan.sampler == Sampler::nearest, Loss::nearest);
    add_if(plan.sparse >= 2, Loss::sparse);
    add_if(takes_for_equal(plan), Loss::thresholds);
    add_if(leap && (plan.leap.kernel != Leaping::lossless || scene.volume.type() == VoxelType::f32), Loss::quantised);
    add_if(gradients && plan.gradient_store != brute.gradient_store, Loss::stored_gradients);
    add_if(gradients && plan.gradient != brute.gradient, Loss::gradient_filter);
    add_if(iso && !same_refinement(plan, brute), Loss::refinement);
    add_if(ea && plan.integration != brute.integration, Loss::segments);
    return found;
}

ErrorBound known_bound(const Plan& plan, const Scene& scene, const Plan& brute) {
    ErrorBound bound;
    bound.losses = losses(plan, scene, brute);
    if (bound.losses.empty()) {
        bound.known = ErrorKnown::exact;
    } else if (bound.losses.size() == 1 && bound.losses.front() == Loss::termination && scene.effects.empty()) {
        bound.known = ErrorKnown::bounded;
        bound.levels = hidden_levels(plan.ert, scene.shading);
    }
    return bound;
}

}  // namespace lacuna
