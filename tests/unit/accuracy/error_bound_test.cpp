#include "core/accuracy/error_bound.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/accuracy/image_error.h"
#include "core/render/reference_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

Scene scene(ViewMode mode, VoxelType type = VoxelType::u16) {
    return type == VoxelType::f32 ? small_scene(bumpy_ball<float>({19, 18, 17}, {1, 1, 1.4}, 1), mode)
                                  : small_scene(bumpy_ball<std::uint16_t>({19, 18, 17}, {1, 1, 1.4}, 50000), mode);
}

ErrorBound bound(const Plan& plan, const Scene& shown) { return known_bound(plan, shown, brute_force(shown, 0.5)); }

TEST(ErrorBound, StructuresAndTheAdaptiveSamplerLoseNothing) {
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::mean})
        for (const auto& [structure, name] : structure_names()) {
            if (structure == Structure::visible) continue;
            for (const Sampler sampler : {Sampler::linear, Sampler::adaptive}) {
                Plan plan = brute_force(scene(mode), 0.5);
                plan.structure = structure;
                plan.sampler = sampler;
                EXPECT_EQ(bound(plan, scene(mode)).known, ErrorKnown::exact) << name << ' ' << name_of(mode);
            }
        }
}

TEST(ErrorBound, TerminationIsBoundedByWhatItCanHide) {
    Scene shown = scene(ViewMode::ea);
    Plan plan = brute_force(shown, 0.5);
    plan.ert = 0.01;
    const ErrorBound made = bound(plan, shown);
    EXPECT_EQ(made.known, ErrorKnown::bounded);
    EXPECT_DOUBLE_EQ(made.levels, hidden_levels(0.01, Shading::phong));
    EXPECT_EQ(made.losses, std::vector<Loss>{Loss::termination});
    shown.mode = ViewMode::mip;  // ends no ray early
    EXPECT_EQ(bound(plan, shown).known, ErrorKnown::exact);
    shown.mode = ViewMode::ea;
    shown.effects = parse_effects("gamma=2.2");  // raises dark differences beyond the bound
    EXPECT_EQ(bound(plan, shown).known, ErrorKnown::unknown);
}

TEST(ErrorBound, TheBoundHoldsWhereTerminationHidesMost) {
    // Fog before a bright core: what is hidden is as bright as it gets.
    for (const double ert : {0.3, 0.05, 0.002})
        for (const Shading shading : {Shading::none, Shading::lambert, Shading::phong}) {
            Scene shown = scene(ViewMode::ea);
            shown.shading = shading;
            shown.background = {1, 1, 1};
            shown.classification.tf = {
                "fog", 1.0, {{0, {0, 0, 0}, 0.15}, {30000, {0, 0, 0}, 0.2}, {45000, {1, 1, 1}, 0.9}}, {}};
            Plan plan = brute_force(shown, 0.5);
            const Frame truth = render_reference(shown, plan);
            plan.ert = ert;
            const double error = compare(render_reference(shown, plan), truth, shown.background).max;
            EXPECT_LE(error, bound(plan, shown).levels);
            if (ert > 0.1) {
                EXPECT_GT(error, 0.05 * bound(plan, shown).levels) << "the scene hides nothing";
            }
        }
}

TEST(ErrorBound, EveryOtherLossIsNamedAndOfUnknownSize) {
    struct Case {
        ViewMode mode;
        Loss loss;
        std::function<void(Plan&)> change;
        VoxelType type = VoxelType::u16;
    };
    const Case cases[] = {
        {ViewMode::mip, Loss::step, [](Plan& p) { p.step = 1; }},
        {ViewMode::mip, Loss::nearest, [](Plan& p) { p.sampler = Sampler::nearest; }},
        {ViewMode::iso, Loss::sparse, [](Plan& p) { p.sparse = 2; }},
        {ViewMode::ea, Loss::thresholds, [](Plan& p) { p.structure = Structure::acd, p.homogeneity = 0.01; }},
        {ViewMode::ea, Loss::thresholds, [](Plan& p) { p.structure = Structure::octree, p.homogeneity = 0.01; }},
        {ViewMode::ea, Loss::quantised,
         [](Plan& p) { p.structure = Structure::leap, p.leap.kernel = Leaping::published; }},
        {ViewMode::ea, Loss::quantised, [](Plan& p) { p.structure = Structure::leap; }, VoxelType::f32},
        {ViewMode::iso, Loss::stored_gradients, [](Plan& p) { p.gradient_store = GradientStore::stored; }},
        {ViewMode::ea, Loss::gradient_filter, [](Plan& p) { p.gradient = GradientFilter::sobel; }},
        {ViewMode::iso, Loss::refinement, [](Plan& p) { p.refine = Refinement::none; }},
        {ViewMode::iso, Loss::refinement, [](Plan& p) { p.refine_steps = 2; }},
        {ViewMode::ea, Loss::segments, [](Plan& p) { p.integration = Integration::preintegrated; }}};
    for (const Case& c : cases) {
        const Scene shown = scene(c.mode, c.type);
        Plan plan = brute_force(shown, 0.5);
        c.change(plan);
        const ErrorBound made = bound(plan, shown);
        EXPECT_EQ(made.known, ErrorKnown::unknown) << int(c.loss);
        EXPECT_EQ(made.losses, std::vector<Loss>{c.loss}) << int(c.loss);
        plan.ert = 0.01;
        if (c.mode == ViewMode::ea) {
            EXPECT_EQ(bound(plan, shown).known, ErrorKnown::unknown) << "two losses, one bound";
        }
    }
}

TEST(ErrorBound, WhatTheModeHasNoUseForIsNoLoss) {
    const Scene mip = scene(ViewMode::mip);
    Plan plan = brute_force(mip, 0.5);
    plan.gradient_store = GradientStore::stored;
    plan.gradient = GradientFilter::sobel;
    plan.refine = Refinement::none;
    plan.homogeneity = 0.1;  // no structure that knows thresholds
    EXPECT_EQ(bound(plan, mip).known, ErrorKnown::exact);
    Scene flat = scene(ViewMode::ea);
    flat.shading = Shading::none;
    EXPECT_EQ(bound(plan, flat).known, ErrorKnown::exact);
    flat.classification.tf.gradient_opacity = {{0, 0.1}, {4000, 1.0}};
    EXPECT_EQ(bound(plan, flat).losses, (std::vector<Loss>{Loss::stored_gradients, Loss::gradient_filter}));
}

TEST(ErrorBound, ShearWarpHasNoBruteForce) {
    const Scene shown = scene(ViewMode::shear_warp);
    const ErrorBound made = bound(default_plan(shown), shown);
    EXPECT_EQ(made.known, ErrorKnown::unknown);
    EXPECT_EQ(made.losses, std::vector<Loss>{Loss::shear_warp});
}

}  // namespace
}  // namespace lacuna
