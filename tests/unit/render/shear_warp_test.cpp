#include "core/render/shear_warp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna {
namespace {

using namespace test;

struct Agreement {
    double overlap = 0;     ///< covered by both / covered by either
    double worst_mm = 0;    ///< depth, where the surface is not grazed
    double typical_mm = 0;  ///< mean of the same
    int compared = 0;
};

Frame shear_warp(Scene scene, ShearWarpRenderer* renderer = nullptr) {
    scene.mode = ViewMode::shear_warp;
    BuildRecord built;
    ShearWarpRenderer own;
    return (renderer ? *renderer : own).render(scene, default_plan(scene), {}, built);
}

/// Against the iso reference: where shading shows a surface not steeper than 45 degrees, and its neighbours agree.
Agreement compare_with_rays(Scene scene, const Frame& warped) {
    scene.mode = ViewMode::iso;
    scene.shading = Shading::lambert;
    scene.surface_color = glm::dvec3(1);
    const Frame truth = render_reference(scene, brute_force(0.25));
    const double pixel = resolve(scene.camera, scene.volume.geometry(), scene.size).pixel_mm;
    Agreement agreement;
    double both = 0, either = 0;
    for (int y = 1; y + 1 < truth.size.y; ++y) {
        for (int x = 1; x + 1 < truth.size.x; ++x) {
            const std::size_t i = pixel_index(truth, x, y);
            const bool a = truth.color[i].a > 0.5f, b = warped.color[i].a >= 0.5f;
            both += a && b;
            either += a || b;
            if (!(a && b)) continue;
            bool steep = false;
            for (const std::size_t n : {i - 1, i + 1, i - std::size_t(truth.size.x), i + std::size_t(truth.size.x)})
                steep = steep || !(std::fabs(truth.depth_mm[n] - truth.depth_mm[i]) <= pixel);
            if (steep) continue;
            const double error = std::fabs(warped.depth_mm[i] - truth.depth_mm[i]);
            agreement.worst_mm = std::fmax(agreement.worst_mm, error);
            agreement.typical_mm += error;
            ++agreement.compared;
        }
    }
    agreement.overlap = either > 0 ? both / either : 1;
    if (agreement.compared > 0) agreement.typical_mm /= agreement.compared;
    return agreement;
}

Scene ball_scene(glm::dvec3 spacing, double turn_deg) {
    const glm::ivec3 size = glm::ivec3(glm::round(70.0 / spacing));
    return scene_of(ball(centred(size, spacing, turn_deg), 30), ViewMode::iso, 160);
}

TEST(ShearWarp, AgreesWithRaysFromAllSixSidesAndBetween) {
    struct Case {
        glm::dvec3 spacing;
        double turn_deg;
    };
    for (const Case& c : {Case{glm::dvec3(1), 0}, Case{{1, 1, 2}, 0}, Case{{0.8, 1, 1.5}, 30}}) {
        Scene scene = ball_scene(c.spacing, c.turn_deg);
        ShearWarpRenderer renderer;
        const double diagonal = glm::length(c.spacing);
        for (const auto& [azimuth, elevation] : {std::pair(10.0, 5.0),
                                                 {100.0, 5.0},
                                                 {190.0, -5.0},
                                                 {-80.0, 5.0},
                                                 {0.0, 80.0},
                                                 {20.0, -80.0},
                                                 {0.0, 0.0},
                                                 {90.0, 0.0},
                                                 {45.0, 0.0},
                                                 {44.0, 35.0},
                                                 {0.0, 90.0}}) {
            scene.camera.azimuth_deg = azimuth;
            scene.camera.elevation_deg = elevation;
            scene.camera.roll_deg = 15;
            scene.camera.zoom = 1.3;
            const Agreement agreement = compare_with_rays(scene, shear_warp(scene, &renderer));
            SCOPED_TRACE(testing::Message()
                         << azimuth << ' ' << elevation << " z " << c.spacing.z << " turned " << c.turn_deg);
            EXPECT_GT(agreement.overlap, c.spacing.z > 1 ? 0.95 : 0.97);
            EXPECT_GT(agreement.compared, 2000);
            EXPECT_LT(agreement.worst_mm, 1.5 * diagonal);
            EXPECT_LT(agreement.typical_mm, 0.4 * diagonal);
        }
    }
}

TEST(ShearWarp, ShadesAsRaysDo) {
    Scene scene = ball_scene({1, 1, 1.5}, 20);
    scene.shading = Shading::phong;
    scene.camera.azimuth_deg = 25;
    const Frame warped = shear_warp(scene), truth = render_reference(scene, brute_force(0.25));
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < truth.pixels(); ++i) {
        if (!(truth.color[i].a > 0.5f && warped.color[i].a > 0.999f)) continue;
        sum += std::fabs(warped.color[i].r - truth.color[i].r);
        ++count;
    }
    EXPECT_GT(count, 3000);
    EXPECT_LT(sum / count, 0.03);
}

TEST(ShearWarp, AFullVolumeShowsItsFaces) {
    Scene scene = scene_of(sampled<std::uint8_t>(centred({30, 24, 10}, {1, 1, 3}), [](const glm::dvec3&) { return 9; }),
                           ViewMode::iso, 120);
    scene.iso = 5;
    scene.camera.azimuth_deg = 30;
    scene.camera.elevation_deg = 20;
    const Frame warped = shear_warp(scene);
    EXPECT_GT(compare_with_rays(scene, warped).overlap, 0.93);  // one voxel of 3 mm is a large share here
    scene.shading = Shading::lambert;
    const Frame truth = render_reference(scene, brute_force(0.5));
    scene.shading = Shading::lambert;
    const Frame shaded = shear_warp(scene);
    int alike = 0, count = 0;
    for (std::size_t i = 0; i < truth.pixels(); ++i) {
        if (!(truth.color[i].a > 0.5f && shaded.color[i].a > 0.999f)) continue;
        ++count;
        alike += std::fabs(truth.color[i].r - shaded.color[i].r) < 0.02f;
    }
    EXPECT_GT(count, 1000);
    EXPECT_GT(double(alike) / count, 0.85);
}

TEST(ShearWarp, CutsCapOrOpenAsRaysDo) {
    Scene scene = ball_scene(glm::dvec3(1), 0);
    scene.window = {-30, 30};
    scene.camera.azimuth_deg = 20;
    scene.camera.elevation_deg = 10;
    for (const bool cap : {true, false}) {
        scene.cuts = {{{-0.3, 1, 0.1}, 0, cap}};
        const Frame warped = shear_warp(scene);
        const Agreement agreement = compare_with_rays(scene, warped);
        EXPECT_GT(agreement.overlap, 0.97) << cap;
        // The open shell is up to two voxels thick; rays see its outside, shear-warp its inside.
        EXPECT_LT(agreement.typical_mm, cap ? 0.8 : 2.2) << cap;
        const std::size_t middle = pixel_index(warped, 80, 80);
        if (cap) {
            EXPECT_NEAR(warped.color[middle].r, 1, 0.04);
            const Frame truth = render_reference(scene, brute_force(0.25));
            const std::size_t beside = pixel_index(truth, 80 + 20, 80);
            EXPECT_NEAR(warped.color[beside].r, truth.color[beside].r, 0.05);
        }
    }
}

TEST(ShearWarp, UglyVolumesShowNothingOrThemselves) {
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), glm::ivec3(1, 1, 9), glm::ivec3(9, 1, 1), glm::ivec3(1, 9, 4)}) {
        for (const double azimuth : {0.0, 90.0, 33.0}) {
            for (const double elevation : {0.0, 90.0, -25.0}) {
                Scene scene =
                    scene_of(sampled(centred(size, {1, 1, 5}), [](const glm::dvec3&) { return 5; }), ViewMode::iso, 21);
                scene.camera.azimuth_deg = azimuth;
                scene.camera.elevation_deg = elevation;
                const Frame frame = shear_warp(scene);
                EXPECT_GT(frame.color[pixel_index(frame, 10, 10)].a, 0.2f) << size.x << size.y << size.z;
                scene.volume = sampled(centred(size), [](const glm::dvec3&) { return k_nan; });
                for (const glm::vec4& pixel : shear_warp(scene).color) ASSERT_EQ(pixel, glm::vec4(0));
            }
        }
    }
}

TEST(ShearWarp, TheSameBytesWithAnyNumberOfThreads) {
    Scene scene = ball_scene({1, 1, 2}, 10);
    scene.camera.azimuth_deg = 31;
    set_thread_count(1);
    const Frame one = shear_warp(scene);
    set_thread_count(5);
    const Frame five = shear_warp(scene);
    set_thread_count(0);
    EXPECT_EQ(one.color, five.color);
    EXPECT_EQ(one.depth_mm, five.depth_mm);
}

TEST(ShearWarp, ListsAreBuiltOnceADirection) {
    Scene scene = ball_scene({1, 1, 2}, 0);
    scene.mode = ViewMode::shear_warp;
    ShearWarpRenderer renderer;
    BuildRecord built;
    const Frame first = renderer.render(scene, default_plan(scene), {}, built);
    EXPECT_GT(built.ms, 0);
    EXPECT_EQ(built.bytes, renderer.bytes_held());
    EXPECT_GT(first.counters.samples, 1000u);
    scene.camera.azimuth_deg = 20;
    renderer.render(scene, default_plan(scene), {}, built);
    EXPECT_EQ(built.ms, 0);
    scene.camera.azimuth_deg = 90;
    renderer.render(scene, default_plan(scene), {}, built);
    EXPECT_GT(built.ms, 0);
    renderer.drop();
    EXPECT_EQ(renderer.bytes_held(), 0u);
}

TEST(ShearWarp, PerspectiveAndStopsAreErrors) {
    Scene scene = ball_scene(glm::dvec3(2), 0);
    scene.mode = ViewMode::shear_warp;
    ShearWarpRenderer renderer;
    BuildRecord built;
    std::stop_source source;
    source.request_stop();
    try {
        renderer.render(scene, default_plan(scene), {source.get_token()}, built);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::cancelled);
    }
    renderer.render(scene, default_plan(scene), {}, built);  // lists are ready now; a stop still ends the frame
    EXPECT_THROW(renderer.render(scene, default_plan(scene), {source.get_token()}, built), Error);
    scene.camera.fov_deg = 40;
    try {
        renderer.render(scene, default_plan(scene), {}, built);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_usage);
        EXPECT_NE(std::string(error.what()).find("mip"), std::string::npos);
    }
}

}  // namespace
}  // namespace lacuna
