#include <fmt/format.h>

#include "core/inspect/report_text.h"

namespace lacuna {

namespace {

std::string triple(const glm::dvec3& v) {
    return exact_number(v.x) + ' ' + exact_number(v.y) + ' ' + exact_number(v.z);
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : ";") + word;
    return all;
}

constexpr const char* k_header =
    "id,type,volume_mm3,voxels,centroid_mm,bbox_mm,diameter_mm,equivalent_diameter_mm,sphericity,shape_factor,"
    "surface_distance_mm,gap_mm,projected_area_mm2,mean_value,probability,verdict,why,"
    "volume_lo_mm3,volume_hi_mm3,diameter_lo_mm,diameter_hi_mm,equivalent_diameter_lo_mm,equivalent_diameter_hi_mm,"
    "surface_distance_lo_mm,surface_distance_hi_mm,centroid_x_mm,centroid_y_mm,centroid_z_mm,"
    "bbox_min_x_mm,bbox_min_y_mm,bbox_min_z_mm,bbox_max_x_mm,bbox_max_y_mm,bbox_max_z_mm,"
    "principal_length_1_mm,principal_length_2_mm,principal_length_3_mm,"
    "projected_area_x_mm2,projected_area_y_mm2,projected_area_z_mm2,area_mm2,area_lo_mm2,area_hi_mm2,"
    "surface_crofton_mm2,surface_mesh_mm2,voxel_volume_mm3,integral_volume_mm3,threshold_value,"
    "min_value,max_value,stddev_value,value_unit,euler,cavities,tunnels,measurable,touches_border,zones,flags\r\n";

void append_row(std::string& csv, const Defect& d, const DefectJudgement& judged, const std::string& unit) {
    const auto add = [&csv](const std::string& field) { csv.append(csv_field(field)).push_back(','); };
    const auto add_all = [&add](std::initializer_list<double> values) {
        for (const double v : values) add(exact_number(v));
    };
    add(std::to_string(d.id));
    add(std::string(name_of(d.type)));
    add(exact_number(d.volume_mm3.value));
    add(std::to_string(d.voxels));
    add(triple(d.centroid_mm));
    add(triple(d.bbox_min_mm) + ' ' + triple(d.bbox_max_mm));
    add_all({d.diameter_mm.value, d.equivalent_diameter_mm.value, d.sphericity, d.shape_factor,
             d.surface_distance_mm.value, d.gap_mm});
    add(triple(d.projected_area_mm2));
    add_all({d.mean, d.probability});
    add(std::string(name_of(judged.verdict)));
    add(judged.why);
    for (const Measured& m : {d.volume_mm3, d.diameter_mm, d.equivalent_diameter_mm, d.surface_distance_mm})
        add_all({m.lo, m.hi});
    for (const glm::dvec3& v :
         {d.centroid_mm, d.bbox_min_mm, d.bbox_max_mm, d.principal_lengths_mm, d.projected_area_mm2})
        add_all({v.x, v.y, v.z});
    add_all({d.area_mm2.value, d.area_mm2.lo, d.area_mm2.hi, d.surface_crofton_mm2, d.surface_mesh_mm2,
             d.voxel_volume_mm3, d.integral_volume_mm3, d.threshold, d.min, d.max, d.stddev});
    add(unit);
    for (const std::int64_t n : {d.euler, d.cavities, d.tunnels}) add(std::to_string(n));
    add(d.measurable ? "true" : "false");
    add(d.touches_border ? "true" : "false");
    add(joined(judged.zones));
    add(joined(d.flags));
    csv.pop_back();
    csv += "\r\n";
}

}  // namespace

std::string defects_csv(const InspectionReport& report) {
    std::string csv = k_header;
    for (std::size_t i = 0; i < report.analysis.defects.size(); ++i)
        append_row(csv, report.analysis.defects[i], report.judgement.defects[i], report.scan.unit);
    return csv;
}

}  // namespace lacuna
