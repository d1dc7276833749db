#include "core/accuracy/live_sweep.h"

#include <gtest/gtest.h>

#include <set>

#include "core/accuracy/error_bound.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

Scene scene(ViewMode mode = ViewMode::ea) {
    return small_scene(bumpy_ball<std::uint8_t>({16, 15, 14}, {1, 1, 1}, 200), mode, {24, 20});
}

LiveSweep sweep_of(const Scene& shown) {
    return LiveSweep(shown, 0.5, SweepExtent::quick, {shown.mode, default_plan(shown)});
}

LiveSweep::Visit visit_of(double ms, double error = 0) {
    LiveSweep::Visit visit;
    visit.ms = ms;
    visit.error.max = error;
    return visit;
}

TEST(LiveSweep, BruteForceComesFirstThenThePlanInUse) {
    const Scene shown = scene();
    const ModePlan own{ViewMode::ea, [&] {
                           Plan plan = default_plan(shown);
                           plan.step = 0.83;
                           return plan;
                       }()};
    LiveSweep sweep(shown, 0.5, SweepExtent::quick, own);
    EXPECT_EQ(sweep.find(own), 1u);
    EXPECT_EQ(*sweep.next(), 0u);
    EXPECT_EQ(sweep.result().points[0].plan.plan.structure, Structure::none);
    EXPECT_EQ(sweep.measured(), 0u);
    EXPECT_TRUE(sweep.pending(0));
}

TEST(LiveSweep, EveryPlanIsVisitedOnceARoundForthAndBack) {
    LiveSweep sweep = sweep_of(scene());
    std::vector<std::size_t> visited;
    while (const auto at = sweep.next()) {
        visited.push_back(*at);
        sweep.add(visit_of(1 + double(visited.size() % 7), 0));
    }
    const std::size_t plans = visited.size() / LiveSweep::k_rounds;
    ASSERT_EQ(visited.size(), plans * LiveSweep::k_rounds);
    EXPECT_GT(plans, 8u);
    EXPECT_EQ(std::set(visited.begin(), visited.begin() + std::ptrdiff_t(plans)).size(), plans);
    for (std::size_t i = 0; i < plans; ++i) EXPECT_EQ(visited[plans + i], visited[plans - 1 - i]);
    EXPECT_EQ(sweep.result().rounds, LiveSweep::k_rounds);
    EXPECT_EQ(sweep.measured(), plans);
    for (std::size_t i = 0; i < sweep.result().points.size(); ++i) EXPECT_FALSE(sweep.pending(i));
}

TEST(LiveSweep, APlanThatFailsLaterLeavesTheFrontToOthers) {
    LiveSweep sweep = sweep_of(scene());
    const std::size_t fast = 1;
    while (sweep.result().rounds == 0) sweep.add(visit_of(*sweep.next() == fast ? 1 : 50, 0));
    ASSERT_TRUE(sweep.result().points[fast].on_front);
    const std::size_t measured = sweep.measured();
    while (*sweep.next() != fast) sweep.add(visit_of(50, 0));
    LiveSweep::Visit failed;
    failed.refused = "The device is gone.";
    sweep.add(failed);
    EXPECT_FALSE(sweep.result().points[fast].on_front);
    EXPECT_TRUE(sweep.result().points[0].on_front);
    EXPECT_FALSE(sweep.pending(fast));
    EXPECT_EQ(sweep.measured(), measured - 1);
    for (auto at = sweep.next(); at; at = sweep.next()) {
        EXPECT_NE(*at, fast);
        sweep.add(visit_of(50, 0));
    }
    EXPECT_EQ(sweep.result().rounds, LiveSweep::k_rounds);
}

TEST(LiveSweep, TimesAreMediansAndTheFrontFollowsThem) {
    LiveSweep sweep = sweep_of(scene());
    const std::size_t brute = 0, fast = 1;
    int round = 0;
    while (const auto at = sweep.next()) {
        round = sweep.result().rounds;
        if (*at == brute)
            sweep.add(visit_of(round == 0 ? 1000 : 50, 0));  // the first was an accident
        else if (*at == fast)
            sweep.add(visit_of(10, 0.5));
        else
            sweep.add(visit_of(200, 3));
    }
    EXPECT_EQ(sweep.result().points[brute].ms, 50);
    EXPECT_TRUE(sweep.result().points[brute].on_front);
    EXPECT_TRUE(sweep.result().points[fast].on_front);
    for (std::size_t i = 2; i < sweep.result().points.size(); ++i) EXPECT_FALSE(sweep.result().points[i].on_front);
}

TEST(LiveSweep, APlanThatFailsIsLeftOutWithItsReason) {
    LiveSweep sweep = sweep_of(scene());
    std::size_t visits = 0, failed = 0;
    while (const auto at = sweep.next()) {
        LiveSweep::Visit visit = visit_of(5);
        if (*at == 2) visit.refused = "It does not fit.", ++failed;
        sweep.add(visit);
        ASSERT_LT(++visits, 1000u);
    }
    EXPECT_EQ(failed, 1u);
    EXPECT_EQ(sweep.result().points[2].refused, "It does not fit.");
    EXPECT_FALSE(sweep.pending(2));
    for (std::size_t i = 3; i < 6; ++i) EXPECT_TRUE(sweep.result().points[i].refused.empty()) << i;
}

TEST(LiveSweep, APlanThatComesIntoUseIsMeasuredNext) {
    const Scene shown = scene();
    for (const int before : {0, 3, 40, 10000}) {
        LiveSweep sweep = sweep_of(shown);
        for (int i = 0; i < before && sweep.next(); ++i) sweep.add(visit_of(5));
        ModePlan own{ViewMode::ea, default_plan(shown)};
        own.plan.step = 0.77;
        sweep.include(own);
        sweep.include(own);
        ASSERT_TRUE(sweep.next()) << before;
        EXPECT_EQ(*sweep.next(), *sweep.find(own)) << before;
        sweep.add(visit_of(2));
        EXPECT_EQ(sweep.result().points[*sweep.find(own)].ms, 2);
        for (int visits = 0; sweep.next(); ++visits) {
            sweep.add(visit_of(5));
            ASSERT_LT(visits, 1000);
        }
    }
}

TEST(LiveSweep, AVisitMeasuresErrorAndTime) {
    const Scene shown = scene();
    Engine engine(nullptr);
    const Plan brute = brute_force(shown, 0.5);
    const TruePicture truth(engine.render(shown, brute).frame, shown.background);
    const LiveSweep::Visit same = draw_visit(engine, shown, {ViewMode::ea, brute}, &truth);
    EXPECT_EQ(same.error.max, 0);
    EXPECT_GT(same.ms, 0);
    Plan coarse = brute;
    coarse.step = 2;
    EXPECT_GT(draw_visit(engine, shown, {ViewMode::ea, coarse}, &truth).error.max, 0);
    coarse.step = -1;
    EXPECT_FALSE(draw_visit(engine, shown, {ViewMode::ea, coarse}, &truth).refused.empty());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(draw_visit(engine, shown, {ViewMode::ea, brute}, &truth, {stop.get_token()}), Error);
}

}  // namespace
}  // namespace lacuna
