// The catalogue of failures: every entry has its test and its line in docs/limits.md, and is found where it is met.
#include "core/accuracy/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/accuracy/planner.h"
#include "core/classify/opacity_peaks.h"
#include "tests/stability/failure_scenes.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;
namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Every run of blanks and line breaks as one blank.
std::string in_one_line(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\n';
        if (!blank || (!line.empty() && line.back() != ' ')) line += blank ? ' ' : c;
    }
    return line;
}

/// Suite.Case of every test in the sources.
std::set<std::string> all_tests() {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(LACUNA_SOURCE_DIR) / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = in_one_line(text_of(entry.path()));
        for (const std::string start : {"TEST(", "TEST_P(", "TEST_F("})
            for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
                const std::size_t from = at + start.size(), comma = text.find(", ", from), end = text.find(')', from);
                if (comma < end)
                    names.insert(text.substr(from, comma - from) + "." + text.substr(comma + 2, end - comma - 2));
            }
    }
    return names;
}

TEST(Limits, EveryEntryHasATestThatExists) {
    const std::set<std::string> tests = all_tests();
    ASSERT_GT(tests.size(), 300u);
    std::set<std::string_view> names;
    for (const Limit& limit : limits()) {
        EXPECT_TRUE(tests.contains(std::string(limit.test))) << limit.name << " is shown by " << limit.test;
        EXPECT_TRUE(names.insert(limit.name).second) << limit.name << " is there twice";
        for (const std::string_view text : {limit.fails, limit.guarded, limit.bound}) {
            ASSERT_FALSE(text.empty()) << limit.name;
            EXPECT_EQ(text.back(), '.') << limit.name;
        }
        EXPECT_TRUE(!limit.met || limit.concerns) << limit.name;
    }
}

TEST(Limits, TheDocumentHasEveryEntryAndNoOther) {
    const std::string text = text_of(fs::path(LACUNA_SOURCE_DIR) / "docs" / "limits.md"), line = in_one_line(text);
    std::size_t last = 0;
    for (const Limit& limit : limits()) {
        const std::size_t at = line.find(to_markdown(limit));
        EXPECT_NE(at, std::string::npos) << "docs/limits.md lacks, or has otherwise:\n" << to_markdown(limit);
        EXPECT_GE(at, last) << limit.name << " stands before its place";
        last = std::max(last, at == std::string::npos ? last : at);
        EXPECT_NE(text.find("## " + std::string(title_of(limit.topic))), std::string::npos) << title_of(limit.topic);
    }
    std::size_t entries = 0;
    for (std::size_t at = text.find("- **"); at != std::string::npos; at = text.find("- **", at + 1)) ++entries;
    EXPECT_EQ(entries, limits().size());
}

TEST(Limits, EveryModeAndMethodHasSome) {
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip,
                                ViewMode::mean, ViewMode::shear_warp}) {
        const Scene scene = small_scene(bumpy_ball<std::uint16_t>({9, 9, 9}, {1, 1, 1}, 1000), mode);
        EXPECT_GE(limits_of(scene, default_plan(scene)).size(), 6u) << name_of(mode);
    }
    const Scene scene = small_scene(bumpy_ball<std::uint16_t>({9, 9, 9}, {1, 1, 1}, 1000), ViewMode::ea);
    Plan plan = default_plan(scene);
    const std::size_t usual = limits_of(scene, plan).size();
    plan.sparse = 4;
    EXPECT_GT(limits_of(scene, plan).size(), usual);
}

/// The entry of that name, where it is met.
std::optional<MetLimit> met(std::string_view name, const Scene& scene, const Plan& plan) {
    for (const MetLimit& m : limits_met(measure_facts(scene), scene, plan))
        if (m.limit->name == name) return m;
    return std::nullopt;
}

Scene wall(double thickness) {
    Scene scene = scene_of(
        sampled<std::uint16_t>(centred({21, 17, 21}), [](const glm::dvec3& mm) { return mm.y == 0 ? 10000 : 0; }),
        ViewMode::iso);
    scene.iso = 10000 * (1 - 0.5 * thickness);
    return scene;
}

TEST(LimitsMet, WallsAreMeasuredByTheirThickness) {
    for (const double thickness : {0.2, 0.4, 0.9, 1.8}) {
        const Scene scene = wall(thickness);
        const SceneFacts facts = measure_facts(scene);
        EXPECT_EQ(facts.shown, 21 * 21);
        EXPECT_EQ(facts.walls.places, 21 * 21);
        EXPECT_EQ(facts.wires, 0);
        for (const double step : {0.5, 1.0, 2.0}) {
            EXPECT_NEAR(facts.walls.missed(step), std::max(0.0, 1 - thickness / step), 0.07)
                << thickness << " step " << step;
            EXPECT_EQ(met("Walls between two samples", scene, brute_force(step)).has_value(), thickness < step)
                << thickness << " step " << step;
        }
        Scene layer = scene;  // the same wall, by opacity
        layer.mode = ViewMode::ea;
        layer.classification.tf.points = {{scene.iso, glm::dvec3(1), 0}, {10000, glm::dvec3(1), 0.5}};
        EXPECT_EQ(met("Layers between two samples of like value", layer, brute_force(0.5)).has_value(),
                  thickness < 0.5);
        Plan solved = brute_force(2);
        solved.refine = Refinement::cubic;
        EXPECT_FALSE(met("Walls between two samples", scene, solved));
    }
}

TEST(LimitsMet, FactsOfUglyVolumesAreSound) {
    for (const NamedVolume& v : ugly_volumes())
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::minip}) {
            SCOPED_TRACE(v.name + " " + std::string(name_of(mode)));
            const Scene scene = small_scene(v.volume, mode);
            const SceneFacts facts = measure_facts(scene);
            EXPECT_EQ(facts.voxels, v.volume.geometry().voxel_count());
            EXPECT_EQ(facts.not_finite > 0, v.name == "nan_f32");
            EXPECT_EQ(facts.constant(), v.name == "flat_u8" || v.name == "one_voxel");
            EXPECT_LE(facts.range.lo, facts.range.hi);
            for (const MetLimit& m : limits_met(facts, scene, default_plan(scene))) {
                EXPECT_TRUE(m.extent > 0 && m.extent <= 1) << m.limit->name;
                EXPECT_EQ(m.how.back(), '.') << m.how;
            }
            EXPECT_EQ(met("Voxels that are no numbers", scene, default_plan(scene)).has_value(), v.name == "nan_f32");
        }
}

TEST(LimitsMet, PeaksByTheirHalfWidthAgainstWhatAStepChanges) {
    Classification classes;
    classes.tf.points = {
        {100, glm::dvec3(1), 0}, {110, glm::dvec3(1), 0.8}, {130, glm::dvec3(1), 0}, {200, glm::dvec3(1), 0.1}};
    ASSERT_EQ(opacity_peaks(classes).size(), 1u) << "the rise at the end has no other side";
    EXPECT_NEAR(*narrowest_peak(classes), 15, 1e-9);
    classes.ranges = {{"r", {50, 104}, {}}};
    EXPECT_NEAR(*narrowest_peak(classes), 15, 1e-9) << "its middle is transparent";
    classes.ranges = {{"r", {108, 112}, {}}};
    EXPECT_NEAR(*narrowest_peak(classes), 4, 1e-9);

    // Values change by 100 a voxel: a peak 30 wide makes a shell 0.3 voxels thick.
    Scene scene =
        scene_of(sampled<std::uint16_t>(centred({8, 40, 8}),
                                        [](const glm::dvec3& mm) { return std::lround(100 * (mm.y + 19.5)); }),
                 ViewMode::ea);
    scene.classification.tf.points = {{2020, glm::dvec3(1), 0}, {2050, glm::dvec3(1), 0.9}, {2080, glm::dvec3(1), 0}};
    EXPECT_FALSE(met("Peaks between two samples", scene, brute_force(0.25)));
    const auto found = met("Peaks between two samples", scene, brute_force(0.5));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->extent, 0.4, 0.1);
    Plan plan = with_structure(Structure::octree);
    plan.homogeneity = 10;
    EXPECT_FALSE(met("A peak inside a homogeneous node", scene, plan));
    plan.homogeneity = 500;
    EXPECT_TRUE(met("A peak inside a homogeneous node", scene, plan));
}

TEST(LimitsMet, SpotsWiresViewsAndChoices) {
    Scene spots = scene_of(sampled<std::uint8_t>(centred({9, 9, 9}),
                                                 [](const glm::dvec3& mm) { return glm::length(mm) < 0.1 ? 220 : 20; }),
                           ViewMode::mip, 9);
    spots.window = {0, 255};
    EXPECT_NEAR(met("One-voxel spots", spots, brute_force(0.5))->extent, 0.25 * 200 / 255, 1e-6) << "along an axis";
    EXPECT_FALSE(met("One-voxel spots", spots, brute_force(0.001)));
    spots.mode = ViewMode::minip;
    EXPECT_FALSE(met("One-voxel spots", spots, brute_force(0.5))) << "it is bright";

    Scene wire = scene_of(sampled<std::uint8_t>(centred({33, 9, 33}),
                                                [](const glm::dvec3& mm) { return mm.y == 0 && mm.z == 0 ? 255 : 0; }),
                          ViewMode::iso, 96);
    wire.iso = 60;
    Plan sparse = brute_force();
    sparse.sparse = 16;
    EXPECT_TRUE(met("Wires between cast pixels", wire, sparse));
    sparse.sparse_aware = true;
    EXPECT_FALSE(met("Wires between cast pixels", wire, sparse));
    sparse.sparse_aware = false;
    wire.camera.zoom = 60;  // a voxel spans more than 16 pixels
    EXPECT_FALSE(met("Wires between cast pixels", wire, sparse));

    Scene warp = wire;
    warp.mode = ViewMode::shear_warp;
    for (const auto& [azimuth, pops] : {std::pair(45.0, true), {44.95, true}, {40.0, false}, {0.0, false}}) {
        warp.camera.azimuth_deg = azimuth;
        EXPECT_EQ(met("Popping", warp, default_plan(warp)).has_value(), pops) << azimuth;
    }
    Plan dark = brute_force();
    wire.mode = ViewMode::ea;
    for (const auto& [ert, hides] : {std::pair(0.002, false), {0.05, true}}) {
        dark.ert = ert;
        EXPECT_EQ(met("Early termination before a bright core", wire, dark).has_value(), hides) << ert;
    }
}

TEST(LimitsMet, ThePlannerRefusesWhatFailsOnTheScene) {
    LACUNA_NEEDS_DEVICE();
    static Engine engine(device());
    Scene scene = wall(0.6);
    scene.size = {80, 80};
    scene.camera.azimuth_deg = 20;
    scene.shading = Shading::lambert;
    const PlannedPlan planned = choose_plan(engine, scene, {.error = 4.0});
    const auto refused = [&](const std::string& words) {
        return std::any_of(planned.plan.why.begin(), planned.plan.why.end(), [&](const std::string& why) {
            return why.starts_with("Refused ") && why.find(words) != std::string::npos;
        });
    };
    EXPECT_TRUE(refused("it fails on this scene (Walls between two samples)")) << "a step of a voxel and more";
    EXPECT_LT(planned.plan.step, 0.8);
    // A ball has no such walls, and nobody says so.
    Scene plain = small_scene(bumpy_ball<std::uint16_t>({24, 25, 26}, {1, 1, 1}, 60000), ViewMode::iso, {48, 48});
    for (const std::string& why : choose_plan(engine, plain, {.error = 4.0}).plan.why)
        EXPECT_EQ(why.find("it fails on this scene"), std::string::npos) << why;
}

}  // namespace
}  // namespace lacuna
