// The planner's promise on scenes nobody chose: random volumes, transfer functions, cameras and budgets.
#include <gtest/gtest.h>

#include <random>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/image_error.h"
#include "core/accuracy/planner.h"
#include "core/compute/device.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

using Random = std::mt19937;

double between(Random& random, double lo, double hi) { return std::uniform_real_distribution(lo, hi)(random); }

/// Balls, thin walls and noise.
Volume random_volume(Random& random) {
    GridGeometry grid;
    for (int axis = 0; axis < 3; ++axis) {
        grid.size[axis] = int(between(random, 20, 40));
        grid.spacing[axis] = between(random, 0.6, 1.8);
    }
    struct Ball {
        glm::dvec3 centre;
        double radius, value;
    };
    std::vector<Ball> balls(4);
    for (Ball& ball : balls)
        ball = {glm::dvec3(between(random, 0, 1), between(random, 0, 1), between(random, 0, 1)),
                between(random, 0.05, 0.35), between(random, 5000, 40000)};
    const double wall = between(random, 0.2, 0.8), thickness = between(random, 0.01, 0.06);
    const double noise = between(random, 0, 1500);
    return make_volume<std::uint16_t>(grid, [&](auto voxels) {
        std::size_t i = 0;
        for (int z = 0; z < grid.size.z; ++z)
            for (int y = 0; y < grid.size.y; ++y)
                for (int x = 0; x < grid.size.x; ++x) {
                    const glm::dvec3 p = (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(grid.size);
                    double value = between(random, 0, noise);
                    for (const Ball& ball : balls)
                        value += ball.value / (1 + std::exp(40 * (glm::length(p - ball.centre) - ball.radius)));
                    if (std::fabs(p.x - wall) < thickness) value += 15000;
                    voxels[i++] = std::uint16_t(std::clamp(value, 0.0, 65535.0));
                }
    });
}

Scene random_scene(Random& random) {
    const ViewMode modes[] = {ViewMode::ea, ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::mean};
    Scene scene = small_scene(random_volume(random), modes[random() % 5], {96, 72});
    scene.iso = between(random, 4000, 30000);
    TransferFunction function{"random", between(random, 0.5, 3), {}, {}};
    const double start = between(random, 0, 8000);
    for (int i = 0; i < 5; ++i)
        function.points.push_back({start + 9000.0 * i,
                                   {between(random, 0, 1), between(random, 0, 1), between(random, 0, 1)},
                                   i == 0 ? 0 : between(random, 0, 0.8)});
    scene.classification.tf = function;
    scene.camera.azimuth_deg = between(random, -180, 180);
    scene.camera.elevation_deg = between(random, -90, 90);
    scene.camera.zoom = between(random, 0.9, 3);
    if (random() % 3 == 0) scene.camera.fov_deg = between(random, 10, 60);
    return scene;
}

TEST(PlannerPromise, ThePickedPlanKeepsItsBudgetOnHeldBackScenes) {
    const std::shared_ptr<ComputeDevice> device = open_device();
    if (!device) GTEST_SKIP() << "no device";
    Engine engine(device);
    constexpr int k_scenes = 24;
    const double budgets[] = {0, 0.5, 2, 8, 32};
    // Costs of a device on which everything is alike: what is left out must never cost the promise.
    const DeviceCosts costs{"", "", "", 0.1, 50, 10, 5, 5, 40, 20, 5};
    int exceeded = 0, lossy = 0;
    for (unsigned seed = 1; seed <= k_scenes; ++seed) {
        Random random(seed);
        const Scene scene = random_scene(random);
        const double budget = budgets[seed % 5];
        Budget asked{.error = budget};
        if (seed % 2) asked.costs = costs;
        const PlannedPlan planned = choose_plan(engine, scene, asked);
        const Plan brute = brute_force(scene, asked.step);
        const double error =
            compare(engine.render(scene, planned.plan).frame, engine.render(scene, brute).frame, scene.background).max;
        EXPECT_LE(error, 2 * budget) << "seed " << seed << ", " << name_of(scene.mode) << ": " << planned.plan.why[0];
        EXPECT_DOUBLE_EQ(error, planned.error) << "seed " << seed << ": what was said is not what is";
        exceeded += !(error <= budget);
        lossy += error > 0;
        const ErrorBound bound = known_bound(planned.plan, scene, brute);
        if (bound.known == ErrorKnown::bounded) {
            EXPECT_LE(error, bound.levels) << "seed " << seed;
        }
        if (bound.known == ErrorKnown::exact) {
            EXPECT_LE(error, 1) << "seed " << seed;  // single precision
        }
    }
    EXPECT_LE(exceeded, 0.01 * k_scenes);
    EXPECT_GE(lossy, 3) << "budgets nobody uses prove nothing";
}

}  // namespace
}  // namespace lacuna
