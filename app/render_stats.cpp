#include "app/render_stats.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/order_statistics.h"
#include "core/render/plan_json.h"

namespace lacuna::cli {

namespace {

using nlohmann::ordered_json;

ordered_json vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

ordered_json input_json(const Volume& volume) {
    const GridGeometry& g = volume.geometry();
    return {{"dims", {g.size.x, g.size.y, g.size.z}},
            {"spacing", vector_json(g.spacing)},
            {"type", std::string(name_of(volume.type()))},
            {"bytes", volume.total_bytes()},
            {"unit", volume.unit}};
}

ordered_json view_json(const Scene& scene) {
    ordered_json ranges = ordered_json::array(), cuts = ordered_json::array();
    for (const SegmentationRange& r : scene.classification.ranges) ranges.push_back({r.range.lo, r.range.hi});
    for (const CuttingPlane& c : scene.cuts)
        cuts.push_back({{"plane", {c.normal.x, c.normal.y, c.normal.z, c.offset}}, {"cap", c.cap}});
    const Camera& camera = scene.camera;
    ordered_json view{{"azimuth", camera.azimuth_deg},
                      {"elevation", camera.elevation_deg},
                      {"roll", camera.roll_deg},
                      {"zoom", camera.zoom},
                      {"center", vector_json(camera.center_mm.value_or(scene.volume.geometry().centre_mm()))}};
    view["perspective"] = camera.fov_deg ? ordered_json(*camera.fov_deg) : ordered_json();
    view["size"] = {scene.size.x, scene.size.y};
    view["iso"] = scene.iso;
    view["tf"] = scene.classification.tf.name;
    view["ranges"] = ranges;
    view["cuts"] = cuts;
    view["shading"] = std::string(name_of(scene.shading));
    view["window"] = {scene.window.lo, scene.window.hi};
    view["effects"] = ordered_json::array();
    for (const Effect& effect : scene.effects)
        view["effects"].push_back({{"name", std::string(name_of(effect.kind))}, {"values", effect.values}});
    return view;
}

ordered_json bricks_json(const BrickCounts& b) {
    return {{"total", b.total},   {"empty", b.empty},           {"hidden", b.hidden},        {"uniform", b.uniform},
            {"loaded", b.loaded}, {"bytes_read", b.bytes_read}, {"bytes_peak", b.bytes_peak}};
}

ordered_json times_json(const std::vector<FrameRecord>& frames) {
    std::vector<double> ms;
    for (const FrameRecord& frame : frames) ms.push_back(frame.ms);
    std::sort(ms.begin(), ms.end());
    if (ms.empty()) return nullptr;
    return {{"min", ms.front()}, {"median", median(ms)}, {"max", ms.back()}};
}

}  // namespace

std::string stats_json(const Scene& scene, const Plan& plan, const RenderRecord& record) {
    ordered_json build = ordered_json::object(), frames = ordered_json::array();
    for (const auto& [structure, made] : record.build) build[structure] = {{"ms", made.ms}, {"bytes", made.bytes}};
    for (const FrameRecord& f : record.frames)
        frames.push_back({{"azimuth", f.azimuth_deg},
                          {"ms", f.ms},
                          {"rays", f.counters.rays},
                          {"samples", f.counters.samples},
                          {"skipped", f.counters.skipped},
                          {"structure_reads", f.counters.structure_reads},
                          {"trilinear", f.counters.trilinear}});
    ordered_json json{{"device", record.device},
                      {"input", input_json(scene.volume)},
                      {"view", view_json(scene)},
                      {"plan", ordered_json::parse(to_json({scene.mode, plan}))},
                      {"build", build},
                      {"frames", frames},
                      {"ms", times_json(record.frames)}};
    if (record.bricks) json["bricks"] = bricks_json(*record.bricks);
    json["error"] = nullptr;
    if (record.error)  // what is infinite (PSNR of equal pictures) becomes null
        json["error"] = {{"reference", record.error->reference},
                         {"max", record.error->max},
                         {"mean", record.error->mean},
                         {"psnr", record.error->psnr},
                         {"ssim", record.error->ssim},
                         {"flip", record.error->flip},
                         {"pixels_over_budget", record.error->pixels_over_budget}};
    if (record.surface)
        json["error"]["surface"] = {
            {"max_voxels", record.surface->max_voxels}, {"mean_voxels", record.surface->mean_voxels},
            {"rms_voxels", record.surface->rms_voxels}, {"missed", record.surface->missed},
            {"false_hits", record.surface->false_hits}, {"over_one_voxel", record.surface->over_one_voxel}};
    if (record.projection)
        json["error"]["projection"] = {{"max_undershoot", record.projection->max_undershoot},
                                       {"mean_undershoot", record.projection->mean_undershoot},
                                       {"max_overshoot", record.projection->max_overshoot},
                                       {"pixels", record.projection->pixels}};
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string error_text(const RenderRecord& record) {
    const ImageError& error = *record.error;
    std::string text = fmt::format(
        "max error {:.3g}/255, mean {:.3g}/255, PSNR {:.1f} dB, SSIM {:.5f}, FLIP {:.2g}, {} pixels over {:g}/255",
        error.max, error.mean, error.psnr, error.ssim, error.flip, error.pixels_over_budget, record.error_allowed);
    if (const auto& surface = record.surface)
        text += fmt::format("; depth max {:.3g}, mean {:.2g} voxels, {} silhouette pixels missed, {} false",
                            surface->max_voxels, surface->mean_voxels, surface->missed, surface->false_hits);
    if (const auto& projection = record.projection)
        text += fmt::format("; values at most {:.3g} short, {:.2g} on average, at most {:.3g} beyond",
                            projection->max_undershoot, projection->mean_undershoot, projection->max_overshoot);
    return text;
}

}  // namespace lacuna::cli
