#include "core/accuracy/sparse_outlook.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/accuracy/error_bound.h"
#include "core/accuracy/image_error.h"
#include "core/compute/device.h"
#include "core/render/engine.h"
#include "tests/support/scenes.h"
#include "tests/unit/accuracy/pictures.h"

namespace lacuna {
namespace {

using namespace test;

constexpr glm::dvec3 k_black{0, 0, 0};

TEST(SparseOutlook, ABusyPictureNeedsMoreRays) {
    const Frame even = flat({64, 48}, glm::vec4(0.5f));
    const SparseOutlook calm(even, k_black, 4, 1);
    EXPECT_NEAR(calm.share(0.02), 1.0 / 16, 0.02);
    EXPECT_EQ(calm.error(0.02), 0);
    EXPECT_EQ(calm.widest(0), 1) << "nothing is lost by any gradient";
    Frame busy = even;
    for (std::size_t i = 0; i < busy.pixels(); ++i) busy.color[i] = glm::vec4(float(i * 7919 % 97) / 97);
    const SparseOutlook wild(busy, k_black, 4, 1);
    EXPECT_GT(wild.share(0.02), 0.95);
    EXPECT_LT(wild.share(2), 0.1) << "no difference counts";
    EXPECT_GT(wild.error(2), 100);
}

TEST(SparseOutlook, TheWidestGradientIsTheLastThatKeepsTheError) {
    const Frame picture = waves({97, 81}, 0.2);
    for (const int k : {2, 3, 4, 8}) {
        const SparseOutlook outlook(picture, k_black, k, 1);
        double before = 1;
        for (const double error : {30.0, 8.0, 2.0, 0.5}) {
            const double gradient = outlook.widest(error);
            if (gradient <= 0) continue;
            EXPECT_LE(outlook.error(gradient), error) << k;
            EXPECT_LE(gradient, before) << k;
            before = gradient;
            if (gradient < 1) {
                EXPECT_GT(outlook.error(1.01 * gradient), error) << k << ": a wider one would have done";
            }
        }
    }
}

TEST(SparseOutlook, WhatNoCastPixelTellsIsLostByEveryGradient) {
    Frame picture = flat({64, 64}, glm::vec4(0.25f));
    picture.color[std::size_t(21) * 64 + 21] = glm::vec4(1);  // between cast pixels
    EXPECT_LT(SparseOutlook(picture, k_black, 4, 1).widest(10), 0);
    picture.color[std::size_t(21) * 64 + 21].g = std::nanf("");
    EXPECT_LT(SparseOutlook(picture, k_black, 4, 1).widest(1e9), 0);
    Frame edge = flat({64, 64}, glm::vec4(0.25f));
    for (std::size_t i = 0; i < edge.pixels(); ++i) edge.depth_mm[i] = i % 64 < 30 ? 5.f : 500.f;
    EXPECT_GT(SparseOutlook(edge, k_black, 4, 1).share(1), 1.5 / 16) << "an edge in depth is cast again";
}

TEST(SparseOutlook, SaysBeforehandWhatTheDeviceDraws) {
    const std::shared_ptr<ComputeDevice> device = open_device();
    if (!device) GTEST_SKIP() << "no device";
    Engine engine(device);
    // So large that the last cast pixels are the picture's last.
    const Scene scene =
        small_scene(bumpy_ball<std::uint16_t>({48, 47, 46}, {1, 1, 1.3}, 40000), ViewMode::iso, {97, 81});
    Plan plan = brute_force(scene, 0.5);
    const TruePicture truth(engine.render(scene, plan).frame, scene.background);
    const double pixel_mm = resolve(scene.camera, scene.volume.geometry(), scene.size).pixel_mm;
    for (const int k : {2, 4, 8}) {
        const SparseOutlook outlook(truth.frame(), scene.background, k, pixel_mm);
        plan.sparse = k;
        for (const double gradient : {0.004, 0.02, 0.1, 0.5}) {
            plan.sparse_gradient = gradient;
            EXPECT_NEAR(outlook.error(gradient), truth.largest(engine.render(scene, plan).frame), 0.01)
                << k << ", " << gradient;
        }
    }
}

}  // namespace
}  // namespace lacuna
