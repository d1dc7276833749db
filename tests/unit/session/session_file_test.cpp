#include "core/session/session_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "core/base/atomic_file.h"
#include "core/session/settings_fields.h"
#include "core/session/settings_json.h"

namespace lacuna {
namespace {

/// Counts the members of an aggregate: how many values of any type its braces take.
struct AnyValue {
    template <class T>
    operator T() const {
        std::abort();  // asked for its type alone
    }
};
template <class T, class... Values>
consteval std::size_t member_count() {
    if constexpr (requires { T{Values{}..., AnyValue{}}; })
        return member_count<T, Values..., AnyValue>();
    else
        return sizeof...(Values);
}

struct FieldCounter {
    std::size_t count = 0;
    template <class T>
    void operator()(const char*, T&) {
        ++count;
    }
};

template <class T>
std::size_t field_count() {
    T value{};
    FieldCounter counter;
    fields(counter, value);
    return counter.count;
}

TEST(SettingsJson, NoMemberIsForgotten) {
    EXPECT_EQ(field_count<ViewSettings>(), member_count<ViewSettings>());
    EXPECT_EQ(field_count<Quality>(), member_count<Quality>());
    EXPECT_EQ(field_count<ModeSettings>(), member_count<ModeSettings>());
    EXPECT_EQ(field_count<BoxRoi>(), member_count<BoxRoi>());
    EXPECT_EQ(field_count<CuttingPlane>(), member_count<CuttingPlane>());
    EXPECT_EQ(field_count<CutSetting>(), member_count<CutSetting>());
    EXPECT_EQ(field_count<RangeSetting>(), member_count<RangeSetting>());
    EXPECT_EQ(field_count<SliceSettings>(), member_count<SliceSettings>());
    EXPECT_EQ(field_count<Slab>(), member_count<Slab>());
    EXPECT_EQ(field_count<Measurement>(), member_count<Measurement>());
}

/// Settings in which nothing has its default.
ViewSettings unusual_settings(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1000, 1000);
    ViewSettings s;
    s.mode = ViewMode::lmip;
    s.iso = number(random);
    s.lmip_threshold = number(random);
    s.shading = Shading::lambert;
    s.tf.name = "von Hand – \"eigene\"";
    s.tf.unit_distance_mm = 0.3;
    s.tf.points = {{-1.5, {0.1, 0.2, 1.0 / 3}, 0}, {number(random) + 2000, {1, 0, 0.25}, 0.1}};
    s.tf.gradient_opacity = {{0, 0}, {17.25, 1}};
    s.tf.shapes = {{{0.5, 17.25}, {-3, 1.0 / 3}, {-1, 0.25}, {0.1, 1, 0}, 0.4, 0.2}};
    s.tf.by_shapes = false;
    SegmentationRange range{"bone", {0.1, std::numeric_limits<double>::infinity()}, s.tf};
    s.ranges = {{range, false, {0.2, 0.4, 1.0 / 3}}, {{"x", {-2, 3}, {}}, true}};
    s.cuts = {{{{0.3, -0.4, 0.5}, number(random), false}, false}};
    s.window = {-3, number(random) + 1000};
    s.projection_window = {1, 2};
    s.slices = {VoiFunction::sigmoid,
                2,
                glm::angleAxis(number(random) / 400, glm::normalize(glm::dvec3(1, -2, 0.5))),
                {7.5, SlabMode::minip},
                0.125};
    s.measurements = {
        {1, MeasurementKind::distance, {{0.1, 2, number(random)}, {1, 2, 1.0 / 3}}, {1, 0, 0}, {0, 1, 0}},
        {4000000000u, MeasurementKind::angle, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {0, 0.6, 0.8}, {1, 0, 0}},
        {3, MeasurementKind::ellipse, {{1, 2, 3}, {4, 5, 6}}, {0, 0, -1}, {0, 1, 0}}};
    s.color_by_tf = true;
    s.surface_color = {0.1, 0.2, 0.3};
    s.quality.step = 0.125;
    s.quality.sampler = Sampler::nearest;
    s.quality.error_budget = std::abs(number(random));
    s.quality.time_budget_ms = 33;
    s.quality.plan = to_json(ModePlan{ViewMode::iso, {}});
    s.quality.structure = Structure::eacd;
    s.roi = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.9}, true, false};
    s.other_modes[ViewMode::iso] = {Shading::none, {2, Structure::octree, Sampler::adaptive}, {5, 6}, true, {}};
    s.other_modes[ViewMode::mip].effects = parse_effects("contrast=2");
    s.effects = parse_effects("ssao=2,3,gamma=1.7");
    return s;
}

TEST(SettingsJson, EverySettingComesBackTheSame) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const ViewSettings settings = unusual_settings(seed);
        EXPECT_EQ(view_settings_from_json(to_json(settings), "settings"), settings) << seed;
    }
    EXPECT_EQ(view_settings_from_json("{\"tf\":" + to_json(unusual_settings(1).tf) + "}", "old").quality, Quality{});
}

TEST(SettingsJson, WhatCannotBeIsRefusedByName) {
    const auto complaint = [](const std::string& json) {
        try {
            view_settings_from_json(json, "s.lacuna");
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::bad_input);
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_NE(complaint("{\"isovalue\":1}").find("unknown entry 'isovalue'"), std::string::npos);
    EXPECT_NE(complaint("{\"mode\":\"hologram\"}").find("s.lacuna.mode"), std::string::npos);
    EXPECT_NE(complaint("{\"mode\":3}").find("word"), std::string::npos);
    EXPECT_NE(complaint("{\"iso\":\"much\"}").find("s.lacuna.iso"), std::string::npos);
    EXPECT_NE(complaint("{\"iso\":\"nan\"}").find("grey level"), std::string::npos);
    EXPECT_NE(complaint("{\"cuts\":[{\"plane\":{\"normal\":[0,0,0]}}]}").find("direction"), std::string::npos);
    EXPECT_NE(complaint("{\"cuts\":[{\"plane\":{\"normal\":[0,1]}}]}").find("cuts[0].plane.normal"), std::string::npos);
    EXPECT_NE(complaint("{\"roi\":{\"lo\":[0,0,1]}}").find("box"), std::string::npos);
    EXPECT_NE(complaint("{\"other_modes\":{\"hologram\":{}}}").find("other_modes"), std::string::npos);
    EXPECT_NE(complaint("{\"quality\":{\"structure\":\"heap\"}}").find("quality.structure"), std::string::npos);
    EXPECT_NE(complaint("{\"iso\":1").find("cut short"), std::string::npos);
    EXPECT_NE(complaint("{\"slices\":{\"tilt\":[0,0,0,2]}}").find("tilt"), std::string::npos);
    EXPECT_NE(complaint("{\"slices\":{\"slab\":{\"thickness_mm\":-1}}}").find("thickness"), std::string::npos);
    EXPECT_NE(complaint("{\"slices\":{\"slab\":{\"mode\":\"median\"}}}").find("slab mode"), std::string::npos);
    EXPECT_NE(complaint("{\"slices\":{\"overlay_opacity\":\"nan\"}}").find("opacity"), std::string::npos);
    EXPECT_NE(complaint("{\"measurements\":[{\"kind\":\"angle\",\"points_mm\":[[0,0,0],[1,0,0]]}]}").find("points"),
              std::string::npos);
    EXPECT_NE(complaint("{\"measurements\":[{\"points_mm\":[[0,0,0],[\"inf\",0,0]]}]}").find("position"),
              std::string::npos);
}

const std::string k_function = R"({"name":"x","points":[{"value":0,"color":[1,1,1],"opacity":0}]})";

class SessionFile : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("lacuna_session_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder / "data");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    Session example() const {
        Session session;
        session.input = (folder / "data" / "part.mhd").string();
        session.options.series = "1.2.3";
        session.options.spacing_mm = glm::dvec3(0.1, 0.2, 0.3);
        session.sha256 = "abc";
        session.size = {3, 4, 5};
        session.settings = unusual_settings(7);
        session.camera.fov_deg = 30;
        session.camera.center_mm = glm::dvec3(1, 2, 3);
        session.cursor_mm = {4, 5, 6};
        session.criteria = R"({"material":"auto"})";
        session.decisions = {{3, false, "Riss, kein Lunker"}};
        session.regions = SessionRegions{};
        session.regions->options.threshold = ValueRange{-2.5, 1.0 / 3};
        session.regions->options.connectivity = Connectivity::c18;
        session.regions->options.min_voxels = 77;
        session.regions->options.gradient_limit = 12.5;
        session.regions->options.merge_slivers = true;
        session.regions->computed = true;
        session.regions->selected = 4;
        return session;
    }
    std::filesystem::path folder;
};

TEST_F(SessionFile, ComesBackTheSame) {
    const Session session = example();
    save_session(session, folder / "a.lacuna");
    const Session back = load_session(folder / "a.lacuna");
    EXPECT_EQ(back.input, session.input);
    EXPECT_EQ(back.options.series, session.options.series);
    EXPECT_EQ(back.options.spacing_mm, session.options.spacing_mm);
    EXPECT_EQ(back.sha256, session.sha256);
    EXPECT_EQ(back.size, session.size);
    EXPECT_EQ(back.settings, session.settings);
    EXPECT_EQ(back.camera, session.camera);
    EXPECT_EQ(back.cursor_mm, session.cursor_mm);
    EXPECT_EQ(back.criteria, session.criteria);
    ASSERT_EQ(back.decisions.size(), 1u);
    EXPECT_EQ(back.decisions[0].defect, 3u);
    EXPECT_FALSE(back.decisions[0].accepted);
    EXPECT_EQ(back.decisions[0].reason, "Riss, kein Lunker");
    ASSERT_TRUE(back.regions);
    EXPECT_EQ(back.regions->options.threshold, session.regions->options.threshold);
    EXPECT_FALSE(back.regions->options.range_width);
    EXPECT_FALSE(back.regions->options.background);
    EXPECT_EQ(back.regions->options.connectivity, Connectivity::c18);
    EXPECT_EQ(back.regions->options.min_voxels, 77);
    EXPECT_EQ(back.regions->options.gradient_limit, 12.5);
    EXPECT_TRUE(back.regions->options.merge_slivers);
    EXPECT_TRUE(back.regions->computed);
    EXPECT_EQ(back.regions->selected, 4u);
}

TEST_F(SessionFile, OfTheFirstVersionIsRead) {
    write_file(folder / "old.lacuna", "{\"lacuna_session\":1,\"settings\":{\"iso\":7,\"tf\":" + k_function + "}}");
    const Session old = load_session(folder / "old.lacuna");
    EXPECT_EQ(old.settings.iso, 7);
    EXPECT_FALSE(old.regions);
}

TEST_F(SessionFile, FindsDataThatMovedWithIt) {
    std::ofstream(folder / "data" / "part.mhd") << "x";
    save_session(example(), folder / "a.lacuna");
    const std::filesystem::path moved = folder / "elsewhere";
    std::filesystem::create_directories(moved);
    std::filesystem::rename(folder / "data", moved / "data");
    std::filesystem::rename(folder / "a.lacuna", moved / "a.lacuna");
    EXPECT_EQ(load_session(moved / "a.lacuna").input, std::filesystem::canonical(moved / "data" / "part.mhd").string());
}

TEST_F(SessionFile, RefusesWhatIsNone) {
    const auto complaint = [&](const std::string& text) {
        write_file(folder / "b.lacuna", text);
        try {
            load_session(folder / "b.lacuna");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_NE(complaint("{}").find("no session"), std::string::npos);
    EXPECT_NE(complaint("[1]").find("no session"), std::string::npos);
    EXPECT_NE(complaint("{\"lacuna_session\":3}").find("newer"), std::string::npos);
    EXPECT_NE(complaint("{\"lacuna_session\":1,\"colour\":2}").find("'colour'"), std::string::npos);
    const auto with_regions = [&](const std::string& regions) {
        return "{\"lacuna_session\":2,\"settings\":{\"tf\":" + k_function + "},\"regions\":" + regions + "}";
    };
    EXPECT_NE(complaint(with_regions("{}")).find("exactly one"), std::string::npos);
    EXPECT_NE(complaint(with_regions("{\"range_width\":0.1,\"connectivity\":7}")).find("18"), std::string::npos);
    EXPECT_NE(complaint("").find("cut short"), std::string::npos);
    EXPECT_THROW(load_session(folder / "none.lacuna"), Error);
}

TEST_F(SessionFile, ACameraNoPictureCanBeDrawnWithIsRefused) {
    const auto complaint = [&](const Camera& camera) {
        Session session = example();
        session.camera = camera;
        save_session(session, folder / "c.lacuna");
        try {
            load_session(folder / "c.lacuna");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(complaint({}), "accepted");
    for (const double fov : {1e-6, 0.0, -5.0, 180.0, std::nan("")})
        EXPECT_NE(complaint({.fov_deg = fov}).find("c.lacuna.camera: The field of view"), std::string::npos) << fov;
    EXPECT_NE(complaint({.zoom = 0}).find("zoom"), std::string::npos);
}

TEST_F(SessionFile, AnotherSizeIsNotDressedUp) {
    Document document = make_document("sample:spheres@16", open_volume("sample:spheres@16"));
    const ViewSettings before = document.settings;
    EXPECT_THROW(apply_session(example(), document), Error);
    EXPECT_EQ(document.settings, before);
    Session fitting = session_of(document, "");
    fitting.settings.iso = 42;
    apply_session(fitting, document);
    EXPECT_EQ(document.settings.iso, 42);
}

}  // namespace
}  // namespace lacuna
