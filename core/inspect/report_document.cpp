#include "core/inspect/report_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/inspect/report_text.h"

namespace lacuna {

namespace {

TableCell number_cell(double value) { return {short_number(value), value}; }
TableCell interval_cell(const Measured& value) { return {short_interval(value), value.value}; }
TableCell verdict_cell(Verdict verdict) {
    const double order = verdict == Verdict::fail ? 0 : verdict == Verdict::cannot_tell ? 1 : 2;
    return {std::string(name_of(verdict)), order, verdict};
}
std::string triple(const glm::dvec3& v) { return fmt::format("{:.4g}, {:.4g}, {:.4g}", v.x, v.y, v.z); }

Table facts_table(const std::vector<Fact>& facts) {
    Table table{{{"", 150}, {"", 365}}, {}, false};
    for (const Fact& fact : facts) table.rows.push_back({{fact.name}, {fact.value}});
    return table;
}

Table rules_table(const Judgement& judgement) {
    Table table{{{"Where", 70},
                 {"Rule", 105},
                 {"Verdict", 55},
                 {"Value [interval]", 110, true},
                 {"Limit", 60, true},
                 {"Decided by", 50},
                 {"Unit", 35}},
                {},
                false};
    for (const RuleResult& rule : judgement.rules)
        table.rows.push_back(
            {{rule.zone.empty() ? "part" : "zone " + rule.zone},
             {std::string(name_of(rule.rule))},
             verdict_cell(rule.verdict),
             interval_cell(rule.value),
             {fmt::format("{} {:g}", limits_from_above(rule.rule) ? "≤" : "≥", rule.limit), rule.limit},
             {rule.defect ? fmt::format("defect {}", rule.defect) : "part"},
             {std::string(unit_of(rule.rule))}});
    return table;
}

Table defects_table(const InspectionReport& report) {
    const std::string unit = report.scan.unit.empty() ? "" : " (" + report.scan.unit + ")";
    Table table{{{"Id", 26, true},
                 {"Type", 40},
                 {"Verdict", 48},
                 {"Why", 145},
                 {"Volume (mm³)", 82, true},
                 {"Voxels", 38, true},
                 {"Circumscribed diameter (mm)", 80, true},
                 {"Equivalent diameter (mm)", 80, true},
                 {"Sphericity", 48, true},
                 {"Shape factor", 46, true},
                 {"Distance to surface (mm)", 82, true},
                 {"Gap (mm)", 44, true},
                 {"Area (mm²)", 82, true},
                 {"Centre x, y, z (mm)", 92},
                 {"Box from (mm)", 92},
                 {"Box to (mm)", 92},
                 {"Principal lengths (mm)", 92},
                 {"Projected area x, y, z (mm²)", 92},
                 {"Mean value" + unit, 44, true},
                 {"Probability", 46, true},
                 {"Cavities, tunnels", 44},
                 {"Zones", 50},
                 {"Flags", 92}},
                {},
                true};
    for (const std::uint32_t id : worst_first(report.analysis, report.judgement)) {
        const Defect& d = report.analysis.defects[id - 1];
        const DefectJudgement& judged = report.judgement.defects[id - 1];
        std::string zones, flags = d.measurable ? "" : "detected, not measurable";
        for (const std::string& zone : judged.zones) zones += (zones.empty() ? "" : ", ") + zone;
        for (const std::string& flag : d.flags) flags += (flags.empty() ? "" : ", ") + flag;
        table.rows.push_back({{std::to_string(d.id), double(d.id)},
                              {std::string(name_of(d.type))},
                              verdict_cell(judged.verdict),
                              {judged.why},
                              d.measurable ? interval_cell(d.volume_mm3) : TableCell{"not measurable"},
                              {std::to_string(d.voxels), double(d.voxels)},
                              d.measurable ? interval_cell(d.diameter_mm) : TableCell{"not measurable"},
                              d.measurable ? interval_cell(d.equivalent_diameter_mm) : TableCell{"not measurable"},
                              number_cell(d.sphericity),
                              number_cell(d.shape_factor),
                              interval_cell(d.surface_distance_mm),
                              number_cell(d.gap_mm),
                              interval_cell(d.area_mm2),
                              {triple(d.centroid_mm), d.centroid_mm.x},
                              {triple(d.bbox_min_mm), d.bbox_min_mm.x},
                              {triple(d.bbox_max_mm), d.bbox_max_mm.x},
                              {triple(d.principal_lengths_mm), d.principal_lengths_mm.x},
                              {triple(d.projected_area_mm2), d.projected_area_mm2.x},
                              number_cell(d.mean),
                              {fmt::format("{:.3f}", d.probability), d.probability},
                              {fmt::format("{}, {}", d.cavities, d.tunnels)},
                              {zones},
                              {flags}});
    }
    return table;
}

Chart size_histogram(const PartAnalysis& analysis) {
    std::vector<double> sizes;
    for (const Defect& defect : analysis.defects)
        if (defect.measurable && std::isfinite(defect.equivalent_diameter_mm.value))
            sizes.push_back(defect.equivalent_diameter_mm.value);
    std::sort(sizes.begin(), sizes.end());
    Chart chart;
    chart.title = "Sizes of the defects";
    chart.subtitle = fmt::format("{} measurable of {}", sizes.size(), analysis.defects.size());
    chart.x.title = "equivalent diameter";
    chart.x.unit = "mm";
    chart.y.title = "defects";
    chart.legend = Legend::none;
    if (sizes.empty()) return chart;
    // Rice's rule, no bin narrower than a thousandth of the largest.
    const int bins = std::clamp(int(std::ceil(2 * std::cbrt(double(sizes.size())))), 4, 40);
    double lo = sizes.front(), hi = sizes.back();
    if (!(hi - lo > 1e-3 * hi)) lo = 0.9 * hi, hi = 1.1 * hi;
    Bars bars;
    for (int i = 0; i <= bins; ++i) bars.edges.push_back(lo + (hi - lo) * i / bins);
    bars.heights.assign(std::size_t(bins), 0);
    for (const double size : sizes)
        bars.heights[std::size_t(std::clamp(int((size - lo) / (hi - lo) * bins), 0, bins - 1))] += 1;
    chart.bars.push_back(std::move(bars));
    return chart;
}

/// One of the curve's quantities against the threshold.
/// @param title  names it; `axis` with `unit` stands at the axis
Chart stability_chart(const InspectionReport& report, const char* title, const char* axis, const char* unit,
                      const std::vector<double>& values) {
    const StabilityCurve& curve = report.analysis.stability;
    Chart chart;
    chart.title = title;
    chart.x.title = "threshold";
    chart.x.unit = report.scan.unit;
    chart.y.title = axis;
    chart.y.unit = unit;
    chart.legend = Legend::none;
    Series series;
    series.line = true;
    series.size = 3;
    for (std::size_t i = 0; i < std::min(curve.threshold.size(), values.size()); ++i)
        series.points.push_back({curve.threshold[i], values[i]});
    chart.series.push_back(std::move(series));
    if (curve.plateau.lo < curve.plateau.hi)
        chart.bands.push_back({AxisName::x, curve.plateau.lo, curve.plateau.hi, "stable"});
    if (std::isfinite(report.analysis.part.material_threshold))
        chart.marks.push_back({AxisName::x, report.analysis.part.material_threshold, "used"});
    return chart;
}

void add_pictures(const InspectionReport& report, ReportDocument& document) {
    if (!report.key.rgb.empty()) document.blocks.push_back(PictureRow{{report.key}});
    ChartRow charts;
    if (!report.analysis.defects.empty()) charts.charts.push_back(size_histogram(report.analysis));
    if (!report.analysis.stability.threshold.empty()) {
        const StabilityCurve& curve = report.analysis.stability;
        charts.charts.push_back(
            stability_chart(report, "Porosity against threshold", "porosity", "%", curve.porosity_percent));
        charts.charts.push_back(stability_chart(report, "Defect count against threshold", "defects", "", curve.count));
        charts.charts.push_back(
            stability_chart(report, "Euler number against threshold", "Euler number of the voids", "", curve.euler));
    }
    if (!charts.charts.empty()) {
        document.blocks.push_back(Heading{"Sizes and stability"});
        document.blocks.push_back(std::move(charts));
    }
    if (report.worst.empty()) return;
    document.blocks.push_back(Heading{
        report.worst.size() == 1 ? "The worst defect" : fmt::format("The {} worst defects", report.worst.size())});
    for (const DefectPictures& pair : report.worst) {
        const Defect& d = report.analysis.defects[pair.defect - 1];
        const DefectJudgement& judged = report.judgement.defects[pair.defect - 1];
        document.blocks.push_back(Paragraph{fmt::format(
            "Defect {} ({}): {}; volume {} mm³, diameter {} mm, {} mm below the surface. {}", d.id, name_of(d.type),
            name_of(judged.verdict), d.measurable ? short_interval(d.volume_mm3) : "not measurable",
            d.measurable ? short_interval(d.diameter_mm) : "not measurable", short_interval(d.surface_distance_mm),
            judged.why)});
        document.blocks.push_back(PictureRow{{pair.view, pair.slice}});
    }
}

Table errors_table(const InspectionReport& report) {
    Table table{{{"Picture", 70}, {"Plan", 235}, {"Error", 210}}, {}, false};
    const auto add = [&table](const std::string& name, const ReportPicture& picture) {
        if (!picture.rgb.empty()) table.rows.push_back({{name}, {picture.plan}, {picture.error}});
    };
    add("part", report.key);
    for (const DefectPictures& pair : report.worst) {
        add(fmt::format("defect {}", pair.defect), pair.view);
        add(fmt::format("slice of {}", pair.defect), pair.slice);
    }
    return table;
}

std::string banner_text(Verdict verdict) {
    if (verdict == Verdict::pass) return "PASS";
    return verdict == Verdict::fail ? "FAIL" : "CANNOT TELL";
}

std::string pretty_criteria(const Criteria& criteria) {
    if (criteria.json.empty()) return "{}";
    return nlohmann::ordered_json::parse(criteria.json).dump(1);
}

}  // namespace

glm::dvec3 verdict_color(Verdict verdict) {
    if (verdict == Verdict::fail) return {0.72, 0.11, 0.11};
    return verdict == Verdict::pass ? glm::dvec3(0.08, 0.46, 0.22) : glm::dvec3(0.66, 0.40, 0.0);
}

ReportDocument document_of(const InspectionReport& report) {
    ReportDocument document{"Inspection of " + report.scan.name, report.software, {}};
    auto& blocks = document.blocks;
    const Judgement& judgement = report.judgement;
    blocks.push_back(Banner{judgement.verdict, banner_text(judgement.verdict), judgement.reasons});
    if (!judgement.rules.empty()) {
        blocks.push_back(Heading{"Rules"});
        blocks.push_back(rules_table(judgement));
    }
    for (const HandDecision& word : judgement.by_hand)
        blocks.push_back(Paragraph{fmt::format("Defect {} was {} by hand: {}", word.defect,
                                               word.accepted ? "accepted" : "rejected", word.reason)});
    blocks.push_back(Heading{"Part"});
    blocks.push_back(facts_table(part_facts(report)));
    blocks.push_back(Heading{"Scan"});
    blocks.push_back(facts_table(scan_facts(report)));
    add_pictures(report, document);
    blocks.push_back(Heading{fmt::format("All defects ({})", report.analysis.defects.size())});
    if (report.analysis.defects.empty())
        blocks.push_back(Paragraph{"None was found."});
    else
        blocks.push_back(defects_table(report));
    blocks.push_back(Heading{"Criteria"});
    blocks.push_back(Paragraph{pretty_criteria(report.criteria), true});
    if (!report.key.rgb.empty()) {
        blocks.push_back(Heading{"How the pictures were drawn, and how far they are off"});
        blocks.push_back(errors_table(report));
    }
    blocks.push_back(Heading{"To make this report again"});
    blocks.push_back(Paragraph{report.replay, true});
    blocks.push_back(Paragraph{
        "Made by " + report.software +
        ". The same input, criteria and version give the same bytes, on the same kind of device. Values stand with the "
        "interval their true value is taken to lie in, [from, to]. Not a medical device."});
    return document;
}

std::string report_html(const InspectionReport& report) { return to_html(document_of(report)); }

std::string report_pdf(const InspectionReport& report, const JobContext& job) {
    return to_pdf(document_of(report), job);
}

}  // namespace lacuna
