#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/unit/render/render_volumes.h"

namespace lacuna {
namespace {

using namespace test;

struct DepthError {
    double max = 0;
    int hits = 0, wrong_side = 0;
};

/// Compares depths with the ball's closed form where the surface is not grazed.
DepthError ball_error(const Scene& scene, const Plan& plan, double radius, bool far_side = false) {
    const Frame frame = render_reference(scene, plan);
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    DepthError error;
    for (int y = 0; y < frame.size.y; ++y) {
        for (int x = 0; x < frame.size.x; ++x) {
            const glm::dvec3 o = rays.origin(x, y), d = rays.direction(x, y);
            const double truth = ball_depth(o, d, radius, far_side);
            if (std::isinf(truth)) continue;
            if (std::fabs(glm::dot(glm::normalize(o + truth * d), d)) < 0.5) continue;
            const double depth = frame.depth_mm[pixel_index(frame, x, y)];
            if (std::isinf(depth)) {
                ++error.wrong_side;
                continue;
            }
            ++error.hits;
            error.max = std::fmax(error.max, std::fabs(depth - truth));
        }
    }
    return error;
}

Scene ball_scene(int voxels, double turn_deg, glm::dvec3 stretch, bool perspective) {
    const glm::dvec3 spacing = 40.0 / voxels * stretch;
    const glm::ivec3 size = glm::ivec3(glm::round(40.0 / spacing));
    Scene scene = scene_of(ball(centred(size, spacing, turn_deg), 12.3), ViewMode::iso, 41);
    scene.camera.azimuth_deg = 33;
    scene.camera.elevation_deg = 21;
    scene.camera.roll_deg = 10;
    if (perspective) scene.camera.fov_deg = 35;
    return scene;
}

TEST(ReferenceIso, BallDepthConvergesWithTheGridAtSecondOrder) {
    Plan plan = brute_force();
    plan.refine = Refinement::bisect;
    plan.refine_steps = 30;
    for (const bool perspective : {false, true}) {
        for (const glm::dvec3 stretch : {glm::dvec3(1), glm::dvec3(1, 0.8, 2)}) {
            SCOPED_TRACE(testing::Message() << "perspective " << perspective << " stretch z " << stretch.z);
            const DepthError coarse = ball_error(ball_scene(20, 25, stretch, perspective), plan, 12.3);
            const DepthError fine = ball_error(ball_scene(40, 25, stretch, perspective), plan, 12.3);
            EXPECT_GT(fine.hits, 100);
            EXPECT_EQ(fine.wrong_side, 0);
            EXPECT_LT(fine.max, 0.15);
            EXPECT_GT(coarse.max / fine.max, 2.8);
            EXPECT_LT(coarse.max / fine.max, 5.5);
        }
    }
}

TEST(ReferenceIso, UnrefinedDepthErrorIsTheStepAndHalvesWithIt) {
    const Scene scene = ball_scene(64, 0, glm::dvec3(1), false);
    Plan plan = brute_force(1.0);
    plan.refine = Refinement::none;
    const double spacing = scene.volume.geometry().spacing.x;
    const DepthError whole = ball_error(scene, plan, 12.3);
    plan.step = 0.5;
    const DepthError half = ball_error(scene, plan, 12.3);
    EXPECT_LT(whole.max, 1.2 * spacing);
    EXPECT_GT(whole.max, 0.7 * spacing);
    EXPECT_NEAR(whole.max / half.max, 2, 0.4);
}

TEST(ReferenceIso, RefinementsAgree) {
    const Scene scene = ball_scene(32, 25, glm::dvec3(1), true);
    Plan plan = brute_force();
    plan.refine = Refinement::bisect;
    plan.refine_steps = 40;
    const Frame truth = render_reference(scene, plan);
    for (const auto& [refinement, steps, bound] :
         {std::tuple(Refinement::bisect, 8, 1e-3), std::tuple(Refinement::regula_falsi, 5, 1e-4),
          std::tuple(Refinement::newton, 5, 1e-4)}) {
        plan.refine = refinement;
        plan.refine_steps = steps;
        const Frame frame = render_reference(scene, plan);
        double worst = 0;
        int hits = 0;
        for (std::size_t i = 0; i < frame.pixels(); ++i) {
            ASSERT_EQ(std::isinf(frame.depth_mm[i]), std::isinf(truth.depth_mm[i]));
            if (std::isinf(truth.depth_mm[i])) continue;
            // A grazed turn has two near roots; the refinements may differ only where the bracket is no clean one.
            worst = std::fmax(worst, std::fabs(frame.depth_mm[i] - truth.depth_mm[i]));
            ++hits;
        }
        EXPECT_GT(hits, 100);
        EXPECT_LT(worst, 10 * bound) << name_of(refinement);
    }
}

TEST(ReferenceIso, AFlatFaceInsideTheObjectIsHitWithItsOwnNormal) {
    Scene scene = scene_of(sampled(centred({8, 8, 8}), [](const glm::dvec3&) { return 5; }), ViewMode::iso, 9);
    scene.shading = Shading::lambert;
    scene.surface_color = glm::dvec3(1, 0.5, 0.25);
    const Frame front = render_reference(scene, brute_force());
    const std::size_t middle = pixel_index(front, 4, 4);
    EXPECT_EQ(front.color[middle], glm::vec4(1, 0.5, 0.25, 1));
    const double half_sphere = 0.5 * scene.volume.geometry().diameter_mm();
    EXPECT_NEAR(front.depth_mm[middle], half_sphere - 4, 1e-5);
    scene.camera.azimuth_deg = 30;
    const Frame turned = render_reference(scene, brute_force());
    EXPECT_NEAR(turned.color[middle].r, 0.2 + 0.8 * std::cos(glm::radians(30.0)), 1e-6);
    scene.shading = Shading::phong;
    const double c = std::cos(glm::radians(30.0));
    EXPECT_NEAR(render_reference(scene, brute_force()).color[middle].r, 0.2 + 0.7 * c + 0.3 * std::pow(c, 20), 1e-6);
}

TEST(ReferenceIso, AnEyeInsideTheObjectSeesItAtOnce) {
    Scene scene = scene_of(sampled(centred({8, 8, 8}), [](const glm::dvec3&) { return 5; }), ViewMode::iso, 9);
    scene.camera.fov_deg = 170;
    const Frame frame = render_reference(scene, brute_force());
    EXPECT_EQ(frame.depth_mm[pixel_index(frame, 4, 4)], 0);
    EXPECT_EQ(frame.color[pixel_index(frame, 4, 4)], glm::vec4(glm::vec3(scene.surface_color), 1));
}

TEST(ReferenceIso, NormalsOfABallFaceOutwardWhateverTheSpacing) {
    Scene scene = ball_scene(40, 25, glm::dvec3(1, 0.8, 2), false);
    scene.shading = Shading::lambert;
    scene.surface_color = glm::dvec3(1);
    const Frame frame = render_reference(scene, brute_force());
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    int seen = 0;
    for (int y = 0; y < frame.size.y; ++y) {
        for (int x = 0; x < frame.size.x; ++x) {
            const double truth = ball_depth(rays.origin(x, y), rays.direction(x, y), 12.3);
            if (std::isinf(truth)) continue;
            const double c = std::fabs(
                glm::dot(glm::normalize(rays.origin(x, y) + truth * rays.direction(x, y)), rays.direction(x, y)));
            if (c < 0.3) continue;
            ++seen;
            EXPECT_NEAR(frame.color[pixel_index(frame, x, y)].r, 0.2 + 0.8 * c, 0.03) << x << ' ' << y;
        }
    }
    EXPECT_GT(seen, 100);
}

TEST(ReferenceIso, CutsCapOrOpen) {
    Scene scene = scene_of(ball(centred({41, 41, 41}), 15), ViewMode::iso, 41);
    scene.window = {-15, 15};
    scene.cuts = {{{0, 1, 0}, 0, true}};  // keeps y >= 0: the eye in front looks onto the cut face
    const double to_centre = 0.5 * scene.volume.geometry().diameter_mm();
    const Frame capped = render_reference(scene, brute_force());
    const std::size_t middle = pixel_index(capped, 20, 20);
    EXPECT_NEAR(capped.depth_mm[middle], to_centre, 1e-5);
    EXPECT_NEAR(capped.color[middle].r, 1, 1e-6);  // value 15 at the centre
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    EXPECT_NEAR(capped.color[middle + 4].r, (30 - 4 * rays.pixel_mm) / 30, 0.02);

    scene.cuts[0].cap = false;
    const Frame open = render_reference(scene, brute_force());
    EXPECT_NEAR(open.depth_mm[middle], to_centre + 15, 0.02);
    EXPECT_EQ(open.color[middle], glm::vec4(glm::vec3(scene.surface_color), 1));

    scene.cuts[0] = {{0, -2, 0}, 0, true};  // keeps the half towards the eye: nothing changes
    EXPECT_NEAR(render_reference(scene, brute_force()).depth_mm[middle], to_centre - 15, 0.02);
    scene.cuts = {{{1, 0, 0}, -50, true}};  // keeps nothing
    EXPECT_TRUE(std::isinf(render_reference(scene, brute_force()).depth_mm[middle]));
}

TEST(ReferenceIso, RangesBoundTheSurfaceFromAbove) {
    // Value = distance from the centre; only 5..8 is material, so its outer face is met first.
    Scene scene =
        scene_of(sampled(centred({31, 31, 31}), [](const glm::dvec3& p) { return glm::length(p); }), ViewMode::iso, 31);
    scene.iso = 0;
    scene.classification.ranges = {{"shell", {5, 8}, std::nullopt}};
    const Frame frame = render_reference(scene, brute_force());
    const double to_centre = 0.5 * scene.volume.geometry().diameter_mm();
    EXPECT_NEAR(frame.depth_mm[pixel_index(frame, 15, 15)], to_centre - 8, 0.05);
    scene.iso = 6;  // still the outer face; the inner one has moved to 6
    EXPECT_NEAR(render_reference(scene, brute_force()).depth_mm[pixel_index(frame, 15, 15)], to_centre - 8, 0.05);
    scene.iso = 9;
    EXPECT_TRUE(std::isinf(render_reference(scene, brute_force()).depth_mm[pixel_index(frame, 15, 15)]));
}

TEST(ReferenceIso, ANaNShellMakesTheNextSampleTheHit) {
    // Object below y = 0, NaN in the slice before it: the first sample behind the NaN is inside and unrefined.
    Scene scene = scene_of(sampled(centred({9, 9, 9}),
                                   [](const glm::dvec3& p) {
                                       return p.y < -2 ? -1.0 : p.y < -0.5 ? double(k_nan) : 1.0;
                                   }),
                           ViewMode::iso, 9);
    const Frame frame = render_reference(scene, brute_force(0.5));
    const double to_front = 0.5 * scene.volume.geometry().diameter_mm() - 4.5;
    // Voxels y = 0..8 hold -1 -1 NaN NaN 1 ...: samples are NaN up to y = 4, the first beyond lies at y = 4.25.
    const float depth = frame.depth_mm[pixel_index(frame, 4, 4)];
    EXPECT_NEAR(depth, to_front + 4.75, 1e-5);
}

}  // namespace
}  // namespace lacuna
