#include <filesystem>
#include <memory>

#include "core/base/number_text.h"
#include "core/base/shell_word.h"
#include "core/inspect/report.h"
#include "core/io/volume_reader.h"

namespace lacuna {

std::string last_name(const std::string& input) {
    if (input.starts_with("sample:")) return input;
    std::filesystem::path path(input);
    if (!path.has_filename()) path = path.parent_path();
    return path.filename().string();
}

std::string open_flags(const OpenOptions& options) {
    std::string flags;
    if (!options.raw.empty()) flags += " --raw " + shell_word(options.raw);
    if (!options.series.empty()) flags += " --series " + shell_word(options.series);
    if (const auto& s = options.spacing_mm)
        flags += " --spacing " + exact_number(s->x) + "," + exact_number(s->y) + "," + exact_number(s->z);
    if (options.keep_gaps) flags += " --keep-gaps";
    return flags;
}

namespace {

ScanFacts facts_of(const Volume& volume, const std::string& input, const JobContext& job) {
    ScanFacts facts;
    facts.input = last_name(input);
    facts.name = volume.name.empty() ? facts.input : volume.name;
    if (volume.dicom)
        for (const auto& [key, value] : volume.dicom->component)
            if (key == "name" && !value.empty()) facts.name = value;
    facts.geometry = volume.geometry();
    facts.type = volume.type();
    facts.unit = volume.unit;
    facts.warnings = volume.warnings;
    facts.dicom = volume.dicom;
    facts.sha256 = voxel_sha256(volume, job.part(0, 0.6));
    facts.range = compute_statistics(volume, job.part(0.6, 1)).range;
    return facts;
}

}  // namespace

InspectionReport inspect_part(const Volume& volume, const Criteria& criteria, std::span<const ZoneMask> masks,
                              Engine& engine, const InspectOptions& options, const JobContext& job) {
    InspectionReport report;
    report.criteria = criteria;
    report.software = options.software;
    report.replay = options.replay;
    report.source = options.source;
    report.scan = facts_of(volume, options.input, job.part(0, 0.05));
    report.analysis = analyse_part(volume, criteria.detection, job.part(0.05, 0.7));
    // A volume without a part may come back without labels; what is written is never missing.
    const auto voxels = std::size_t(volume.geometry().voxel_count());
    if (!report.analysis.labels.labels)
        report.analysis.labels = {volume.geometry(), std::make_shared<std::vector<std::uint32_t>>(voxels)};
    if (!report.analysis.part_mask.labels)
        report.analysis.part_mask = {volume.geometry(), std::make_shared<std::vector<std::uint8_t>>(voxels)};
    report.judgement = judge(report.analysis, criteria, masks, options.by_hand, job.part(0.7, 0.72));
    draw_pictures(volume, engine, options.worst, report, job.part(0.72, 1));
    return report;
}

}  // namespace lacuna
