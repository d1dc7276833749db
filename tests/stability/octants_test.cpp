// Shear-warp where its regions of viewing directions meet: borders of the 24, exact diagonals, and the jump between
// axes.
#include <gtest/gtest.h>

#include "core/render/shear_warp.h"
#include "tests/stability/failure_scenes.h"

namespace lacuna {
namespace {

using namespace test;

Frame warped(const Scene& scene, Sampler sampler, ShearWarpRenderer& renderer) {
    Scene shown = scene;
    shown.mode = ViewMode::shear_warp;
    Plan plan = default_plan(shown);
    plan.sampler = sampler;
    BuildRecord built;
    return renderer.render(shown, plan, {}, built);
}

/// Balls of several sizes, one hollow: hidden and visible voxels from every side.
Scene balls(const glm::dvec3& spacing) {
    const Volume volume = sampled(centred(glm::ivec3(glm::round(44.0 / spacing)), spacing), [](const glm::dvec3& mm) {
        double inside = 9 - glm::length(mm - glm::dvec3(-6, -5, 4));
        inside = std::max(inside, 4 - glm::length(mm - glm::dvec3(11, 8, -9)));
        return std::max(inside, 6 - glm::length(mm - glm::dvec3(7, -8, -6)));
    });
    return scene_of(volume, ViewMode::iso, 72);
}

void look_along(Scene& scene, const glm::dvec3& direction) {
    const glm::dvec3 d = -glm::normalize(direction);  // towards the eye
    scene.camera.elevation_deg = glm::degrees(std::asin(std::clamp(d.z, -1.0, 1.0)));
    scene.camera.azimuth_deg = glm::degrees(std::atan2(d.x, -d.y));
}

struct Agreement {
    double overlap = 0, worst_mm = 0, mean_mm = 0;
};

/// Depth changes by no more than `limit_mm` towards the four pixels around.
bool is_flat(const Frame& frame, std::size_t i, double limit_mm) {
    for (const std::size_t n : {i - 1, i + 1, i - std::size_t(frame.size.x), i + std::size_t(frame.size.x)})
        if (!(std::fabs(frame.depth_mm[n] - frame.depth_mm[i]) <= limit_mm)) return false;
    return true;
}

/// Against rays, where the surface is not steeper than 45 degrees and no outline runs.
Agreement agreement(const Scene& scene, const Frame& warped, const Frame& truth) {
    const double pixel = resolve(scene.camera, scene.volume.geometry(), scene.size).pixel_mm;
    Agreement a;
    double both = 0, either = 0;
    int compared = 0;
    for (int y = 1; y + 1 < truth.size.y; ++y)
        for (int x = 1; x + 1 < truth.size.x; ++x) {
            const std::size_t i = pixel_index(truth, x, y);
            const bool here = truth.color[i].a > 0.5f, there = warped.color[i].a >= 0.5f;
            both += here && there;
            either += here || there;
            if (!here || !there || !is_flat(truth, i, pixel) || !is_flat(warped, i, 4 * pixel)) continue;
            const double error = std::fabs(double(warped.depth_mm[i]) - double(truth.depth_mm[i]));
            a.worst_mm = std::max(a.worst_mm, error);
            a.mean_mm += error;
            ++compared;
        }
    a.overlap = both / either;
    a.mean_mm /= std::max(compared, 1);
    return a;
}

TEST(Octants, NothingIsLostOnTheBordersOfTheTwentyFourRegions) {
    for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 2)}) {
        Scene scene = balls(spacing);
        ShearWarpRenderer renderer;
        const double diagonal = glm::length(spacing);
        // A component of exactly zero, two of equal size, all three of equal size; and a hair beside each.
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    for (const double hair : {0.0, 1e-9}) {
                        SCOPED_TRACE(testing::Message() << x << " " << y << " " << z << " beside by " << hair
                                                        << ", z spacing " << spacing.z);
                        look_along(scene, glm::dvec3(x, y, z) + hair * glm::dvec3(1, -2, 3));
                        const Frame truth = on_device(scene, brute_force(0.5));
                        const Agreement smooth = agreement(scene, warped(scene, Sampler::linear, renderer), truth);
                        EXPECT_GT(smooth.overlap, spacing.z > 1 ? 0.88 : 0.92);
                        EXPECT_LT(smooth.worst_mm, 0.6 * diagonal);
                        if (hair > 0) continue;
                        const Agreement rough = agreement(scene, warped(scene, Sampler::nearest, renderer), truth);
                        EXPECT_GT(rough.overlap, 0.8);
                        EXPECT_LT(rough.worst_mm, 1.6 * diagonal);
                    }
                }
    }
}

TEST(Octants, NearestLosesDepthAtFortyFiveDegreesLinearDoesNot) {
    Scene scene = balls(glm::dvec3(1));
    ShearWarpRenderer renderer;
    look_along(scene, {1, 1, 0});
    const Frame truth = on_device(scene, brute_force(0.25));
    const Agreement rough = agreement(scene, warped(scene, Sampler::nearest, renderer), truth);
    const Agreement smooth = agreement(scene, warped(scene, Sampler::linear, renderer), truth);
    EXPECT_GT(rough.mean_mm, 0.2);
    EXPECT_LT(smooth.mean_mm, 0.1);
}

TEST(Octants, ThePictureJumpsWhereThePrincipalAxisSwitches) {
    Scene scene = balls(glm::dvec3(1));
    scene.shading = Shading::phong;
    ShearWarpRenderer renderer;
    const auto change = [&](double from_deg, Sampler sampler) {
        scene.camera.elevation_deg = 10;
        scene.camera.azimuth_deg = from_deg - 0.01;
        const Frame before = warped(scene, sampler, renderer);
        scene.camera.azimuth_deg = from_deg + 0.01;
        const Frame after = warped(scene, sampler, renderer);
        double sum = 0;
        for (std::size_t i = 0; i < before.pixels(); ++i)
            sum += 85.0 * double(glm::dot(glm::abs(before.color[i] - after.color[i]), glm::vec4(1, 1, 1, 0)));
        return sum / double(before.pixels());
    };
    for (const Sampler sampler : {Sampler::nearest, Sampler::linear}) {
        const double at = change(45, sampler), beside = change(38, sampler);
        EXPECT_GT(at, 2 * beside) << name_of(sampler) << ": the published failure";
        EXPECT_LT(at, 6) << name_of(sampler) << ": levels on average, at few pixels a voxel";
    }
}

}  // namespace
}  // namespace lacuna
