// Homogeneous regions shown, hidden, alone, or by their own transfer functions: kernels against the reference renderer,
// and every structure against none.
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "core/render/reference_renderer.h"
#include "core/render/region_view.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

Plan plan_for(Structure structure, int cells = 8) {
    Plan plan;
    plan.structure = structure;
    plan.ert = 0;
    plan.cells = cells;
    plan.leap.min_voxels = 8;
    return plan;
}

RegionClasses classes_of(const Volume& volume, RegionView view, std::int64_t min_voxels = 30) {
    RegionViewOptions options;
    options.view = view;
    options.regions.range_width = 0.2;
    options.regions.min_voxels = min_voxels;
    return make_region_classes(volume, options);
}

struct Case {
    std::string name;
    Scene scene;
    std::vector<int> lanes{16};
};

std::vector<Case> make_cases() {
    std::vector<Case> cases;
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (const ViewMode mode :
             {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip, ViewMode::mean})
            for (const RegionView view : {RegionView::hide, RegionView::only}) {
                const bool principal = mode == ViewMode::iso || mode == ViewMode::ea, all = v.name == "odd_u8";
                // Every variant of a kernel takes a second to compile: all modes on one voxel type.
                if (!all && (!principal || v.volume.type() == VoxelType::i8 || v.volume.type() == VoxelType::i16))
                    continue;
                Case c{v.name + "_" + std::string(name_of(mode)) + "_" + std::string(name_of(view)),
                       test::small_scene(v.volume, mode)};
                c.scene.regions = classes_of(v.volume, view);
                c.scene.lmip_threshold = c.scene.window.lo + 0.1 * c.scene.window.width();
                if (mode == ViewMode::iso) c.scene.iso = c.scene.window.lo + 0.2 * c.scene.window.width();
                if (all && principal) c.lanes = {16, 1};
                cases.push_back(c);
                if (!all) continue;
                const glm::dvec3 centre = v.volume.geometry().centre_mm(), normal(0.3, 1, -0.2);
                for (const bool cap : {true, false}) {
                    cases.push_back(c);
                    cases.back().name += cap ? "_cut" : "_open";
                    cases.back().lanes = {16};
                    cases.back().scene.cuts = {{normal, -glm::dot(normal, centre), cap}};
                }
            }
    return cases;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class RegionViews : public testing::TestWithParam<Case> {
protected:
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

TEST_P(RegionViews, EqualTheReferenceRenderer) {
    const Case& c = GetParam();
    const Frame truth = render_reference(c.scene, plan_for(Structure::none));
    for (const int lanes : c.lanes) {
        const Frame frame = test::renderer(lanes).render(c.scene, plan_for(Structure::none), {}, false).frame;
        const ImageError error = compare(frame, truth, {0, 0, 0});
        // A region's border is a step: single precision puts a few samples on its other side.
        EXPECT_LE(test::share_over(frame, truth, 2.0), 0.01) << "lanes " << lanes << " max " << error.max;
        EXPECT_LE(error.mean, 0.3) << "lanes " << lanes << " max " << error.max;
    }
}

TEST_P(RegionViews, AreTheSameByEveryStructure) {
    const Case& c = GetParam();
    const ViewMode mode = c.scene.mode;
    if (!c.name.starts_with("odd_u8") || mode == ViewMode::minip || mode == ViewMode::mean) return;
    const Frame plain = test::renderer(16).render(c.scene, plan_for(Structure::none), {}, false).frame;
    std::vector<Plan> plans = {plan_for(Structure::leap)};
    if (mode == ViewMode::iso || mode == ViewMode::ea)
        plans.insert(plans.end(),
                     {plan_for(Structure::acd), plan_for(Structure::octree), plan_for(Structure::pyramid)});
    if (mode == ViewMode::ea) plans.push_back(plan_for(Structure::pc, 1));
    for (const Plan& plan : plans) {
        const Frame frame = test::renderer(16).render(c.scene, plan, {}, false).frame;
        EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4) << name_of(plan.structure);
        EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << name_of(plan.structure);
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, RegionViews, testing::ValuesIn(make_cases()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& ch : name)
        if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
    return name;
});

/// Left half 50, right half 200, both homogeneous; a noisy layer between.
Volume halves() {
    GridGeometry grid;
    grid.size = {40, 32, 32};
    return make_volume<std::uint8_t>(grid, [](std::span<std::uint8_t> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            const int x = int(i % 40);
            voxels[i] = std::uint8_t(x < 18 ? 50 : x < 22 ? 60 + i * 7919 % 190 : 200);
        }
    });
}

TEST(RegionView, HideAndOnlyShareTheVoxels) {
    const Volume volume = halves();
    const RegionClasses hide = classes_of(volume, RegionView::hide), only = classes_of(volume, RegionView::only);
    ASSERT_TRUE(hide && only);
    EXPECT_FALSE(classes_of(volume, RegionView::show)) << "nothing special: nothing held";
    for (std::size_t i = 0; i < hide.of_voxel->size(); ++i) {
        ASSERT_NE((*hide.of_voxel)[i] == RegionClasses::k_hidden, (*only.of_voxel)[i] == RegionClasses::k_hidden);
        if (i % 40 < 18) {
            ASSERT_EQ((*hide.of_voxel)[i], RegionClasses::k_hidden);
        }
    }
}

TEST(RegionView, ARegionIsDrawnByItsOwnFunction) {
    LACUNA_NEEDS_DEVICE();
    const Volume volume = halves();
    Scene scene = test::small_scene(volume, ViewMode::ea, {64, 64});
    scene.camera = {};
    scene.shading = Shading::none;
    scene.classification.tf = {"blue", 1.0, {{0, {0, 0, 1}, 0.3}, {255, {0, 0, 1}, 0.3}}, {}};
    RegionViewOptions options;
    options.regions.range_width = 0.1;
    options.regions.min_voxels = 1000;
    options.functions = {{1, {"red", 1.0, {{0, {1, 0, 0}, 0.5}, {255, {1, 0, 0}, 0.5}}, {}}},
                         {2, {"green", 1.0, {{0, {0, 1, 0}, 0.1}, {255, {0, 1, 0}, 0.1}}, {{0, 1}, {500, 1}}}}};
    scene.regions = make_region_classes(volume, options);
    const Frame truth = render_reference(scene, plan_for(Structure::none));
    const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none), {}, false).frame;
    const Frame leap = test::renderer(16).render(scene, plan_for(Structure::leap), {}, true).frame;
    EXPECT_LE(test::share_over(plain, truth, 2.0), 0.01);
    EXPECT_LE(test::share_over(leap, plain, 1.0), 0);
    EXPECT_GT(leap.counters.skipped, 0u);
    const auto pixel = [&](int x) { return truth.color[std::size_t(32 * 64 + x)]; };
    // Region 1 is the larger one: voxels of the layer between joined it.
    EXPECT_GT(pixel(22).g, 0.9);
    EXPECT_GT(pixel(42).r, 0.9);
    EXPECT_LT(pixel(22).r + pixel(42).g + pixel(22).b + pixel(42).b, 0.02);
}

TEST(RegionView, RefusesWhatItCannotShow) {
    const Volume volume = halves();
    RegionViewOptions options;
    options.regions.range_width = 0.1;
    options.regions.min_voxels = 1000;
    options.functions = {{3, {"red", 1.0, {{0, {1, 0, 0}, 0.5}}, {}}}};
    EXPECT_THROW(make_region_classes(volume, options), Error) << "there are two regions";
    options.functions[0].first = 1;
    Scene scene = test::small_scene(volume, ViewMode::ea);
    scene.regions = make_region_classes(volume, options);
    EXPECT_NO_THROW(check(scene));
    EXPECT_NO_THROW(check(default_plan(scene), scene));
    try {
        check(plan_for(Structure::octree), scene);
        FAIL() << "drew regions by the wrong function";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("none and leap"), std::string::npos);
    }
    scene.mode = ViewMode::mip;
    EXPECT_THROW(check(scene), Error);
    scene.regions = classes_of(volume, RegionView::hide);
    EXPECT_NO_THROW(check(scene));
    scene.mode = ViewMode::shear_warp;
    EXPECT_THROW(check(scene), Error);
    scene.mode = ViewMode::ea;
    scene.regions.of_voxel = std::make_shared<std::vector<std::uint8_t>>(5);
    EXPECT_THROW(check(scene), Error);
}

TEST(RegionView, StopsWhereverItStands) {
    const Volume volume = test::bumpy_ball<std::uint8_t>({96, 96, 96}, {1, 1, 1}, 200);
    for (const double at : {0.0, 0.5, 0.9}) {
        std::stop_source source;
        const JobContext job{source.get_token(), [&](double done) {
                                 if (done >= at) source.request_stop();
                             }};
        RegionViewOptions options;
        options.view = RegionView::hide;
        options.regions.range_width = 0.1;
        EXPECT_THROW(make_region_classes(volume, options, job), Error) << at;
    }
}

}  // namespace
}  // namespace lacuna
