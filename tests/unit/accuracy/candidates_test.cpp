#include "core/accuracy/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

constexpr ViewMode k_modes[] = {ViewMode::iso,   ViewMode::ea,   ViewMode::mip,       ViewMode::lmip,
                                ViewMode::minip, ViewMode::mean, ViewMode::shear_warp};

Scene scene(ViewMode mode) { return small_scene(bumpy_ball<std::uint8_t>({20, 20, 20}, {1, 1, 1}, 200), mode); }

TEST(Candidates, EveryStructureThereIsIsConsideredInEveryMode) {
    for (const ViewMode mode : k_modes)
        for (const SweepExtent extent : {SweepExtent::quick, SweepExtent::full}) {
            const std::vector<Candidate> found = candidates(scene(mode), 0.5, extent);
            for (const auto& [structure, name] : structure_names())
                EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                        [&](const Candidate& c) { return c.plan.plan.structure == structure; }))
                    << name << " in " << name_of(mode);
        }
}

TEST(Candidates, TheFullSweepTriesEverySamplerAndRefinement) {
    const std::vector<Candidate> found = candidates(scene(ViewMode::iso), 0.5, SweepExtent::full);
    for (const auto& [sampler, name] : sampler_names())
        EXPECT_TRUE(
            std::any_of(found.begin(), found.end(), [&](const auto& c) { return c.plan.plan.sampler == sampler; }));
    for (const auto& [refinement, name] : refinement_names())
        EXPECT_TRUE(
            std::any_of(found.begin(), found.end(), [&](const auto& c) { return c.plan.plan.refine == refinement; }));
}

TEST(Candidates, BruteForceIsFirstAndNoneIsThereTwice) {
    for (const ViewMode mode : k_modes)
        for (const SweepExtent extent : {SweepExtent::quick, SweepExtent::full}) {
            const Scene shown = scene(mode);
            const std::vector<Candidate> found = candidates(shown, 0.7, extent);
            EXPECT_EQ(found.front().refused, "");
            if (mode != ViewMode::shear_warp) {
                EXPECT_EQ(found.front().plan.plan.structure, Structure::none);
                EXPECT_EQ(found.front().plan.plan.ert, 0);
                EXPECT_EQ(found.front().plan.plan.step, 0.7);
            }
            std::set<std::string> seen;
            for (const Candidate& c : found) {
                EXPECT_TRUE(seen.insert(to_json(c.plan)).second) << to_json(c.plan);
                EXPECT_GE(c.plan.plan.step, 0.7) << "none finer than the reference";
                if (!c.refused.empty()) continue;
                Scene drawn = shown;
                drawn.mode = c.plan.mode;
                EXPECT_NO_THROW(check(c.plan.plan, drawn));
            }
            if (extent == SweepExtent::quick) {
                EXPECT_LE(found.size(), structure_names().size() + 14);
            }
        }
}

TEST(Candidates, AFullSweepBeginsWithTheQuickOne) {
    for (const ViewMode mode : k_modes) {
        const std::vector<Candidate> quick = candidates(scene(mode), 0.5, SweepExtent::quick);
        const std::vector<Candidate> full = candidates(scene(mode), 0.5, SweepExtent::full);
        ASSERT_GE(full.size(), quick.size());
        for (std::size_t i = 0; i < quick.size() && quick[i].refused.empty(); ++i)
            EXPECT_EQ(to_json(full[i].plan), to_json(quick[i].plan)) << name_of(mode) << " " << i;
    }
}

TEST(Candidates, WhatCannotServeIsARowWithItsReason) {
    const std::vector<Candidate> found = candidates(scene(ViewMode::mip), 0.5, SweepExtent::quick);
    const auto visible = std::find_if(found.begin(), found.end(),
                                      [](const Candidate& c) { return c.plan.plan.structure == Structure::visible; });
    ASSERT_NE(visible, found.end());
    EXPECT_NE(visible->refused.find("visible"), std::string::npos);
    Scene perspective = scene(ViewMode::iso);
    const auto warped = [](const std::vector<Candidate>& all) {
        return std::count_if(all.begin(), all.end(), [](const Candidate& c) {
            return c.refused.empty() && c.plan.mode == ViewMode::shear_warp;
        });
    };
    EXPECT_EQ(warped(candidates(perspective, 0.5, SweepExtent::quick)), 2) << "bilinear and nearest";
    perspective.camera.fov_deg = 40;
    EXPECT_EQ(warped(candidates(perspective, 0.5, SweepExtent::quick)), 0) << "shear-warp is orthographic";
}

TEST(Candidates, WordsSayWhatDiffers) {
    ModePlan reference, plan;
    EXPECT_EQ(difference_in_words(plan, reference), "");
    plan.plan.structure = Structure::octree;
    EXPECT_EQ(difference_in_words(plan, reference), "");
    plan.plan.step = 1.5;
    plan.plan.sparse = 3;
    plan.plan.sampler = Sampler::nearest;
    EXPECT_EQ(difference_in_words(plan, reference), "step 1.5, sampler nearest, sparse 3");
    plan.plan = {};
    plan.plan.structure = Structure::leap;
    EXPECT_EQ(difference_in_words(plan, reference), "") << "how leap values are made is no picture's matter";
    plan.plan.leap.kernel = Leaping::confirmed;
    EXPECT_EQ(difference_in_words(plan, reference), "kernel confirmed");
}

}  // namespace
}  // namespace lacuna
