#include <cmath>
#include <nlohmann/json.hpp>

#include "core/inspect/criteria.h"

namespace lacuna {

namespace {

using Json = nlohmann::ordered_json;

/// Whole numbers without ".0", as people write them.
Json number(double value) {
    constexpr double k_exact = 9007199254740992.0;  // 2^53: up to there every whole double is that integer
    if (std::trunc(value) == value && std::abs(value) <= k_exact) return Json(std::int64_t(value));
    return Json(value);
}

Json limits_json(const Limits& limits) {
    Json json = Json::object();
    for (const Rule rule : k_rules)
        if (limits[rule])
            json[std::string(name_of(rule))] =
                rule == Rule::count ? Json(std::int64_t(std::llround(*limits[rule]))) : number(*limits[rule]);
    return json;
}

Json zone_json(const Zone& zone) {
    Json json{{"name", zone.name}};
    if (zone.is_box)
        json["box_mm"] = {{number(zone.box_min_mm.x), number(zone.box_min_mm.y), number(zone.box_min_mm.z)},
                          {number(zone.box_max_mm.x), number(zone.box_max_mm.y), number(zone.box_max_mm.z)}};
    else
        json["labels"] = zone.labels.string();
    if (zone.label) json["label"] = *zone.label;
    json["limits"] = limits_json(zone.limits);
    return json;
}

}  // namespace

std::string criteria_to_json(const Criteria& criteria) {
    const DetectionOptions& o = criteria.detection;
    Json json{{"material", o.material ? Json{number(o.material->lo), number(o.material->hi)} : Json("auto")}};
    Json defects = Json::object();
    if (o.voids) defects["void"] = o.void_below ? Json{{"below", number(*o.void_below)}} : Json("auto");
    if (o.inclusions)
        defects["inclusion"] = o.inclusion_above ? Json{{"above", number(*o.inclusion_above)}} : Json("auto");
    json["defects"] = std::move(defects);
    json["min_voxels"] = o.min_voxels;
    json["method"] = name_of(o.method);
    json["connectivity"] = int(o.connectivity);
    json["limits"] = limits_json(criteria.limits);
    if (!criteria.zones.empty()) json["zones"] = Json::array();
    for (const Zone& zone : criteria.zones) json["zones"].push_back(zone_json(zone));
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace lacuna
