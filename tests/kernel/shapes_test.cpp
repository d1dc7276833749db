// Transfer functions of value and gradient magnitude: the kernel against the reference, and every structure against
// none, which must skip only what no gradient could show.
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "core/classify/part_histogram.h"
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

/// A soft trapezoid on the flank and a sharp rectangle where little changes, placed by the data.
void add_shapes(TransferFunction& tf, const Volume& volume, const VolumeStatistics& statistics) {
    const double steepest = joint_histogram(volume, statistics, {}).magnitudes.hi;
    const double lo = statistics.range.lo, w = std::max(statistics.range.width(), 1.0);
    tf.shapes = {
        {{0.15 * steepest, 1.1 * steepest},
         {lo + 0.11 * w, lo + 0.83 * w},
         {lo + 0.37 * w, lo + 0.61 * w},
         {1.0, 0.4, 0.2},
         0.5,
         0.6},
        {{0, 0.21 * steepest}, {lo + 0.87 * w, lo + 1.1 * w}, {lo + 0.87 * w, lo + 1.1 * w}, {0.3, 0.7, 1}, 0.2, 0}};
}

struct Case {
    std::string name;
    Scene scene;
};

std::vector<Case> make_cases() {
    std::vector<Case> cases;
    for (const test::NamedVolume& v : test::ugly_volumes()) {
        const VolumeStatistics statistics = compute_statistics(v.volume);
        Case c{v.name, test::small_scene(v.volume, ViewMode::ea)};
        add_shapes(c.scene.classification.tf, v.volume, statistics);
        cases.push_back(c);
        if (v.name != "u16_1_1_5") continue;
        Case flat = c;
        flat.name += "_unshaded_cut";
        flat.scene.shading = Shading::none;
        const glm::dvec3 centre = v.volume.geometry().centre_mm(), normal(0.3, 1, -0.2);
        flat.scene.cuts = {{normal, -glm::dot(normal, centre), true}};
        cases.push_back(flat);
        // One function by points, one by shapes, one by points with a curve: each in its own range.
        Case mixed = c;
        mixed.name += "_ranges";
        const double lo = statistics.range.lo, w = statistics.range.width();
        TransferFunction points{"points", 1.0, {{lo, {1, 0, 0}, 0.3}, {lo + w, {0, 1, 0}, 0.6}}};
        TransferFunction curve = points;
        curve.gradient_opacity = {{0, 0.1}, {4000, 1.0}};
        mixed.scene.classification.ranges = {{"points", {lo + 0.2 * w, lo + 0.4 * w}, points},
                                             {"shapes", {lo + 0.45 * w, lo + 0.7 * w}, {}},
                                             {"curve", {lo + 0.8 * w, lo + w}, curve}};
        cases.push_back(mixed);
    }
    return cases;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Shapes : public testing::TestWithParam<Case> {
protected:
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

TEST_P(Shapes, EqualTheReferenceRenderer) {
    const Case& c = GetParam();
    const Frame truth = render_reference(c.scene, brute_force());
    for (const int lanes : c.name == "odd_u8" ? std::vector<int>{16, 1} : std::vector<int>{16}) {
        const Frame frame = test::renderer(lanes).render(c.scene, brute_force(), {}, false).frame;
        const ImageError error = compare(frame, truth, {0, 0, 0});
        EXPECT_LE(test::share_over(frame, truth, 2.0), 0.004) << "lanes " << lanes << " max " << error.max;
        EXPECT_LE(error.mean, 0.15) << "lanes " << lanes << " max " << error.max;
    }
}

TEST_P(Shapes, StructuresChangeNothing) {
    const Case& c = GetParam();
    if (c.name != "odd_u8" && !c.name.starts_with("u16") && c.name != "nan_f32") GTEST_SKIP() << "covered by others";
    const Frame plain = test::renderer(16).render(c.scene, brute_force(), {}, false).frame;
    for (const Structure structure : {Structure::macrocells, Structure::octree, Structure::pyramid, Structure::pc,
                                      Structure::acd, Structure::eacd, Structure::leap}) {
        if (structure == Structure::leap && c.scene.volume.type() == VoxelType::f32) continue;
        Plan plan = brute_force();
        plan.structure = structure;
        const Frame frame = test::renderer(16).render(c.scene, plan, {}, false).frame;
        EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4) << name_of(structure);
        EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << name_of(structure);
    }
    Plan adaptive = brute_force();
    adaptive.sampler = Sampler::adaptive;
    EXPECT_LE(test::share_over(test::renderer(16).render(c.scene, adaptive, {}, false).frame, plain, 1.0), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Shapes, testing::ValuesIn(make_cases()),
                         [](const auto& row) { return row.param.name; });

TEST(ShapesOfValueAndGradient, ShowASurfaceThatNoFunctionOfTheValueAloneCan) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({48, 48, 48}, {1, 1, 1}, 60000);
    const VolumeStatistics statistics = compute_statistics(ball);
    Scene scene = test::small_scene(ball, ViewMode::ea);
    const double steepest = joint_histogram(ball, statistics, {}).magnitudes.hi;
    scene.classification.tf.shapes = {{{0.9 * steepest, 2 * steepest}, {0, 65535}, {0, 65535}, {1, 1, 1}, 1.0, 0}};
    const auto coverage = [&](const Scene& s) {
        double sum = 0;
        for (const glm::vec4& c : test::renderer(16).render(s, brute_force(), {}, false).frame.color) sum += c.a;
        return sum;
    };
    const double steep = coverage(scene);
    scene.classification.tf.shapes[0].magnitude = {1.5 * steepest, 2 * steepest};  // steeper than anything
    EXPECT_EQ(coverage(scene), 0);
    EXPECT_GT(steep, 20);
    scene.classification.tf.by_shapes = false;
    EXPECT_GT(coverage(scene), steep);
}

TEST(ShapesOfValueAndGradient, WhatTakesValuesAloneIsRefused) {
    Scene scene = test::small_scene(test::ugly_volumes()[0].volume, ViewMode::ea);
    add_shapes(scene.classification.tf, scene.volume, compute_statistics(scene.volume));
    Plan plan = brute_force();
    plan.integration = Integration::preintegrated;
    EXPECT_THROW(check(plan, scene), Error);
    scene.classification.tf.by_shapes = false;
    EXPECT_NO_THROW(check(plan, scene));
}

}  // namespace
}  // namespace lacuna
