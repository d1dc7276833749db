// What the hand does to the 3D view: arcball, levels, points picked, modes switched.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/render/reference_renderer.h"
#include "core/session/arcball.h"
#include "core/session/level_drag.h"
#include "core/session/pick.h"

namespace lacuna {
namespace {

Volume ball(glm::ivec3 size, glm::dvec3 spacing) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    geometry.origin = {3, -4, 5};
    return make_volume<std::int16_t>(geometry, [&](std::span<std::int16_t> v) {
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 mm = (glm::dvec3(x, y, z) - 0.5 * glm::dvec3(size - 1)) * spacing;
                    v[i++] = std::int16_t(std::lround(1000 * std::clamp(10 - glm::length(mm), 0.0, 1.0)));
                }
    });
}

ViewRays frame_of(const Camera& camera) {
    GridGeometry unit;
    unit.size = {1, 1, 1};
    return resolve(camera, unit, {2, 2});
}

TEST(Arcball, AnglesOfAnyFrameGiveItBack) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(-180, 180);
    for (int i = 0; i < 300; ++i) {
        Camera camera;
        camera.azimuth_deg = angle(random);
        camera.elevation_deg = i < 8 ? (i % 2 ? 90 : -90) : 0.5 * angle(random);
        camera.roll_deg = angle(random);
        const ViewRays rays = frame_of(camera);
        Camera again;
        set_angles(again, rays.right, rays.forward, i < 4 ? camera.azimuth_deg : 17);
        const ViewRays same = frame_of(again);
        EXPECT_LT(glm::length(same.right - rays.right) + glm::length(same.up - rays.up), 1e-7);
        EXPECT_LE(std::abs(again.elevation_deg), 90);
    }
}

TEST(Arcball, WhatIsTakenHoldOfFollowsTheHandAndComingBackTurnsBack) {
    Camera camera;
    camera.azimuth_deg = 30, camera.elevation_deg = -20, camera.roll_deg = 10, camera.zoom = 2;
    const Arcball ball(camera, {0.1, 0.2});
    const ViewRays before = frame_of(camera);
    const ViewRays same = frame_of(ball.to({0.1, 0.2}));
    EXPECT_LT(glm::length(same.right - before.right) + glm::length(same.up - before.up), 1e-9);
    EXPECT_EQ(ball.to({0.4, -0.3}).zoom, 2);
    // Drawn from the middle to the right, the front of the volume turns to the right: the eye goes to the left of it.
    const Camera right = Arcball(Camera(), {0, 0}).to({0.2, 0});
    EXPECT_NEAR(right.azimuth_deg, -2 * glm::degrees(std::asin(0.2)), 1e-9);
    EXPECT_NEAR(right.elevation_deg, 0, 1e-9);
    const Camera up = Arcball(Camera(), {0, 0}).to({0, 0.2});
    EXPECT_NEAR(up.elevation_deg, -2 * glm::degrees(std::asin(0.2)), 1e-9);
    // Around the rim it rolls: a quarter of the rim is half a turn of the picture, anticlockwise as the hand went.
    const Camera rolled = Arcball(Camera(), {1.5, 0}).to({0, 1.5});
    EXPECT_LT(glm::length(frame_of(rolled).forward - frame_of(Camera()).forward), 1e-9);
    EXPECT_NEAR(std::abs(rolled.roll_deg), 180, 1e-9);
}

TEST(Levels, DraggingShiftsAndWidensWhatTheModeUses) {
    Document document = make_document("ball", ball({24, 24, 24}, glm::dvec3(1)));
    const ValueRange values = document.statistics->range;
    ViewSettings& settings = document.settings;
    settings.mode = ViewMode::ea;
    const ViewSettings ea = with_levels(settings, values, 0.1, std::log(2.0));
    ASSERT_EQ(ea.tf.points.size(), settings.tf.points.size());
    const auto span = [](const TransferFunction& f) { return f.points.back().value - f.points.front().value; };
    const auto middle = [](const TransferFunction& f) {
        return 0.5 * (f.points.back().value + f.points.front().value);
    };
    EXPECT_NEAR(span(ea.tf), 2 * span(settings.tf), 1e-6);
    EXPECT_NEAR(middle(ea.tf), middle(settings.tf) + 0.1 * span(settings.tf), 1e-6);
    for (std::size_t i = 0; i < ea.tf.points.size(); ++i)
        EXPECT_EQ(ea.tf.points[i].opacity, settings.tf.points[i].opacity);
    EXPECT_NO_THROW(check(ea.tf));
    EXPECT_EQ(ea.iso, settings.iso);

    settings.mode = ViewMode::iso;
    const ViewSettings iso = with_levels(settings, values, 0.1, 1);
    EXPECT_NEAR(iso.iso, settings.iso + 0.1 * values.width(), 1e-9);
    EXPECT_EQ(iso.tf, settings.tf);
    EXPECT_EQ(with_levels(settings, values, 100, 0).iso, values.hi);

    settings.mode = ViewMode::mip;
    const ViewSettings mip = with_levels(settings, values, -0.25, std::log(0.5));
    EXPECT_NEAR(mip.projection_window.width(), 0.5 * settings.projection_window.width(), 1e-9);
    EXPECT_EQ(mip.window, settings.window) << "the slices keep theirs";
    settings.color_by_tf = true;
    EXPECT_FALSE(with_levels(settings, values, -0.25, 0).tf == settings.tf);
}

TEST(Levels, NothingLeavesASoundScene) {
    Document document = make_document("ball", ball({9, 9, 9}, glm::dvec3(1)));
    TransferPoint low, jump, high;
    low.value = 10, jump.value = high.value = 200;
    jump.opacity = 0.2, high.opacity = 1;
    for (const std::vector<TransferPoint>& points : {std::vector{low, jump, high}, std::vector{low}}) {
        document.settings.tf.points = points;
        for (const ViewMode mode : {ViewMode::ea, ViewMode::mip, ViewMode::iso})
            for (const double higher : {-1e9, -1.0, 0.0, 1e9, std::nan("")})
                for (const double wider : {-1e9, 0.0, 1e9, std::numeric_limits<double>::infinity()}) {
                    Document moved = document;
                    moved.settings.mode = mode;
                    moved.settings = with_levels(moved.settings, document.statistics->range, higher, wider);
                    EXPECT_NO_THROW(check(scene_of(moved))) << higher << " " << wider;
                }
    }
}

TEST(Pick, ThePointShownIsOnTheSurface) {
    Document document = make_document("ball", ball({31, 31, 17}, {1, 1, 2}));
    const glm::dvec3 centre = document.volume.geometry().centre_mm();
    for (const bool perspective : {false, true})
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip}) {
            document.camera = {};
            document.camera.azimuth_deg = 30;
            document.camera.elevation_deg = 20;
            if (perspective) document.camera.fov_deg = 40;
            document.settings.mode = mode;
            document.settings.iso = 500;
            TransferPoint clear, dense;
            clear.value = 499, dense.value = 501, dense.opacity = 0.999;
            document.settings.tf.points = {clear, dense};
            Scene scene = scene_of(document);
            scene.size = {41, 33};
            const Frame frame = render_reference(scene, plan_of(document, scene));
            const auto middle = point_at(frame, scene, {20.5 / 41, 16.5 / 33});
            ASSERT_TRUE(middle) << name_of(mode);
            // The ball's value falls from 1000 at 9 mm to 0 at 10 mm.
            EXPECT_NEAR(glm::length(*middle - centre), mode == ViewMode::mip ? 8.9 : 9.5, 0.8) << name_of(mode);
            EXPECT_LT(glm::dot(*middle - centre, resolve(scene.camera, scene.volume.geometry(), scene.size).forward), 0)
                << "the near side";
            EXPECT_FALSE(point_at(frame, scene, {0.5 / 41, 0.5 / 33}).has_value() && mode != ViewMode::mip);
            for (const glm::dvec2 outside : {glm::dvec2(-0.01, 0.5), glm::dvec2(0.5, 1), glm::dvec2(std::nan(""), 0)})
                EXPECT_FALSE(point_at(frame, scene, outside));
        }
}

TEST(Pick, AFocusOnAPointMakesItTheSharpPlane) {
    const GridGeometry geometry = ball({31, 31, 17}, {1, 1, 2}).geometry();
    const ViewRays rays = resolve(Camera(), geometry, {64, 64});
    EXPECT_NEAR(focus_at(geometry.centre_mm(), rays, geometry), 0.5, 1e-12);
    EXPECT_NEAR(focus_at(geometry.centre_mm() - 0.25 * geometry.diameter_mm() * rays.forward, rays, geometry), 0.25,
                1e-12);
    EXPECT_EQ(focus_at(geometry.centre_mm() + 1e5 * rays.forward, rays, geometry), 1);
}

TEST(ModeSwitch, EachModeKeepsItsOwn) {
    Document document = make_document("ball", ball({9, 9, 9}, glm::dvec3(1)));
    ViewSettings& settings = document.settings;
    const ViewSettings opened = settings;
    settings.shading = Shading::lambert;
    settings.quality.step = 0.25;
    settings.effects = {{EffectKind::ssao, {1}}};
    const ViewSettings ea = settings;
    switch_mode(settings, ViewMode::mip);
    EXPECT_EQ(settings.mode, ViewMode::mip);
    EXPECT_TRUE(settings.effects.empty());
    EXPECT_EQ(settings.quality, opened.quality);
    settings.projection_window = {1, 2};
    settings.quality.structure = Structure::octree;
    switch_mode(settings, ViewMode::minip);
    EXPECT_EQ(settings.projection_window, opened.projection_window);
    EXPECT_FALSE(settings.quality.structure.has_value());
    switch_mode(settings, ViewMode::mip);
    EXPECT_EQ(settings.projection_window, (ValueRange{1, 2}));
    EXPECT_EQ(settings.quality.structure, Structure::octree);
    ViewSettings back = settings;
    switch_mode(back, ViewMode::ea);
    EXPECT_EQ(back.shading, Shading::lambert);
    EXPECT_EQ(back.quality, ea.quality);
    EXPECT_EQ(back.effects, ea.effects);
    switch_mode(back, ViewMode::ea);
    switch_mode(back, ViewMode::mip);
    EXPECT_EQ(back, settings) << "there and back is nothing";
}

TEST(StructureChoice, IsTakenWhereItServesAndElseExplained) {
    Document document = make_document("ball", ball({9, 9, 9}, glm::dvec3(1)));
    for (const auto& [structure, name] : structure_names()) {
        document.settings.mode = ViewMode::ea;
        document.settings.quality.structure = structure;
        Scene scene = scene_of(document);
        const Plan plan = plan_of(document, scene);
        EXPECT_NO_THROW(check(plan, scene));
        EXPECT_EQ(plan.structure == structure, structure_refusal(structure, scene).empty()) << name;
        EXPECT_EQ(structure_refusal(structure, scene).empty(), structure != Structure::visible) << name;
    }
    document.settings.mode = ViewMode::shear_warp;
    document.settings.quality.structure = Structure::octree;
    const Scene scene = scene_of(document);
    EXPECT_EQ(plan_of(document, scene).structure, Structure::visible);
    EXPECT_NE(structure_refusal(Structure::octree, scene).find("shear-warp"), std::string::npos);
}

}  // namespace
}  // namespace lacuna
