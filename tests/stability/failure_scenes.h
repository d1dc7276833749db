#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/render/plan.h"
#include "tests/support/device_renderer.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna::test {

/// Every structure that serves ray casting, brute force first.
inline std::vector<Structure> casting_structures() {
    std::vector<Structure> all;
    for (const auto& [structure, name] : structure_names())
        if (structure != Structure::visible) all.push_back(structure);
    return all;
}

/// Brute force by another structure. Distances are taken over macro-cells of 4^3, leaps through regions of any size.
inline Plan with_structure(Structure structure, double step = 0.5) {
    Plan plan = brute_force(step);
    plan.structure = structure;
    plan.cells = 4;
    plan.leap.min_voxels = 1;
    return plan;
}

inline Frame on_device(const Scene& scene, const Plan& plan, bool count = false) {
    check(plan, scene);
    return renderer().render(scene, plan, {}, count).frame;
}

/// Largest difference of any channel, in 1/255; NaN anywhere is infinite.
inline double worst_levels(const Frame& a, const Frame& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const glm::vec4 d = glm::abs(a.color[i] - b.color[i]) * 255.0f;
        for (int c = 0; c < 4; ++c) worst = d[c] <= 1e6f ? std::max(worst, double(d[c])) : INFINITY;
    }
    return worst;
}

}  // namespace lacuna::test
