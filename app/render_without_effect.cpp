// Words of lacuna render that say nothing beside the others.

#include "app/render_options.h"

namespace lacuna::cli {

namespace {

bool over_cells(Structure structure) {
    return structure == Structure::pc || structure == Structure::acd || structure == Structure::eacd;
}

bool knows_thresholds(ViewMode mode, Structure structure) {
    return structure == Structure::leap ||
           (mode == ViewMode::ea && (structure == Structure::octree || over_cells(structure)));
}

bool projects(ViewMode mode) {
    return mode == ViewMode::mip || mode == ViewMode::lmip || mode == ViewMode::minip || mode == ViewMode::mean;
}

}  // namespace

std::vector<std::string> RenderOptions::without_effect(const Plan& plan) const {
    const bool iso = mode_ == ViewMode::iso, ea = mode_ == ViewMode::ea, warp = mode_ == ViewMode::shear_warp;
    std::vector<std::string> found;
    const auto look = [&](const char* flag, const std::optional<std::string>& word, bool serves) {
        if (word && !serves) found.emplace_back(flag);
    };
    look("--iso", words_.iso, iso || warp);
    look("--lmip-threshold", words_.lmip_threshold, mode_ == ViewMode::lmip);
    look("--window", words_.window, projects(mode_) && !tf_);
    look("--shading", words_.shading, iso || ea || warp || shading_ == Shading::none);
    look("--refine", words_.refine, iso);
    look("--refine-steps", words_.refine_steps, iso && plan.refine != Refinement::none);
    look("--ert", words_.ert, ea || ert_ == 0.0);
    look("--gradient", words_.gradient, iso || ea);
    look("--integration", words_.integration, ea || integration_ == Integration::riemann);
    look("--cells", words_.cells, over_cells(plan.structure));
    look("--homogeneity", words_.homogeneity,
         knows_thresholds(mode_, plan.structure) || (homogeneity_ == 0.0 && !homogeneity_angle_));
    look("--directions", words_.directions, warp);
    look("--voxel-gradient", words_.voxel_gradient, warp && plan.sampler == Sampler::nearest);
    return found;
}

}  // namespace lacuna::cli
