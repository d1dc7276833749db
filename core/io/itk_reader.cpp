#include "core/io/itk_reader.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <future>
#include <memory>
#include <new>

#include "core/base/error.h"
#include "core/io/grid_repair.h"
#include "core/io/header_check.h"
#include "core/io/raw_reader.h"
#include "core/io/text_fields.h"
#include "core/io/voxel_convert.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

/// ITK's descriptions carry addresses and a history of calls, one a line; the last line is the cause.
std::string cause_of(const std::string& description) {
    std::string last;
    for (const auto line : split(description, "\n"))
        if (!trimmed(line).empty()) last = std::string(trimmed(line));
    if (const auto at = last.rfind("): "); at != std::string::npos) last = last.substr(at + 3);
    if (const auto at = last.find("] "); last.starts_with("[") && at != std::string::npos) last = last.substr(at + 2);
    if (last.size() > 200) last.resize(200);
    while (!last.empty() && last.back() == '.') last.pop_back();
    return last;
}

/// Calls fn, turning what ITK throws into an Error that names the file.
template <class Fn>
void guarded(const fs::path& file, Fn&& fn) {
    try {
        fn();
    } catch (const itk::ExceptionObject& e) {
        throw Error(Errc::bad_input, "Cannot read " + file.string() + ": it is damaged or cut short (" +
                                         cause_of(e.GetDescription()) + ").");
    } catch (const std::bad_alloc&) {
        throw Error(Errc::out_of_memory, "Cannot read " + file.string() + ": not enough memory.");
    }
}

itk::ImageIOBase::Pointer make_io(ItkFormat format) {
    itk::Object::SetGlobalWarningDisplay(false);
    switch (format) {
        case ItkFormat::meta_image:
            return itk::MetaImageIO::New().GetPointer();
        case ItkFormat::nrrd:
            return itk::NrrdImageIO::New().GetPointer();
        case ItkFormat::nifti:
            break;
    }
    return itk::NiftiImageIO::New().GetPointer();
}

/// A file whose header was checked and read.
struct OpenedImage {
    itk::ImageIOBase::Pointer io;
    GridGeometry geometry;
    bool integers_rescaled = false;
    std::optional<CompressedData> compressed;
    std::optional<PlainData> plain;
};

GridGeometry geometry_of(const fs::path& file, const itk::ImageIOBase& io) {
    const unsigned dims = io.GetNumberOfDimensions();
    GridGeometry g;
    for (unsigned a = 3; a < dims; ++a)
        if (io.GetDimensions(a) > 1)
            throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it holds " +
                                               std::to_string(io.GetDimensions(a)) +
                                               " volumes (time points or channels); extract one first.");
    const unsigned used = std::min(dims, 3u);
    g.size = glm::ivec3(1);
    for (unsigned a = 0; a < used; ++a) {
        checked_bytes(file.string(), std::int64_t(io.GetDimensions(a)), 1, 1, 1);
        g.size[int(a)] = int(io.GetDimensions(a));
        g.spacing[int(a)] = io.GetSpacing(a);
        g.origin[int(a)] = io.GetOrigin(a);
        const auto axis = io.GetDirection(a);
        for (unsigned r = 0; r < used; ++r) g.direction[int(a)][int(r)] = axis[r];
    }
    return g;
}

OpenedImage open_image(const fs::path& file, ItkFormat format) {
    OpenedImage image;
    HeaderFacts facts;
    if (format == ItkFormat::meta_image) facts = check_meta_image(file);
    if (format == ItkFormat::nrrd) facts = check_nrrd(file);
    if (format == ItkFormat::nifti) facts = check_nifti(file);
    image.compressed = facts.compressed;
    image.plain = facts.plain;
    image.io = make_io(format);
    guarded(file, [&] {
        image.io->SetFileName(file.string());
        image.io->ReadImageInformation();
    });
    if (image.io->GetNumberOfComponents() != 1)
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it has " +
                                           std::to_string(image.io->GetNumberOfComponents()) +
                                           " values a voxel (colours or vectors); only scalar volumes can be opened.");
    image.geometry = geometry_of(file, *image.io);
    using Component = itk::IOComponentEnum;
    const auto type = image.io->GetComponentType();
    image.integers_rescaled = facts.stored_as_integer && (type == Component::FLOAT || type == Component::DOUBLE);
    return image;
}

/// The voxel type ITK's component is read as without any conversion, if it is one of ours.
std::optional<VoxelType> own_type(itk::IOComponentEnum component) {
    using Component = itk::IOComponentEnum;
    switch (component) {
        case Component::UCHAR:
            return VoxelType::u8;
        case Component::CHAR:
            return VoxelType::i8;
        case Component::USHORT:
            return VoxelType::u16;
        case Component::SHORT:
            return VoxelType::i16;
        case Component::FLOAT:
            return VoxelType::f32;
        default:
            return std::nullopt;
    }
}

template <class T>
ConvertedVoxels read_and_convert(const fs::path& file, itk::ImageIOBase& io, std::int64_t count, bool whole_may_shrink,
                                 const JobContext& job) {
    VoxelBuffer wide(std::size_t(count) * sizeof(T));
    guarded(file, [&] { io.Read(wide.data()); });
    job.check();
    return to_smallest<T>({reinterpret_cast<const T*>(wide.data()), std::size_t(count)}, whole_may_shrink, job);
}

ConvertedVoxels read_voxels(const fs::path& file, OpenedImage& image, const JobContext& job) {
    using Component = itk::IOComponentEnum;
    const std::int64_t count = image.geometry.voxel_count();
    const bool shrink = image.integers_rescaled;
    itk::ImageIOBase& io = *image.io;
    const Component component = io.GetComponentType();
    if (const auto type = own_type(component); type && !shrink) {
        ConvertedVoxels out{*type, VoxelBuffer(std::size_t(count) * size_of(*type)), {}};
        guarded(file, [&] { io.Read(out.voxels.data()); });
        return out;
    }
    switch (component) {
        case Component::FLOAT:
            return read_and_convert<float>(file, io, count, shrink, job);
        case Component::DOUBLE:
            return read_and_convert<double>(file, io, count, shrink, job);
        case Component::UINT:
            return read_and_convert<std::uint32_t>(file, io, count, true, job);
        case Component::INT:
            return read_and_convert<std::int32_t>(file, io, count, true, job);
        case Component::ULONG:
        case Component::ULONGLONG:
            return read_and_convert<std::uint64_t>(file, io, count, true, job);
        case Component::LONG:
        case Component::LONGLONG:
            return read_and_convert<std::int64_t>(file, io, count, true, job);
        default:
            break;
    }
    throw Error(Errc::unsupported, "Cannot read " + file.string() + ": its voxel type " +
                                       itk::ImageIOBase::GetComponentTypeAsString(component) + " is not supported.");
}

}  // namespace

glm::ivec3 itk_volume_size(const fs::path& file, ItkFormat format) { return open_image(file, format).geometry.size; }

std::optional<Volume> open_itk_volume(const fs::path& file, ItkFormat format) {
    OpenedImage image = open_image(file, format);
    const auto type = own_type(image.io->GetComponentType());
    if (!image.plain || !type) return std::nullopt;
    std::vector<Warning> warnings;
    repair_grid(file.string(), image.geometry, warnings);
    RawLayout layout{image.plain->file,   image.geometry, *type, image.plain->big_endian,
                     image.plain->offset, true,           false};
    Volume volume = open_raw(layout);
    volume.name = file.filename().string();
    volume.warnings = std::move(warnings);
    return volume;
}

Volume read_itk_volume(const fs::path& file, ItkFormat format, const JobContext& job,
                       const std::function<void(std::uint64_t)>& room) {
    OpenedImage image = open_image(file, format);
    if (room) {
        const auto type = own_type(image.io->GetComponentType());
        room(std::uint64_t(image.geometry.voxel_count()) * (type ? size_of(*type) : 1));
    }
    std::vector<Warning> warnings;
    repair_grid(file.string(), image.geometry, warnings);
    itk::ImageIORegion region(image.io->GetNumberOfDimensions());
    for (unsigned a = 0; a < image.io->GetNumberOfDimensions(); ++a) region.SetSize(a, image.io->GetDimensions(a));
    image.io->SetIORegion(region);
    job.checkpoint(0, 1);
    std::future<void> sound;  // checked beside the reading, on a core that would idle
    if (image.compressed)
        sound = std::async(std::launch::async, [&] { check_compressed(file, *image.compressed, {job.stop, nullptr}); });
    ConvertedVoxels read = read_voxels(file, image, job.part(0.5, 1.0));
    if (sound.valid()) sound.get();
    job.checkpoint(1, 1);
    if (!read.warning.empty()) warnings.push_back({read.warning, 0});
    Volume volume(image.geometry, read.type, std::move(read.voxels));
    volume.name = file.filename().string();
    volume.warnings = std::move(warnings);
    return volume;
}

}  // namespace lacuna
