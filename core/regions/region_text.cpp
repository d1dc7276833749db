#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/csv.h"
#include "core/base/number_text.h"
#include "core/regions/regions.h"

namespace lacuna {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const RegionCharacteristics& row) {
    Json json;
    json["id"] = row.id;
    json["voxels"] = row.voxels;
    json["volume_mm3"] = row.volume_mm3;
    json["fraction"] = row.fraction;
    json["surface_mm2"] = row.surface_mm2;
    json["shape_factor"] = row.shape_factor;
    json["sphericity"] = row.sphericity;
    json["holes"] = row.holes;
    json["tunnels"] = row.tunnels;
    json["mean"] = row.mean;
    json["min"] = row.min;
    json["max"] = row.max;
    json["stddev"] = row.stddev;
    json["centroid_mm"] = json_of(row.centroid_mm);
    json["bbox_mm"] = Json::array({json_of(row.bbox_min_mm), json_of(row.bbox_max_mm)});
    json["equivalent_diameter_mm"] = row.equivalent_diameter_mm;
    json["principal_lengths_mm"] = json_of(row.principal_lengths_mm);
    json["touches_border"] = row.touches_border;
    json["euler"] = row.euler;
    json["flags"] = row.flags;
    json["surface_crofton_mm2"] = row.surface_crofton_mm2;
    json["surface_mesh_mm2"] = row.surface_mesh_mm2;
    json["diameter_mm"] = row.diameter_mm;
    json["projected_area_mm2"] = json_of(row.projected_area_mm2);
    json["integral_volume_mm3"] = row.integral_volume_mm3;
    json["surface_distance_mm"] = row.surface_distance_mm;
    json["gap_mm"] = row.gap_mm;
    json["volume_lo_mm3"] = row.volume_lo_mm3;
    json["volume_hi_mm3"] = row.volume_hi_mm3;
    json["gap_lo_mm"] = row.gap_lo_mm;
    json["gap_hi_mm"] = row.gap_hi_mm;
    return json;
}

std::string triple(const glm::dvec3& v) {
    return exact_number(v.x) + ' ' + exact_number(v.y) + ' ' + exact_number(v.z);
}

std::string flags_of(const RegionCharacteristics& row) {
    std::string all;
    for (const std::string& flag : row.flags) all += (all.empty() ? "" : ";") + flag;
    return csv_field(all);
}

constexpr const char* k_csv_header =
    "id,voxels,volume_mm3,fraction,surface_mm2,shape_factor,sphericity,holes,tunnels,mean,min,max,stddev,"
    "centroid_mm,bbox_mm,equivalent_diameter_mm,principal_lengths_mm,touches_border,euler,flags,"
    "centroid_mm_x,centroid_mm_y,centroid_mm_z,bbox_min_mm_x,bbox_min_mm_y,bbox_min_mm_z,"
    "bbox_max_mm_x,bbox_max_mm_y,bbox_max_mm_z,principal_lengths_mm_1,principal_lengths_mm_2,principal_lengths_mm_3,"
    "surface_crofton_mm2,surface_mesh_mm2,diameter_mm,projected_area_mm2,projected_area_mm2_x,projected_area_mm2_y,"
    "projected_area_mm2_z,integral_volume_mm3,surface_distance_mm,gap_mm,"
    "volume_lo_mm3,volume_hi_mm3,gap_lo_mm,gap_hi_mm\r\n";

void append_row(std::string& csv, const RegionCharacteristics& row) {
    const auto add = [&csv](std::string_view field) { csv.append(field).push_back(','); };
    add(fmt::format("{},{}", row.id, row.voxels));
    for (const double v : {row.volume_mm3, row.fraction, row.surface_mm2, row.shape_factor, row.sphericity})
        add(exact_number(v));
    add(fmt::format("{},{}", row.holes, row.tunnels));
    for (const double v : {row.mean, row.min, row.max, row.stddev}) add(exact_number(v));
    add(triple(row.centroid_mm));
    add(triple(row.bbox_min_mm) + ' ' + triple(row.bbox_max_mm));
    add(exact_number(row.equivalent_diameter_mm));
    add(triple(row.principal_lengths_mm));
    add(row.touches_border ? "true" : "false");
    add(fmt::format("{}", row.euler));
    add(flags_of(row));
    for (const glm::dvec3& v : {row.centroid_mm, row.bbox_min_mm, row.bbox_max_mm, row.principal_lengths_mm})
        for (int axis = 0; axis < 3; ++axis) add(exact_number(v[axis]));
    for (const double v : {row.surface_crofton_mm2, row.surface_mesh_mm2, row.diameter_mm}) add(exact_number(v));
    const glm::dvec3 shadow = row.projected_area_mm2;
    add(std::isfinite(shadow.x) ? triple(shadow) : "");
    for (const double v : {shadow.x, shadow.y, shadow.z, row.integral_volume_mm3, row.surface_distance_mm, row.gap_mm,
                           row.volume_lo_mm3, row.volume_hi_mm3, row.gap_lo_mm, row.gap_hi_mm})
        add(exact_number(v));
    csv.pop_back();
    csv += "\r\n";
}

}  // namespace

std::string regions_to_json(const RegionTable& table) {
    Json head;
    head["surface_method"] = table.surface_method;
    head["surface_mesh_method"] = table.mesh_method;
    head["adjacency"] = table.adjacency;
    head["value_range"] = Json::array({table.value_range.lo, table.value_range.hi});
    head["count"] = table.rows.size();
    // Row by row: a tree of a million rows would take many times the text's memory.
    std::string text = head.dump(1);
    text.resize(text.find_last_of('}'));
    while (!text.empty() && text.back() == '\n') text.pop_back();
    text += ",\n \"regions\": [";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        text += i ? ",\n  " : "\n  ";
        text += json_of(table.rows[i]).dump();
    }
    text += table.rows.empty() ? "]\n}\n" : "\n ]\n}\n";
    return text;
}

std::string regions_to_csv(const RegionTable& table) {
    std::string csv = k_csv_header;
    for (const RegionCharacteristics& row : table.rows) append_row(csv, row);
    return csv;
}

}  // namespace lacuna
