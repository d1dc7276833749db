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

/// A ball whose signal rises over two voxels between two flat levels, in a picture `across_mm` wide about its outline.
Scene outline(double radius_mm, double across_mm) {
    const Volume volume = sampled(centred({40, 40, 40}), [=](const glm::dvec3& mm) {
        return std::clamp(radius_mm - glm::length(mm), -1.0, 1.0);
    });
    Scene scene = scene_of(volume, ViewMode::iso, 65);
    scene.iso = -0.5;
    scene.camera.center_mm = glm::dvec3(radius_mm, 0, 0);
    scene.camera.zoom = volume.geometry().diameter_mm() / across_mm;
    return scene;
}

constexpr double k_outline_step = 2;

/// Largest distance to the exact turn among pixels hit, mm, and what the reference counts of Newton's failures.
std::pair<double, std::uint64_t> outline_error(const Scene& scene, Refinement refinement, bool on_device = false) {
    static Engine engine(open_device());
    Plan plan = brute_force(k_outline_step);
    plan.refine = Refinement::cubic;
    const Frame truth = render_reference(scene, plan);
    plan.refine = refinement;
    plan.refine_steps = 8;
    const Frame frame = on_device ? engine.render(scene, plan).frame : render_reference(scene, plan);
    double worst = 0;
    for (std::size_t i = 0; i < frame.pixels(); ++i)
        if (std::isfinite(frame.depth_mm[i]))
            worst = std::max(worst, std::fabs(double(frame.depth_mm[i]) - double(truth.depth_mm[i])));
    return {worst, frame.counters.not_converged};
}

// Where a ray all but touches the surface the signal's slope along it all but vanishes, and textbook Newton runs off.
TEST(Refinement, NewtonRunsOffAtTangentRaysUnlessItStartsAtTheSecant) {
    constexpr double k_radius = 12.2;
    int off = 0, tried = 0;
    for (double beside = 0.001; beside < 0.1; beside *= 2) {
        const double offset = k_radius - beside, half = std::sqrt(k_radius * k_radius - offset * offset);
        const auto signal = [&](double t) { return k_radius - std::hypot(offset, t); };
        for (const double start : {-0.001, -0.02, 0.1}) {  // the inner sample, beside the middle of a short chord
            double t = start;
            for (int i = 0; i < 5; ++i) t -= signal(t) / (-t / std::hypot(offset, t));
            off += !(std::fabs(t + half) < 1e-3);
            ++tried;
        }
    }
    EXPECT_GT(off, tried / 2) << "the published failure";
    const Scene tangent = outline(k_radius, 2);
    const auto [error, left] = outline_error(tangent, Refinement::newton);
    EXPECT_EQ(left, 0u);
    EXPECT_LT(error, 1e-3);
    EXPECT_LT(outline_error(tangent, Refinement::newton, true).first, 2e-3) << "on the device";
}

// Beside an edge narrower than a step the signal is flat: there Newton has no slope to go by.
TEST(Refinement, NewtonLeavesItsBracketWhereTheSignalIsFlatAndIsCaught) {
    const Scene head_on = outline(12.2, 30);
    const auto [error, left] = outline_error(head_on, Refinement::newton);
    EXPECT_GT(left, 0u) << "rays whose estimate left the bracket";
    EXPECT_GT(error, 0.2) << "the bracket's middle is not the surface,";
    for (const bool on_device : {false, true})
        EXPECT_LE(outline_error(head_on, Refinement::newton, on_device).first, 0.5 * k_outline_step + 1e-3)
            << "but never farther off than half a step";
    EXPECT_LT(outline_error(head_on, Refinement::regula_falsi).first, 0.05) << "the guarded secant has no such trouble";
}

TEST(NearestSampler, StairsAreHalfADiagonalHighAdaptiveHasNone) {
    static Engine engine(open_device());
    Scene scene = scene_of(
        sampled<std::uint16_t>(
            centred({40, 40, 40}),
            [](const glm::dvec3& mm) { return std::clamp(1000 * (14.2 - glm::length(mm)), -500.0, 500.0) + 500; }),
        ViewMode::iso, 65);
    scene.iso = 500;
    scene.camera.azimuth_deg = 33;
    scene.camera.elevation_deg = 21;
    Plan plan = brute_force(0.5);
    const Frame linear = engine.render(scene, plan).frame;
    const auto worst_and_mean = [&](Sampler sampler) {
        plan.sampler = sampler;
        const Frame frame = engine.render(scene, plan).frame;
        double worst = 0, sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < frame.pixels(); ++i) {
            // Where the surface is not steeper than 45 degrees: elsewhere a stair is met from its side.
            const double slope = std::fabs(double(linear.depth_mm[i]) - 0.5 * scene.volume.geometry().diameter_mm());
            if (!std::isfinite(linear.depth_mm[i]) || !std::isfinite(frame.depth_mm[i]) || slope < 10.1) continue;
            const double off = std::fabs(double(frame.depth_mm[i]) - double(linear.depth_mm[i]));
            worst = std::max(worst, off);
            sum += off;
            ++count;
        }
        return std::pair(worst, sum / count);
    };
    const auto [worst, mean] = worst_and_mean(Sampler::nearest);
    EXPECT_GT(mean, 0.15) << "the failure";
    EXPECT_LE(worst, 0.5 * std::sqrt(3.0) * std::sqrt(2.0) + 0.5) << "half a diagonal at 45 degrees, and the step";
    EXPECT_EQ(worst_and_mean(Sampler::adaptive).first, 0);
}

}  // namespace
}  // namespace lacuna
