#include "core/accuracy/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/image_error.h"
#include "core/compute/device.h"
#include "core/render/turn.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

Engine& engine() {
    static Engine on_device(open_device());
    return on_device;
}

Scene scene(ViewMode mode, int view = 0) {
    Scene made = small_scene(bumpy_ball<std::uint16_t>({48, 47, 46}, {1, 1, 1.3}, 40000), mode, {97, 80});
    made.camera.azimuth_deg = 17 + 71.0 * view;
    made.camera.elevation_deg = 11.0 * view;
    return made;
}

double true_error(const Scene& shown, const Plan& plan, double step = 0.5) {
    Plan brute = reference_plan(shown, default_plan(shown));
    brute.step = step;
    return compare(engine().render(shown, plan).frame, engine().render(shown, brute).frame, shown.background).max;
}

// Every mode's budgets on random scenes: tests/stability/planner_promise_test.cpp.
TEST(Planner, TheErrorBudgetIsKeptByEveryPixel) {
    for (const ViewMode mode : {ViewMode::ea, ViewMode::mip})
        for (const double budget : {0.0, 1.0, 20.0}) {
            const Scene shown = scene(mode, int(budget) % 3);
            const PlannedPlan planned = choose_plan(engine(), shown, {.error = budget});
            EXPECT_LE(planned.error, budget) << name_of(mode);
            EXPECT_LE(true_error(shown, planned.plan), budget) << name_of(mode);
            EXPECT_TRUE(planned.meets_budget);
            EXPECT_NO_THROW(check(planned.plan, shown));
        }
}

TEST(Planner, EveryRefusalHasItsReason) {
    const PlannedPlan planned = choose_plan(engine(), scene(ViewMode::ea), {.error = 0.5});
    ASSERT_GT(planned.plan.why.size(), 5u);
    EXPECT_NE(planned.plan.why[0].find("error budget 0.5/255"), std::string::npos) << planned.plan.why[0];
    for (std::size_t i = 1; i < planned.plan.why.size(); ++i) {
        EXPECT_TRUE(planned.plan.why[i].starts_with("Refused ")) << planned.plan.why[i];
        EXPECT_NE(planned.plan.why[i].find(": "), std::string::npos);
    }
}

TEST(Planner, TerminationWithinTheBudgetIsNeverRefusedForItsError) {
    const PlannedPlan planned = choose_plan(engine(), scene(ViewMode::ea), {.error = 8.0});
    for (const std::string& why : planned.plan.why) {
        const bool alone = why.find(", ert 0.0261:") != std::string::npos;  // 8 / 306, as Phong's gloss allows
        EXPECT_FALSE(alone && why.find("off") != std::string::npos) << why;
        EXPECT_FALSE(alone && why.find("fails") != std::string::npos) << why;
    }
}

TEST(Planner, ATurnIsPromisedByRuleAndMeasuredInSomeViews) {
    const Scene shown = scene(ViewMode::ea);
    const std::vector<Camera> views = full_turn(shown.camera, 8);
    Budget budget{.error = 8.0};
    budget.other_views.assign(views.begin() + 1, views.end());
    const PlannedPlan planned = choose_plan(engine(), shown, budget);
    EXPECT_NE(known_bound(planned.plan, shown, brute_force(shown, 0.5)).known, ErrorKnown::unknown);
    EXPECT_NE(planned.plan.why[1].find("Holds in all 8 views by rule"), std::string::npos) << planned.plan.why[1];
    EXPECT_NE(planned.plan.why[1].find("measured in 4 of them"), std::string::npos) << planned.plan.why[1];
    EXPECT_TRUE(std::any_of(planned.plan.why.begin(), planned.plan.why.end(), [](const std::string& why) {
        return why.find("how far off it is only a drawn view tells, and 7 more are to come") != std::string::npos;
    }));
    for (const Camera& view : views) {
        Scene turned = shown;
        turned.camera = view;
        EXPECT_LE(true_error(turned, planned.plan), 8) << view.azimuth_deg;
    }
    budget.error.reset();
    budget.time_ms = 1e6;
    const PlannedPlan timed = choose_plan(engine(), shown, budget);
    EXPECT_NE(timed.plan.why[1].find("Measured in 4 of 8 views"), std::string::npos) << timed.plan.why[1];
}

TEST(Planner, AnImpossibleTimeIsSaidAGenerousOneIsExact) {
    const Scene shown = scene(ViewMode::mip);
    const PlannedPlan hopeless = choose_plan(engine(), shown, {.time_ms = 1e-6});
    EXPECT_FALSE(hopeless.meets_budget);
    const PlannedPlan generous = choose_plan(engine(), shown, {.time_ms = 1e6});
    EXPECT_TRUE(generous.meets_budget);
    EXPECT_EQ(true_error(shown, generous.plan), 0);
}

TEST(Planner, TheStepMeantIsTheBudgets) {
    const Scene shown = scene(ViewMode::ea);
    const PlannedPlan planned = choose_plan(engine(), shown, {.error = 0.0, .step = 0.25});
    EXPECT_EQ(planned.plan.step, 0.25);
    EXPECT_EQ(true_error(shown, planned.plan, 0.25), 0);
}

TEST(Planner, RefusesBudgetsThatAreNone) {
    const Scene shown = scene(ViewMode::ea);
    const double nan = std::nan("");
    EXPECT_THROW(choose_plan(engine(), shown, {}), Error);
    EXPECT_THROW(choose_plan(engine(), shown, {.error = -1}), Error);
    EXPECT_THROW(choose_plan(engine(), shown, {.error = nan}), Error);
    EXPECT_THROW(choose_plan(engine(), shown, {.time_ms = nan}), Error);
    EXPECT_THROW(choose_plan(engine(), shown, {.error = 1.0, .frames = 0}), Error);
    EXPECT_THROW(choose_plan(engine(), scene(ViewMode::shear_warp), {.error = 1}), Error);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(choose_plan(engine(), shown, {.error = 1}, {stop.get_token()}), Error);
}

}  // namespace
}  // namespace lacuna
