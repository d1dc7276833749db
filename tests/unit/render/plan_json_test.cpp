#include "core/render/plan_json.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(PlanJson, EveryChoiceComesBack) {
    ModePlan made;
    made.mode = ViewMode::iso;
    made.plan = {.structure = Structure::eacd,
                 .step = 0.7,
                 .sampler = Sampler::nearest,
                 .refine = Refinement::newton,
                 .refine_steps = 3,
                 .ert = 0.01,
                 .homogeneity = 0.2,
                 .homogeneity_angle_deg = 12,
                 .cells = 4,
                 .sparse = 3,
                 .sparse_gradient = 0.1,
                 .directions = 6,
                 .voxel_gradient = VoxelGradient::gaussian,
                 .leap = {},
                 .why = {"because"}};
    const std::string text = to_json(made);
    const ModePlan back = plan_from_json(text, "test");
    EXPECT_EQ(back.mode, made.mode);
    EXPECT_EQ(back.plan.structure, made.plan.structure);
    EXPECT_EQ(back.plan.step, made.plan.step);
    EXPECT_EQ(back.plan.sampler, made.plan.sampler);
    EXPECT_EQ(back.plan.refine, made.plan.refine);
    EXPECT_EQ(back.plan.refine_steps, made.plan.refine_steps);
    EXPECT_EQ(back.plan.ert, made.plan.ert);
    EXPECT_EQ(back.plan.homogeneity, made.plan.homogeneity);
    EXPECT_EQ(back.plan.homogeneity_angle_deg, made.plan.homogeneity_angle_deg);
    EXPECT_EQ(back.plan.cells, made.plan.cells);
    EXPECT_EQ(back.plan.sparse, made.plan.sparse);
    EXPECT_EQ(back.plan.sparse_gradient, made.plan.sparse_gradient);
    EXPECT_EQ(back.plan.directions, made.plan.directions);
    EXPECT_EQ(back.plan.voxel_gradient, made.plan.voxel_gradient);
    EXPECT_EQ(back.plan.why, made.plan.why);
    EXPECT_EQ(to_json(back), text);
}

TEST(PlanJson, EveryNameThereIsIsRead) {
    for (const auto& [structure, name] : structure_names()) {
        ModePlan made;
        made.plan.structure = structure;
        EXPECT_EQ(plan_from_json(to_json(made), "test").plan.structure, structure) << name;
    }
}

TEST(PlanJson, WhatIsLeftOutKeepsItsDefault) {
    const ModePlan made = plan_from_json("{}", "test");
    EXPECT_EQ(to_json(made), to_json(ModePlan{}));
}

TEST(PlanJson, RefusesWhatItDoesNotKnow) {
    const auto complaint = [](const char* text) -> std::string {
        try {
            plan_from_json(text, "plan.json");
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::bad_input);
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(complaint(R"({"stepp": 1})").find("stepp"), std::string::npos);
    EXPECT_NE(complaint(R"({"step": "wide"})").find("step"), std::string::npos);
    EXPECT_NE(complaint(R"({"structure": "oak"})").find("oak"), std::string::npos);
    EXPECT_NE(complaint(R"({"gradient": "scharr"})").find("gradient"), std::string::npos);
    EXPECT_NE(complaint("[1]").find("plan.json"), std::string::npos);
    EXPECT_NE(complaint("{").find("no JSON"), std::string::npos);
}

}  // namespace
}  // namespace lacuna
