#include "core/accuracy/truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "core/accuracy/mode_error.h"
#include "core/render/reference_renderer.h"
#include "core/render/region_view.h"
#include "core/volume/statistics.h"

namespace lacuna {
namespace {

struct Sample {
    AnalyticSample analytic;
    Scene scene;
};

Sample sample(const char* name, int size, ViewMode mode, int pixels = 40) {
    Sample made{make_sample(name, {.size = size}), {}};
    made.scene = default_scene(made.analytic.volume, compute_statistics(made.analytic.volume));
    made.scene.mode = mode;
    made.scene.size = glm::ivec2(pixels, pixels - 7);
    made.scene.camera.azimuth_deg = 33;
    made.scene.camera.elevation_deg = 21;
    return made;
}

/// The brute-force picture of the voxels, as a plan draws it.
Frame voxels(const Scene& scene, double step = 0.5) {
    Plan plan = reference_plan(scene, default_plan(scene));
    plan.step = step;
    return render_reference(scene, plan);
}

TEST(Truth, NamesAreThoseParsed) {
    for (const Truth truth : {Truth::samples, Truth::fine, Truth::closed_form})
        EXPECT_EQ(parse_truth(name_of(truth)), truth);
    EXPECT_THROW(parse_truth("better"), Error);
}

TEST(Truth, SamplesAreBruteForceAtThePlansStep) {
    const Sample s = sample("head", 24, ViewMode::ea);
    Plan plan = default_plan(s.scene);
    plan.step = 0.7;
    const TrueFrame truth = render_truth(Truth::samples, s.scene, plan);
    EXPECT_EQ(compare(voxels(s.scene, 0.7), truth.frame, {0, 0, 0}).max, 0);
    EXPECT_NE(truth.reference.find("step 0.7"), std::string::npos) << truth.reference;
    EXPECT_TRUE(truth.has_colors);
}

TEST(Truth, TheFineReferenceShowsWhatTheStepCosts) {
    const Sample s = sample("head", 24, ViewMode::ea);
    double before = 1e9;
    for (const double step : {2.0, 1.0, 0.5}) {
        Plan plan = default_plan(s.scene);
        plan.step = 0.5;
        const TrueFrame truth = render_truth(Truth::fine, s.scene, plan);
        const double error = compare(voxels(s.scene, step), truth.frame, {0, 0, 0}).mean;
        EXPECT_GT(error, 0);
        EXPECT_LT(error, before);
        before = error;
    }
}

TEST(Truth, BallsAreFoundExactlyAndVoxelsComeCloser) {
    double before = 1e9;
    for (const int size : {24, 48, 96}) {
        Sample s = sample("spheres", size, ViewMode::iso);
        s.scene.iso = 110;  // halfway: where the surface truly is
        const TrueFrame truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
        EXPECT_TRUE(truth.has_colors);
        const SurfaceError error =
            compare_surfaces(voxels(s.scene), truth.frame, s.scene.volume.geometry().smallest_spacing_mm());
        EXPECT_GT(error.both, 80u);
        const double mean_mm = error.mean_voxels * s.scene.volume.geometry().smallest_spacing_mm();
        EXPECT_LT(mean_mm, 0.6 * before) << size;
        before = mean_mm;
    }
}

TEST(Truth, BallsHaveNoSurfaceAtValuesTheyDoNotHave) {
    Sample s = sample("spheres", 24, ViewMode::iso);
    s.scene.iso = s.analytic.material + 1000;
    TrueFrame truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
    EXPECT_TRUE(truth.has_colors);
    EXPECT_EQ(compare(voxels(s.scene), truth.frame, {0, 0, 0}).max, 0) << "nothing is that bright";
    s.scene.iso = s.analytic.background - 1000;
    truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
    EXPECT_TRUE(truth.has_colors);
    EXPECT_LT(compare(voxels(s.scene), truth.frame, {0, 0, 0}).max, 1) << "the volume's own sides";
}

TEST(Truth, RegionsHaveNoClosedForm) {
    Sample s = sample("spheres", 24, ViewMode::ea);
    s.scene.shading = Shading::none;
    EXPECT_NO_THROW(render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic));
    RegionViewOptions options;
    options.view = RegionView::hide;
    options.regions.range_width = 0.1;
    s.scene.regions = make_region_classes(s.scene.volume, options);
    EXPECT_THROW(render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic), Error);
}

TEST(Truth, FineIsSixteenTimesFinerAtTheShortestStepToo) {
    const Sample s = sample("spheres", 16, ViewMode::mip, 12);
    for (const double step : {0.5, 0.1, 0.01}) {
        Plan plan = default_plan(s.scene);
        plan.step = step;
        const std::string words = render_truth(Truth::fine, s.scene, plan).reference;
        EXPECT_NE(words.find(fmt::format("step {:g},", step / 16)), std::string::npos) << words;
    }
}

TEST(Truth, ExactDepthOfTheMiddleBall) {
    Sample s = sample("spheres", 32, ViewMode::iso, 64);
    s.scene.camera = {};  // from the front: along +y
    s.scene.camera.center_mm = s.analytic.objects[0].centre_mm;
    s.scene.size = {63, 63};
    const Frame truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic).frame;
    const ViewRays rays = resolve(s.scene.camera, s.scene.volume.geometry(), s.scene.size);
    const SampleObject& ball = s.analytic.objects[0];
    const double expected = ball.centre_mm.y - ball.radii_mm.y - rays.origin(31, 31).y;
    EXPECT_NEAR(truth.depth_mm[31 * 63 + 31], expected, 1e-4);
    EXPECT_NEAR(truth.color[31 * 63 + 31].r, s.scene.surface_color.r * 0.9 + 0.3, 1e-3) << "seen head-on";
}

TEST(Truth, AFormulasSurfaceHasDepthAndNormal) {
    for (const int size : {41, 81}) {
        Sample s = sample("marschner-lobb", size, ViewMode::iso);
        s.scene.iso = 0.5;
        const TrueFrame truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
        EXPECT_TRUE(truth.has_colors);
        const SurfaceError error =
            compare_surfaces(voxels(s.scene), truth.frame, s.scene.volume.geometry().smallest_spacing_mm());
        EXPECT_LT(error.mean_voxels, size == 41 ? 2 : 0.8);
        EXPECT_GT(error.both, 100u);
    }
}

TEST(Truth, ProjectionsFallShortOfTheFormula) {
    Sample s = sample("marschner-lobb", 81, ViewMode::mip);
    const TrueFrame truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
    double before = 1e9;
    for (const double step : {2.0, 0.5}) {
        const ProjectionError error = compare_projections(voxels(s.scene, step), truth.frame, s.scene.window);
        EXPECT_GT(error.max_undershoot, 0);
        EXPECT_LT(error.mean_undershoot, before);
        before = error.mean_undershoot;
    }
    s.scene.mode = ViewMode::mean;
    const TrueFrame mean = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
    EXPECT_LT(compare(voxels(s.scene), mean.frame, {0, 0, 0}).mean, 3);
}

TEST(Truth, UnshadedVolumesOfSolidPartsAreIntegrated) {
    Sample s = sample("spheres", 64, ViewMode::ea);
    s.scene.shading = Shading::none;
    s.scene.classification.tf = {"balls", 8, {{60, {1, 1, 1}, 0}, {160, {1, 0.5, 0.2}, 0.6}}, {}};
    const TrueFrame truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
    const double mean = compare(voxels(s.scene), truth.frame, {0, 0, 0}).mean;
    EXPECT_LT(mean, 4);
    EXPECT_GT(mean, 0);
    // A ray through the middle of a ball: 1 - (1 - a)^(chord / unit).
    s.scene.camera = {};
    s.scene.camera.center_mm = s.analytic.objects[4].centre_mm;  // the lone ball at the back
    s.scene.size = {1, 1};
    const glm::dvec3 middle = s.analytic.objects[4].centre_mm;
    double chord = 0;  // through every ball on that line
    for (const SampleObject& o : s.analytic.objects) {
        const double aside = std::hypot(o.centre_mm.x - middle.x, o.centre_mm.z - middle.z);
        if (aside < o.radii_mm.x) chord += 2 * std::sqrt(o.radii_mm.x * o.radii_mm.x - aside * aside);
    }
    const Frame one = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic).frame;
    EXPECT_NEAR(one.color[0].a, 1 - std::pow(0.4, chord / 8), 2e-3);
}

TEST(Truth, SolidPartsWithoutNormalsGiveDepthsAlone) {
    Sample s = sample("casting", 32, ViewMode::iso, 24);
    s.scene.iso = 0.5 * (s.analytic.background + s.analytic.material);
    const TrueFrame truth = render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
    EXPECT_FALSE(truth.has_colors);
    const SurfaceError error =
        compare_surfaces(voxels(s.scene), truth.frame, s.scene.volume.geometry().smallest_spacing_mm());
    EXPECT_GT(error.both, 50u);
    EXPECT_LT(error.mean_voxels, 1.5);
    s.scene.shading = Shading::none;
    EXPECT_TRUE(render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic).has_colors);
}

TEST(Truth, SaysWhereThereIsNoClosedForm) {
    Sample s = sample("casting", 16, ViewMode::ea, 8);
    const auto refused = [&] {
        try {
            render_truth(Truth::closed_form, s.scene, default_plan(s.scene), &s.analytic);
        } catch (const Error& error) {
            return error.code() == Errc::unsupported;
        }
        return false;
    };
    EXPECT_TRUE(refused()) << "shaded";
    s.scene.shading = Shading::none;
    EXPECT_FALSE(refused());
    s.scene.cuts.push_back({});
    EXPECT_TRUE(refused());
    s.scene.cuts.clear();
    s.scene.mode = ViewMode::lmip;
    EXPECT_TRUE(refused());
    EXPECT_THROW(render_truth(Truth::closed_form, s.scene, {}, nullptr), Error);
    std::stop_source stop;
    stop.request_stop();
    s.scene.mode = ViewMode::mip;
    EXPECT_THROW(render_truth(Truth::closed_form, s.scene, {}, &s.analytic, {stop.get_token()}), Error);
}

}  // namespace
}  // namespace lacuna
