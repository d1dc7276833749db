// Kernels that sample from blocks (kernels/include/block.clh) against those that read the volume: the same pictures, to
// 2e-4 levels of 255.
#include <gtest/gtest.h>

#include "tests/support/device_renderer.h"
#include "tests/support/random_scenes.h"

namespace lacuna {
namespace {

OpenClRenderer& with_blocks() { return test::renderer(16); }
OpenClRenderer& without_blocks() {
    static OpenClRenderer plain(test::device(), 16, false);
    return plain;
}

struct Case {
    std::string name;
    Scene scene;
    Plan plan;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Plan plan_of(Structure structure) {
    Plan plan;
    plan.structure = structure;
    return plan;
}

/// The scene from everywhere and cut: near, far, from inside the volume through a wide lens, cut and ranged.
void add_views(const Case& plain, std::vector<Case>& cases) {
    cases.push_back(plain);
    const GridGeometry& grid = plain.scene.volume.geometry();
    Case inside = plain;
    inside.name += "_inside";
    inside.scene.camera.fov_deg = 120;
    inside.scene.camera.zoom = 6;
    cases.push_back(inside);
    Case small = plain;
    small.name += "_small";
    small.scene.camera.zoom = 0.2;
    cases.push_back(small);
    Case close = plain;
    close.name += "_close";
    close.scene.camera.zoom = 9;
    cases.push_back(close);
    for (const double azimuth : {0.0, 90.0, 225.0}) {
        Case turned = plain;
        turned.name += "_" + std::to_string(int(azimuth));
        turned.scene.camera.azimuth_deg = azimuth;
        turned.scene.camera.elevation_deg = azimuth > 180 ? -60 : 0;
        cases.push_back(turned);
    }
    for (const bool cap : {true, false}) {
        Case cut = plain;
        cut.name += cap ? "_cut" : "_open";
        const glm::dvec3 normal(0.3, 1, -0.2);
        cut.scene.cuts = {{normal, -glm::dot(normal, grid.centre_mm()), cap},
                          {{-1, 0.1, 0}, grid.centre_mm().x + 4, false}};
        cases.push_back(cut);
    }
}

void add_ranges(const Case& plain, std::vector<Case>& cases) {
    Case ranged = plain;
    ranged.name += "_ranges";
    const double lo = plain.scene.window.lo, w = plain.scene.window.width();
    const TransferFunction own{"own", 1.0, {{lo, {1, 0, 0}, 0.3}, {lo + w, {0, 1, 0}, 0.6}}, {}};
    ranged.scene.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}},
                                          {"b", {lo + 0.6 * w, lo + 0.9 * w}, own}};
    cases.push_back(ranged);
}

std::vector<Case> make_cases() {
    std::vector<Case> cases;
    for (const test::NamedVolume& v : test::ugly_volumes()) {
        if (v.volume.type() == VoxelType::f32) continue;
        const bool thorough = v.volume.type() == VoxelType::u16;
        for (const ViewMode mode : {ViewMode::ea, ViewMode::mip, ViewMode::minip}) {
            const Structure usual = mode == ViewMode::ea ? Structure::acd : Structure::macrocells;
            const Case plain{v.name + "_" + std::string(name_of(mode)), test::small_scene(v.volume, mode, {77, 50}),
                             plan_of(usual)};
            add_views(plain, cases);
            if (v.volume.type() != VoxelType::i8) add_ranges(plain, cases);
            if (!thorough || v.name == "one_voxel") continue;
            Case all = plain;
            all.name += "_none";
            all.plan.structure = Structure::none;
            cases.push_back(all);
        }
        if (!thorough) continue;
        Case c{v.name + "_ea", test::small_scene(v.volume, ViewMode::ea, {77, 50}), plan_of(Structure::acd)};
        c.plan.ert = 0;
        for (const Structure structure :
             {Structure::macrocells, Structure::octree, Structure::pyramid, Structure::eacd}) {
            Case other = c;
            other.name += "_" + std::string(name_of(structure));
            other.plan.structure = structure;
            cases.push_back(other);
        }
        Case flat = c;
        flat.name += "_unshaded";
        flat.scene.shading = Shading::none;
        cases.push_back(flat);
        Case faded = c;
        faded.name += "_gradient_opacity";
        faded.scene.classification.tf.gradient_opacity = {{0, 0.1}, {4000, 1.0}};
        cases.push_back(faded);
    }
    return cases;
}

class Blocks : public testing::TestWithParam<Case> {
protected:
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

/// The arithmetic is the same but in the outer half of a border voxel: there one kernel interpolates between the last
/// two layers, all the weight on the last, the other between two copies of the last, which rounds once less.
void expect_same_picture(const Scene& scene, const Plan& plan) {
    const Frame plain = without_blocks().render(scene, plan, {}, false).frame;
    const Frame frame = with_blocks().render(scene, plan, {}, false).frame;
    ASSERT_EQ(frame.size, plain.size);
    EXPECT_EQ(test::share_over(frame, plain, 2e-4), 0) << "levels of 255";
    int elsewhere = 0;  // of two samples alike to rounding either may be the best
    for (std::size_t i = 0; i < plain.pixels(); ++i) elsewhere += frame.depth_mm[i] != plain.depth_mm[i];
    EXPECT_LE(elsewhere, 1) << "depths differ";
}

TEST_P(Blocks, GiveTheSamePicture) { expect_same_picture(GetParam().scene, GetParam().plan); }

INSTANTIATE_TEST_SUITE_P(Kernels, Blocks, testing::ValuesIn(make_cases()),
                         [](const auto& row) { return row.param.name; });

TEST(BlocksOf, RandomScenesGiveTheSamePicture) {
    LACUNA_NEEDS_DEVICE();
    test::Random random(7);
    for (int i = 0; i < 60; ++i) {
        Scene scene = test::random_scene(random);
        if (scene.mode != ViewMode::ea) scene.mode = i % 2 ? ViewMode::mip : ViewMode::minip;
        SCOPED_TRACE(i);
        expect_same_picture(scene, default_plan(scene));
    }
}

/// One group through a lens so wide that some of its rays run across its axis, forwards, backwards and hardly at all.
TEST(BlocksOf, RaysAcrossTheAxisOfTheirGroupGiveTheSamePicture) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({40, 40, 40}, {1, 1, 1}, 1000);
    for (const ViewMode mode : {ViewMode::ea, ViewMode::mip})
        for (int i = 0; i < 40; ++i) {
            Scene scene = test::small_scene(ball, mode, {16, 16});
            scene.camera.fov_deg = 150;
            scene.camera.zoom = 8;
            scene.camera.azimuth_deg = i < 20 ? 40 + i : 49.9 + 0.01 * (i - 20);
            scene.camera.elevation_deg = 7;
            SCOPED_TRACE(i);
            expect_same_picture(scene, plan_of(mode == ViewMode::ea ? Structure::acd : Structure::macrocells));
        }
}

/// Steps so long that a packet's rays may have no sample in a slab between two in which they have some.
TEST(BlocksOf, SlabsWithoutASampleAreNone) {
    LACUNA_NEEDS_DEVICE();
    const Volume head = make_sample("head", {.dims = {37, 52, 41}}).volume;
    for (const double step : {10.0, 17.0, 40.0})
        for (int i = 0; i < 24; ++i) {
            Scene scene = test::small_scene(head, i % 2 ? ViewMode::ea : ViewMode::mip, {33, 31});
            scene.camera.azimuth_deg = -133.31 + 31 * i;
            scene.camera.elevation_deg = 63.6 - 7 * i;
            scene.camera.zoom = 0.2;
            scene.camera.fov_deg = 60;
            scene.cuts = {{{0, -0.42, -0.18}, -0.1, false}};
            Plan plan = plan_of(Structure::none);
            plan.step = step;
            SCOPED_TRACE(i);
            expect_same_picture(scene, plan);
        }
}

TEST(BlocksOf, SamplesAreCopiedOnceForManyRays) {
    LACUNA_NEEDS_DEVICE();
    const Volume head = make_sample("head", {.size = 64}).volume;
    for (const ViewMode mode : {ViewMode::ea, ViewMode::mip}) {
        const Scene scene = test::small_scene(head, mode, {128, 128});
        const Plan plan = default_plan(scene);
        const Counters work = with_blocks().render(scene, plan, {}, true).frame.counters;
        EXPECT_GT(work.copied, 0u);
        EXPECT_LT(work.copied, 2 * work.samples);  // eight voxels a sample otherwise
        const Counters plain = without_blocks().render(scene, plan, {}, true).frame.counters;
        EXPECT_EQ(plain.copied, 0u);
        EXPECT_EQ(work.rays, plain.rays);
        EXPECT_EQ(work.samples + work.skipped, plain.samples + plain.skipped);
        if (mode == ViewMode::ea) {
            // Other samples of neighbouring rays are asked about together.
            EXPECT_NEAR(double(work.samples), double(plain.samples), 0.02 * double(plain.samples));
        }
    }
    // Each cell at least once where every one is sampled.
    const Scene whole = test::small_scene(head, ViewMode::mip, {128, 128});
    const Counters work = with_blocks().render(whole, plan_of(Structure::none), {}, true).frame.counters;
    EXPECT_GE(work.copied, 63u * 63u * 63u);
}

TEST(BlocksOf, WhatTheyDoNotServeIsDrawnWithoutThem) {
    LACUNA_NEEDS_DEVICE();
    const auto copied = [](const Scene& scene, const Plan& plan) {
        return with_blocks().render(scene, plan, {}, true).frame.counters.copied;
    };
    const Volume thin = test::bumpy_ball<std::uint16_t>({7, 40, 40}, {1, 1, 1}, 1000);  // rows shorter than one load
    EXPECT_EQ(copied(test::small_scene(thin, ViewMode::mip), plan_of(Structure::macrocells)), 0u);
    const Volume ball = test::bumpy_ball<std::uint16_t>({40, 40, 40}, {1, 1, 1}, 1000);
    EXPECT_EQ(copied(test::small_scene(ball, ViewMode::mean), plan_of(Structure::none)), 0u);
    Plan nearest = plan_of(Structure::acd);
    nearest.sampler = Sampler::nearest;
    EXPECT_EQ(copied(test::small_scene(ball, ViewMode::ea), nearest), 0u);
}

}  // namespace
}  // namespace lacuna
