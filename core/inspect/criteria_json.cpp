#include <cmath>
#include <nlohmann/json.hpp>

#include "core/inspect/criteria.h"

namespace lacuna {

namespace {

using Json = nlohmann::ordered_json;

Json limits_json(const Limits& limits) {
    Json json = Json::object();
    for (const Rule rule : k_rules)
        if (limits[rule])
            json[std::string(name_of(rule))] =
                rule == Rule::count ? Json(std::int64_t(std::llround(*limits[rule]))) : Json(*limits[rule]);
    return json;
}

Json zone_json(const Zone& zone) {
    Json json{{"name", zone.name}};
    if (zone.is_box)
        json["box_mm"] = {{zone.box_min_mm.x, zone.box_min_mm.y, zone.box_min_mm.z},
                          {zone.box_max_mm.x, zone.box_max_mm.y, zone.box_max_mm.z}};
    else
        json["labels"] = zone.labels.string();
    if (zone.label) json["label"] = *zone.label;
    json["limits"] = limits_json(zone.limits);
    return json;
}

}  // namespace

std::string criteria_to_json(const Criteria& criteria) {
    const DetectionOptions& o = criteria.detection;
    Json json{{"material", o.material ? Json{o.material->lo, o.material->hi} : Json("auto")}};
    Json defects = Json::object();
    if (o.voids) defects["void"] = o.void_below ? Json{{"below", *o.void_below}} : Json("auto");
    if (o.inclusions) defects["inclusion"] = o.inclusion_above ? Json{{"above", *o.inclusion_above}} : Json("auto");
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
