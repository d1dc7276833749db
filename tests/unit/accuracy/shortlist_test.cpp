#include "core/accuracy/shortlist.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/accuracy/error_bound.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

ModePlan plan(Structure structure, double step = 0.5, double ert = 0, Sampler sampler = Sampler::linear) {
    ModePlan made{ViewMode::ea, {}};
    made.plan.structure = structure;
    made.plan.step = step;
    made.plan.ert = ert;
    made.plan.sampler = sampler;
    return made;
}

TEST(Shortlist, OnlyTheHopelessAreLeftOut) {
    const std::vector<std::string> reasons = leave_out({{plan(Structure::none), 100.0},
                                                        {plan(Structure::acd), 10.0},
                                                        {plan(Structure::octree), 39.0},
                                                        {plan(Structure::pyramid), 41.0},
                                                        {plan(Structure::leap), std::nullopt}});
    ASSERT_EQ(reasons.size(), 5u);
    EXPECT_NE(reasons[0].find("acd"), std::string::npos) << reasons[0];
    EXPECT_EQ(reasons[1], "");
    EXPECT_EQ(reasons[2], "");
    EXPECT_NE(reasons[3], "");
    EXPECT_EQ(reasons[4], "") << "nothing is known of it";
}

TEST(Shortlist, NothingKnownLeavesNothingOut) {
    EXPECT_TRUE(leave_out({}).empty());
    for (const std::string& reason : leave_out({{plan(Structure::none), {}}, {plan(Structure::acd), {}}}))
        EXPECT_EQ(reason, "");
    const auto reasons = leave_out({{plan(Structure::none), std::nan("")}, {plan(Structure::acd), 5.0}});
    EXPECT_EQ(reasons[1], "");
}

TEST(Shortlist, AMilderPlanThatFailsTakesTheBolderWithIt) {
    const std::vector<TooFarOff> off{{plan(Structure::acd, 1, 0.01), 14}};
    EXPECT_NE(off_already(plan(Structure::acd, 1.5, 0.01), off).find("14/255"), std::string::npos);
    EXPECT_NE(off_already(plan(Structure::acd, 1, 0.05), off), "");
    EXPECT_EQ(off_already(plan(Structure::acd, 0.75, 0.01), off), "");
    EXPECT_EQ(off_already(plan(Structure::acd, 1.5, 0), off), "") << "less termination";
    EXPECT_EQ(off_already(plan(Structure::acd, 1.5, 0.01, Sampler::nearest), off), "");
    EXPECT_EQ(off_already(plan(Structure::octree, 1.5, 0.01), off), "");
    ModePlan segments = plan(Structure::acd, 1.5, 0.01);
    segments.plan.integration = Integration::preintegrated;
    EXPECT_EQ(off_already(segments, off), "");
}

TEST(Shortlist, TrialsGoOnWhileOneMayBeFaster) {
    EXPECT_TRUE(worth_a_trial(100, std::numeric_limits<double>::infinity(), 0)) << "nothing fits yet";
    EXPECT_TRUE(worth_a_trial(15, 10, 1));
    EXPECT_FALSE(worth_a_trial(30, 10, 1));
    EXPECT_FALSE(worth_a_trial(5, 10, k_finalists)) << "enough of them";
    EXPECT_FALSE(worth_a_trial(std::nan(""), 10, 1));
    EXPECT_EQ(still_in({10, 12, 13, 9.9, std::nan("")}), (std::vector<bool>{true, true, false, true, false}));
    EXPECT_TRUE(still_in({}).empty());
}

TEST(Shortlist, NumbersAreRoundedDownToThreeDigits) {
    EXPECT_EQ(rounded_down(0.0016339869), 0.00163);
    EXPECT_EQ(rounded_down(0.5), 0.499) << "below it, whatever the rounding was";
    EXPECT_EQ(rounded_down(123.9), 123);
    EXPECT_EQ(rounded_down(0), 0);
    EXPECT_EQ(rounded_down(-1), 0);
    EXPECT_EQ(rounded_down(std::nan("")), 0);
}

Scene scene(ViewMode mode) {
    return test::small_scene(test::bumpy_ball<std::uint16_t>({16, 15, 14}, {1, 1, 1}, 40000), mode);
}

TEST(Shortlist, EveryStructureThatServesIsOnIt) {
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::mean}) {
        const Scene shown = scene(mode);
        const ModePlan brute{mode, brute_force(shown, 0.5)};
        std::set<Structure> structures;
        for (const ModePlan& plan : lossless_plans(shown, brute)) {
            structures.insert(plan.plan.structure);
            EXPECT_TRUE(losses(plan.plan, shown, brute.plan).empty()) << name_of(plan.plan.structure);
        }
        EXPECT_EQ(structures.size(), structure_names().size() - 1) << "all but shear-warp's";
    }
}

TEST(Shortlist, TerminationAloneKeepsTheBudgetByRule) {
    const Scene shown = scene(ViewMode::ea);
    const ModePlan brute{ViewMode::ea, brute_force(shown, 0.5)};
    for (const double budget : {0.0, 0.5, 8.0, 200.0}) {
        int bounded = 0;
        for (const ModePlan& trade : trades(shown, brute, budget)) {
            EXPECT_NE(to_json(trade), to_json(brute));
            const ErrorBound bound = known_bound(trade.plan, shown, brute.plan);
            if (bound.known != ErrorKnown::bounded) continue;
            ++bounded;
            EXPECT_LE(bound.levels, budget);
            EXPECT_GT(bound.levels, budget < 100 ? 0.95 * budget : 100) << "and uses it";
        }
        EXPECT_EQ(bounded > 0, budget > 0) << budget;
    }
    bool steeper = false;
    for (const ModePlan& trade : trades(shown, brute, std::nullopt)) steeper |= trade.plan.ert > 0.02;
    EXPECT_TRUE(steeper) << "no budget of error bounds it";
}

}  // namespace
}  // namespace lacuna
