#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "core/base/error.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna {
namespace {

using namespace test;

constexpr ViewMode k_ray_modes[] = {ViewMode::iso,  ViewMode::ea,    ViewMode::mip,
                                    ViewMode::lmip, ViewMode::minip, ViewMode::mean};

glm::vec4 middle_of(const Frame& frame) { return frame.color[pixel_index(frame, frame.size.x / 2, frame.size.y / 2)]; }
float middle_depth(const Frame& frame) {
    return frame.depth_mm[pixel_index(frame, frame.size.x / 2, frame.size.y / 2)];
}

TEST(ReferenceEa, HomogeneousSlabFollowsTheClosedForm) {
    // 10 mm along y in voxels of 0.5 x 2 x 1 mm; 0.1 per 2.5 mm.
    Scene scene =
        scene_of(sampled(centred({16, 5, 8}, {0.5, 2, 1}), [](const glm::dvec3&) { return 7; }), ViewMode::ea, 9);
    scene.classification.tf = constant_tf(0.1, {1, 0.5, 0});
    scene.classification.tf.unit_distance_mm = 2.5;
    const double truth = 1 - std::pow(0.9, 10 / 2.5);
    for (const double step : {1.0, 0.5, 0.25}) {
        const glm::vec4 color = middle_of(render_reference(scene, brute_force(step)));
        EXPECT_NEAR(color.a, truth, 1e-6) << step;
        EXPECT_NEAR(color.r, truth, 1e-6);
        EXPECT_NEAR(color.g, 0.5 * truth, 1e-6);
        EXPECT_EQ(color.b, 0);
    }
    scene.classification.tf.points[0].opacity = 0.9;
    const Frame dense = render_reference(scene, brute_force(0.5));
    EXPECT_GT(middle_depth(dense), 0);
    const double front = 0.5 * scene.volume.geometry().diameter_mm() - 5;
    EXPECT_NEAR(middle_depth(dense), front + 0.875, 1e-5);  // samples .125 + k/4; half opaque at 0.753 mm: 4th sample
}

TEST(ReferenceEa, HalvingTheStepQuartersTheErrorOnASmoothRamp) {
    Scene scene = scene_of(sampled(centred({9, 17, 9}), [](const glm::dvec3& p) { return p.y + 8; }), ViewMode::ea, 9);
    scene.classification.tf.points = {{0, {1, 0, 0}, 0.0}, {16, {0, 1, 0}, 0.4}};
    const glm::vec4 fine = middle_of(render_reference(scene, brute_force(1.0 / 64)));
    // alpha(v) = v/40 over y in 0..16, half a voxel of 0.4 behind (and of 0 before): exact by the integral of
    // log(1-v/40).
    const auto antiderivative = [](double v) { return -40 * ((1 - v / 40) * std::log(1 - v / 40) - (1 - v / 40)); };
    const double log_through = antiderivative(16) - antiderivative(0) + 0.5 * std::log(0.6);
    const double truth = 1 - std::exp(log_through);
    EXPECT_NEAR(fine.a, truth, 1e-5);
    double before = 0, before_red = 0;
    for (const double step : {0.5, 0.25}) {
        const glm::vec4 color = middle_of(render_reference(scene, brute_force(step)));
        const double error = std::fabs(color.a - truth), red = std::fabs(color.r - fine.r);
        // Steps over 1/2 do not end on the kinks half a voxel inside the box.
        if (step == 0.25) {
            EXPECT_NEAR(before / error, 4, 0.4);
            EXPECT_NEAR(before_red / red, 4, 0.6);
        }
        before = error;
        before_red = red;
    }
}

TEST(ReferenceEa, TerminationLeavesAtMostItsShare) {
    Scene scene = scene_of(sampled(centred({9, 40, 9}), [](const glm::dvec3&) { return 7; }), ViewMode::ea, 9);
    scene.classification.tf = constant_tf(0.3);
    Plan plan = brute_force();
    const Frame whole = render_reference(scene, plan);
    plan.ert = 0.01;
    const Frame ended = render_reference(scene, plan);
    EXPECT_LT(ended.counters.samples, whole.counters.samples / 2);
    EXPECT_LE(middle_of(whole).a - middle_of(ended).a, 0.01);
    EXPECT_GT(middle_of(ended).a, 0.99);
}

TEST(ReferenceEa, GradientFactorAndOwnRangeFunctions) {
    Scene scene =
        scene_of(sampled(centred({9, 9, 9}, {1, 2, 1}), [](const glm::dvec3& p) { return 6 * p.y; }), ViewMode::ea, 9);
    scene.classification.tf = constant_tf(0.2);
    scene.classification.tf.gradient_opacity = {{5, 1.0}, {7, 0.0}};  // 6 per mm: factor 1/2 away from the border
    scene.classification.ranges = {{"inner", {-6, 6}, std::nullopt}};
    const Frame scened = render_reference(scene, brute_force(0.5));
    EXPECT_NEAR(middle_of(scened).a, 1 - std::pow(0.9, 2), 1e-6);  // |y| <= 1: 4 samples of 1/2 mm
    scene.classification.ranges[0].tf = constant_tf(0.7, {0, 0, 1});
    const Frame own = render_reference(scene, brute_force(0.5));
    EXPECT_NEAR(middle_of(own).a, 1 - std::pow(0.3, 2), 1e-6);
    EXPECT_EQ(middle_of(own).r, 0);
}

TEST(ReferenceEa, CapShowsDataOnlyWhereOpaque) {
    Scene scene =
        scene_of(sampled(centred({9, 9, 9}), [](const glm::dvec3& p) { return 50 + 10 * p.x; }), ViewMode::ea, 9);
    scene.classification.tf.points = {{49, {1, 0, 0}, 0.0}, {50, {1, 0, 0}, 0.1}};
    scene.cuts = {{{0, 1, 0}, 0, true}};
    const Frame frame = render_reference(scene, brute_force());
    EXPECT_NEAR(middle_of(frame).r, 0.5, 1e-6);
    EXPECT_EQ(middle_of(frame).a, 1);
    EXPECT_NEAR(middle_depth(frame), 0.5 * scene.volume.geometry().diameter_mm(), 1e-5);
    EXPECT_EQ(frame.color[pixel_index(frame, 3, 4)].a, 0);  // value below 49
    scene.cuts[0].cap = false;
    EXPECT_NEAR(middle_of(render_reference(scene, brute_force())).a, 1 - std::pow(0.9, 4.5), 1e-6);
}

TEST(ReferenceMip, AOneVoxelSpotReadsAsTheLatticeMeetsIt) {
    Scene scene =
        scene_of(sampled(centred({9, 9, 9}), [](const glm::dvec3& p) { return p == glm::dvec3(0) ? 100 : 0; }),
                 ViewMode::mip, 9);
    const double front = 0.5 * scene.volume.geometry().diameter_mm() - 4.5;
    EXPECT_NEAR(middle_of(render_reference(scene, brute_force(1.0))).r, 1.0, 1e-6);  // samples on the voxel centres
    const Frame half = render_reference(scene, brute_force(0.5));
    EXPECT_NEAR(middle_of(half).r, 0.75, 1e-6);  // samples 1/4 beside it
    EXPECT_NEAR(middle_depth(half), front + 4.25, 1e-5);
    EXPECT_NEAR(middle_of(render_reference(scene, brute_force(0.25))).r, 0.875, 1e-6);
    Plan nearest = brute_force(0.5);
    nearest.sampler = Sampler::nearest;
    EXPECT_NEAR(middle_of(render_reference(scene, nearest)).r, 1.0, 1e-6);
    scene.color_by_tf = true;
    scene.classification.tf.points = {{0, {1, 0, 0}, 0}, {100, {0, 1, 0}, 0}};
    EXPECT_NEAR(middle_of(render_reference(scene, brute_force(0.5))).g, 0.75, 1e-6);
}

TEST(ReferenceMip, TheFamilyPicksItsSamples) {
    // Along y: 10 60 10 100 10 (one voxel each, sampled at their centres).
    const double row[] = {10, 60, 10, 100, 10};
    Scene scene = scene_of(sampled(centred({5, 5, 5}), [&](const glm::dvec3& p) { return row[int(p.y + 2)]; }),
                           ViewMode::lmip, 5);
    const auto value = [&](ViewMode mode) {
        scene.mode = mode;
        return 100 * middle_of(render_reference(scene, brute_force(1.0))).r;
    };
    const double front = 0.5 * scene.volume.geometry().diameter_mm() - 2.5;
    scene.lmip_threshold = 50;
    EXPECT_NEAR(value(ViewMode::lmip), 60, 1e-4);
    EXPECT_NEAR(middle_depth(render_reference(scene, brute_force(1.0))), front + 1.5, 1e-5);
    scene.lmip_threshold = 80;
    EXPECT_NEAR(value(ViewMode::lmip), 100, 1e-4);
    scene.lmip_threshold = 200;
    EXPECT_NEAR(value(ViewMode::lmip), 100, 1e-4);
    EXPECT_NEAR(value(ViewMode::mip), 100, 1e-4);
    EXPECT_NEAR(value(ViewMode::minip), 10, 1e-4);
    EXPECT_NEAR(middle_depth(render_reference(scene, brute_force(1.0))), front + 0.5, 1e-5);  // the first of equals
    EXPECT_NEAR(value(ViewMode::mean), 38, 1e-4);
    EXPECT_TRUE(std::isinf(middle_depth(render_reference(scene, brute_force(1.0)))));
    scene.classification.ranges = {{"", {0, 70}, std::nullopt}};
    EXPECT_NEAR(value(ViewMode::mip), 60, 1e-4);
    EXPECT_NEAR(value(ViewMode::mean), 22.5, 1e-4);
    scene.classification.ranges = {{"", {20, 30}, std::nullopt}};
    for (const ViewMode mode : {ViewMode::mip, ViewMode::minip, ViewMode::mean, ViewMode::lmip}) {
        scene.mode = mode;
        EXPECT_EQ(middle_of(render_reference(scene, brute_force(1.0))), glm::vec4(0)) << name_of(mode);
    }
}

TEST(ReferenceMip, CutsNarrowTheLatticeWithoutShiftingIt) {
    Scene scene =
        scene_of(sampled(centred({9, 9, 9}), [](const glm::dvec3& p) { return 50 - 10 * p.y; }), ViewMode::mip, 9);
    scene.cuts = {{{0, 1, 0}, 0.1, true}};  // keeps y >= -0.1; samples lie at -0.25 and 0.25
    EXPECT_NEAR(middle_of(render_reference(scene, brute_force(0.5))).r, 0.475, 1e-6);
    scene.cuts = {{{0, 1, 0}, 0.25, true}};  // a sample on the plane is kept
    EXPECT_NEAR(middle_of(render_reference(scene, brute_force(0.5))).r, 0.525, 1e-6);
}

TEST(ReferenceUgly, NaNVolumesShowNothing) {
    const Volume dead = sampled(centred({5, 6, 7}), [](const glm::dvec3&) { return k_nan; });
    const Volume one_dead =
        sampled(centred({5, 5, 5}), [](const glm::dvec3& p) { return p == glm::dvec3(0) ? k_nan : 50.f; });
    const Volume infinite =
        sampled(centred({5, 5, 5}), [](const glm::dvec3&) { return std::numeric_limits<float>::infinity(); });
    for (const ViewMode mode : k_ray_modes) {
        for (const Volume* volume : {&dead, &infinite}) {
            const Frame frame = render_reference(scene_of(*volume, mode, 7), brute_force());
            for (const glm::vec4& pixel : frame.color) ASSERT_EQ(pixel, glm::vec4(0)) << name_of(mode);
        }
        Scene scene = scene_of(one_dead, mode, 15);
        scene.shading = Shading::phong;
        const Frame frame = render_reference(scene, brute_force());
        for (const glm::vec4& pixel : frame.color)
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(pixel[c] >= 0 && pixel[c] < 1.5f) << name_of(mode);
        if (mode == ViewMode::mip || mode == ViewMode::mean) {
            EXPECT_NEAR(middle_of(frame).r, 0.5, 1e-6);
        }
    }
}

TEST(ReferenceUgly, ThinAndFlatVolumesOfEveryType) {
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 9), glm::ivec3(1, 9, 1), glm::ivec3(1, 1, 1), glm::ivec3(2, 1, 3)}) {
        for (const VoxelType type : {VoxelType::u8, VoxelType::i8, VoxelType::u16, VoxelType::i16, VoxelType::f32}) {
            const Volume volume = visit_type(type, [&](auto tag) {
                return sampled<decltype(tag)>(centred(size, {1, 1, 5}), [](const glm::dvec3&) { return 50; });
            });
            for (const ViewMode mode : k_ray_modes) {
                const Frame frame = render_reference(scene_of(volume, mode, 9), brute_force());
                EXPECT_GT(middle_of(frame).a, 0.2) << name_of(mode) << ' ' << size.x << size.y << size.z;
                if (mode != ViewMode::iso && mode != ViewMode::ea) {
                    EXPECT_NEAR(middle_of(frame).r, 0.5, 1e-6);
                }
            }
        }
    }
}

TEST(ReferenceUgly, RaysAlongAxesAndThroughCornersStaySound) {
    const Volume volume = sampled(centred({4, 4, 4}), [](const glm::dvec3& p) { return 50 + p.x + p.y + p.z; });
    for (const ViewMode mode : k_ray_modes) {
        for (const double azimuth : {0.0, 90.0, 180.0, 270.0, 45.0}) {
            for (const double elevation : {0.0, 90.0, -90.0, 35.26438968275465}) {
                Scene scene = scene_of(volume, mode, 8);
                scene.iso = 50.5;
                scene.camera.azimuth_deg = azimuth;
                scene.camera.elevation_deg = elevation;
                scene.camera.zoom =
                    scene.volume.geometry().diameter_mm() / 8;  // pixel centres on voxel corners and centres
                const Frame frame = render_reference(scene, brute_force(0.5));
                for (const glm::vec4& pixel : frame.color)
                    for (int c = 0; c < 4; ++c) ASSERT_TRUE(pixel[c] >= 0 && pixel[c] <= 1.0001f);
                if (mode == ViewMode::iso) continue;  // a ray along the surface's plane may rightly see nothing
                EXPECT_GT(middle_of(frame).a, 0) << name_of(mode) << ' ' << azimuth << ' ' << elevation;
            }
        }
    }
}

TEST(ReferenceCamera, TheFrontViewHasLeftOfThePatientOnTheRightAndTheHeadOnTop) {
    const auto spot_at = [](glm::dvec3 at) {
        Scene scene = scene_of(sampled(centred({9, 9, 9}), [=](const glm::dvec3& p) { return p == at ? 100 : 0; }),
                               ViewMode::mip, 9);
        scene.camera.zoom = scene.volume.geometry().diameter_mm() / 9;  // one pixel a voxel
        return scene;
    };
    const auto brightest = [](const Frame& frame) {
        glm::ivec2 best(0);
        for (int y = 0; y < frame.size.y; ++y)
            for (int x = 0; x < frame.size.x; ++x)
                if (frame.color[pixel_index(frame, x, y)].r > frame.color[pixel_index(frame, best.x, best.y)].r)
                    best = {x, y};
        return best;
    };
    Scene scene = spot_at({3, 0, 2});
    EXPECT_EQ(brightest(render_reference(scene, brute_force(1))), glm::ivec2(4 + 3, 4 - 2));
    scene.camera.azimuth_deg = 90;  // from +x: the back (+y) is on the right
    scene.volume = spot_at({0, 3, 2}).volume;
    EXPECT_EQ(brightest(render_reference(scene, brute_force(1))), glm::ivec2(4 + 3, 4 - 2));
    scene.camera.azimuth_deg = 0;
    scene.camera.elevation_deg = 90;  // from above: the front (-y) is at the bottom
    scene.volume = spot_at({3, -2, 0}).volume;
    EXPECT_EQ(brightest(render_reference(scene, brute_force(1))), glm::ivec2(4 + 3, 4 + 2));
    // The near spot is met first: the eye stands in front.
    scene.camera.elevation_deg = 0;
    scene.mode = ViewMode::iso;
    scene.iso = 40;
    scene.volume = sampled(centred({9, 9, 9}), [](const glm::dvec3& p) { return p.y == -3 || p.y == 3 ? 100 : 0; });
    const double to_centre = 0.5 * scene.volume.geometry().diameter_mm();
    EXPECT_NEAR(middle_depth(render_reference(scene, brute_force(0.5))), to_centre - 3.6, 1e-4);
}

TEST(ReferenceCamera, ZoomOneSpansTheBoundingSphere) {
    Scene scene =
        scene_of(sampled(centred({20, 30, 40}, {1, 2, 0.5}), [](const glm::dvec3&) { return 50; }), ViewMode::mip);
    scene.size = {300, 200};
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    EXPECT_NEAR(rays.pixel_mm * 200, std::sqrt(20.0 * 20 + 60 * 60 + 20 * 20), 1e-9);
    const Frame frame = render_reference(scene, brute_force(1));
    int columns = 0, rows = 0;
    for (int x = 0; x < 300; ++x) columns += frame.color[pixel_index(frame, x, 100)].a > 0;
    for (int y = 0; y < 200; ++y) rows += frame.color[pixel_index(frame, 150, y)].a > 0;
    EXPECT_NEAR(columns * rays.pixel_mm, 20, rays.pixel_mm);
    EXPECT_NEAR(rows * rays.pixel_mm, 20, rays.pixel_mm);
    EXPECT_EQ(frame.counters.rays, std::uint64_t(columns) * std::uint64_t(rows));
}

TEST(ReferenceJob, AStopEndsTheFrameWithin30Ms) {
    Scene scene = scene_of(sampled<std::uint8_t>(centred({96, 96, 96}), [](const glm::dvec3& p) { return 100 + p.x; }),
                           ViewMode::ea, 2048);
    scene.classification.tf = constant_tf(0.001);
    scene.shading = Shading::phong;
    std::stop_source source;
    std::chrono::steady_clock::time_point asked;
    std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(80));
        asked = std::chrono::steady_clock::now();
        source.request_stop();
    });
    try {
        render_reference(scene, brute_force(0.1), {source.get_token()});
        FAIL() << "the frame was finished";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::cancelled);
    }
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - asked).count();
#ifdef __SANITIZE_THREAD__
    constexpr double k_most_ms = 10000;  // a ray takes twenty times as long, the whole frame hours
#else
    constexpr double k_most_ms = 150;
#endif
    EXPECT_LT(ms, k_most_ms) << "30 ms are promised; the rest is a busy machine's";
}

TEST(ReferenceJob, ShearWarpIsRefused) {
    const Scene scene = scene_of(ball(centred({5, 5, 5}), 2), ViewMode::shear_warp);
    try {
        render_reference(scene, brute_force());
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::unsupported);
    }
}

}  // namespace
}  // namespace lacuna
