#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/atomic_folder.h"
#include "core/chart/svg_text.h"
#include "core/inspect/report.h"
#include "core/inspect/report_text.h"
#include "core/io/dicom_capture_writer.h"
#include "core/io/dicom_seg_writer.h"
#include "core/io/dicom_source.h"
#include "core/io/dicom_sr_writer.h"
#include "core/io/dicom_uid.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_writer.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

constexpr const char* k_mark = "report.json";            // tells a report folder from any other
constexpr std::int64_t k_most_segment_bytes = 64 << 20;  // of all frames that defects have of their own
constexpr std::size_t k_most_segments = 65533;           // of the part and defects; two kinds may share one each

/// All that a report folder can hold, its mark first.
std::vector<std::string> report_files() {
    return {k_mark,        "report.html", "report.pdf", "defects.csv", "defects.stl",
            "labels.nrrd", "seg.dcm",     "sr.dcm",     "key.dcm"};
}

/// All defects' surfaces, one behind the other.
TriangleMesh all_surfaces(const Volume& volume, const PartAnalysis& analysis, const JobContext& job) {
    TriangleMesh all;
    for (const Defect& defect : analysis.defects) {
        const TriangleMesh one = defect_mesh(volume, analysis, defect.id, {job.stop, nullptr});
        const auto offset = std::uint32_t(all.vertices.size());
        all.vertices.insert(all.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (const auto& t : one.triangles) all.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
        job.checkpoint(defect.id, analysis.defects.size());
    }
    return all;
}

DicomProvenance provenance(const InspectionReport& report) {
    const std::size_t space = report.software.find(' ');
    DicomProvenance made;
    made.software = report.software.substr(0, space);
    made.version = space == std::string::npos ? "0" : report.software.substr(space + 1);
    made.title = report.scan.name;
    made.seed = report.scan.sha256 + "\n" + report.source->series_uid + "\n" + report.criteria.json;
    for (const HandDecision& word : report.judgement.by_hand)
        made.seed += "\n" + std::to_string(word.defect) + (word.accepted ? "+" : "-") + word.reason;
    return made;
}

/// Which defect has which segment. The part is the first; then the worst defects, one each, as long as their frames
/// stay within bounds; what is left shares a segment a kind.
struct Segments {
    std::vector<DicomSegment> list;
    std::vector<int> of_defect;  ///< by id - 1, from 1
};

Segments segments_of(const InspectionReport& report, const DicomProvenance& made) {
    const PartAnalysis& analysis = report.analysis;
    const glm::ivec3 n = analysis.labels.geometry.size;
    Segments segments;
    segments.of_defect.resize(analysis.defects.size());
    segments.list.push_back(
        {"Part", "part", "Material and the voids in it", {1}, glm::ivec3(0), n - 1, dicom::uid_for(made, "part")});
    std::int64_t bytes = 0;
    const std::int64_t frame = (std::int64_t(n.x) * n.y + 7) / 8;
    int rest[2] = {0, 0};  // segment numbers of what is left, by type
    for (const std::uint32_t id : worst_first(analysis, report.judgement)) {
        const Defect& defect = analysis.defects[id - 1];
        bytes += frame * (defect.bbox_last.z - defect.bbox_first.z + 1);
        const std::string type(name_of(defect.type));
        int& shared = rest[defect.type == DefectType::void_ ? 0 : 1];
        if (bytes <= k_most_segment_bytes && segments.list.size() < k_most_segments) {
            const std::string label = "Defect " + std::to_string(id);
            segments.list.push_back({label,
                                     type,
                                     std::string(name_of(report.judgement.defects[id - 1].verdict)),
                                     {id},
                                     defect.bbox_first,
                                     defect.bbox_last,
                                     dicom::uid_for(made, label)});
            segments.of_defect[id - 1] = int(segments.list.size());
            continue;
        }
        if (shared == 0) {
            segments.list.push_back({"Other defects: " + type,
                                     type,
                                     "Those of lesser size",
                                     {},
                                     defect.bbox_first,
                                     defect.bbox_last,
                                     dicom::uid_for(made, "others " + type)});
            shared = int(segments.list.size());
        }
        DicomSegment& others = segments.list[std::size_t(shared - 1)];
        others.ids.push_back(id);
        others.first = glm::min(others.first, defect.bbox_first);
        others.last = glm::max(others.last, defect.bbox_last);
        segments.of_defect[id - 1] = shared;
    }
    for (DicomSegment& segment : segments.list) std::sort(segment.ids.begin(), segment.ids.end());
    return segments;
}

std::vector<DicomMeasurementGroup> groups_of(const InspectionReport& report, const Segments& segments,
                                             const DicomProvenance& made) {
    std::vector<DicomMeasurementGroup> groups;
    const PartFacts& part = report.analysis.part;
    if (part.has_material && std::isfinite(part.part_volume_mm3.value))
        groups.push_back({"Part",
                          dicom::uid_for(made, "part"),
                          "part",
                          1,
                          {{DicomQuantity::volume_mm3, part.part_volume_mm3.value}},
                          {{"Volume interval", short_interval(part.part_volume_mm3) + " mm3"},
                           {"Porosity", short_interval(part.porosity_percent) + " %"}}});
    constexpr std::size_t k_most = 1000;  // readers unfold every group; the table holds them all
    for (const std::uint32_t id : worst_first(report.analysis, report.judgement)) {
        if (groups.size() > k_most) break;
        const Defect& d = report.analysis.defects[id - 1];
        const DefectJudgement& judged = report.judgement.defects[id - 1];
        const std::string label = "Defect " + std::to_string(id);
        DicomMeasurementGroup group{
            label, dicom::uid_for(made, label), std::string(name_of(d.type)), segments.of_defect[id - 1], {}, {}};
        if (d.measurable)
            group.measurements = {{DicomQuantity::volume_mm3, d.volume_mm3.value},
                                  {DicomQuantity::diameter_mm, d.diameter_mm.value},
                                  {DicomQuantity::equivalent_diameter_mm, d.equivalent_diameter_mm.value},
                                  {DicomQuantity::area_mm2, d.area_mm2.value}};
        group.measurements.push_back({DicomQuantity::surface_distance_mm, d.surface_distance_mm.value});
        group.measurements.push_back({DicomQuantity::mean_value, d.mean});
        group.said = {{"Verdict", std::string(name_of(judged.verdict))}, {"Why", valid_utf8(judged.why)}};
        if (d.measurable)
            group.said.push_back({"Volume interval", short_interval(d.volume_mm3) + " mm3"});
        else
            group.said.push_back({"Size", "detected, not measurable"});
        groups.push_back(std::move(group));
    }
    return groups;
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
    constexpr std::size_t k_most = 1000;  // a short text
    if (text.size() <= k_most) return valid_utf8(text);
    std::size_t end = k_most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // between two characters
    return valid_utf8(text.substr(0, end)) + " ...";
}

void write_dicom_files(const InspectionReport& report, const fs::path& folder, const JobContext& job) {
    const DicomSource& source = *report.source;
    const DicomProvenance made = provenance(report);
    const Segments segments = segments_of(report, made);
    write_dicom_segmentation(report.analysis.part_mask, report.analysis.labels, segments.list, source, made,
                             folder / "seg.dcm", job);
    write_dicom_report(
        groups_of(report, segments, made),
        {{"Verdict", std::string(name_of(report.judgement.verdict))}, {"Reasons", joined(report.judgement.reasons)}},
        report.scan.unit, source, made, folder / "sr.dcm");
    if (!report.key.rgb.empty()) write_dicom_capture(report.key.size, report.key.rgb, source, made, folder / "key.dcm");
}

}  // namespace

void check_report_folder(const fs::path& folder) { AtomicFolder::check(folder, report_files()); }

void write_report(const InspectionReport& report, const Volume& volume, const fs::path& folder, const JobContext& job) {
    AtomicFolder output(folder, report_files());
    const fs::path& to = output.path();
    write_labels(report.analysis.labels, to / "labels.nrrd", job.part(0, 0.2));
    write_mesh(all_surfaces(volume, report.analysis, job.part(0.2, 0.5)), to / "defects.stl");
    write_file(to / "defects.csv", defects_csv(report));
    write_file(to / "report.html", report_html(report));
    job.check();
    write_file(to / "report.pdf", report_pdf(report, {job.stop, nullptr}));
    if (report.source && !report.source->images.empty()) write_dicom_files(report, to, job.part(0.7, 0.95));
    write_file(to / k_mark, report_json(report));
    job.checkpoint(1, 1);  // the last moment at which a stop leaves nothing behind
    output.commit();
}

}  // namespace lacuna
