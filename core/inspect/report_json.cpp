#include <cmath>
#include <nlohmann/json.hpp>

#include "core/inspect/report_text.h"

namespace lacuna {

namespace {

using Json = nlohmann::ordered_json;

/// NaN and infinity have no number in JSON: null stands for both.
Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json json_of(const glm::dvec3& v) { return Json::array({json_of(v.x), json_of(v.y), json_of(v.z)}); }
Json json_of(const Measured& m) {
    return Json{{"value", json_of(m.value)}, {"lo", json_of(m.lo)}, {"hi", json_of(m.hi)}};
}

Json json_of(const ScanFacts& scan) {
    const GridGeometry& g = scan.geometry;
    Json json{{"name", scan.name},
              {"input", scan.input},
              {"sha256", scan.sha256},
              {"dims", {g.size.x, g.size.y, g.size.z}},
              {"spacing_mm", json_of(g.spacing)},
              {"origin_mm", json_of(g.origin)},
              {"direction", Json::array({json_of(g.direction[0]), json_of(g.direction[1]), json_of(g.direction[2])})},
              {"scalar", std::string(name_of(scan.type))},
              {"unit", scan.unit},
              {"range", Json::array({json_of(scan.range.lo), json_of(scan.range.hi)})}};
    json["warnings"] = Json::array();
    for (const Warning& w : scan.warnings)
        json["warnings"].push_back({{"text", w.text}, {"max_error_mm", json_of(w.max_error_mm)}});
    json["dicom"] = nullptr;
    if (scan.dicom) {
        Json component = Json::object();
        for (const auto& [name, value] : scan.dicom->component) component[name] = value;
        json["dicom"] = Json{{"modality", scan.dicom->modality},
                             {"description", scan.dicom->description},
                             {"series_uid", scan.dicom->series_uid},
                             {"slices_found", scan.dicom->slices_found},
                             {"slices_used", scan.dicom->slices_used},
                             {"slices_missing", scan.dicom->slices_missing},
                             {"component", component}};
    }
    return json;
}

Json json_of(const PartFacts& part) {
    return Json{{"has_material", part.has_material},
                {"cut_by_frame", part.cut_by_frame},
                {"porosity_percent", json_of(part.porosity_percent)},
                {"part_volume_mm3", json_of(part.part_volume_mm3)},
                {"material_volume_mm3", json_of(part.material_volume_mm3)},
                {"material_threshold", json_of(part.material_threshold)},
                {"void_level", json_of(part.void_level)},
                {"material_level", json_of(part.material_level)},
                {"noise", json_of(part.noise)},
                {"edge_width_mm", json_of(part.edge_width_mm)},
                {"bbox_mm", Json::array({json_of(part.bbox_min_mm), json_of(part.bbox_max_mm)})},
                {"warnings", part.warnings}};
}

Json json_of(const RuleResult& rule) {
    return Json{{"zone", rule.zone.empty() ? Json() : Json(rule.zone)},
                {"rule", std::string(name_of(rule.rule))},
                {"unit", std::string(unit_of(rule.rule))},
                {"verdict", std::string(name_of(rule.verdict))},
                {"value", json_of(rule.value)},
                {"limit", rule.limit},
                {"defect", rule.defect ? Json(rule.defect) : Json()},
                {"why", rule.why}};
}

Json json_of(const Defect& d, const DefectJudgement& judged) {
    return Json{{"id", d.id},
                {"type", std::string(name_of(d.type))},
                {"volume_mm3", json_of(d.volume_mm3)},
                {"voxels", d.voxels},
                {"centroid_mm", json_of(d.centroid_mm)},
                {"bbox_mm", Json::array({json_of(d.bbox_min_mm), json_of(d.bbox_max_mm)})},
                {"diameter_mm", json_of(d.diameter_mm)},
                {"equivalent_diameter_mm", json_of(d.equivalent_diameter_mm)},
                {"sphericity", json_of(d.sphericity)},
                {"shape_factor", json_of(d.shape_factor)},
                {"surface_distance_mm", json_of(d.surface_distance_mm)},
                {"gap_mm", json_of(d.gap_mm)},
                {"projected_area_mm2", json_of(d.projected_area_mm2)},
                {"mean_value", json_of(d.mean)},
                {"probability", json_of(d.probability)},
                {"verdict", std::string(name_of(judged.verdict))},
                {"why", judged.why},
                {"zones", judged.zones},
                {"principal_lengths_mm", json_of(d.principal_lengths_mm)},
                {"area_mm2", json_of(d.area_mm2)},
                {"voxel_volume_mm3", json_of(d.voxel_volume_mm3)},
                {"integral_volume_mm3", json_of(d.integral_volume_mm3)},
                {"threshold_value", json_of(d.threshold)},
                {"surface_crofton_mm2", json_of(d.surface_crofton_mm2)},
                {"surface_mesh_mm2", json_of(d.surface_mesh_mm2)},
                {"min_value", json_of(d.min)},
                {"max_value", json_of(d.max)},
                {"stddev_value", json_of(d.stddev)},
                {"euler", d.euler},
                {"cavities", d.cavities},
                {"tunnels", d.tunnels},
                {"measurable", d.measurable},
                {"touches_border", d.touches_border},
                {"flags", d.flags}};
}

Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double v : values) list.push_back(json_of(v));
    return list;
}

Json json_of(const StabilityCurve& curve) {
    const bool plateau = curve.plateau.lo <= curve.plateau.hi && !curve.threshold.empty();
    return Json{{"threshold", numbers(curve.threshold)},
                {"porosity_percent", numbers(curve.porosity_percent)},
                {"count", numbers(curve.count)},
                {"euler", numbers(curve.euler)},
                {"plateau", plateau ? Json::array({curve.plateau.lo, curve.plateau.hi}) : Json()}};
}

Json json_of(const ReportPicture& picture, const std::string& what, std::uint32_t defect) {
    return Json{{"what", what},
                {"defect", defect ? Json(defect) : Json()},
                {"caption", picture.caption},
                {"size", {picture.size.x, picture.size.y}},
                {"plan", picture.plan},
                {"error", picture.error}};
}

Json pictures_of(const InspectionReport& report) {
    Json list = Json::array();
    if (!report.key.rgb.empty()) list.push_back(json_of(report.key, "part", 0));
    for (const DefectPictures& pair : report.worst) {
        list.push_back(json_of(pair.view, "view", pair.defect));
        list.push_back(json_of(pair.slice, "slice", pair.defect));
    }
    return list;
}

Json json_of(const Judgement& judgement) {
    Json json{{"verdict", std::string(name_of(judgement.verdict))}, {"reasons", judgement.reasons}};
    json["rules"] = Json::array();
    for (const RuleResult& rule : judgement.rules) json["rules"].push_back(json_of(rule));
    json["by_hand"] = Json::array();
    for (const HandDecision& word : judgement.by_hand)
        json["by_hand"].push_back(
            {{"defect", word.defect}, {"decision", word.accepted ? "accepted" : "rejected"}, {"reason", word.reason}});
    return json;
}

}  // namespace

std::string report_json(const InspectionReport& report) {
    Json head{{"software", report.software}, {"replay", report.replay}};
    const Json judged = json_of(report.judgement);
    for (const auto& [key, value] : judged.items()) head[key] = value;
    head["scan"] = json_of(report.scan);
    head["part"] = json_of(report.analysis.part);
    head["criteria"] = report.criteria.json.empty() ? Json::object() : Json::parse(report.criteria.json);
    head["surface_method"] = report.analysis.surface_method;
    head["adjacency"] = report.analysis.adjacency;
    head["stability"] = json_of(report.analysis.stability);
    head["pictures"] = pictures_of(report);
    head["count"] = report.analysis.defects.size();
    // Row by row: a tree of a million rows would take many times the text's memory.
    constexpr auto k_replace = Json::error_handler_t::replace;
    std::string text = head.dump(1, ' ', false, k_replace);
    text.resize(text.find_last_of('}'));
    while (!text.empty() && text.back() == '\n') text.pop_back();
    text += ",\n \"defects\": [";
    for (std::size_t i = 0; i < report.analysis.defects.size(); ++i) {
        text += i ? ",\n  " : "\n  ";
        text += json_of(report.analysis.defects[i], report.judgement.defects[i]).dump(-1, ' ', false, k_replace);
    }
    text += report.analysis.defects.empty() ? "]\n}\n" : "\n ]\n}\n";
    return text;
}

}  // namespace lacuna
