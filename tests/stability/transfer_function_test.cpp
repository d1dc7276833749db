// Where what lies between two samples, or within one node, is lost: peaks of the transfer function, and the opacity of
// a step, whatever its length and the voxels' size.
#include <gtest/gtest.h>

#include "tests/stability/failure_scenes.h"

namespace lacuna {
namespace {

using namespace test;

/// Values rise evenly from 0 to 240 along y, one every half voxel; a peak of the transfer function makes a shell.
Scene ramp(double peak, double half_width, double opacity = 0.9) {
    const Volume volume = sampled<std::uint16_t>(centred({40, 40, 40}),
                                                 [](const glm::dvec3& mm) { return std::lround(100 * (mm.y + 19.5)); });
    Scene scene = scene_of(volume, ViewMode::ea, 48);
    scene.camera.azimuth_deg = 20;
    scene.camera.elevation_deg = 12;
    scene.classification.tf.points = {
        {peak - half_width, {1, 0.8, 0.2}, 0}, {peak, {1, 0.8, 0.2}, opacity}, {peak + half_width, {1, 0.8, 0.2}, 0}};
    return scene;
}

// Lesar 2015: a node whose values span less than the threshold is taken as its average.
TEST(HomogeneousNodes, HideAPeakOfTheTransferFunctionUnlessOpacitiesAreCompared) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = ramp(2000, 60);
    const Frame plain = on_device(scene, brute_force());
    Plan plan = with_structure(Structure::octree);
    EXPECT_LE(worst_levels(on_device(scene, plan), plain), 1) << "threshold 0 is lossless";
    plan.homogeneity = 1500;  // a leaf of 8 voxels spans 800 to 1000
    EXPECT_GT(worst_levels(on_device(scene, plan), plain), 60) << "the published failure";
    for (const Structure structure : {Structure::pc, Structure::acd, Structure::eacd}) {
        plan = with_structure(structure);
        plan.cells = 1;
        plan.homogeneity = 0.02;  // of opacity and colour, not of values
        EXPECT_LE(worst_levels(on_device(scene, plan), plain), 6) << name_of(structure);
    }
    plan = with_structure(Structure::octree);
    plan.homogeneity = 1500;
    add_method_reasons(plan, scene);
    ASSERT_EQ(plan.why.size(), 1u) << "it is said";
    plan.homogeneity = 50;
    plan.why.clear();
    add_method_reasons(plan, scene);
    EXPECT_TRUE(plan.why.empty()) << "the peak is wider than that";
    // No threshold, no failure: what every structure does by default.
    for (const Structure structure : casting_structures())
        EXPECT_LE(worst_levels(on_device(scene, with_structure(structure)), plain), 1) << name_of(structure);
}

// Es et al. 2006: thresholds too wide show as patches.
TEST(HomogeneousNodes, TheErrorOfAnOpacityThresholdIsBoundedByIt) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = ramp(2000, 1900, 0.06);
    const Frame plain = on_device(scene, brute_force());
    double last = 0;
    for (const double threshold : {0.002, 0.01, 0.05}) {
        Plan plan = with_structure(Structure::acd);
        plan.cells = 1;
        plan.homogeneity = threshold;
        const double off = worst_levels(on_device(scene, plan), plain);
        // A ray crosses 40 to 70 mm, each off by less than the threshold in opacity.
        EXPECT_LE(off, 255 * threshold * 70) << threshold;
        EXPECT_GE(off, last - 0.5) << threshold;
        last = off;
    }
    EXPECT_GT(last, 8) << "a twentieth of opacity shows";
}

/// Opacity of a shell as a ray crosses it whose value changes by `slope` a mm, by integrating its extinction.
double shell_opacity(const TransferFunction& tf, double lo, double hi, double slope) {
    constexpr int k_parts = 100000;
    double depth = 0;
    for (int i = 0; i < k_parts; ++i)
        depth -= std::log1p(-tf.at(lo + (hi - lo) * (i + 0.5) / k_parts).opacity) * (hi - lo) / k_parts;
    return 1 - std::exp(-depth / (slope * tf.unit_distance_mm));
}

TEST(Peaks, FallBetweenSamplesOfPointsNotOfSegments) {
    LACUNA_NEEDS_DEVICE();
    // A peak a tenth of what a step changes the value by: most lattices never meet it. Beyond its ends there is
    // nothing, or (`veil`) what is drawn alike on either side: values outside the function's points are most of a
    // segment's way.
    for (const double veil : {0.0, 0.02})
        for (const double step : {1.0, 2.0, 4.0}) {
            SCOPED_TRACE(testing::Message() << "step " << step << " veil " << veil);
            Scene scene = ramp(2010, 5 * step, 0.95);
            scene.classification.tf.points.front().opacity = scene.classification.tf.points.back().opacity = veil;
            const Frame fine = on_device(scene, brute_force(0.01));
            Plan plan = brute_force(step);
            const double points = worst_levels(on_device(scene, plan), fine);
            plan.integration = Integration::preintegrated;
            EXPECT_GT(points, 20);
            EXPECT_LT(worst_levels(on_device(scene, plan), fine), 3);
        }
}

TEST(Peaks, SegmentTablesSmearWhatIsNarrowerThanTheirEntriesButKeepItsOpacity) {
    LACUNA_NEEDS_DEVICE();
    // An entry covers 1/511 of the span between the outermost points, here 7.6: this peak is a twentieth of that wide.
    Scene scene = ramp(2010, 0.2, 0.999);
    auto& points = scene.classification.tf.points;
    points.insert(points.begin(), {0, {0, 0, 0}, 0});
    points.push_back({3900, {0, 0, 0}, 0});
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    const double truth = shell_opacity(scene.classification.tf, 2009.8, 2010.2, 100 * std::fabs(rays.forward.y));
    Plan plan = brute_force(0.5);
    EXPECT_LT(std::fabs(double(on_device(scene, plan).color[24 * 48 + 24].a)), 0.2 * truth) << "points miss it";
    plan.integration = Integration::preintegrated;
    EXPECT_NEAR(double(on_device(scene, plan).color[24 * 48 + 24].a), truth, 0.2 * truth);
}

// Segments take the signal to be linear between two samples, points know the samples alone.
TEST(Layers, AreLostBetweenSamplesByPointsAndBySegments) {
    LACUNA_NEEDS_DEVICE();
    const Volume volume =
        sampled<std::uint16_t>(centred({33, 33, 33}), [](const glm::dvec3& mm) { return mm.y == 0 ? 10000 : 0; });
    Scene scene = scene_of(volume, ViewMode::ea, 64);
    scene.camera.fov_deg = 40;  // samples meet the layer at every phase
    scene.camera.zoom = 2.5;    // and every ray crosses it
    scene.classification.tf.points = {{5000, glm::dvec3(1), 0}, {10000, glm::dvec3(1), 0.9}};  // a voxel thick
    const auto faintest = [&](double step, Integration integration) {
        Plan plan = brute_force(step);
        plan.integration = integration;
        float least = 1;
        for (const glm::vec4& c : on_device(scene, plan).color) least = std::min(least, c.a);
        return least;
    };
    for (const Integration integration : {Integration::riemann, Integration::preintegrated}) {
        EXPECT_LT(faintest(2, integration), 0.01) << name_of(integration) << ": the failure";
        EXPECT_GT(faintest(0.5, integration), 0.1) << name_of(integration);
    }
}

double middle_opacity(const Frame& frame) { return double(frame.color[frame.pixels() / 2].a); }

/// A slab of one value, `voxels` thick, seen square on; the transfer function's unit is a share of a voxel.
Scene slab(double voxel_mm, double unit_voxels) {
    const Volume volume = sampled<std::uint8_t>(centred({8, 16, 8}, glm::dvec3(voxel_mm)), [](auto) { return 100; });
    Scene scene = scene_of(volume, ViewMode::ea, 9);
    scene.classification.tf = constant_tf(0.1);
    scene.classification.tf.unit_distance_mm = unit_voxels * voxel_mm;
    return scene;
}

TEST(OpacityOfAStep, IsThatOfItsLengthWhateverTheStep) {
    LACUNA_NEEDS_DEVICE();
    const double truth = 1 - std::pow(0.9, 16.0);
    for (const double step : {1.0, 0.5, 0.25, 0.125}) {
        EXPECT_NEAR(middle_opacity(on_device(slab(1, 1), brute_force(step))), truth, 5e-4) << step;
        // Left uncorrected, that is with the unit as long as the step, each halving squares what is let through.
        const double uncorrected = middle_opacity(on_device(slab(1, step), brute_force(step)));
        EXPECT_NEAR(uncorrected, 1 - std::pow(0.9, 16.0 / step), 5e-4) << step;
    }
    EXPECT_GT(1 - std::pow(0.9, 32.0) - truth, 0.1) << "the failure is large";
}

TEST(OpacityOfAStep, HoldsForVoxelsScaledByAMillion) {
    LACUNA_NEEDS_DEVICE();
    for (const Structure structure : casting_structures()) {
        const Frame plain = on_device(slab(1, 1), with_structure(structure));
        for (const double scale : {1e-6, 1e6}) {
            const Frame scaled = on_device(slab(scale, 1), with_structure(structure));
            EXPECT_LE(worst_levels(scaled, plain), 0.5) << name_of(structure) << " voxels of " << scale << " mm";
            EXPECT_NEAR(double(scaled.depth_mm[40]) / scale, double(plain.depth_mm[40]), 1e-3) << name_of(structure);
        }
        // With the unit left at 1 mm the slab is a film or a wall, and never NaN.
        EXPECT_LE(middle_opacity(on_device(slab(1e-6, 1e6), with_structure(structure))), 1e-4) << name_of(structure);
        EXPECT_NEAR(middle_opacity(on_device(slab(1e6, 1e-6), with_structure(structure))), 1, 1e-6)
            << name_of(structure);
    }
}

}  // namespace
}  // namespace lacuna
