#include "core/accuracy/shortlist.h"

#include <gtest/gtest.h>

#include <limits>

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

TEST(Shortlist, FinalistsAreCloseToTheFirstThatFits) {
    const std::vector<double> expected{5, 10, 11, 13, 13.5, 30};
    EXPECT_EQ(finalists(expected, 0), 1u);
    EXPECT_EQ(finalists(expected, 1), k_finalists);
    EXPECT_EQ(finalists(expected, 4), 1u);
    EXPECT_EQ(finalists(expected, 5), 1u);
    EXPECT_EQ(finalists(expected, 6), 0u);
    EXPECT_EQ(finalists({1, std::nan("")}, 0), 1u);
}

}  // namespace
}  // namespace lacuna
