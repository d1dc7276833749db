// The planner's promise on scenes nobody chose: random volumes, transfer functions, cameras and budgets.
#include <gtest/gtest.h>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/image_error.h"
#include "core/accuracy/planner.h"
#include "core/compute/device.h"
#include "core/render/turn.h"
#include "tests/support/random_scenes.h"

namespace lacuna {
namespace {

using namespace test;

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

TEST(PlannerPromise, ABudgetHoldsInEveryViewOfATurnThoughFewAreMeasured) {
    const std::shared_ptr<ComputeDevice> device = open_device();
    if (!device) GTEST_SKIP() << "no device";
    Engine engine(device);
    int lossy = 0;
    for (const unsigned seed : {3u, 6u, 7u, 11u}) {
        Random random(seed);
        Scene scene = random_scene(random, {64, 48});
        if (seed != 3) scene.mode = ViewMode::ea;  // where rules allow for some loss
        const double budget = 8;
        const std::vector<Camera> views = full_turn(scene.camera, 9);
        Budget asked{.error = budget};
        asked.other_views.assign(views.begin() + 1, views.end());
        const PlannedPlan planned = choose_plan(engine, scene, asked);
        const Plan brute = brute_force(scene, asked.step);
        EXPECT_NE(known_bound(planned.plan, scene, brute).known, ErrorKnown::unknown) << planned.plan.why[0];
        EXPECT_NE(planned.plan.why[1].find("Holds in all 9 views by rule"), std::string::npos) << planned.plan.why[1];
        EXPECT_NE(planned.plan.why[1].find("measured in 4 of them"), std::string::npos) << planned.plan.why[1];
        for (const Camera& view : views) {
            scene.camera = view;
            const double error =
                compare(engine.render(scene, planned.plan).frame, engine.render(scene, brute).frame, scene.background)
                    .max;
            EXPECT_LE(error, budget) << "seed " << seed << " at " << view.azimuth_deg;
            lossy += error > 0;
        }
    }
    EXPECT_GT(lossy, 0) << "a budget nobody uses proves nothing";
}

}  // namespace
}  // namespace lacuna
