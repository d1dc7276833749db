// Pre-integrated transfer functions: against the integral itself (the reference's 16 times finer samples).
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "core/render/reference_renderer.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

Plan segments(double step = 1) {
    Plan plan;
    plan.structure = Structure::none;
    plan.step = step;
    plan.ert = 0;
    plan.integration = Integration::preintegrated;
    return plan;
}

Frame render(const Scene& scene, const Plan& plan, int lanes = 16, bool count = false) {
    check(plan, scene);
    return test::renderer(lanes).render(scene, plan, {}, count).frame;
}

/// A peak of the given width (share of the value range) around the middle value, like an isosurface.
Scene spike_scene(const Volume& volume, double width, glm::ivec2 size = {61, 47}) {
    Scene scene = test::small_scene(volume, ViewMode::ea, size);
    const double lo = scene.window.lo, w = scene.window.width(), peak = lo + 0.5 * w, half = 0.5 * width * w;
    const double unit = volume.geometry().smallest_spacing_mm();
    scene.classification.tf = {"spike",
                               unit,
                               {{lo, {0.2, 0.3, 0.9}, 0},
                                {peak - half, {0.2, 0.3, 0.9}, 0},
                                {peak, {1, 0.7, 0.2}, 0.9},
                                {peak + half, {0.9, 0.1, 0.1}, 0},
                                {lo + w, {1, 1, 1}, 0}},
                               {}};
    return scene;
}

TEST(Segments, ComeFarCloserToTheIntegralThanPoints) {
    LACUNA_NEEDS_DEVICE();
    const Volume volume = test::bumpy_ball<std::uint16_t>({40, 41, 39}, {1, 1, 1}, 60000);
    for (Shading shading : {Shading::none, Shading::phong}) {
        Scene scene = spike_scene(volume, 0.06, {80, 80});
        scene.shading = shading;
        Plan plan = segments(1);
        const Frame truth = render_reference(scene, plan);
        const ImageError pre = compare(render(scene, plan), truth, {0, 0, 0});
        plan.integration = Integration::riemann;
        const ImageError points = compare(render(scene, plan), truth, {0, 0, 0});
        EXPECT_LT(pre.mean, 0.15 * points.mean) << name_of(shading);
        EXPECT_GT(pre.psnr, points.psnr + 12) << name_of(shading);
    }
}

// The volume's signal is not linear between samples: what is left falls with the square of the step.
TEST(Segments, ConvergeWithTheSquareOfTheStep) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = spike_scene(test::bumpy_ball<std::uint16_t>({40, 41, 39}, {1, 1, 1}, 60000), 0.2, {64, 64});
    scene.shading = Shading::none;
    Plan fine = segments(0.0625);
    const Frame truth = render_reference(scene, fine);
    const double at_two = compare(render(scene, segments(2)), truth, {0, 0, 0}).mean;
    const double at_one = compare(render(scene, segments(1)), truth, {0, 0, 0}).mean;
    const double at_half = compare(render(scene, segments(0.5)), truth, {0, 0, 0}).mean;
    EXPECT_GT(at_two / at_one, 2.0);
    EXPECT_GT(at_one / at_half, 2.0);
    EXPECT_LT(at_half, 0.6);
}

TEST(Segments, AgreeWithTheIntegralOnUglyVolumes) {
    LACUNA_NEEDS_DEVICE();
    for (const test::NamedVolume& v : test::ugly_volumes()) {
        SCOPED_TRACE(v.name);
        Scene scene = test::small_scene(v.volume, ViewMode::ea);
        scene.shading = Shading::none;
        for (TransferPoint& p : scene.classification.tf.points) p.opacity *= 0.3;  // nothing but the integral
        const Plan plan = segments(0.25);
        const Frame truth = render_reference(scene, plan);
        const ImageError error = compare(render(scene, plan), truth, {0, 0, 0});
        // A segment with one end that is NaN is left out whole; points leave out a sixteenth of it.
        EXPECT_LT(error.mean, v.name == "nan_f32" ? 6.0 : 0.6) << "max " << error.max;
    }
}

TEST(Segments, RangesAreIntegratedWithTheirOwnFunctions) {
    LACUNA_NEEDS_DEVICE();
    const Volume volume = test::bumpy_ball<std::int16_t>({40, 41, 39}, {1, 1, 1.5}, 3000, -1000);
    Scene scene = test::small_scene(volume, ViewMode::ea);
    scene.shading = Shading::none;
    scene.classification.tf.unit_distance_mm = 3;
    const double lo = scene.window.lo, w = scene.window.width();
    scene.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}}, {"b", {lo + 0.6 * w, lo + 0.9 * w}, {}}};
    scene.classification.ranges[1].tf =
        TransferFunction{"own", 1.0, {{lo, {1, 0, 0}, 0.3}, {lo + w, {0, 1, 0}, 0.6}}, {}};
    Plan plan = segments(0.5);
    const Frame truth = render_reference(scene, plan);
    const double pre = compare(render(scene, plan), truth, {0, 0, 0}).mean;
    plan.integration = Integration::riemann;
    EXPECT_LT(pre, 0.5 * compare(render(scene, plan), truth, {0, 0, 0}).mean);
    EXPECT_LT(pre, 1.0);
}

TEST(Segments, EveryStructureChangesNothing) {
    LACUNA_NEEDS_DEVICE();
    const auto volumes = test::ugly_volumes();
    for (const std::size_t which : {std::size_t(2), std::size_t(4)})
        for (Structure structure : {Structure::macrocells, Structure::octree, Structure::pyramid, Structure::pc,
                                    Structure::acd, Structure::eacd}) {
            if (which == 4 && structure != Structure::macrocells && structure != Structure::pyramid) continue;
            for (bool cut : {false, true}) {
                SCOPED_TRACE(volumes[which].name + " " + std::string(name_of(structure)));
                Scene scene = spike_scene(volumes[which].volume, 0.1);
                const glm::dvec3 normal(0.3, 1, -0.2);
                if (cut) scene.cuts = {{normal, -glm::dot(normal, scene.volume.geometry().centre_mm()), true}};
                for (double step : {0.5, 2.3}) {
                    Plan plan = segments(step);
                    const Frame plain = render(scene, plan);
                    plan.structure = structure;
                    const Frame frame = render(scene, plan, 16, structure == Structure::acd);
                    EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4) << step;
                    EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << step;
                    if (structure == Structure::acd && !cut) {
                        EXPECT_GT(frame.counters.skipped, 0u);
                    }
                }
            }
        }
}

// A ray that jumps from one invisible value to another in one step shows what lies between.
TEST(Segments, ShowAPeakNoSampleEverHits) {
    LACUNA_NEEDS_DEVICE();
    GridGeometry grid;
    grid.size = {24, 24, 24};
    const Volume step = make_volume<std::uint8_t>(grid, [&](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = (i / 24) % 24 < 12 ? 0 : 200;
    });
    Scene scene = test::small_scene(step, ViewMode::ea, {40, 40});
    scene.camera = {};
    scene.camera.zoom = 3;
    scene.classification.tf = {
        "peak", 1, {{98, glm::dvec3(1), 0}, {100, glm::dvec3(1), 0.99}, {102, glm::dvec3(1), 0}}, {}};
    scene.shading = Shading::none;
    Plan plan = segments(3);
    for (Structure structure : {Structure::none, Structure::octree, Structure::pyramid, Structure::acd}) {
        plan.structure = structure;
        const Frame frame = render(scene, plan);
        double least = 1;
        for (const glm::vec4& c : frame.color) least = std::min(least, double(c.a));
        EXPECT_GT(least, 0.01) << name_of(structure);
    }
}

TEST(Segments, LeapIsRefusedNamingWhatCanServe) {
    const Scene scene = spike_scene(test::ugly_volumes()[2].volume, 0.1);
    Plan plan = segments(0.5);
    plan.structure = Structure::leap;
    try {
        check(plan, scene);
        FAIL() << "no kernel takes runs of segments";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_usage);
        EXPECT_NE(std::string(error.what()).find("acd"), std::string::npos) << error.what();
    }
}

TEST(Segments, WrongCombinationsAreRefused) {
    Scene scene = test::small_scene(test::ugly_volumes()[0].volume, ViewMode::ea);
    Plan plan = segments();
    EXPECT_NO_THROW(check(plan, scene));
    for (Sampler sampler : {Sampler::nearest, Sampler::adaptive}) {
        plan.sampler = sampler;
        EXPECT_THROW(check(plan, scene), Error);
    }
    plan = segments();
    plan.homogeneity = 0.1;
    EXPECT_THROW(check(plan, scene), Error);
    plan = segments();
    scene.classification.tf.gradient_opacity = {{0, 0.1}, {40, 1.0}};
    EXPECT_THROW(check(plan, scene), Error);
    scene.mode = ViewMode::iso;
    EXPECT_THROW(check(plan, scene), Error);
}

}  // namespace
}  // namespace lacuna
