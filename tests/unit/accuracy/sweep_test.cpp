#include "core/accuracy/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <thread>

#include "core/accuracy/sweep_report.h"
#include "core/base/atomic_file.h"
#include "core/compute/device.h"
#include "tests/support/json_schema.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

Engine& engine() {
    static Engine on_device(open_device());
    return on_device;
}

SweepScene small(ViewMode mode, int views = 1) {
    SweepScene made{.name = "ball",
                    .scene = small_scene(bumpy_ball<std::uint16_t>({24, 23, 22}, {1, 1, 1}, 50000), mode, {40, 32}),
                    .views = {}};
    for (int i = 0; i < views; ++i) {
        made.views.push_back(made.scene.camera);
        made.views.back().azimuth_deg = 90.0 * i;
    }
    made.command = "lacuna render ball";
    return made;
}

SweepOptions quickly(int rounds = 2) {
    SweepOptions options;
    options.extent = SweepExtent::quick;
    options.rounds = rounds;
    return options;
}

SweepPoint point(double ms, double error) {
    SweepPoint made;
    made.ms = ms;
    made.error.max = error;
    return made;
}

TEST(Front, HoldsWhatNothingBeats) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    std::vector<SweepPoint> points{point(80, 0), point(20, 0),  point(20, 3),    point(9, 3), point(15, 5),
                                   point(9, 8),  point(1, inf), point(0.5, nan), point(2, 90)};
    points.push_back(point(0.1, 0));
    points.back().refused = "no";
    mark_front(points, FrontError::max);
    std::vector<bool> expected{false, true, false, true, false, false, false, false, true, false};
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i].on_front, expected[i]) << i;
    // Against the definition.
    for (const SweepPoint& p : points)
        for (const SweepPoint& q : points)
            if (p.on_front && q.refused.empty()) {
                EXPECT_FALSE(q.ms <= p.ms && q.error.max < p.error.max);
                EXPECT_FALSE(q.ms < p.ms && q.error.max <= p.error.max);
            }
    for (SweepPoint& p : points) p.error.mean = 100 - p.ms;
    mark_front(points, FrontError::mean);
    EXPECT_TRUE(points[0].on_front) << "weighed by another error";
}

TEST(Front, EqualPointsStandTogetherWhateverTheirOrder) {
    for (const bool turned : {false, true}) {
        std::vector<SweepPoint> points{point(20, 0), point(20, 0), point(9, 3), point(9, 3), point(9, 4), point(20, 3)};
        if (turned) std::reverse(points.begin(), points.end());
        mark_front(points, FrontError::max);
        for (const SweepPoint& p : points) {
            bool beaten = false;  // the definition
            for (const SweepPoint& q : points)
                beaten = beaten ||
                         (q.ms <= p.ms && q.error.max <= p.error.max && (q.ms < p.ms || q.error.max < p.error.max));
            EXPECT_EQ(p.on_front, !beaten) << p.ms << ", " << p.error.max;
        }
    }
}

TEST(Front, MeasuresAreNamed) {
    for (const FrontError e : {FrontError::max, FrontError::mean, FrontError::flip})
        EXPECT_EQ(parse_front_error(name_of(e)), e);
    EXPECT_THROW(parse_front_error("rms"), Error);
}

TEST(Sweep, LosslessStructuresAreWithoutErrorCoarseStepsAreNot) {
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip}) {
        const SceneResult result = sweep(engine(), small(mode, 2), quickly());
        EXPECT_EQ(result.rounds, 2);
        EXPECT_EQ(result.points.front().error.max, 0) << "the reference itself";
        double largest = 0, undershoot = 0;
        for (const SweepPoint& p : result.points) {
            if (!p.refused.empty()) continue;
            EXPECT_GT(p.ms, 0);
            EXPECT_LE(p.ms_low, p.ms);
            EXPECT_GE(p.ms_high, p.ms);
            const Plan& plan = p.plan.plan;
            if (p.plan.mode != mode) continue;
            if (plan.step == 0.5 && plan.ert == 0 && plan.sampler == Sampler::linear && plan.sparse == 0) {
                EXPECT_LE(p.error.max, 0.01) << name_of(plan.structure) << " in " << name_of(mode);
            }
            if (plan.step > 0.5) largest = std::max(largest, p.error.max);
            EXPECT_EQ(p.surface.has_value(), mode == ViewMode::iso);
            ASSERT_EQ(p.projection.has_value(), mode == ViewMode::mip);
            if (p.projection) undershoot = std::max(undershoot, p.projection->max_undershoot);
        }
        EXPECT_GT(largest, 0.1) << "coarser steps are not lossless";
        EXPECT_EQ(undershoot > 0, mode == ViewMode::mip);
        EXPECT_TRUE(std::any_of(result.points.begin(), result.points.end(), [](const auto& p) { return p.on_front; }));
        ASSERT_TRUE(result.of_reference.device && result.of_reference.fine);
        EXPECT_LT(result.of_reference.device->mean, 0.5);
        EXPECT_GT(result.of_reference.fine->max, 0);
    }
}

TEST(Sweep, BytesAreThoseHeldAfterAllViews) {
    SweepScene scene = small(ViewMode::iso, 2);
    scene.views[1].elevation_deg = 90;  // shear-warp makes other lists for it
    const SceneResult result = sweep(engine(), scene, quickly(1));
    int looked_at = 0;
    for (const SweepPoint& p : result.points) {
        if (p.plan.mode != ViewMode::shear_warp || !p.refused.empty()) continue;
        ++looked_at;
        engine().drop_caches();
        std::size_t after_one = 0, after_all = 0;
        for (const Camera& view : scene.views) {
            Scene shown = scene.scene;
            shown.camera = view;
            shown.mode = p.plan.mode;
            std::size_t bytes = 0;
            for (const auto& [name, made] : engine().render(shown, p.plan.plan).build) bytes += made.bytes;
            if (after_one == 0) after_one = bytes;
            after_all = std::max(after_all, bytes);
        }
        EXPECT_GT(after_all, after_one);
        EXPECT_EQ(p.bytes, after_all);
    }
    EXPECT_GT(looked_at, 0);
}

TEST(Sweep, ASampleIsHeldAgainstItsFormula) {
    SweepScene scene{.name = "balls", .scene = {}, .views = {}, .step = 0.5};
    const AnalyticSample sample = make_sample("spheres", {.size = 24});
    scene.scene = small_scene(sample.volume, ViewMode::iso, {40, 40});
    scene.scene.iso = 110;
    scene.views = {scene.scene.camera};
    scene.sample = [](const JobContext& job) { return make_sample("spheres", {.size = 24}, job); };
    SweepOptions options = quickly(1);
    const SceneResult result = sweep(engine(), scene, options);
    EXPECT_EQ(result.of_reference.unmeasured, "");
    ASSERT_TRUE(result.of_reference.closed_form && result.of_reference.closed_form_surface);
    EXPECT_GT(result.of_reference.closed_form_surface->both, 50u);
    EXPECT_LT(result.of_reference.closed_form_surface->mean_voxels, 0.5);
    options.closed_form = false;
    EXPECT_FALSE(sweep(engine(), scene, options).of_reference.closed_form);
}

TEST(Sweep, WhatTheTimeDidNotSufficeForSaysSo) {
    SweepOptions options = quickly();
    options.time_limit_s = 1e-9;
    const SceneResult result = sweep(engine(), small(ViewMode::ea), options);
    for (const SweepPoint& p : result.points) EXPECT_NE(p.refused, "") << "nothing measured is nothing claimed";
    EXPECT_EQ(result.rounds, 0);
    EXPECT_NE(result.of_reference.unmeasured, "");
    EXPECT_FALSE(result.of_reference.device || result.of_reference.fine);
    EXPECT_NE(sweep_table(result).find(result.of_reference.unmeasured), std::string::npos);
    EXPECT_NO_THROW(sweep_chart("device", {result}, FrontError::max));
    const JsonSchema schema(nlohmann::json::parse(read_file(LACUNA_SOURCE_DIR "/docs/schemas/bench.schema.json")));
    EXPECT_TRUE(schema.faults(nlohmann::json::parse(sweep_json("device", {result}, FrontError::max))).empty());
}

TEST(Sweep, ALongTruthIsLeftInItsMiddleAndThePlansAreStillMeasured) {
    SweepScene scene = small(ViewMode::mip);
    bool left = false;
    scene.sample =
        [&](const JobContext& job) -> AnalyticSample {  // a truth that ends when it is stopped, and never else
        while (!job.stopped()) std::this_thread::yield();
        left = true;
        job.check();
        return {};
    };
    SweepOptions options = quickly(1);
    options.time_limit_s = 8;
    const SceneResult result = sweep(engine(), scene, options);
    EXPECT_TRUE(left);
    EXPECT_NE(result.of_reference.unmeasured, "");
    EXPECT_TRUE(result.of_reference.fine) << "what was there in time is kept";
    EXPECT_TRUE(result.points.front().refused.empty());
}

TEST(Sweep, StopsAndReportsProgress) {
    double last = 0;
    JobContext job;
    job.progress = [&](double f) {
        EXPECT_GE(f, last - 1e-12);
        last = f;
    };
    sweep(engine(), small(ViewMode::mip), quickly(1), job);
    EXPECT_GT(last, 0.99);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(sweep(engine(), small(ViewMode::mip), quickly(1), {stop.get_token()}), Error);
    EXPECT_THROW(sweep(engine(), small(ViewMode::mip, 0), quickly(1)), Error) << "no view";
}

TEST(SweepReport, JsonKeepsToItsSchemaAndPlansComeBack) {
    const JsonSchema schema(nlohmann::json::parse(read_file(LACUNA_SOURCE_DIR "/docs/schemas/bench.schema.json")));
    std::vector<SceneResult> results{sweep(engine(), small(ViewMode::iso), quickly(1)),
                                     sweep(engine(), small(ViewMode::mip), quickly(1))};
    SweepPoint broken = results[0].points[1];
    broken.error = {};
    broken.error.max = broken.error.mean = std::numeric_limits<double>::infinity();
    results[0].points.push_back(broken);
    const nlohmann::json json = nlohmann::json::parse(sweep_json("a device", results, FrontError::max));
    for (const std::string& fault : schema.faults(json)) ADD_FAILURE() << fault;
    nlohmann::json wrong = json;
    wrong["scenes"][0]["points"][0]["ms"] = -1;
    wrong["scenes"][1]["points"][0]["better"] = true;
    EXPECT_EQ(schema.faults(wrong).size(), 2u) << "the schema is no rubber stamp";
    for (std::size_t s = 0; s < results.size(); ++s) {
        std::size_t i = 0;
        for (const SweepPoint& p : results[s].points) {
            if (!p.refused.empty()) continue;
            const nlohmann::json& plan = json["scenes"][s]["points"][i++]["plan"];
            EXPECT_EQ(to_json(plan_from_json(plan.dump(), "point")), to_json(p.plan));
        }
    }
}

TEST(SweepReport, ChartAndTableShowEveryStructureMeasured) {
    const SceneResult result = sweep(engine(), small(ViewMode::ea), quickly(1));
    const ChartSheet sheet = sweep_chart("a device", {result}, FrontError::max);
    ASSERT_EQ(sheet.charts.size(), 1u);
    const std::string table = sweep_table(result);
    std::size_t drawn = 0;
    for (const Series& series : sheet.charts[0].series) {
        EXPECT_NE(table.find(series.name == "Pareto front" ? "* " : series.name), std::string::npos) << series.name;
        if (series.name != "Pareto front") drawn += series.points.size();
    }
    EXPECT_EQ(std::ptrdiff_t(drawn), std::count_if(result.points.begin(), result.points.end(),
                                                   [](const auto& p) { return p.refused.empty(); }));
    EXPECT_GT(sheet.charts[0].series.back().points.size(), 0u);
    EXPECT_GT(to_svg(sheet.charts[0]).size(), 1000u);
}

}  // namespace
}  // namespace lacuna
