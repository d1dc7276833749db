#include "core/io/dicom_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/axis_rule.h"
#include "core/io/dicom_pixels.h"
#include "core/io/dicom_resample.h"
#include "core/io/dicom_series.h"
#include "core/io/dicom_source.h"
#include "core/io/dicom_stack.h"
#include "core/io/folder_listing.h"
#include "core/io/random_access_file.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;
using namespace dicom;

constexpr double k_untagged_padding_hu = -1500;  // no tissue, no air: CT values below were never measured
constexpr std::size_t k_most_named = 8;

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < k_most_named; ++i) text += (i ? ", " : "") + names[i];
    return names.size() > k_most_named ? text + ", ..." : text;
}

SeriesEntry make_entry(SeriesScan scan, int number) {
    SeriesEntry entry;
    const File& first = scan.file_of(scan.slices.front());
    entry.number = number;
    entry.description = first.description;
    entry.uid = scan.uid;
    entry.modality = first.modality;
    entry.slices = int(scan.slices.size());
    entry.size = {first.pixels.columns, first.pixels.rows, entry.slices};
    for (const File& file : scan.files) entry.files.push_back(file.path);
    entry.scan = std::make_shared<const SeriesScan>(std::move(scan));
    return entry;
}

[[noreturn]] void throw_nothing_found(const fs::path& input, std::size_t files,
                                      const std::vector<std::string>& unreadable,
                                      const std::vector<std::string>& locked, std::size_t without_image) {
    const std::string where = input.string();
    std::error_code ignored;
    const bool folder = fs::is_directory(input, ignored);
    if (!locked.empty())
        throw Error(Errc::io,
                    "No DICOM image could be opened under " + where + ": permission denied for " + listed(locked) +
                        "; ask for the right to read it.",
                    where);
    if (folder && files == 0)
        throw Error(Errc::bad_input, "The folder " + where + " is empty; name one that holds DICOM images.", where);
    if (!unreadable.empty())
        throw Error(Errc::bad_input,
                    "Cannot read " + where + ": the DICOM header of " + listed(unreadable) +
                        " is cut short or damaged; copy or export the files again.",
                    where);
    if (folder)
        throw Error(Errc::bad_input, "The folder " + where + " holds no DICOM images; name one that does.", where);
    throw Error(Errc::bad_input,
                where + (without_image ? " is DICOM but holds no image; name one that does."
                                       : " is no DICOM file; name a DICOM image or a folder of them."),
                where);
}

std::vector<SeriesEntry> scan_files(const fs::path& input, const FolderListing& listing, const JobContext& job) {
    const std::vector<fs::path>& paths = listing.files;
    std::vector<HeaderResult> headers(paths.size());
    parallel_for(
        0, std::int64_t(paths.size()),
        [&](std::int64_t i) {
            try {
                headers[std::size_t(i)] = read_header(paths[std::size_t(i)]);
            } catch (const Error& error) {
                if (error.code() != Errc::io || paths.size() == 1) throw;
                headers[std::size_t(i)].what = FileClass::locked;  // one such file does not hide a folder
                headers[std::size_t(i)].file.path = paths[std::size_t(i)];
            }
        },
        job);
    std::vector<File> images;
    std::vector<std::string> unreadable, locked = listing.locked;
    std::size_t without_image = 0;
    for (HeaderResult& header : headers) {
        if (header.what == FileClass::image) images.push_back(std::move(header.file));
        if (header.what == FileClass::unreadable) unreadable.push_back(header.file.name());
        if (header.what == FileClass::locked) locked.push_back(header.file.name());
        without_image += header.what == FileClass::no_image;
    }
    if (images.empty()) throw_nothing_found(input, paths.size(), unreadable, locked, without_image);
    std::vector<SeriesEntry> entries;
    for (SeriesScan& scan : group_series(std::move(images))) {
        scan.unreadable = unreadable;
        scan.locked = locked;
        entries.push_back(make_entry(std::move(scan), int(entries.size()) + 1));
    }
    return entries;
}

/// The entry's headers: those its scan left, or parsed anew for an entry made by hand.
std::shared_ptr<const SeriesScan> scan_of(const SeriesEntry& series, const JobContext& job) {
    if (series.scan) return series.scan;
    if (series.files.empty()) throw Error(Errc::bad_input, "The series names no files.");
    auto found = scan_files(series.files.front().parent_path(), {series.files}, job);
    const auto largest =
        std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.slices < b.slices; });
    return largest->scan;
}

void refuse_faults(const SeriesScan& scan) {
    for (const Frame& slice : scan.slices) {
        const File& file = scan.file_of(slice);
        if (!file.fault.empty())
            throw Error(file.unsupported ? Errc::unsupported : Errc::bad_input,
                        "Cannot read " + file.path.string() + ": " + file.fault + ".", file.path.string());
    }
}

std::string unit_of(const File& file, const Frame& slice) {
    const bool plain = slice.rescale_type.empty() || slice.rescale_type == "HU";
    if (file.modality == "CT" && slice.has_rescale && plain) return "HU";
    return slice.rescale_type == "US" ? "" : slice.rescale_type;  // US: unspecified
}

DicomFacts facts_of(const SeriesScan& scan, const StackPlan& plan) {
    const Frame& slice = scan.slices[plan.order.front()];
    const File& file = scan.file_of(slice);
    DicomFacts facts;
    facts.modality = file.modality;
    facts.description = file.description;
    facts.transfer_syntax = file.syntax_name + " (" + file.syntax_uid + ")";
    facts.photometric_interpretation = file.pixels.photometric;
    facts.series_uid = file.series_uid;
    facts.slices_found = int(scan.slices.size());
    facts.slices_used = int(plan.order.size());
    facts.slices_missing = plan.missing;
    for (const std::size_t s : plan.duplicates) facts.duplicates.push_back(scan.name_of(scan.slices[s]));
    facts.slice_spacing_min_mm = plan.spacing_min_mm;
    facts.slice_spacing_max_mm = plan.spacing_max_mm;
    facts.gantry_tilt_deg = plan.tilt_deg;
    facts.window_center = slice.window_center;
    facts.window_width = slice.window_width;
    facts.component = file.component;
    return facts;
}

void add_warnings(std::vector<Warning>& warnings, const SeriesScan& scan, const LoadedSlices& loaded) {
    if (!scan.set_aside.empty())
        warnings.push_back(
            {fmt::format("{} images beside the series (localizers, other sizes or orientations) are set "
                         "aside: {}.",
                         scan.set_aside.size(), listed(scan.set_aside))});
    if (!scan.unreadable.empty())
        warnings.push_back({fmt::format("{} DICOM files with a damaged header are left out: {}.",
                                        scan.unreadable.size(), listed(scan.unreadable))});
    if (!scan.locked.empty())
        warnings.push_back(
            {fmt::format("{} files or folders may not be opened (permission denied) and are left out: {}.",
                         scan.locked.size(), listed(scan.locked))});
    const auto longer = std::count_if(scan.files.begin(), scan.files.end(), [](const File& file) {
        const auto bits = std::uint64_t(file.pixels.pixels()) * std::uint64_t(file.pixels.bits_allocated);
        return file.direct && file.pixel_bytes > (bits * file.frames.size() + 7) / 8 + 1;  // padded to an even length
    });
    if (longer > 0)
        warnings.push_back(
            {fmt::format("{} of {} files hold more pixels than rows, columns and frames say; check that the picture is "
                         "whole and not skewed.",
                         longer, scan.files.size())});
    if (loaded.padding_voxels > 0)
        warnings.push_back(
            {fmt::format("{} voxels are padding, not measured; they hold the smallest measured value {:g}.",
                         loaded.padding_voxels, loaded.range.lo)});
    if (loaded.rounded)
        warnings.push_back(
            {fmt::format("Values up to {:.0f} exceed what 32-bit floating point holds exactly and are "
                         "rounded.",
                         std::max(std::abs(loaded.range.lo), std::abs(loaded.range.hi)))});
}

/// Values that must not be interpolated with tissue: tagged padding, and in CT what lies below any air.
AirRule air_rule(const LoadedSlices& loaded, const std::string& unit) {
    AirRule rule{loaded.range.lo, loaded.range.lo, loaded.padding_voxels > 0};
    if (unit == "HU" && loaded.range.lo < k_untagged_padding_hu) rule = {k_untagged_padding_hu, loaded.range.lo, true};
    return rule;
}

}  // namespace

bool looks_like_dicom(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return false;
    std::array<std::byte, 256> start{};
    const RandomAccessFile bytes(file);
    const std::size_t got = bytes.read(0, start);
    const std::string_view text(reinterpret_cast<const char*>(start.data()), got);
    if (!starts_like_dicom(text)) return false;
    if (got >= 132 && text.substr(128, 4) == "DICM") return true;
    return read_header(file).what != FileClass::not_dicom;
}

std::vector<SeriesEntry> find_dicom_series(const fs::path& input, const JobContext& job) {
    return scan_files(input, files_under(input, job), job);
}

Volume read_dicom_series(const SeriesEntry& series, const OpenOptions& options, const JobContext& job) {
    const auto scan = scan_of(series, job);
    refuse_faults(*scan);
    std::vector<std::string> names;
    for (const Frame& slice : scan->slices) names.push_back(scan->name_of(slice));
    const File& first = scan->file_of(scan->slices.front());
    const glm::ivec2 size(first.pixels.columns, first.pixels.rows);
    StackPlan plan = plan_stack(scan->slices, size, names);
    if (options.keep_gaps && !plan.missing.empty())
        throw Error(Errc::bad_input, "The series has gaps: " + plan.missing_text +
                                         "; add the missing files, or open it without --keep-gaps to have them "
                                         "interpolated.");

    // Slices that stay as they are go straight to their planes; the others are resampled from a dense stack.
    std::vector<int> dense(plan.order.size());
    std::iota(dense.begin(), dense.end(), 0);
    const bool direct = !plan.resampled();
    LoadedSlices loaded = load_slices(*scan, plan.order, direct ? plan.planes : dense,
                                      direct ? plan.grid.size.z : int(dense.size()), job.part(0, direct ? 0.95 : 0.6));
    const Frame& slice = scan->slices[plan.order.front()];
    const std::string unit = unit_of(scan->file_of(slice), slice);
    const AirRule air = air_rule(loaded, unit);
    const JobContext rest = job.part(direct ? 0.95 : 0.6, 1);
    if (direct)
        fill_missing_planes(loaded.voxels, loaded.type, plan, air, rest);
    else
        loaded.voxels = resample_slices(loaded.voxels, loaded.type, size, plan, air, rest);
    job.checkpoint(1, 1);

    const File& file = scan->file_of(slice);
    plan.grid.axis_names = axis_names_of({FileFormat::dicom, {}, slice.has_orientation, !file.component.empty()});
    Volume volume(plan.grid, loaded.type, std::move(loaded.voxels));
    volume.name =
        series.description.empty() ? "series " + std::to_string(std::max(1, series.number)) : series.description;
    volume.unit = unit;
    volume.warnings = plan.warnings;
    add_warnings(volume.warnings, *scan, loaded);
    volume.dicom = facts_of(*scan, plan);
    return volume;
}

std::shared_ptr<const DicomSource> dicom_source_of(const SeriesEntry& series, const JobContext& job) {
    const auto scan = scan_of(series, job);
    refuse_faults(*scan);
    const File& first = scan->file_of(scan->slices.front());
    std::vector<std::string> names;
    for (const Frame& slice : scan->slices) names.push_back(scan->name_of(slice));
    const StackPlan plan = plan_stack(scan->slices, {first.pixels.columns, first.pixels.rows}, names);
    auto source = std::make_shared<DicomSource>();
    source->study_uid = first.study_uid;
    source->series_uid = first.series_uid;
    source->frame_of_reference_uid = first.frame_of_reference_uid;
    for (std::size_t i = 0; i < plan.order.size(); ++i) {
        const Frame& slice = scan->slices[plan.order[i]];
        const File& file = scan->file_of(slice);
        const double plane = slice.position ? plan.grid.mm_to_voxel(*slice.position).z : double(i);
        source->images.push_back({file.path, file.sop_class_uid, file.sop_instance_uid,
                                  file.frames.size() > 1 ? slice.number + 1 : 0, plane});
    }
    return source;
}

}  // namespace lacuna
