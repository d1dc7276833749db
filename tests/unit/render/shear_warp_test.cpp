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

Frame shear_warp(Scene scene, Sampler sampler, ShearWarpRenderer* renderer = nullptr, int directions = 24) {
    scene.mode = ViewMode::shear_warp;
    BuildRecord built;
    ShearWarpRenderer own;
    Plan plan = default_plan(scene);
    plan.sampler = sampler;
    plan.directions = directions;
    return (renderer ? *renderer : own).render(scene, plan, {}, built);
}

constexpr Sampler k_samplers[] = {Sampler::nearest, Sampler::linear};

Frame truth_of(Scene scene) {
    scene.mode = ViewMode::iso;
    return render_reference(scene, brute_force(0.25));
}

/// Against the iso reference: where the surface is not steeper than 45 degrees and its neighbours agree.
Agreement compare_with_rays(const Scene& scene, const Frame& warped, const Frame& truth) {
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
    for (const Case& c : {Case{glm::dvec3(1), 0}, Case{{1, 1, 2}, 0}, Case{{0.8, 1, 1.5}, 30}, Case{{1, 1, 5}, 0}}) {
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
                                                 {45.0, 35.26438968},
                                                 {-135.0, -35.26438968},
                                                 {0.0, 90.0}}) {
            scene.camera.azimuth_deg = azimuth;
            scene.camera.elevation_deg = elevation;
            scene.camera.roll_deg = 15;
            scene.camera.zoom = 1.3;
            SCOPED_TRACE(testing::Message()
                         << azimuth << ' ' << elevation << " z " << c.spacing.z << " turned " << c.turn_deg);
            const bool coarse = c.spacing.z > 3;  // 14 slices through the ball
            const Frame truth = truth_of(scene);
            const Agreement rough = compare_with_rays(scene, shear_warp(scene, Sampler::nearest, &renderer), truth);
            EXPECT_GT(rough.overlap, coarse ? 0.88 : c.spacing.z > 1 ? 0.95 : 0.97);
            EXPECT_GT(rough.compared, 2000);
            EXPECT_LT(rough.worst_mm, 1.6 * diagonal);
            EXPECT_LT(rough.typical_mm, 0.4 * diagonal);
            const Agreement smooth = compare_with_rays(scene, shear_warp(scene, Sampler::linear, &renderer), truth);
            EXPECT_GT(smooth.overlap, rough.overlap - 0.005);
            EXPECT_GT(smooth.compared, 2000);
            EXPECT_LT(smooth.worst_mm, 0.6 * diagonal);
            EXPECT_LT(smooth.typical_mm, (coarse ? 0.08 : 0.05) * diagonal);
            EXPECT_LT(smooth.typical_mm, (coarse ? 0.9 : 0.5) * rough.typical_mm);
        }
    }
}

TEST(ShearWarp, ShadesAsRaysDo) {
    Scene scene = ball_scene({1, 1, 1.5}, 20);
    scene.shading = Shading::phong;
    scene.camera.azimuth_deg = 25;
    const Frame truth = render_reference(scene, brute_force(0.25));
    double error[2];
    for (const Sampler sampler : k_samplers) {
        const Frame warped = shear_warp(scene, sampler);
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < truth.pixels(); ++i) {
            if (!(truth.color[i].a > 0.5f && warped.color[i].a > 0.999f)) continue;
            sum += std::fabs(warped.color[i].r - truth.color[i].r);
            ++count;
        }
        EXPECT_GT(count, 3000);
        error[sampler == Sampler::linear] = sum / count;
    }
    EXPECT_LT(error[0], 0.03);
    EXPECT_LT(error[1], 0.01);
    EXPECT_LT(error[1], 0.5 * error[0]);
}

TEST(ShearWarp, AFullVolumeShowsItsFaces) {
    Scene scene = scene_of(sampled<std::uint8_t>(centred({30, 24, 10}, {1, 1, 3}), [](const glm::dvec3&) { return 9; }),
                           ViewMode::iso, 120);
    scene.iso = 5;
    scene.camera.azimuth_deg = 30;
    scene.camera.elevation_deg = 20;
    scene.shading = Shading::lambert;
    const Frame truth = render_reference(scene, brute_force(0.5));
    for (const Sampler sampler : k_samplers) {
        const Frame shaded = shear_warp(scene, sampler);
        EXPECT_GT(compare_with_rays(scene, shaded, truth).overlap, 0.93);  // one voxel of 3 mm is a large share here
        int alike = 0, count = 0;
        for (std::size_t i = 0; i < truth.pixels(); ++i) {
            if (!(truth.color[i].a > 0.5f && shaded.color[i].a > 0.999f)) continue;
            ++count;
            alike += std::fabs(truth.color[i].r - shaded.color[i].r) < 0.02f;
        }
        EXPECT_GT(count, 1000);
        EXPECT_GT(double(alike) / count, 0.85);
    }
}

TEST(ShearWarp, CutsCapOrOpenAsRaysDo) {
    Scene scene = ball_scene(glm::dvec3(1), 0);
    scene.window = {-30, 30};
    scene.camera.azimuth_deg = 20;
    scene.camera.elevation_deg = 10;
    for (const bool cap : {true, false}) {
        scene.cuts = {{{-0.3, 1, 0.1}, 0, cap}};
        const Frame truth = render_reference(scene, brute_force(0.25));
        for (const Sampler sampler : k_samplers) {
            const bool linear = sampler == Sampler::linear;
            SCOPED_TRACE(testing::Message() << cap << linear);
            const Frame warped = shear_warp(scene, sampler);
            const Agreement agreement = compare_with_rays(scene, warped, truth);
            EXPECT_GT(agreement.overlap, 0.97);
            EXPECT_GT(agreement.compared, 1000);
            // The open shell is up to two voxels thick; rays see its outside, whole voxels its inside.
            EXPECT_LT(agreement.typical_mm, linear ? 0.08 : cap ? 0.8 : 2.2);
            if (!cap) continue;
            EXPECT_NEAR(warped.color[pixel_index(warped, 80, 80)].r, 1, 0.04);
            const std::size_t beside = pixel_index(truth, 80 + 20, 80);
            EXPECT_NEAR(warped.color[beside].r, truth.color[beside].r, linear ? 0.01 : 0.05);
        }
    }
}

/// Noise that touches no side of its volume.
Scene noise_scene(glm::ivec3 size, glm::dvec3 spacing, int pixels = 90, bool to_the_sides = false) {
    const GridGeometry geometry = centred(size, spacing);
    unsigned state = 12345;
    const Volume volume = make_volume<std::uint8_t>(geometry, [&](std::span<std::uint8_t> voxels) {
        for (int i = 0; i < int(voxels.size()); ++i) {
            state = state * 1664525u + 1013904223u;
            const int x = i % size.x, y = i / size.x % size.y, z = i / size.x / size.y;
            const bool side = x == 0 || y == 0 || z == 0 || x == size.x - 1 || y == size.y - 1 || z == size.z - 1;
            voxels[std::size_t(i)] = side && !to_the_sides ? 0 : std::uint8_t((state >> 24) % 100);
        }
    });
    Scene scene = scene_of(volume, ViewMode::iso, pixels);
    scene.iso = 80;
    scene.shading = Shading::phong;
    return scene;
}

TEST(ShearWarp, SixAndTwentyFourRegionsGiveTheSamePictureTheirBordersIncluded) {
    for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 5)}) {
        Scene scene = noise_scene({27, 25, 22}, spacing);
        ShearWarpRenderer renderer;
        for (const double azimuth : {0.0, 1e-9, -1e-9, 45.0, 90.0, 13.0, 180.0, -135.0}) {
            for (const double elevation : {0.0, 35.26438968, -1e-9, 90.0, -62.0}) {
                scene.camera.azimuth_deg = azimuth;
                scene.camera.elevation_deg = elevation;
                for (const Sampler sampler : k_samplers) {
                    const Frame six = shear_warp(scene, sampler, &renderer, 6);
                    const Frame quarters = shear_warp(scene, sampler, &renderer, 24);
                    ASSERT_TRUE(six.color == quarters.color) << azimuth << ' ' << elevation;
                    ASSERT_TRUE(six.depth_mm == quarters.depth_mm) << azimuth << ' ' << elevation;
                    ASSERT_LE(quarters.counters.samples, six.counters.samples);
                }
            }
        }
    }
}

TEST(ShearWarp, SixAndTwentyFourRegionsAgreeAtTheVolumesSidesAndBehindCuts) {
    for (const double iso : {0.5, 30.0, 80.0}) {  // nearly full, full of holes, specks
        Scene scene = noise_scene({19, 17, 15}, {1, 1, 1.5}, 60, true);
        scene.iso = iso;
        ShearWarpRenderer renderer;
        for (const int cut : {0, 1, 2}) {
            scene.cuts.clear();
            if (cut > 0) scene.cuts = {{{0.78, -0.04, 0.52}, 1, cut == 1}};
            for (const auto& [azimuth, elevation] :
                 {std::pair(-37.6, 0.0), {100.0, 5.0}, {12.0, -62.0}, {180.0, 40.0}, {-135.0, 35.26438968}}) {
                scene.camera.azimuth_deg = azimuth;
                scene.camera.elevation_deg = elevation;
                for (const Sampler sampler : k_samplers) {
                    const Frame six = shear_warp(scene, sampler, &renderer, 6);
                    const Frame quarters = shear_warp(scene, sampler, &renderer, 24);
                    EXPECT_TRUE(six.color == quarters.color) << iso << ' ' << cut << ' ' << azimuth;
                    EXPECT_TRUE(six.depth_mm == quarters.depth_mm) << iso << ' ' << cut << ' ' << azimuth;
                }
            }
        }
    }
}

TEST(ShearWarp, AnAxisAlignedCutLeavesTheDepthOfTheVolumeWithoutItsSlices) {
    for (int axis = 0; axis < 3; ++axis) {
        Scene cut = noise_scene({27, 25, 22}, {1, 1, 1.5});
        const GridGeometry& geometry = cut.volume.geometry();
        const int slices = 9;
        glm::dvec3 normal(0);
        normal[axis] = 1;
        glm::dvec3 plane(0);
        plane[axis] = slices - 0.5;
        cut.cuts = {{normal, -glm::dot(normal, geometry.voxel_to_mm(plane)), true}};
        Scene cropped = cut;
        cropped.cuts.clear();
        const auto view = cut.volume.view<std::uint8_t>();
        cropped.volume = make_volume<std::uint8_t>(geometry, [&](std::span<std::uint8_t> voxels) {
            std::copy(view.voxels().begin(), view.voxels().end(), voxels.begin());
            for (int i = 0; i < int(voxels.size()); ++i) {
                const int at[3] = {i % view.size.x, i / view.size.x % view.size.y, i / view.size.x / view.size.y};
                if (at[axis] < slices) voxels[std::size_t(i)] = 0;
            }
        });
        for (const double azimuth : {10.0, 75.0, 200.0}) {
            cut.camera.azimuth_deg = cropped.camera.azimuth_deg = azimuth;
            cut.camera.elevation_deg = cropped.camera.elevation_deg = 25;
            EXPECT_TRUE(shear_warp(cut, Sampler::nearest).depth_mm == shear_warp(cropped, Sampler::nearest).depth_mm);
        }
    }
}

TEST(ShearWarp, BilinearCutsAgreeWithRaysOnCavesAndWalls) {
    const Volume volume = sampled(centred({47, 45, 41}), [](const glm::dvec3& p) {
        return std::sin(0.7 * p.x) + std::sin(0.6 * p.y + 1) + std::cos(0.5 * p.z + 0.2 * p.x);
    });
    Scene scene = scene_of(volume, ViewMode::iso, 120);
    scene.iso = 0.3;
    scene.camera.azimuth_deg = 21;
    scene.camera.elevation_deg = 12;
    for (const bool cap : {true, false}) {
        scene.cuts = {{{0.2, 1, 0.1}, 1.3, cap}, {{1, 0, 0.4}, 3, true}};
        const Frame warped = shear_warp(scene, Sampler::linear);
        const Frame truth = render_reference(scene, brute_force(0.05));
        int close = 0, both = 0, either = 0;
        for (std::size_t i = 0; i < truth.pixels(); ++i) {
            const bool a = truth.color[i].a > 0.5f, b = warped.color[i].a >= 0.5f;
            either += a || b;
            both += a && b;
            close += a && b && std::fabs(truth.depth_mm[i] - warped.depth_mm[i]) < 0.5;
        }
        EXPECT_GT(either, 2000);
        EXPECT_GT(double(both) / either, 0.9) << cap;
        EXPECT_GT(double(close) / both, 0.75) << cap;
    }
}

TEST(ShearWarp, RangesBoundTheObjectInBothSamplings) {
    Scene scene = ball_scene(glm::dvec3(1), 0);
    scene.iso = -100;
    scene.classification.ranges = {{"shell", {0, 8}, std::nullopt}};
    Scene plain = scene;
    plain.iso = 0;
    plain.classification.ranges.clear();
    for (const Sampler sampler : k_samplers) {
        const Frame shell = shear_warp(scene, sampler), ball = shear_warp(plain, sampler);
        int apart = 0;
        for (std::size_t i = 0; i < ball.pixels(); ++i)
            apart += !(std::fabs(shell.depth_mm[i] - ball.depth_mm[i]) < 0.1) && shell.depth_mm[i] != ball.depth_mm[i];
        EXPECT_LT(apart, 20);
        scene.cuts = {{{0, 1, 0}, 0, true}};
        const Frame hollow = shear_warp(scene, sampler);
        EXPECT_GT(hollow.depth_mm[pixel_index(hollow, 80, 80)], ball.depth_mm[pixel_index(ball, 80, 80)] + 45);
        scene.cuts.clear();
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
                for (const Sampler sampler : k_samplers) {
                    const Frame frame = shear_warp(scene, sampler);
                    EXPECT_GT(frame.color[pixel_index(frame, 10, 10)].a, 0.2f) << size.x << size.y << size.z;
                    Scene empty = scene;
                    empty.volume = sampled(centred(size), [](const glm::dvec3&) { return k_nan; });
                    for (const glm::vec4& pixel : shear_warp(empty, sampler).color) ASSERT_EQ(pixel, glm::vec4(0));
                    empty = scene;
                    empty.iso = 6;  // flat, and below
                    for (const glm::vec4& pixel : shear_warp(empty, sampler).color) ASSERT_EQ(pixel, glm::vec4(0));
                }
            }
        }
    }
}

TEST(ShearWarp, TheSameBytesWithAnyNumberOfThreads) {
    Scene scene = ball_scene({1, 1, 2}, 10);
    scene.camera.azimuth_deg = 31;
    scene.cuts = {{{1, 0.3, 0}, 4, false}};
    for (const Sampler sampler : k_samplers) {
        for (const Shading shading : {Shading::lambert, Shading::phong}) {
            scene.shading = shading;
            set_thread_count(1);
            const Frame one = shear_warp(scene, sampler);
            set_thread_count(5);
            const Frame five = shear_warp(scene, sampler);
            set_thread_count(0);
            EXPECT_EQ(one.color, five.color);
            EXPECT_EQ(one.depth_mm, five.depth_mm);
        }
    }
}

TEST(ShearWarp, ListsAreBuiltOnceADirection) {
    Scene scene = ball_scene({1, 1, 2}, 0);
    scene.mode = ViewMode::shear_warp;
    ShearWarpRenderer renderer;
    BuildRecord built;
    scene.camera.azimuth_deg = 10;
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
    Plan moving = default_plan(scene);
    moving.sampler = Sampler::nearest;
    renderer.render(scene, moving, {}, built);
    EXPECT_GT(built.ms, 0);
    renderer.render(scene, moving, {}, built);
    EXPECT_EQ(built.ms, 0);
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
    for (const Sampler sampler : k_samplers) {
        Plan plan = default_plan(scene);
        plan.sampler = sampler;
        try {
            renderer.render(scene, plan, {source.get_token()}, built);
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::cancelled);
        }
        renderer.render(scene, plan, {}, built);  // lists are ready now; a stop still ends the frame
        EXPECT_THROW(renderer.render(scene, plan, {source.get_token()}, built), Error);
    }
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
