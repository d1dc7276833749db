// How fast each refinement of an isosurface's depth closes in, where the signal is convex along the ray.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/compute/device.h"
#include "core/render/engine.h"
#include "core/render/reference_renderer.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna {
namespace {

using namespace test;

/// A wall whose signal rises ever faster along the ray: flat where the surface lies, early in a step of 8 mm, and steep
/// at that step's end, so that every secant ends beside the step's beginning.
Scene convex_wall() {
    const Volume volume = sampled(centred({12, 40, 12}), [](const glm::dvec3& mm) { return std::exp(0.9 * mm.y); });
    Scene scene = scene_of(volume, ViewMode::iso, 9);
    scene.iso = std::exp(0.9 * -7);
    scene.camera.zoom = 4;
    return scene;
}

/// Largest distance to the exact turn, mm.
double depth_error(const Scene& scene, Refinement refinement, int steps, bool on_device) {
    static Engine engine(open_device());
    Plan plan = brute_force(8);
    plan.refine = Refinement::cubic;
    const Frame truth = render_reference(scene, plan);
    plan.refine = refinement;
    plan.refine_steps = steps;
    const Frame frame = on_device ? engine.render(scene, plan).frame : render_reference(scene, plan);
    double worst = 0;
    for (std::size_t i = 0; i < frame.pixels(); ++i)
        if (!std::isfinite(truth.depth_mm[i])) return std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < frame.pixels(); ++i)
        worst = std::max(worst, std::fabs(double(frame.depth_mm[i]) - double(truth.depth_mm[i])));
    return worst;
}

TEST(Refinement, PlainRegulaFalsiStallsTheGuardedOneDoesNot) {
    const Scene scene = convex_wall();
    for (bool on_device : {false, true}) {
        SCOPED_TRACE(on_device ? "device" : "reference");
        for (int steps : {8, 16, 64})
            EXPECT_GT(depth_error(scene, Refinement::regula_falsi_plain, steps, on_device), 0.2) << steps;
        EXPECT_LT(depth_error(scene, Refinement::regula_falsi, 16, on_device), 1e-3);
        // Bisection's promise: half the step after each evaluation.
        for (int steps : {4, 8, 12})
            EXPECT_LE(depth_error(scene, Refinement::bisect, steps, on_device), 8.0 / (1 << (steps + 1)) + 1e-4);
    }
}

}  // namespace
}  // namespace lacuna
