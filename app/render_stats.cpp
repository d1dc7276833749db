#include "app/render_stats.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

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

ordered_json plan_json(const Scene& scene, const Plan& plan) {
    return {{"mode", std::string(name_of(scene.mode))},
            {"structure", std::string(name_of(plan.structure))},
            {"step", plan.step},
            {"sampler", std::string(name_of(plan.sampler))},
            {"gradient", fmt::format("{},{}", name_of(plan.gradient), name_of(plan.gradient_store))},
            {"integration", std::string(name_of(plan.integration))},
            {"refine", std::string(name_of(plan.refine))},
            {"refine_steps", plan.refine_steps},
            {"ert", plan.ert},
            {"sparse", plan.sparse >= 2 ? ordered_json(plan.sparse) : ordered_json(nullptr)},
            {"sparse_gradient", plan.sparse >= 2 ? ordered_json(plan.sparse_gradient) : ordered_json(nullptr)},
            {"sparse_aware", plan.sparse >= 2 && plan.sparse_aware},
            {"cells", plan.cells},
            {"directions", plan.directions},
            {"voxel_gradient", std::string(name_of(plan.voxel_gradient))},
            {"homogeneity", plan.homogeneity},
            {"homogeneity_angle", plan.homogeneity_angle_deg},
            {"brick", plan.brick > 0 ? ordered_json(plan.brick) : ordered_json(nullptr)},
            {"why", plan.why}};
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
    const std::size_t half = ms.size() / 2;
    const double median = ms.size() % 2 ? ms[half] : 0.5 * (ms[half - 1] + ms[half]);
    return {{"min", ms.front()}, {"median", median}, {"max", ms.back()}};
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
                      {"plan", plan_json(scene, plan)},
                      {"build", build},
                      {"frames", frames},
                      {"ms", times_json(record.frames)}};
    if (record.bricks) json["bricks"] = bricks_json(*record.bricks);
    json["error"] = nullptr;
    if (record.error)  // what is infinite (PSNR of equal pictures) becomes null
        json["error"] = {
            {"reference", record.error->reference}, {"max", record.error->max},
            {"mean", record.error->mean},           {"psnr", record.error->psnr},
            {"ssim", record.error->ssim},           {"pixels_over_budget", record.error->pixels_over_budget}};
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string error_text(const ImageError& error) {
    return fmt::format("max error {:.3g}/255, mean {:.3g}/255, PSNR {:.1f} dB, SSIM {:.5f}, {} pixels over 1/255",
                       error.max, error.mean, error.psnr, error.ssim, error.pixels_over_budget);
}

}  // namespace lacuna::cli
