#include "core/accuracy/sweep_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/chart/axis_scale.h"

namespace lacuna {

namespace {

using nlohmann::ordered_json;

ordered_json finite(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json json_of(const ImageError& error) {
    ordered_json json{{"reference", error.reference},
                      {"max", finite(error.max)},
                      {"mean", finite(error.mean)},
                      {"psnr", finite(error.psnr)},
                      {"ssim", error.ssim},
                      {"flip", error.flip},
                      {"pixels_over_budget", error.pixels_over_budget}};
    for (const auto& [key, value] :
         {std::pair("channel_max", error.channel_max), std::pair("channel_mean", error.channel_mean)})
        json[key] = {finite(value.r), finite(value.g), finite(value.b)};
    return json;
}

ordered_json json_of(const SurfaceError& error) {
    return {{"max_voxels", finite(error.max_voxels)}, {"mean_voxels", finite(error.mean_voxels)},
            {"rms_voxels", finite(error.rms_voxels)}, {"missed", error.missed},
            {"false_hits", error.false_hits},         {"over_one_voxel", error.over_one_voxel}};
}

ordered_json json_of(const ProjectionError& error) {
    return {{"max_undershoot", finite(error.max_undershoot)},
            {"mean_undershoot", finite(error.mean_undershoot)},
            {"max_overshoot", finite(error.max_overshoot)},
            {"pixels", error.pixels}};
}

ordered_json json_of(const ReferenceErrors& errors) {
    ordered_json json{{"size", {errors.size.x, errors.size.y}}};
    const auto add = [&](const char* key, const auto& error) {
        json[key] = error ? json_of(*error) : ordered_json(nullptr);
    };
    add("device", errors.device);
    add("fine", errors.fine);
    add("closed_form", errors.closed_form);
    add("closed_form_surface", errors.closed_form_surface);
    if (!errors.unmeasured.empty()) json["unmeasured"] = errors.unmeasured;
    return json;
}

ordered_json json_of(const SweepPoint& point) {
    ordered_json json{{"plan", ordered_json::parse(to_json(point.plan))},
                      {"ms", point.ms},
                      {"ms_low", point.ms_low},
                      {"ms_high", point.ms_high},
                      {"build_ms", point.build_ms},
                      {"bytes", point.bytes}};
    ordered_json error = json_of(point.error);
    error.erase("reference");
    json.update(error);
    if (point.surface) json["surface"] = json_of(*point.surface);
    if (point.projection) json["projection"] = json_of(*point.projection);
    json["on_front"] = point.on_front;
    return json;
}

constexpr double k_mebibyte = 1048576;

std::string label_of(const SweepPoint& point, const SweepPoint& reference) {
    const std::string words = difference_in_words(point.plan, reference.plan);
    return words.empty() ? std::string(name_of(point.plan.plan.structure)) : words;
}

const char* title_of(FrontError error) {
    switch (error) {
        case FrontError::mean:
            return "mean error";
        case FrontError::flip:
            return "mean FLIP";
        case FrontError::max:
            break;
    }
    return "largest error";
}

std::size_t rank_of(Structure structure) {
    std::size_t rank = 0;
    for (const auto& [value, name] : structure_names()) {
        if (value == structure) break;
        ++rank;
    }
    return rank;
}

}  // namespace

Chart scene_chart(const SceneResult& scene, FrontError front) {
    Chart chart;
    chart.title = scene.name;
    const auto measured =
        std::count_if(scene.points.begin(), scene.points.end(), [](const auto& p) { return p.refused.empty(); });
    chart.subtitle = fmt::format("{} plans, {}", measured,
                                 scene.rounds == 0   ? "not all of them timed more than once"
                                 : scene.rounds == 1 ? "1 round"
                                                     : fmt::format("{} rounds", scene.rounds));
    chart.x = {.title = title_of(front),
               .unit = front == FrontError::flip ? "" : "1/255",
               .scale = Scale::log,
               .zero_lane = true};
    chart.y = {.title = "time a frame", .unit = "ms", .scale = Scale::log};
    for (const auto& [structure, name] : structure_names()) {
        Series series{.name = std::string(name)};
        series.color = series_color(rank_of(structure));
        series.marker = series_marker(rank_of(structure));
        for (const SweepPoint& p : scene.points)
            if (p.refused.empty() && p.plan.plan.structure == structure)
                series.points.push_back({front_error(p, front), p.ms, "", p.ms_low, p.ms_high});
        if (!series.points.empty()) chart.series.push_back(std::move(series));
    }
    Series line{.name = "Pareto front",
                .marker = Marker::none,
                .color = glm::dvec3(0.1),
                .steps = true,
                .width = 1,
                .dashes = {4, 2}};
    for (const SweepPoint& p : scene.points)
        if (p.on_front) line.points.push_back({front_error(p, front), p.ms, label_of(p, scene.points.front())});
    std::sort(line.points.begin(), line.points.end(), [](const DataPoint& a, const DataPoint& b) { return a.x < b.x; });
    chart.series.push_back(std::move(line));
    if (front != FrontError::flip) chart.marks.push_back({AxisName::x, 1, "1 grey level", glm::dvec3(0.45)});
    if (const auto& fine = scene.of_reference.fine; fine && front_error({.plan = {}, .error = *fine}, front) > 0)
        chart.marks.push_back({AxisName::x,
                               front_error({.plan = {}, .error = *fine}, front),
                               "the reference itself",
                               glm::dvec3(0.65, 0.1, 0.1),
                               {1, 2}});
    return chart;
}

std::string sweep_json(const std::string& device, const std::vector<SceneResult>& scenes, FrontError front) {
    ordered_json list = ordered_json::array();
    for (const SceneResult& scene : scenes) {
        ordered_json points = ordered_json::array(), refused = ordered_json::array();
        for (const SweepPoint& p : scene.points) {
            if (p.refused.empty())
                points.push_back(json_of(p));
            else
                refused.push_back({{"plan", ordered_json::parse(to_json(p.plan))}, {"why", p.refused}});
        }
        list.push_back({{"name", scene.name},
                        {"command", scene.command},
                        {"reference", scene.reference},
                        {"rounds", scene.rounds},
                        {"reference_error", json_of(scene.of_reference)},
                        {"points", std::move(points)},
                        {"refused", std::move(refused)}});
    }
    const ordered_json json{{"device", device}, {"front_error", name_of(front)}, {"scenes", std::move(list)}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string sweep_table(const SceneResult& scene) {
    std::vector<const SweepPoint*> order;
    for (const SweepPoint& p : scene.points)
        if (p.refused.empty()) order.push_back(&p);
    std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->ms < b->ms; });
    std::string text = fmt::format("{}: {} plans, {} rounds; error against {}\n", scene.name, order.size(),
                                   scene.rounds, scene.reference);
    if (const auto& fine = scene.of_reference.fine)
        text += fmt::format("the reference itself: max {:.3g}/255, mean {:.3g}/255 from a 16 times finer step\n",
                            fine->max, fine->mean);
    if (!scene.of_reference.unmeasured.empty())
        text += "the reference itself, in part: " + scene.of_reference.unmeasured + "\n";
    text += fmt::format("  {:<11} {:<34} {:>8} {:>15} {:>9} {:>8} {:>7} {:>8} {:>7} {:>7}\n", "structure", "plan", "ms",
                        "quartiles", "build ms", "MiB", "max", "mean", "SSIM", "FLIP");
    for (const SweepPoint* p : order)
        text += fmt::format("{} {:<11} {:<34} {:>8.2f} {:>15} {:>9.1f} {:>8.1f} {:>7.3g} {:>8.2g} {:>7.4f} {:>7.2g}\n",
                            p->on_front ? '*' : ' ', name_of(p->plan.plan.structure),
                            difference_in_words(p->plan, scene.points.front().plan), p->ms,
                            fmt::format("{:.2f}-{:.2f}", p->ms_low, p->ms_high), p->build_ms,
                            double(p->bytes) / k_mebibyte, p->error.max, p->error.mean, p->error.ssim, p->error.flip);
    for (const SweepPoint& p : scene.points)
        if (!p.refused.empty()) {
            const std::string words = difference_in_words(p.plan, scene.points.front().plan);
            text += fmt::format("- {}{}{}: {}\n", name_of(p.plan.plan.structure), words.empty() ? "" : ", ", words,
                                p.refused);
        }
    return text;
}

ChartSheet sweep_chart(const std::string& device, const std::vector<SceneResult>& scenes, FrontError front) {
    ChartSheet sheet{.title = "Time against error", .subtitle = device};
    sheet.note =
        "Each point is one plan: mean over the views, median over rounds measured in turn, whiskers its quartiles. "
        "Lane 0: "
        "the same picture as brute force. Front: no other plan is both faster and more exact; labels say how its plans "
        "differ from brute force. \"The reference itself\": how far brute force is from a 16 times finer step.";
    for (const SceneResult& scene : scenes) sheet.charts.push_back(scene_chart(scene, front));
    sheet.columns = scenes.size() == 3 ? 3 : 2;
    return sheet;
}

}  // namespace lacuna
