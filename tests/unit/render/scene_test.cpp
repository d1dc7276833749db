#include "core/render/scene.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/base/error.h"
#include "core/render/plan.h"
#include "core/volume/statistics.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna {
namespace {

using namespace test;

TEST(Scene, NamesGoThereAndBack) {
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip,
                                ViewMode::mean, ViewMode::shear_warp})
        EXPECT_EQ(parse_view_mode(name_of(mode)), mode);
    EXPECT_EQ(name_of(ViewMode::shear_warp), "shear-warp");
    for (const Shading shading : {Shading::none, Shading::lambert, Shading::phong})
        EXPECT_EQ(parse_shading(name_of(shading)), shading);
    for (const Structure structure : {Structure::none, Structure::macrocells, Structure::visible})
        EXPECT_EQ(parse_structure(name_of(structure)), structure);
    for (const Sampler sampler : {Sampler::nearest, Sampler::linear})
        EXPECT_EQ(parse_sampler(name_of(sampler)), sampler);
    for (const Refinement refinement :
         {Refinement::none, Refinement::bisect, Refinement::regula_falsi, Refinement::newton})
        EXPECT_EQ(parse_refinement(name_of(refinement)), refinement);
    EXPECT_EQ(name_of(Refinement::regula_falsi), "regula-falsi");
    try {
        parse_view_mode("shear_warp");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_usage);
        EXPECT_NE(std::string(error.what()).find("shear-warp"), std::string::npos) << error.what();
    }
}

TEST(Scene, EachFaultIsRefusedAsBadUsage) {
    const Scene sound = scene_of(ball(centred({5, 5, 5}), 2), ViewMode::ea);
    EXPECT_NO_THROW(check(sound));
    const double nan = double(k_nan);
    const std::function<void(Scene&)> faults[] = {
        [](Scene& s) { s.volume = Volume(); },
        [](Scene& s) { s.cuts.assign(Scene::k_max_cuts + 1, CuttingPlane{}); },
        [](Scene& s) {
            s.cuts = {{{0, 0, 0}, 1, true}};
        },
        [&](Scene& s) {
            s.cuts = {{{nan, 0, 0}, 1, true}};
        },
        [&](Scene& s) {
            s.cuts = {{{1, 0, 0}, nan, true}};
        },
        [](Scene& s) {
            s.classification.ranges.assign(Classification::k_max_ranges + 1, {"", {0, 1}, std::nullopt});
        },
        [](Scene& s) {
            s.classification.ranges = {{"", {2, 1}, std::nullopt}};
        },
        [&](Scene& s) {
            s.classification.ranges = {{"", {nan, 1}, std::nullopt}};
        },
        [](Scene& s) { s.camera.zoom = 0; },
        [&](Scene& s) { s.camera.azimuth_deg = nan; },
        [&](Scene& s) { s.camera.center_mm = glm::dvec3(nan); },
        [](Scene& s) { s.camera.fov_deg = 180; },
        [](Scene& s) { s.camera.fov_deg = 1e-6; },
        [&](Scene& s) { s.camera.fov_deg = nan; },
        [](Scene& s) {
            s.size = {0, 5};
        },
        [](Scene& s) {
            s.size = {5, 20000};
        },
        [&](Scene& s) { s.iso = nan; },
        [&](Scene& s) { s.lmip_threshold = nan; },
        [](Scene& s) {
            s.window = {5, 5};
        },
        [&](Scene& s) {
            s.window = {nan, 5};
        },
        [](Scene& s) { s.surface_color.g = 1.5; },
        [&](Scene& s) { s.background.b = nan; },
        [](Scene& s) {
            s.highlights.emplace_back().size = {1, 1, 1};
        },
        [](Scene& s) {
            s.mode = ViewMode::shear_warp;
            s.camera.fov_deg = 30;
        },
    };
    int number = 0;
    for (const auto& fault : faults) {
        Scene scene = sound;
        fault(scene);
        try {
            check(scene);
            ADD_FAILURE() << "fault " << number << " passed";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::bad_usage) << error.what();
        }
        ++number;
    }
}

TEST(Scene, TheDefaultIsFittedAndSoundEvenForAConstantVolume) {
    for (const bool constant : {false, true}) {
        const Volume volume = constant ? sampled<std::uint8_t>(centred({4, 5, 6}), [](const glm::dvec3&) { return 9; })
                                       : ball(centred({9, 9, 9}), 3);
        const VolumeStatistics statistics = compute_statistics(volume);
        const Scene scene = default_scene(volume, statistics);
        EXPECT_NO_THROW(check(scene));
        EXPECT_EQ(scene.window.lo, statistics.range.lo);
        EXPECT_EQ(scene.iso, otsu_threshold(statistics));
        EXPECT_EQ(scene.lmip_threshold, scene.iso);
    }
}

TEST(Plan, DefaultsServeTheirModeAndSayWhy) {
    Scene scene = scene_of(ball(centred({5, 5, 5}), 2), ViewMode::ea);
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip,
                                ViewMode::mean, ViewMode::shear_warp}) {
        scene.mode = mode;
        const Plan plan = default_plan(scene);
        EXPECT_NO_THROW(check(plan, scene)) << name_of(mode);
        EXPECT_FALSE(plan.why.empty());
        const Plan reference = reference_plan(scene, plan);
        EXPECT_NO_THROW(check(reference, scene));
        if (mode == ViewMode::shear_warp) continue;
        EXPECT_EQ(reference.structure, Structure::none);
        EXPECT_EQ(reference.ert, 0);
        EXPECT_EQ(reference.sampler, Sampler::linear);
        EXPECT_EQ(reference.step, plan.step);
    }
}

TEST(Plan, FaultsAreRefused) {
    Scene scene = scene_of(ball(centred({5, 5, 5}), 2), ViewMode::ea);
    const double nan = double(k_nan);
    const std::function<void(Plan&)> faults[] = {
        [](Plan& p) { p.step = 0; },
        [&](Plan& p) { p.step = nan; },
        [](Plan& p) { p.step = 1e9; },
        [](Plan& p) { p.refine_steps = -1; },
        [](Plan& p) { p.ert = 1; },
        [&](Plan& p) { p.ert = nan; },
        [](Plan& p) { p.structure = Structure::visible; },
    };
    for (const auto& fault : faults) {
        Plan plan = default_plan(scene);
        fault(plan);
        EXPECT_THROW(check(plan, scene), Error);
    }
    scene.mode = ViewMode::shear_warp;
    Plan plan = default_plan(scene);
    plan.structure = Structure::macrocells;
    EXPECT_THROW(check(plan, scene), Error);
    plan = default_plan(scene);
    plan.directions = 12;
    EXPECT_THROW(check(plan, scene), Error);
    for (const VoxelGradient filter : {VoxelGradient::central, VoxelGradient::sobel, VoxelGradient::gaussian})
        EXPECT_EQ(parse_voxel_gradient(name_of(filter)), filter);
}

TEST(Frame, To8BitRoundsClampsAndPutsTheBackgroundBehind) {
    Frame frame;
    frame.size = {4, 1};
    frame.color = {{0.5f, 0, 0, 0.5f}, {2, -1, 0.5f, 1}, {k_nan, 0, 0, 1}, {0, 0, 0, 0}};
    const auto rgb = to_rgb8(frame, {0, 1, 0.2});
    EXPECT_EQ(rgb, (std::vector<std::uint8_t>{128, 128, 26, 255, 0, 128, 0, 0, 0, 0, 255, 51}));
}

}  // namespace
}  // namespace lacuna
