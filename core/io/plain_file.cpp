#include "core/io/plain_file.h"

#include "core/base/error.h"
#include "core/io/dicom_reader.h"
#include "core/io/header_check.h"
#include "core/io/itk_reader.h"
#include "core/io/raw_reader.h"
#include "core/io/text_fields.h"
#include "core/io/tiff_reader.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

std::string ending_of(const fs::path& file) {
    const std::string name = lower_case(file.filename().string());
    if (name.ends_with(".nii.gz")) return ".nii.gz";
    return lower_case(file.extension().string());
}

}  // namespace

FileFormat format_by_name(const fs::path& file) {
    const std::string ending = ending_of(file);
    static const std::pair<std::string_view, FileFormat> k_endings[] = {
        {".mhd", FileFormat::meta_image}, {".mha", FileFormat::meta_image}, {".nrrd", FileFormat::nrrd},
        {".nhdr", FileFormat::nrrd},      {".nii", FileFormat::nifti},      {".nii.gz", FileFormat::nifti},
        {".hdr", FileFormat::nifti},      {".tif", FileFormat::tiff},       {".tiff", FileFormat::tiff},
        {".raw", FileFormat::raw},        {".img", FileFormat::raw},        {".vol", FileFormat::raw},
        {".dat", FileFormat::dat},        {".vgi", FileFormat::vgi}};
    FileFormat format = FileFormat::dicom;
    for (const auto& [text, k] : k_endings)
        if (ending == text) format = k;
    return format;
}

FileFormat format_of(const fs::path& file, const OpenOptions& options) {
    if (!options.raw.empty()) return FileFormat::raw;
    const FileFormat format = format_by_name(file);
    // Scanners name DICOM files as they please, some of them .img or .dat.
    const bool doubtful = format == FileFormat::raw || format == FileFormat::dat || ending_of(file) == ".hdr";
    if (doubtful && looks_like_dicom(file)) return FileFormat::dicom;
    return format;
}

namespace {

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code ec;
    return fs::equivalent(a, b, ec) && !ec;
}

/// How to read a raw file without --raw: by a layout, from a sidecar or its own name; or, where the sidecar is one ITK
/// reads, by that.
struct RawSource {
    std::optional<RawLayout> layout;
    fs::path header = {};
    ItkFormat format = ItkFormat::meta_image;  ///< of the header
};

/// Nothing where neither a sidecar nor the name says it.
std::optional<RawSource> described_raw(const fs::path& file) {
    std::error_code ec;
    const auto beside = [&](const char* ending) { return fs::path(file).replace_extension(ending); };
    if (fs::is_regular_file(beside(".mhd"), ec) && same_file(meta_image_data_file(beside(".mhd")), file))
        return RawSource{std::nullopt, beside(".mhd")};
    if (const fs::path header = nifti_pair_header(file); !header.empty())
        return RawSource{std::nullopt, header, ItkFormat::nifti};
    for (const fs::path& sidecar : {beside(".vgi"), fs::path(file.string() + ".vgi")})
        if (fs::is_regular_file(sidecar, ec))
            if (const RawLayout layout = read_vgi(sidecar); same_file(layout.file, file)) return RawSource{layout};
    for (const fs::path& sidecar : {beside(".dat"), fs::path(file.string() + ".dat")})
        if (fs::is_regular_file(sidecar, ec) && !looks_like_dicom(sidecar))
            if (const RawLayout layout = read_dat(sidecar); same_file(layout.file, file)) return RawSource{layout};
    if (auto named = raw_layout_of_name(file)) return RawSource{named};
    return std::nullopt;
}

RawSource raw_source(const fs::path& file) {
    if (auto found = described_raw(file)) return *found;
    throw Error(Errc::bad_input,
                "Cannot read " + file.string() +
                    ": it is raw, and neither a sidecar (.dat, .vgi, .mhd, .hdr) nor its name says its size; "
                    "give --raw WxHxD:TYPE[:SX,SY,SZ][:be][:+OFFSET].");
}

RawSource raw_source(const fs::path& file, FileFormat format, const OpenOptions& options) {
    if (format == FileFormat::dat) return {read_dat(file)};
    if (format == FileFormat::vgi) return {read_vgi(file)};
    if (options.raw.empty()) return raw_source(file);
    RawLayout layout = parse_raw_text(options.raw);
    layout.file = file;
    return {layout};
}

ItkFormat itk_format(FileFormat format) {
    if (format == FileFormat::meta_image) return ItkFormat::meta_image;
    return format == FileFormat::nrrd ? ItkFormat::nrrd : ItkFormat::nifti;
}

/// Bytes of voxels of the smallest type there is, or of a known one. @throws Error(bad_input) where they overflow
std::uint64_t bytes_of(const fs::path& path, const glm::ivec3& size, std::size_t word = 1) {
    return checked_bytes(path.string(), size.x, size.y, size.z, word);
}

std::vector<fs::path> tiff_files(const fs::path& path) {
    std::error_code ec;
    return fs::is_directory(path, ec) ? tiff_stack(path) : std::vector<fs::path>{path};
}

}  // namespace

void refuse_folder(const std::string& input) {
    throw Error(Errc::bad_input, "Cannot read " + input + ": the folder holds no DICOM images and no TIFF slices.");
}

void require_bytes(const fs::path& file) {
    std::error_code ec;
    if (fs::is_regular_file(file, ec) && fs::file_size(file, ec) == 0)
        throw Error(Errc::bad_input, "Cannot read " + file.string() + ": it is empty (0 bytes); copy it again.");
}

bool needs_raw_layout(const fs::path& file) {
    std::error_code ec;
    if (format_by_name(file) != FileFormat::raw || !fs::is_regular_file(file, ec)) return false;
    if (format_of(file, {}) != FileFormat::raw || described_raw(file)) return false;
    require_bytes(file);
    return true;
}

glm::ivec3 plain_size(const fs::path& file, FileFormat format) {
    if (format == FileFormat::tiff) return tiff_size({file});
    if (format == FileFormat::raw || format == FileFormat::dat || format == FileFormat::vgi) {
        const RawSource source = raw_source(file, format, {});
        return source.layout ? source.layout->geometry.size : itk_volume_size(source.header, source.format);
    }
    return itk_volume_size(file, itk_format(format));
}

Volume read_plain(const fs::path& path, FileFormat format, const OpenOptions& options,
                  const std::function<void(std::uint64_t)>& room, const JobContext& job) {
    if (format == FileFormat::tiff) {
        const auto files = tiff_files(path);
        if (files.empty()) refuse_folder(path.string());
        if (room) room(bytes_of(path, tiff_size(files)));
        return read_tiff(files, job);
    }
    if (format == FileFormat::meta_image || format == FileFormat::nrrd || format == FileFormat::nifti)
        return read_itk_volume(path, itk_format(format), job, room);
    const RawSource source = raw_source(path, format, options);
    if (!source.layout) return read_itk_volume(source.header, source.format, job, room);
    if (room) room(bytes_of(path, source.layout->geometry.size, size_of(source.layout->type)));
    return read_raw(*source.layout, job);
}

std::optional<Volume> open_plain_in_parts(const fs::path& path, FileFormat format, const OpenOptions& options) {
    if (format == FileFormat::meta_image || format == FileFormat::nrrd)
        return open_itk_volume(path, itk_format(format));
    if (format != FileFormat::raw && format != FileFormat::dat && format != FileFormat::vgi) return std::nullopt;
    const RawSource source = raw_source(path, format, options);
    return source.layout ? open_raw(*source.layout) : open_itk_volume(source.header, source.format);
}

}  // namespace lacuna
