#include "core/inspect/report_text.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {

std::string short_number(double value) {
    if (std::isnan(value)) return "not measurable";
    if (std::isinf(value)) return value > 0 ? "none" : "-inf";
    return fmt::format("{:.4g}", value);
}

std::string short_interval(const Measured& value) {
    if (std::isnan(value.value)) return short_number(value.value);
    if (value.lo == value.hi) return short_number(value.value);
    return fmt::format("{:.4g} [{:.4g}, {:.4g}]", value.value, value.lo, value.hi);
}

/// "name" -> "Component name"; DICOM's "MaterialGrade" -> "Component material grade", "ComponentShape" -> "Component
/// shape".
static std::string component_label(std::string_view name) {
    if (name.starts_with("Component")) name.remove_prefix(9);
    std::string label = "Component";
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool starts_word = name[i] >= 'A' && name[i] <= 'Z';
        if (starts_word || i == 0) label += ' ';
        label += starts_word ? char(name[i] - 'A' + 'a') : name[i];
    }
    return label;
}

std::vector<Fact> scan_facts(const InspectionReport& report) {
    const ScanFacts& scan = report.scan;
    const GridGeometry& g = scan.geometry;
    const std::string unit = scan.unit.empty() ? "" : " " + scan.unit;
    std::vector<Fact> facts{
        {"Input", scan.input},
        {"Voxels", fmt::format("{} x {} x {}, {}", g.size.x, g.size.y, g.size.z, name_of(scan.type))},
        {"Spacing", fmt::format("{:.6g} x {:.6g} x {:.6g} mm", g.spacing.x, g.spacing.y, g.spacing.z)},
        {"Origin", fmt::format("{:.6g}, {:.6g}, {:.6g} mm", g.origin.x, g.origin.y, g.origin.z)},
        {"Values", fmt::format("{:.6g} to {:.6g}{}", scan.range.lo, scan.range.hi, unit)},
        {"SHA-256 of the voxels", scan.sha256}};
    if (scan.dicom) {
        const DicomFacts& dicom = *scan.dicom;
        for (const auto& [name, value] : dicom.component)
            if (!value.empty()) facts.push_back({component_label(name), value});
        facts.push_back({"Modality", dicom.modality});
        if (!dicom.description.empty()) facts.push_back({"Series", dicom.description});
        facts.push_back({"Series UID", dicom.series_uid});
        facts.push_back({"Slices", fmt::format("{} found, {} used, {} missing", dicom.slices_found, dicom.slices_used,
                                               dicom.slices_missing.size())});
    }
    for (const Warning& warning : scan.warnings) facts.push_back({"Warning", warning.text});
    return facts;
}

std::vector<Fact> part_facts(const InspectionReport& report) {
    const PartFacts& part = report.analysis.part;
    const std::string unit = report.scan.unit.empty() ? "" : " " + report.scan.unit;
    std::vector<Fact> facts;
    if (part.has_material) {
        facts = {{"Porosity", short_interval(part.porosity_percent) + " %"},
                 {"Part volume", short_interval(part.part_volume_mm3) + " mm³"},
                 {"Material volume", short_number(part.material_volume_mm3) + " mm³"},
                 {"Defects", std::to_string(report.analysis.defects.size())},
                 {"Material from", short_number(part.material_threshold) + unit},
                 {"Level of voids, of material",
                  short_number(part.void_level) + ", " + short_number(part.material_level) + unit},
                 {"Noise (standard deviation)", short_number(part.noise) + unit},
                 {"Edge width (sigma)", short_number(part.edge_width_mm) + " mm"},
                 {"Part from, to", fmt::format("({:.5g}, {:.5g}, {:.5g}), ({:.5g}, {:.5g}, {:.5g}) mm",
                                               part.bbox_min_mm.x, part.bbox_min_mm.y, part.bbox_min_mm.z,
                                               part.bbox_max_mm.x, part.bbox_max_mm.y, part.bbox_max_mm.z)}};
        facts.push_back({"Surfaces by", report.analysis.surface_method});
        facts.push_back({"Adjacency", report.analysis.adjacency});
    }
    facts.push_back({"Material found", part.has_material ? "yes" : "no"});
    facts.push_back({"Cut by the frame", part.cut_by_frame ? "yes" : "no"});
    for (const std::string& warning : part.warnings) facts.push_back({"Warning", warning});
    return facts;
}

}  // namespace lacuna
