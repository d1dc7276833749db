#include "core/classify/transfer_function.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/base/atomic_file.h"
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
    EXPECT_FALSE(TransferFunction{}.any_visible({0, 1}));
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
    EXPECT_FALSE(tf.any_visible({0, std::nextafter(5.0, 0.0)}));
    EXPECT_TRUE(tf.any_visible({5, 5}));
    const TransferFunction down = with_opacities({{0, 1}, {5, 1}, {5, 0}, {10, 0}});
    EXPECT_FALSE(down.any_visible({5, 10}));
    EXPECT_TRUE(down.any_visible({4.999, 10}));
}

TEST(TransferFunctionAt, AnyVisibleFindsAPeakBetweenInvisibleEnds) {
    const TransferFunction tf = with_opacities({{0, 0}, {5, 1}, {10, 0}});
    EXPECT_TRUE(tf.any_visible({-5, 50}));
    EXPECT_FALSE(tf.any_visible({-5, 0}));
    EXPECT_FALSE(tf.any_visible({10, k_inf}));
    EXPECT_FALSE(tf.any_visible({7, 3}));
    EXPECT_FALSE(tf.any_visible({k_nan, 3}));
}

TEST(TransferFunctionAt, AnyVisibleAgreesWithBruteForce) {
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        std::vector<std::pair<double, double>> nodes;
        double v = double(random() % 5);
        for (unsigned i = 0; i < 1 + random() % 6; ++i) {
            nodes.emplace_back(v, random() % 3 ? 0.0 : 0.5);
            const bool jump = nodes.size() < 2 || nodes[nodes.size() - 2].first != v;
            v += double(jump ? random() % 4 : 1 + random() % 3);
        }
        const TransferFunction tf = with_opacities(nodes);
        ASSERT_NO_THROW(check(tf));
        for (int lo = -2; lo < 20; ++lo)
            for (int hi = lo; hi < 20; ++hi) {
                bool any = false;
                for (int s = lo * 8; s <= hi * 8; ++s) any = any || tf.at(s / 8.0).opacity > 0;
                ASSERT_EQ(tf.any_visible({double(lo), double(hi)}), any) << to_json(tf) << lo << ".." << hi;
            }
    }
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
                    "gradient_opacity[0].magnitude"}),
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
            EXPECT_TRUE(tf.any_visible(statistics.range)) << sample << ' ' << name;
            EXPECT_DOUBLE_EQ(tf.unit_distance_mm, s.volume.geometry().smallest_spacing_mm());
        }
        const TransferFunction fitted = fit_transfer_function(s.volume, statistics);
        EXPECT_EQ(fitted.at(s.background).opacity, 0) << sample;
        EXPECT_GT(fitted.at(s.material).opacity, 0) << sample;
    }
}

}  // namespace
}  // namespace lacuna
