#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/inspect/criteria.h"
#include "core/inspect/part_analysis.h"
#include "core/inspect/verdict.h"
#include "core/volume/statistics.h"
#include "core/volume/volume.h"

namespace lacuna {

class Engine;
struct DicomSource;
struct OpenOptions;

/// A picture of a report: pixels, and how far they can be trusted.
struct ReportPicture {
    std::string caption;
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel, row 0 on top; empty: there is no picture
    std::string plan;               ///< how it was drawn
    std::string error;              ///< how far it is off, and against what
};

struct DefectPictures {
    std::uint32_t defect = 0;
    ReportPicture view;   ///< the part cut open at the defect
    ReportPicture slice;  ///< the voxels around it
};

/// What was inspected, free of any patient's identity.
struct ScanFacts {
    std::string name;    ///< of the part, for titles
    std::string input;   ///< file or folder name, without its folders
    std::string sha256;  ///< of the voxels
    GridGeometry geometry;
    VoxelType type = VoxelType::u8;
    std::string unit;
    ValueRange range{0, 0};
    std::vector<Warning> warnings;
    std::optional<DicomFacts> dicom;
};

/// A part inspected: the one value behind every file of the report folder. Free of clocks, host and folder names: the
/// same input, criteria and program make the same value.
struct InspectionReport {
    ScanFacts scan;
    PartAnalysis analysis;
    Criteria criteria;
    Judgement judgement;
    ReportPicture key;                          ///< the whole part, its worst defects marked
    std::vector<DefectPictures> worst;          ///< worst first
    std::string software;                       ///< "Lacuna 0.1.0"
    std::string replay;                         ///< the command that makes this report again
    std::shared_ptr<const DicomSource> source;  ///< the DICOM series inspected; none: no DICOM files are written
};

struct InspectOptions {
    std::string input;     ///< as the user named it
    std::string software;  ///< name and version
    std::string replay;    ///< command, without folder names
    std::vector<HandDecision> by_hand;
    int worst = 10;                             ///< defects that get pictures
    std::shared_ptr<const DicomSource> source;  ///< of find_dicom_source, where the volume came from DICOM
};

/// What a report calls its input: its last name, for folders differ from machine to machine and may name people; a
/// sample's whole name.
std::string last_name(const std::string& input);

/// The flags of `lacuna inspect` that open an input in this way, each after a blank; empty where all is as usual.
std::string open_flags(const OpenOptions& options);

/// Measures, judges and draws a part.
/// @param masks  of lay_zones(criteria, volume.geometry()): laid before, so that a bad zone costs no work
/// @throws what analyse_part, judge and Engine::render throw
InspectionReport inspect_part(const Volume& volume, const Criteria& criteria, std::span<const ZoneMask> masks,
                              Engine& engine, const InspectOptions& options, const JobContext& job = {});

/// Ids of the defects, worst first: fail, cannot tell, pass; by volume within each.
std::vector<std::uint32_t> worst_first(const PartAnalysis& analysis, const Judgement& judgement);

/// Draws the report's pictures; each with its plan, and its error against the reference renderer.
/// A part without material gets none but a slice through the volume's middle.
void draw_pictures(const Volume& volume, Engine& engine, int worst, InspectionReport& report,
                   const JobContext& job = {});

/// The defect table (RFC 4180, CRLF, dot decimals in every locale): the contract's row first, then the ends of the
/// intervals and each component of a vector in a column of its own.
std::string defects_csv(const InspectionReport& report);
/// docs/schemas/report.schema.json says what it holds.
std::string report_json(const InspectionReport& report);
/// Self-contained: styles, pictures and charts inside, no script but the table's sorting.
std::string report_html(const InspectionReport& report);
/// A4; table rows are never split and their header stands on every page. No date, so that equal reports are equal
/// bytes. @throws Error(cancelled)
std::string report_pdf(const InspectionReport& report, const JobContext& job = {});

/// Writes the whole folder beside its target and renames it: report.html, report.pdf, defects.csv, report.json,
/// labels.nrrd, defects.stl; for DICOM input also seg.dcm, sr.dcm and key.dcm. A report that stands there is replaced;
/// any other folder with files in it is refused.
/// @param volume  the one inspected: the defects' surfaces are made from its values
/// @throws Error(io), the target as it was; Error(cancelled)
void write_report(const InspectionReport& report, const Volume& volume, const std::filesystem::path& folder,
                  const JobContext& job = {});

/// Refuses a report folder that could not be written in the end. @throws Error(io)
void check_report_folder(const std::filesystem::path& folder);

}  // namespace lacuna
