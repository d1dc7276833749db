// The adaptive sampler, gradient filters and stored gradients, early termination: each against what it must equal.
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "core/render/reference_renderer.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

Plan brute_force() {
    Plan plan;
    plan.structure = Structure::none;
    plan.ert = 0;
    return plan;
}

RenderResult render(const Scene& scene, const Plan& plan, bool count = false) {
    check(plan, scene);
    return test::renderer().render(scene, plan, {}, count);
}

TEST(Adaptive, ThePictureIsThatOfLinear) {
    LACUNA_NEEDS_DEVICE();
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::mean}) {
            if (mode == ViewMode::mean && v.name != "nan_f32") continue;
            // Each voxel type is a kernel to compile: three tell all there is to tell.
            if (v.volume.type() == VoxelType::i8 || v.volume.type() == VoxelType::i16) continue;
            for (bool ranged : {false, true}) {
                if (ranged && v.name != "u16_1_1_5") continue;
                SCOPED_TRACE(v.name + " " + std::string(name_of(mode)) + (ranged ? " ranges" : ""));
                Scene scene = test::small_scene(v.volume, mode);
                const double lo = scene.window.lo, w = scene.window.width();
                if (ranged) {
                    scene.iso = lo;
                    scene.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}},
                                                   {"b", {lo + 0.6 * w, lo + 0.9 * w}, {}}};
                }
                Plan plan = brute_force();
                const Frame linear = render(scene, plan).frame;
                plan.sampler = Sampler::adaptive;
                const Frame adaptive = render(scene, plan).frame;
                EXPECT_LE(test::share_over(adaptive, linear, 0.01), 0);
                for (std::size_t i = 0; i < linear.pixels(); ++i)
                    ASSERT_EQ(adaptive.depth_mm[i], linear.depth_mm[i]) << i;
            }
        }
}

TEST(Adaptive, ReadsFewerCellsOfEightVoxels) {
    LACUNA_NEEDS_DEVICE();
    const Volume casting = make_sample("casting", {.size = 96}).volume;
    for (ViewMode mode : {ViewMode::iso, ViewMode::ea}) {
        Scene scene = test::small_scene(casting, mode, {96, 96});
        Plan plan = brute_force();
        const Counters linear = render(scene, plan, true).frame.counters;
        EXPECT_EQ(linear.trilinear, linear.samples);
        plan.sampler = Sampler::adaptive;
        const RenderResult adaptive = render(scene, plan, true);
        EXPECT_EQ(adaptive.frame.counters.samples, linear.samples);
        EXPECT_LT(double(adaptive.frame.counters.trilinear), 0.8 * double(linear.trilinear)) << name_of(mode);
        EXPECT_GT(adaptive.frame.counters.trilinear, 0u);
        EXPECT_GT(adaptive.build.at("steady blocks").bytes, 0u);
        plan.sampler = Sampler::nearest;
        EXPECT_EQ(render(scene, plan, true).frame.counters.trilinear, 0u);
    }
}

TEST(Adaptive, AnEditOfTheTransferFunctionIsSeen) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = test::small_scene(test::ugly_volumes()[2].volume, ViewMode::ea);
    Plan plan = brute_force();
    plan.sampler = Sampler::adaptive;
    render(scene, plan);
    for (TransferPoint& p : scene.classification.tf.points) p.opacity = 0.5 * p.opacity + 0.01;
    const Frame adaptive = render(scene, plan).frame;
    plan.sampler = Sampler::linear;
    EXPECT_LE(test::share_over(adaptive, render(scene, plan).frame, 0.01), 0);
}

/// Share of pixels off by more than two levels, and the mean difference.
void expect_close(const Frame& frame, const Frame& truth, double share, double mean) {
    const ImageError error = compare(frame, truth, {0, 0, 0});
    EXPECT_LE(test::share_over(frame, truth, 2.0), share) << "max " << error.max << " mean " << error.mean;
    EXPECT_LE(error.mean, mean) << "max " << error.max;
}

TEST(Gradients, SobelEqualsTheReference) {
    LACUNA_NEEDS_DEVICE();
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (ViewMode mode : {ViewMode::iso, ViewMode::ea}) {
            SCOPED_TRACE(v.name + " " + std::string(name_of(mode)));
            const Scene scene = test::small_scene(v.volume, mode);
            Plan plan = brute_force();
            plan.gradient = GradientFilter::sobel;
            const Frame truth = render_reference(scene, plan);
            expect_close(render(scene, plan).frame, truth, 0.004, 0.15);
        }
}

TEST(Gradients, SobelIsNotCentral) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = test::small_scene(make_sample("casting", {.size = 48}).volume, ViewMode::iso);
    Plan plan = brute_force();
    const Frame central = render(scene, plan).frame;
    plan.gradient = GradientFilter::sobel;
    EXPECT_GT(test::share_over(render(scene, plan).frame, central, 1.0), 0.02);
}

// Nine bits a component with a shared exponent: at most 0.2 degrees, under a grey level but where Phong's gloss is
// steep.
TEST(Gradients, StoredOnesLookLikeThoseOnTheFly) {
    LACUNA_NEEDS_DEVICE();
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (GradientFilter filter : {GradientFilter::central, GradientFilter::sobel})
            for (ViewMode mode : {ViewMode::iso, ViewMode::ea}) {
                SCOPED_TRACE(v.name + " " + std::string(name_of(mode)) + " " + std::string(name_of(filter)));
                Scene scene = test::small_scene(v.volume, mode);
                if (v.name == "i16_oblique") scene.classification.tf.gradient_opacity = {{0, 0.1}, {400, 1.0}};
                Plan plan = brute_force();
                plan.gradient = filter;
                const Frame fly = render(scene, plan).frame;
                plan.gradient_store = GradientStore::stored;
                const RenderResult stored = render(scene, plan);
                expect_close(stored.frame, fly, 0.004, 0.3);
                EXPECT_GE(stored.build.at("gradients").bytes, 4 * std::size_t(v.volume.geometry().voxel_count()));
            }
}

TEST(Gradients, NothingIsStoredWhereNothingIsShaded) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = test::small_scene(test::ugly_volumes()[0].volume, ViewMode::ea);
    scene.shading = Shading::none;
    Plan plan = brute_force();
    plan.gradient_store = GradientStore::stored;
    EXPECT_EQ(render(scene, plan).build.count("gradients"), 0u);
    scene.mode = ViewMode::mip;
    EXPECT_EQ(render(scene, plan).build.count("gradients"), 0u);
}

// Adversarial: a veil that leaves just more than E, in front of the brightest core there can be.
TEST(Termination, HidesNoMoreThanItsBound) {
    LACUNA_NEEDS_DEVICE();
    GridGeometry grid;
    grid.size = {32, 64, 32};
    const Volume volume = make_volume<std::uint8_t>(grid, [&](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = (i / 32) % 64 < 32 ? 100 : 200;
    });
    for (Shading shading : {Shading::none, Shading::phong})
        for (double ert : {0.3, 0.05, 0.002}) {
            Scene scene = test::small_scene(volume, ViewMode::ea, {48, 48});
            scene.camera = {};
            scene.camera.zoom = 2;
            scene.shading = shading;
            // Dark until the veil has taken 1 - ert/0.999 of the light, then white and opaque.
            const double veil = 1 - std::pow(ert * 0.999, 1 / 31.0);
            scene.classification.tf = {"core",
                                       1,
                                       {{100, glm::dvec3(0), veil},
                                        {101, glm::dvec3(0), veil},
                                        {102, glm::dvec3(1), 1},
                                        {200, glm::dvec3(1), 1}},
                                       {}};
            Plan plan = brute_force();
            const Frame whole = render(scene, plan).frame;
            plan.ert = ert;
            const Frame stopped = render(scene, plan).frame;
            double worst = 0;
            for (std::size_t i = 0; i < whole.pixels(); ++i) {
                const glm::vec4 d = glm::abs(whole.color[i] - stopped.color[i]) * 255.0f;
                worst = std::max(worst, double(std::max({d.r, d.g, d.b})));
            }
            EXPECT_LE(worst, hidden_levels(ert, shading) + 1e-3) << ert;
            EXPECT_GT(worst, 0.3 * 255 * ert) << "the scene must come close to the bound to test it";
        }
}

}  // namespace
}  // namespace lacuna
