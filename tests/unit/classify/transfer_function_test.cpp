#include "core/classify/transfer_function.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/base/atomic_file.h"
#include "core/classify/classification.h"
#include "core/classify/preset_file.h"
#include "core/volume/samples.h"

namespace lacuna {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_inf = std::numeric_limits<double>::infinity();

TransferFunction with_points(std::vector<TransferPoint> points) {
    TransferFunction tf;
    tf.name = "test";
    tf.points = std::move(points);
    return tf;
}

TransferFunction with_opacities(std::vector<std::pair<double, double>> nodes) {
    std::vector<TransferPoint> points;
    for (const auto& [value, opacity] : nodes) points.push_back({value, {1, 1, 1}, opacity});
    return with_points(std::move(points));
}

TEST(TransferFunctionAt, NanAndNoPointsAreTransparent) {
    EXPECT_EQ(with_opacities({{0, 1}}).at(k_nan).opacity, 0);
    EXPECT_EQ(TransferFunction{}.at(1).opacity, 0);
}

TEST(TransferFunctionAt, ConstantOutsideLinearBetween) {
    const TransferFunction tf = with_points({{10, {0, 0.5, 1}, 0.2}, {20, {1, 0.5, 0}, 0.6}});
    EXPECT_DOUBLE_EQ(tf.at(-k_inf).opacity, 0.2);
    EXPECT_DOUBLE_EQ(tf.at(k_inf).opacity, 0.6);
    EXPECT_DOUBLE_EQ(tf.at(12.5).opacity, 0.3);
    EXPECT_DOUBLE_EQ(tf.at(12.5).color.r, 0.25);
    EXPECT_EQ(tf.at(10).opacity, 0.2);
    EXPECT_EQ(tf.at(20).opacity, 0.6);
}

TEST(TransferFunctionAt, AJumpTakesTheLaterPoint) {
    const TransferFunction tf = with_opacities({{0, 0}, {5, 0}, {5, 1}, {10, 1}});
    EXPECT_EQ(tf.at(std::nextafter(5.0, 0.0)).opacity, 0);
    EXPECT_EQ(tf.at(5).opacity, 1);
    const TransferFunction down = with_opacities({{0, 1}, {5, 1}, {5, 0}, {10, 0}});
    EXPECT_EQ(down.at(5).opacity, 0);
}

TEST(GradientFactor, CurveAndItsEnds) {
    TransferFunction tf = with_opacities({{0, 1}});
    EXPECT_EQ(tf.gradient_factor(5), 1);
    tf.gradient_opacity = {{1, 0}, {3, 1}};
    EXPECT_EQ(tf.gradient_factor(0), 0);
    EXPECT_DOUBLE_EQ(tf.gradient_factor(2), 0.5);
    EXPECT_EQ(tf.gradient_factor(k_inf), 1);
    EXPECT_EQ(tf.gradient_factor(k_nan), 0);
}

TEST(CorrectOpacity, KeepsWhatAStackOfStepsAddsUpTo) {
    EXPECT_EQ(correct_opacity(0, 1, 1), 0);
    EXPECT_EQ(correct_opacity(1, 0.1, 1), 1);
    EXPECT_EQ(correct_opacity(k_nan, 1, 1), 0);
    EXPECT_NEAR(correct_opacity(0.3, 2, 2), 0.3, 1e-15);
    EXPECT_NEAR(std::pow(1 - correct_opacity(0.7, 0.25, 1), 4), 0.3, 1e-14);
    EXPECT_GT(correct_opacity(1e-18, 0.5, 1), 0);
}

struct BadFunction {
    const char* name;
    const char* json;
    const char* says;
};

class TransferFunctionFaults : public testing::TestWithParam<BadFunction> {};

TEST_P(TransferFunctionFaults, NameFileAndKey) {
    try {
        transfer_function_from_json(GetParam().json, "my.json");
        FAIL() << "accepted";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Errc::bad_input);
        EXPECT_NE(std::string(e.what()).find("my.json"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find(GetParam().says), std::string::npos) << e.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    Json, TransferFunctionFaults,
    testing::Values(
        BadFunction{"empty", "", "JSON"}, BadFunction{"cut", R"({"points":[)", "JSON"},
        BadFunction{"list", "[]", "object"}, BadFunction{"no_points", R"({"name":"a"})", "\"points\" is missing"},
        BadFunction{"points_number", R"({"points":3})", "\"points\" must be a list"},
        BadFunction{"points_empty", R"({"points":[]})", "at least one"},
        BadFunction{"unknown_key", R"({"points":[],"opacty":1})", "\"opacty\""},
        BadFunction{"unknown_in_point", R"({"points":[{"value":1,"color":[1,1,1],"opacity":1,"alpha":1}]})",
                    "\"points[0].alpha\""},
        BadFunction{"missing_opacity", R"({"points":[{"value":1,"color":[1,1,1]}]})",
                    "\"points[0].opacity\" is missing"},
        BadFunction{"value_text", R"({"points":[{"value":"1","color":[1,1,1],"opacity":1}]})", "\"points[0].value\""},
        BadFunction{"value_null", R"({"points":[{"value":null,"color":[1,1,1],"opacity":1}]})", "\"points[0].value\""},
        BadFunction{"two_colors", R"({"points":[{"value":1,"color":[1,1],"opacity":1}]})", "\"points[0].color\""},
        BadFunction{"color_out", R"({"points":[{"value":1,"color":[1,1,255],"opacity":1}]})", "points[0].color"},
        BadFunction{"opacity_out", R"({"points":[{"value":1,"color":[1,1,1],"opacity":1.5}]})", "points[0].opacity"},
        BadFunction{"value_huge", R"({"points":[{"value":1e999,"color":[1,1,1],"opacity":1}]})", "JSON"},
        BadFunction{"descending",
                    R"({"points":[{"value":2,"color":[1,1,1],"opacity":1},{"value":1,"color":[1,1,1],"opacity":1}]})",
                    "points[1].value"},
        BadFunction{"unit_zero", R"({"unit_distance_mm":0,"points":[{"value":1,"color":[1,1,1],"opacity":1}]})",
                    "unit_distance_mm"},
        BadFunction{"name_number", R"({"name":3,"points":[{"value":1,"color":[1,1,1],"opacity":1}]})", "\"name\""},
        BadFunction{"gradient",
                    R"({"points":[{"value":1,"color":[1,1,1],"opacity":1}],)"
                    R"("gradient_opacity":[{"magnitude":-1,"opacity":0}]})",
                    "gradient_opacity[0].magnitude"},
        BadFunction{"version_text", R"({"version":"two","points":[]})", "\"version\""},
        BadFunction{"shape_flat",
                    R"({"points":[{"value":1,"color":[1,1,1],"opacity":1}],"shapes":[{"magnitude":[2,2],)"
                    R"("values_at_lo":[0,1],"color":[1,1,1],"opacity":1}]})",
                    "shapes[0].magnitude"},
        BadFunction{"shape_turned",
                    R"({"points":[{"value":1,"color":[1,1,1],"opacity":1}],"shapes":[{"magnitude":[1,2],)"
                    R"("values_at_lo":[0,1],"values_at_hi":[3,1],"color":[1,1,1],"opacity":1}]})",
                    "shapes[0].values_at_hi"},
        BadFunction{"technique_word",
                    R"({"points":[{"value":1,"color":[1,1,1],"opacity":1}],"technique":{"fast":true}})",
                    "\"technique.fast\""},
        BadFunction{"technique_step", R"({"points":[{"value":1,"color":[1,1,1],"opacity":1}],"technique":{"step":0}})",
                    "\"technique.step\""}),
    [](const auto& row) { return row.param.name; });

TEST(TransferFunctionJson, ThreePointsAtOneValueAreRefused) {
    EXPECT_THROW(check(with_opacities({{1, 0}, {1, 1}, {1, 0}})), Error);
    EXPECT_THROW(check(with_opacities({{k_nan, 0}})), Error);
    EXPECT_THROW(check(with_opacities({{0, k_nan}})), Error);
}

TEST(TransferFunctionJson, RoundTripIsExact) {
    TransferFunction tf =
        with_points({{-1000.1, {0.1, 0.2, 0.3}, 0}, {1.0 / 3, {1, 0, 1}, 0.7}, {1.0 / 3, {0, 0, 0}, 1}});
    tf.name = "M\xc3\xa4rz \"quoted\"";
    tf.unit_distance_mm = 0.123456789012345;
    tf.gradient_opacity = {{0, 0.5}, {1e-3, 1}};
    EXPECT_EQ(transfer_function_from_json(to_json(tf), "memory"), tf);
    const auto file = std::filesystem::temp_directory_path() / ("lacuna-tf-" + std::to_string(::getpid()) + ".json");
    save_transfer_function(tf, file);
    EXPECT_EQ(load_transfer_function(file), tf);
    std::filesystem::remove(file);
    EXPECT_THROW(load_transfer_function(file), Error);
}

TEST(TransferFunctionJson, ShapesAndTechniqueRoundTripAndNameTheirVersion) {
    PresetFile preset;
    preset.tf = with_points({{0, {0, 0, 0}, 0.25}});
    EXPECT_EQ(to_json(preset).find("version"), std::string::npos);  // programs that know version 1 alone read it
    preset.tf.shapes = {{{0.5, 1e3}, {-10.1, 20}, {1.0 / 3, 2}, {0.1, 0.2, 0.3}, 0.7, 0.9}};
    preset.tf.by_shapes = false;
    preset.technique = Technique{"mip", "none", 0.25};
    const std::string json = to_json(preset);
    EXPECT_NE(json.find("\"version\": 2"), std::string::npos);
    EXPECT_EQ(preset_from_json(json, "memory"), preset);
    EXPECT_EQ(transfer_function_from_json(json, "memory"), preset.tf);
}

TEST(TransferFunctionJson, ALaterVersionIsRefusedAsSuch) {
    try {
        preset_from_json(R"({"version":3,"curves":[]})", "mine.json");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Errc::bad_input);
        EXPECT_NE(std::string(e.what()).find("version 3"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("mine.json"), std::string::npos) << e.what();
    }
}

TransferShape random_shape(std::mt19937& random) {
    const auto number = [&](int most) { return double(random() % unsigned(most)); };
    TransferShape s;
    s.magnitude.lo = number(4);
    s.magnitude.hi = s.magnitude.lo + 1 + number(4);
    s.at_lo.lo = number(12);
    s.at_lo.hi = s.at_lo.lo + 2 + number(5);
    s.at_hi.lo = number(12);
    s.at_hi.hi = s.at_hi.lo + 2 + number(5);
    s.opacity = number(3) / 2;
    s.softness = number(3) / 2;
    return s;
}

TEST(TransferShape, TheMostOpacityOfAValueIsThatOfSomeMagnitude) {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        const TransferShape shape = random_shape(random);
        for (double v = -1; v <= 18; v += 0.25) {
            double most = 0;
            for (int i = 0; i <= 2000; ++i)
                most = std::max(most, shape.opacity_at(v, shape.magnitude.lo + i / 2000.0 * shape.magnitude.width()));
            EXPECT_GE(shape.most_opacity_at(v), most - 1e-12) << round << " at " << v;
            EXPECT_LE(shape.most_opacity_at(v), most + 0.02) << round << " at " << v;
        }
    }
}

TEST(TransferShape, SidesRunStraightAndSoftnessFallsTowardsThem) {
    const TransferShape triangle{{10, 20}, {0, 8}, {4, 4}, glm::dvec3(1), 0.5, 0};
    EXPECT_EQ(triangle.opacity_at(4, 20), 0.5);
    EXPECT_EQ(triangle.opacity_at(1.99, 15), 0);
    EXPECT_EQ(triangle.opacity_at(2, 15), 0.5);
    EXPECT_EQ(triangle.opacity_at(4, 20.01), 0);
    EXPECT_EQ(triangle.opacity_at(4, k_nan), 0);
    const TransferShape soft{{0, 1}, {0, 8}, {0, 8}, glm::dvec3(1), 0.5, 0.5};
    EXPECT_EQ(soft.opacity_at(0, 0.5), 0);
    EXPECT_EQ(soft.opacity_at(1, 0.5), 0.25);
    EXPECT_EQ(soft.opacity_at(4, 0.5), 0.5);
}

TEST(TransferFunctionAt, ShapesAreTheFunctionOfValueAndGradient) {
    TransferFunction tf = with_points({{0, {0.1, 0.1, 0.1}, 0.9}});
    tf.gradient_opacity = {{0, 0.5}};
    tf.shapes = {{{1, 3}, {10, 20}, {10, 20}, {1, 0, 0}, 0.5, 0}, {{2, 4}, {15, 30}, {15, 30}, {0, 0, 1}, 0.25, 0}};
    EXPECT_EQ(tf.at(12, 0).opacity, 0);
    EXPECT_EQ(tf.at(12, k_nan).opacity, 0);  // counts as magnitude 0
    EXPECT_EQ(tf.at(12, 2).opacity, 0.5);
    const ColorOpacity both = tf.at(17, 2.5);
    EXPECT_DOUBLE_EQ(both.opacity, 1 - 0.5 * 0.75);
    EXPECT_DOUBLE_EQ(both.color.r, 0.5 / 0.75);
    EXPECT_DOUBLE_EQ(both.color.b, 0.25 / 0.75);
    EXPECT_EQ(tf.at(25).opacity, 0.25);  // what some gradient shows
    EXPECT_EQ(tf.at(25).color.r, 0.1);   // projections keep the points' colours
    EXPECT_EQ(tf.extent(), (ValueRange{0, 30}));
    tf.by_shapes = false;
    EXPECT_DOUBLE_EQ(tf.at(12, 2).opacity, 0.45);
    EXPECT_TRUE(tf.uses_gradient());
}

TEST(TransferFunctionJson, TheContractsExampleLoads) {
    const TransferFunction tf = transfer_function_from_json(
        R"({"name":"x","unit_distance_mm":1.0,"points":[{"value":150,"color":[0.9,0.8,0.7],"opacity":0.0}],
            "gradient_opacity":[{"magnitude":10,"opacity":1}]})",
        "example");
    EXPECT_EQ(tf.points.at(0).value, 150);
    EXPECT_EQ(tf.gradient_opacity.size(), 1u);
}

TEST(Presets, UnknownNameListsTheKnown) {
    try {
        make_preset("bones", Volume{}, {});
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Errc::bad_usage);
        EXPECT_NE(std::string(e.what()).find("soft-tissue"), std::string::npos);
    }
}

TEST(Presets, SoundForDegenerateStatistics) {
    for (const ValueRange range : {ValueRange{0, 0}, {-1000, -1000}, {1e30, 1e30}, {0, 1e-9}, {-3e38, 3e38}, {7, 8}}) {
        VolumeStatistics s;
        s.range = s.histogram_range = range;
        s.histogram = range.width() > 0 ? std::vector<std::uint64_t>{5, 1} : std::vector<std::uint64_t>{6};
        for (const char* unit : {"", "HU"}) {
            Volume volume;
            volume.unit = unit;
            for (const std::string& name : preset_names()) {
                TransferFunction tf;
                ASSERT_NO_THROW(tf = make_preset(name, volume, s)) << name << ' ' << range.lo;
                for (std::size_t i = 1; i < tf.points.size(); ++i)
                    ASSERT_LT(tf.points[i - 1].value, tf.points[i].value) << name << ' ' << range.lo;
            }
            ASSERT_NO_THROW(check(fit_transfer_function(volume, s)));
        }
    }
    ASSERT_NO_THROW(check(fit_transfer_function(Volume{}, {})));
}

TEST(Presets, AirIsExactlyTransparentAndMatterIsNot) {
    for (const char* sample : {"casting", "head", "vessels", "spheres"}) {
        SampleOptions options;
        options.size = 48;
        const AnalyticSample s = make_sample(sample, options);
        const VolumeStatistics statistics = compute_statistics(s.volume);
        for (const std::string& name : preset_names()) {
            const TransferFunction tf = make_preset(name, s.volume, statistics);
            EXPECT_EQ(tf.at(s.background).opacity, 0) << sample << ' ' << name;
            EXPECT_NE(VisibilityTable::of_opacity({tf, {}}, statistics.range).query(statistics.range),
                      VisibilityTable::Answer::none)
                << sample << ' ' << name;
            EXPECT_DOUBLE_EQ(tf.unit_distance_mm, s.volume.geometry().smallest_spacing_mm());
        }
        const TransferFunction fitted = fit_transfer_function(s.volume, statistics);
        EXPECT_EQ(fitted.at(s.background).opacity, 0) << sample;
        EXPECT_GT(fitted.at(s.material).opacity, 0) << sample;
    }
}

}  // namespace
}  // namespace lacuna
