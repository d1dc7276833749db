#include "core/accuracy/image_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/unit/accuracy/pictures.h"

namespace lacuna {
namespace {

using namespace test;

TEST(ImageError, EqualPicturesHaveNone) {
    const Frame frame = waves({31, 17}, 0.3);
    const ImageError error = compare(frame, frame, {0, 0, 0});
    EXPECT_EQ(error.max, 0);
    EXPECT_EQ(error.mean, 0);
    EXPECT_TRUE(std::isinf(error.psnr) && error.psnr > 0);
    EXPECT_NEAR(error.ssim, 1, 1e-12);
    EXPECT_EQ(error.pixels_over_budget, 0u);
}

TEST(ImageError, AKnownOffsetGivesKnownNumbers) {
    const Frame a = flat({8, 4}, {0.5f, 0.25f, 0.25f, 1});
    Frame b = a;
    b.color[5].r += 10.f / 255;
    const ImageError error = compare(a, b, {0, 0, 0}, 9.9);
    EXPECT_NEAR(error.max, 10, 1e-4);
    EXPECT_NEAR(error.mean, 10.0 / 96, 1e-5);
    EXPECT_NEAR(error.psnr, 10 * std::log10(255.0 * 255 / (100.0 / 96)), 1e-3);
    EXPECT_EQ(error.pixels_over_budget, 1u);
    EXPECT_EQ(compare(a, b, {0, 0, 0}, 10.1).pixels_over_budget, 0u);
    b.color[5].r = a.color[5].r + 0.25f / 255;  // below one level, still seen
    EXPECT_NEAR(compare(a, b, {0, 0, 0}).max, 0.25, 1e-4);
}

TEST(ImageError, TheLargestAloneIsTheSameNumber) {
    const glm::dvec3 background(0.2, 0.4, 0.9);
    const TruePicture truth(waves({31, 17}, 0.3), background);
    for (const double phase : {0.0, 0.01, 1.5}) {
        Frame other = waves({31, 17}, 0.3, phase);
        other.color[7].a = 0.5f;
        EXPECT_EQ(truth.largest(other), truth.compare(other).max) << phase;
    }
    EXPECT_EQ(truth.largest(truth.frame()), 0);
    Frame broken = truth.frame();
    broken.color[40].b = std::nanf("");
    EXPECT_TRUE(std::isinf(truth.largest(broken)));
    EXPECT_THROW(truth.largest(flat({3, 3}, glm::vec4(0))), Error);
}

TEST(ImageError, TheBackgroundAndTheDisplaysRangeCount) {
    const Frame clear = flat({4, 4}, {0, 0, 0, 0}), white = flat({4, 4}, {1, 1, 1, 1}),
                brighter = flat({4, 4}, {3, 2, 1, 1});
    EXPECT_EQ(compare(clear, white, {1, 1, 1}).max, 0);
    EXPECT_NEAR(compare(clear, white, {0, 0, 0}).max, 255, 1e-9);
    EXPECT_EQ(compare(brighter, white, {0, 0, 0}).max, 0);
}

TEST(ImageError, SsimFallsWithStructureNotWithBrightness) {
    const glm::ivec2 size(40, 40);
    const Frame truth = waves(size, 0.3);
    Frame brighter = truth;
    for (auto& pixel : brighter.color) pixel += glm::vec4(0.04f, 0.04f, 0.04f, 0);
    EXPECT_GT(compare(brighter, truth, {0, 0, 0}).ssim, 0.97);
    EXPECT_LT(compare(waves(size, 0.3, 1.5), truth, {0, 0, 0}).ssim, 0.5);
    EXPECT_LT(compare(waves(size, 0.3, 3.14159), truth, {0, 0, 0}).ssim, 0);  // inverted
    // Two flat pictures: SSIM has a closed form, (2ab + c1) / (a^2 + b^2 + c1).
    const double a = 0.4 * 255, b = 0.6 * 255, c1 = 6.5025;
    EXPECT_NEAR(compare(flat(size, {0.4f, 0.4f, 0.4f, 1}), flat(size, {0.6f, 0.6f, 0.6f, 1}), {0, 0, 0}).ssim,
                (2 * a * b + c1) / (a * a + b * b + c1), 1e-4);
}

TEST(ImageError, NaNFailsEveryBudget) {
    const Frame sound = flat({4, 4}, {0.5f, 0.5f, 0.5f, 1});
    for (const int part : {0, 3}) {
        Frame broken = sound;
        broken.color[7][part] = std::numeric_limits<float>::quiet_NaN();
        for (const bool swapped : {false, true}) {
            const ImageError error =
                swapped ? compare(sound, broken, {0, 0, 0}, 1e9) : compare(broken, sound, {0, 0, 0}, 1e9);
            EXPECT_TRUE(std::isinf(error.max)) << part;
            EXPECT_GE(error.pixels_over_budget, 1u);
            EXPECT_FALSE(error.mean <= 1e9 || error.psnr > 0 || error.ssim > 0 || error.flip < 1);
        }
    }
}

TEST(ImageError, ChannelsAreToldApart) {
    const Frame a = flat({8, 4}, {0.5f, 0.25f, 0.25f, 1});
    Frame b = a;
    b.color[5].r += 10.f / 255;
    b.color[9].b -= 3.f / 255;
    const ImageError error = compare(a, b, {0, 0, 0});
    EXPECT_NEAR(error.channel_max.r, 10, 1e-4);
    EXPECT_EQ(error.channel_max.g, 0);
    EXPECT_NEAR(error.channel_max.b, 3, 1e-4);
    EXPECT_NEAR(error.channel_mean.r, 10.0 / 32, 1e-5);
    EXPECT_NEAR(error.mean, (error.channel_mean.r + error.channel_mean.g + error.channel_mean.b) / 3, 1e-12);
}

TEST(ImageError, OneTruthServesManyPictures) {
    const glm::ivec2 size(33, 21);
    const TruePicture truth(waves(size, 0.3), {0.1, 0.2, 0.3});
    for (const double phase : {0.0, 0.1, 1.0}) {
        const ImageError once = compare(waves(size, 0.3, phase), truth.frame(), {0.1, 0.2, 0.3});
        const ImageError kept = truth.compare(waves(size, 0.3, phase));
        EXPECT_EQ(once.max, kept.max);
        EXPECT_EQ(once.ssim, kept.ssim);
        EXPECT_EQ(once.flip, kept.flip);
        EXPECT_EQ(once.flip > 0, phase > 0);
    }
}

TEST(ImageError, SizesMustAgree) {
    EXPECT_THROW(compare(flat({4, 4}, {}), flat({2, 8}, {}), {0, 0, 0}), Error);
    EXPECT_EQ(compare(flat({1, 1}, {}), flat({1, 1}, {}), {0, 0, 0}).ssim, 1);
}

}  // namespace
}  // namespace lacuna
