#include "core/io/volume_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "core/base/error.h"
#include "core/io/axis_rule.h"
#include "core/io/dicom_writer.h"
#include "core/io/nifti_writer.h"
#include "core/io/output_file.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "voxels are written as they lie in memory");

namespace {

constexpr const char* k_known_endings = ".nrrd, .mhd, .nii, .nii.gz, .raw, or a folder name for a DICOM series";

std::span<const std::byte> bytes_of(const Volume& volume) { return {volume.data(), volume.bytes()}; }

std::string row_of(const glm::dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }

/// NRRD 4 with gzip data behind the header (teem's format definition). `space` is LPS, our own axes: of a part, too, as
/// readers place a file by it; a key of our own says that they are called X, Y, Z.
std::string nrrd_header(const GridGeometry& g, std::string_view type, std::string_view encoding) {
    std::string directions;
    for (int a = 0; a < 3; ++a) {
        const glm::dvec3 step = g.direction[a] * g.spacing[a];
        directions += fmt::format("{}({},{},{})", a ? " " : "", step.x, step.y, step.z);
    }
    return fmt::format(
        "NRRD0004\n# Complete NRRD file format specification at:\n# http://teem.sourceforge.net/nrrd/format.html\n"
        "type: {}\ndimension: 3\nspace: left-posterior-superior\nsizes: {} {} {}\nspace directions: {}\n"
        "kinds: domain domain domain\nendian: little\nencoding: {}\nspace origin: ({},{},{})\n{}\n",
        type, g.size.x, g.size.y, g.size.z, directions, encoding, g.origin.x, g.origin.y, g.origin.z,
        g.axis_names == AxisNames::xyz ? fmt::format("{}:={}\n", k_axes_key, k_axes_xyz) : "");
}

std::string_view nrrd_type(VoxelType type) {
    switch (type) {
        case VoxelType::u8:
            return "uint8";
        case VoxelType::i8:
            return "int8";
        case VoxelType::u16:
            return "uint16";
        case VoxelType::i16:
            return "int16";
        case VoxelType::f32:
            break;
    }
    return "float";
}

void write_nrrd(const GridGeometry& geometry, std::string_view type, std::span<const std::byte> voxels,
                const fs::path& target, const JobContext& job) {
    OutputFile file(target);
    file.write(nrrd_header(geometry, type, "gzip"));
    write_gzip(file, {}, voxels, job);
    file.commit();
}

/// All voxels as they are, of a volume in memory or not: the latter slab by slab.
void write_voxels(OutputFile& file, const Volume& volume, const JobContext& job) {
    if (volume.in_memory()) return write_plain(file, bytes_of(volume), job);
    constexpr std::uint64_t k_slab_bytes = std::uint64_t(64) << 20;
    constexpr int k_granule = 8;  // samples are painted in blocks of as many voxels
    const glm::ivec3 size = volume.geometry().size;
    const std::uint64_t row = std::uint64_t(size.x) * size_of(volume.type()), slice = row * std::uint64_t(size.y);
    // Whole slices, several at a time; of a slice too large for that, whole rows.
    const int slices = int(std::clamp<std::uint64_t>(k_slab_bytes / slice / k_granule * k_granule, 1, 1 << 16));
    const int rows = slices > 1 ? size.y : int(std::clamp<std::uint64_t>(k_slab_bytes / row, 1, std::uint64_t(size.y)));
    std::vector<std::byte> slab;
    for (int z = 0; z < size.z; z += slices)
        for (int y = 0; y < size.y; y += rows) {
            const VoxelBox box{{0, y, z}, {size.x, std::min(rows, size.y - y), std::min(slices, size.z - z)}};
            slab.resize(std::size_t(box.voxels()) * size_of(volume.type()));
            read_box(volume, box, slab.data(), {job.stop, nullptr});
            file.write(slab);
            job.checkpoint(std::size_t(z) * std::size_t(size.y) + std::size_t((y + box.size.y) * box.size.z),
                           std::size_t(size.z) * std::size_t(size.y));
        }
    job.check();
}

/// NRRD of a volume that does not lie in memory: not packed, so that it can be opened in parts again.
void write_nrrd_in_parts(const Volume& volume, const fs::path& target, const JobContext& job) {
    OutputFile file(target);
    file.write(nrrd_header(volume.geometry(), nrrd_type(volume.type()), "raw"));
    write_voxels(file, volume, job);
    file.commit();
}

std::string_view meta_type(VoxelType type) {
    switch (type) {
        case VoxelType::u8:
            return "MET_UCHAR";
        case VoxelType::i8:
            return "MET_CHAR";
        case VoxelType::u16:
            return "MET_USHORT";
        case VoxelType::i16:
            return "MET_SHORT";
        case VoxelType::f32:
            break;
    }
    return "MET_FLOAT";
}

std::string meta_header(const Volume& volume, const std::string& data_file) {
    const GridGeometry& g = volume.geometry();
    return fmt::format(
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
        "TransformMatrix = {} {} {}\nOffset = {}\nCenterOfRotation = 0 0 0\nAnatomicalOrientation = {}\n"
        "ElementSpacing = {}\nDimSize = {} {} {}\nElementType = {}\nElementDataFile = {}\n",
        row_of(g.direction[0]), row_of(g.direction[1]), row_of(g.direction[2]), row_of(g.origin),
        g.axis_names == AxisNames::patient ? "RAI" : "???", row_of(g.spacing), g.size.x, g.size.y, g.size.z,
        meta_type(volume.type()), data_file);
}

std::string_view dat_format(VoxelType type) {
    switch (type) {
        case VoxelType::u8:
            return "UCHAR";
        case VoxelType::i8:
            return "CHAR";
        case VoxelType::u16:
            return "USHORT";
        case VoxelType::i16:
            return "SHORT";
        case VoxelType::f32:
            break;
    }
    return "FLOAT";
}

/// The volvis sidecar. Origin and direction are our addition, written only where they say something.
std::string dat_header(const Volume& volume, const std::string& data_file) {
    const GridGeometry& g = volume.geometry();
    std::string text = fmt::format(
        "ObjectFileName: {}\nTaggedFileName: ---\nResolution: {} {} {}\nSliceThickness: {}\nFormat: {}\nNbrTags: 0\n"
        "ObjectType: TEXTURE_VOLUME_OBJECT\nObjectModel: I\nGridType: EQUIDISTANT\n",
        data_file, g.size.x, g.size.y, g.size.z, row_of(g.spacing), dat_format(volume.type()));
    if (g.origin != glm::dvec3(0)) text += "Origin: " + row_of(g.origin) + "\n";
    if (g.direction != glm::dmat3(1))
        text +=
            "Direction: " + row_of(g.direction[0]) + " " + row_of(g.direction[1]) + " " + row_of(g.direction[2]) + "\n";
    return text;
}

/// Writes data and header; both lie whole beside their targets before the first is renamed.
void write_pair(const Volume& volume, const fs::path& data, const fs::path& header, const std::string& header_text,
                const JobContext& job) {
    OutputFile voxels(data), text(header);
    write_voxels(voxels, volume, job);
    text.write(header_text);
    voxels.commit();
    text.commit();
}

/// The file written beside the one named must not replace one that belongs to something else, such as the input.
void check_companion(const fs::path& target, const fs::path& companion) {
    std::error_code ec;
    if (fs::exists(companion, ec) && !fs::exists(target, ec))
        throw Error(Errc::io, "Cannot write " + target.string() + ": it needs " + companion.filename().string() +
                                  " beside it, and there is such a file already; choose another name.");
}

void write_meta(const Volume& volume, const fs::path& target, const JobContext& job) {
    const fs::path data = fs::path(target).replace_extension(".raw");
    check_companion(target, data);
    write_pair(volume, data, target, meta_header(volume, data.filename().string()), job);
}

void write_raw(const Volume& volume, const fs::path& target, const JobContext& job) {
    check_companion(target, fs::path(target).replace_extension(".dat"));
    write_pair(volume, target, fs::path(target).replace_extension(".dat"),
               dat_header(volume, target.filename().string()), job);
}

bool means_folder(const fs::path& target) {
    std::error_code ec;
    return !target.has_filename() || target.extension().empty() || fs::is_directory(target, ec);
}

template <class T>
void write_labels_as(const LabelVolume& labels, std::string_view type, const fs::path& target, const JobContext& job) {
    const std::vector<std::uint32_t>& ids = *labels.labels;
    if constexpr (sizeof(T) == sizeof(std::uint32_t)) {
        write_nrrd(labels.geometry, type, std::as_bytes(std::span(ids)), target, job);
    } else {
        std::vector<T> narrow(ids.size());
        std::transform(ids.begin(), ids.end(), narrow.begin(), [](std::uint32_t id) { return T(id); });
        write_nrrd(labels.geometry, type, std::as_bytes(std::span(narrow)), target, job);
    }
}

}  // namespace

void write_volume(const Volume& volume, const fs::path& target, const JobContext& job) {
    if (volume.empty()) throw Error(Errc::bad_input, "Cannot write " + target.string() + ": there is no volume.");
    const std::string name = lower_case(target.filename().string());
    if (!volume.in_memory()) {
        if (name.ends_with(".nrrd")) return write_nrrd_in_parts(volume, target, job);
        if (name.ends_with(".mhd")) return write_meta(volume, target, job);
        if (name.ends_with(".raw")) return write_raw(volume, target, job);
        throw Error(Errc::unsupported, "Cannot write " + target.string() +
                                           ": this volume does not go into memory, and only .raw, .mhd and .nrrd are "
                                           "written in parts; choose one of them or raise --memory-limit.");
    }
    if (means_folder(target)) return write_dicom_series(volume, target, job);
    if (name.ends_with(".nrrd"))
        return write_nrrd(volume.geometry(), nrrd_type(volume.type()), bytes_of(volume), target, job);
    if (name.ends_with(".mhd")) return write_meta(volume, target, job);
    if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return write_nifti(volume, target, job);
    if (name.ends_with(".raw")) return write_raw(volume, target, job);
    throw Error(Errc::bad_usage,
                "Cannot write " + target.string() + ": its ending names no format; known are " + k_known_endings + ".");
}

void write_labels(const LabelVolume& labels, const fs::path& target, const JobContext& job) {
    if (lower_case(target.extension().string()) != ".nrrd")
        throw Error(Errc::bad_usage, "Cannot write the labels to " + target.string() + ": name a .nrrd file.");
    if (!labels.labels || std::int64_t(labels.labels->size()) != labels.geometry.voxel_count())
        throw Error(Errc::bad_input, "Cannot write " + target.string() + ": the labels do not fit their grid.");
    const auto& ids = *labels.labels;
    const std::uint32_t largest = ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
    if (largest <= 0xff) return write_labels_as<std::uint8_t>(labels, "uint8", target, job);
    if (largest <= 0xffff) return write_labels_as<std::uint16_t>(labels, "uint16", target, job);
    write_labels_as<std::uint32_t>(labels, "uint32", target, job);
}

}  // namespace lacuna
