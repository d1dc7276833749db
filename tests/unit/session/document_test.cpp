#include "core/session/document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/volume/samples.h"

namespace lacuna {
namespace {

Volume ramp(glm::ivec3 size, glm::dvec3 spacing = glm::dvec3(1)) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return make_volume<std::int16_t>(geometry, [](std::span<std::int16_t> v) {
        for (std::size_t i = 0; i < v.size(); ++i) v[i] = std::int16_t(i);
    });
}

TEST(Document, AnEmptyVolumeIsRefused) { EXPECT_THROW(make_document("x", Volume()), Error); }

TEST(Document, OddVolumesOpen) {
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), glm::ivec3(1, 1, 7), glm::ivec3(5, 3, 1)}) {
        const Document document = make_document("odd", ramp(size, {1, 1, 5}));
        EXPECT_GT(document.settings.window.width(), 0);
        const Scene scene = scene_of(document);
        EXPECT_NO_THROW(check(scene));
        EXPECT_NO_THROW(check(plan_of(document, scene), scene));
    }
}

TEST(Document, NanVolumesOpen) {
    GridGeometry geometry;
    geometry.size = {3, 3, 3};
    const Volume volume = make_volume<float>(
        geometry, [](std::span<float> v) { std::fill(v.begin(), v.end(), std::numeric_limits<float>::quiet_NaN()); });
    const Document document = make_document("nan", volume);
    EXPECT_TRUE(std::isfinite(document.settings.window.lo) && std::isfinite(document.settings.window.hi));
    EXPECT_GT(document.settings.window.width(), 0);
}

TEST(Document, SwitchedOffRangesAndCutsLeaveTheScene) {
    Document document = make_document("ramp", ramp({8, 8, 8}));
    document.settings.ranges = {{{"a", {1, 2}, {}}, true}, {{"b", {3, 4}, {}}, false}};
    document.settings.cuts = {{CuttingPlane{}, false}, {CuttingPlane{{0, 1, 0}, 2, false}, true}};
    const Scene scene = scene_of(document);
    ASSERT_EQ(scene.classification.ranges.size(), 1u);
    EXPECT_EQ(scene.classification.ranges[0].name, "a");
    ASSERT_EQ(scene.cuts.size(), 1u);
    EXPECT_EQ(scene.cuts[0].offset, 2);
}

TEST(Document, ShearWarpDropsPerspective) {
    Document document = make_document("ramp", ramp({8, 8, 8}));
    document.camera.fov_deg = 30;
    document.settings.mode = ViewMode::shear_warp;
    EXPECT_FALSE(scene_of(document).camera.fov_deg.has_value());
    document.settings.mode = ViewMode::iso;
    EXPECT_TRUE(scene_of(document).camera.fov_deg.has_value());
}

TEST(Document, TheCameraStartsOnTheObject) {
    GridGeometry geometry;
    geometry.size = {40, 30, 20};
    geometry.spacing = {1, 1, 5};
    const auto block = [&](glm::ivec3 first, glm::ivec3 last) {
        return make_volume<std::uint8_t>(geometry, [&](std::span<std::uint8_t> v) {
            std::fill(v.begin(), v.end(), std::uint8_t(0));
            for (int z = first.z; z <= last.z; ++z)
                for (int y = first.y; y <= last.y; ++y)
                    for (int x = first.x; x <= last.x; ++x) v[std::size_t(geometry.linear_index(x, y, z))] = 200;
        });
    };
    const Document small = make_document("small", block({4, 10, 6}, {9, 19, 7}));
    ASSERT_TRUE(small.home.center_mm.has_value());
    EXPECT_NEAR(glm::length(*small.home.center_mm - glm::dvec3(6.5, 14.5, 32.5)), 0, 1e-9);
    EXPECT_NEAR(small.home.zoom, geometry.diameter_mm() / glm::length(glm::dvec3(6, 10, 10)), 1e-9);
    EXPECT_EQ(small.camera, small.home);
    const Document flat = make_document("flat", block({0, 0, 0}, {39, 29, 19}));
    EXPECT_EQ(flat.home, Camera());
}

TEST(Document, TheDicomWindowIsTaken) {
    Volume volume = ramp({4, 4, 4});
    volume.unit = "HU";
    VolumeStatistics statistics = compute_statistics(volume);
    EXPECT_EQ(default_window(volume, statistics), (ValueRange{-160, 240}));
    volume.dicom.emplace();
    volume.dicom->window_center = 10;
    volume.dicom->window_width = 20;
    EXPECT_EQ(default_window(volume, statistics), (ValueRange{0, 20}));
    volume.dicom->window_width = std::nan("");
    EXPECT_EQ(default_window(volume, statistics), (ValueRange{-160, 240}));
}

TEST(Document, AHighlightHoldsItsRegionOnly) {
    RegionTable table;
    table.labels.geometry.size = {4, 3, 2};
    table.labels.labels = std::make_shared<std::vector<std::uint32_t>>(24, 0u);
    auto& labels = *table.labels.labels;
    labels[std::size_t(table.labels.geometry.linear_index(1, 1, 0))] = 2;
    labels[std::size_t(table.labels.geometry.linear_index(2, 2, 1))] = 2;
    labels[std::size_t(table.labels.geometry.linear_index(2, 1, 1))] = 1;
    RegionCharacteristics region;
    region.id = 2;
    region.bbox_first = {1, 1, 0};
    region.bbox_last = {2, 2, 1};
    const Highlight highlight = highlight_of(table, region);
    EXPECT_EQ(highlight.size, glm::ivec3(2, 2, 2));
    EXPECT_EQ(std::count(highlight.inside->begin(), highlight.inside->end(), 1), 2);
    EXPECT_EQ((*highlight.inside)[0], 1);
    EXPECT_EQ((*highlight.inside)[7], 1);
}

TEST(Document, TheNearestVoxelStaysInside) {
    GridGeometry geometry;
    geometry.size = {10, 10, 10};
    geometry.spacing = {1, 1, 5};
    EXPECT_EQ(nearest_voxel(geometry, {-100, 4.4, 1e9}), glm::ivec3(0, 4, 9));
    EXPECT_EQ(nearest_voxel(geometry, {0.5, 0, 12.6}).z, 3);
    EXPECT_EQ(nearest_voxel(geometry, glm::dvec3(std::nan(""))), glm::ivec3(0));
}

TEST(Document, AChosenPlanGoesBeforeBudgetsAndBothOnlyWhereTheyServe) {
    Document document = make_document("sample:spheres@24", make_sample("spheres", {.size = 24}).volume);
    document.settings.mode = ViewMode::ea;
    const auto drawn = [&] { return plan_of(document, scene_of(document)); };
    EXPECT_EQ(drawn().structure, Structure::acd);
    ModePlan answer{ViewMode::ea, drawn()};
    answer.plan.structure = Structure::octree;
    answer.plan.step = 0.75;
    document.planned = std::make_shared<const ModePlan>(answer);
    EXPECT_EQ(drawn().structure, Structure::acd) << "no budget asks for it";
    document.settings.quality.error_budget = 1;
    EXPECT_EQ(drawn().structure, Structure::octree);
    EXPECT_EQ(drawn().step, 0.75);
    answer.plan.structure = Structure::eacd;
    document.settings.quality.plan = to_json(answer);
    EXPECT_EQ(drawn().structure, Structure::eacd);
    document.settings.mode = ViewMode::iso;  // what was chosen is of another mode
    EXPECT_EQ(drawn().structure, default_plan(scene_of(document)).structure);
    EXPECT_EQ(drawn().step, 0.5);
    document.settings.mode = ViewMode::ea;
    document.settings.quality.plan = "no plan";
    EXPECT_EQ(drawn().structure, Structure::acd);
}

}  // namespace
}  // namespace lacuna
