#include "core/io/itk_reader.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <memory>
#include <mutex>
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

std::mutex g_itk;

/// Calls fn, turning what ITK throws into an Error that names the file. One at a time: what is wrong with a NRRD file
/// is put together in variables of the whole process.
template <class Fn>
void guarded(const fs::path& file, Fn&& fn) {
    const std::lock_guard one_at_a_time(g_itk);
    try {
        fn();
    } catch (const itk::ExceptionObject& e) {
        const std::string cause = cause_of(e.GetDescription());
        if (cause.find("orthonormal") != std::string::npos)
            throw Error(Errc::bad_input, "Cannot read " + file.string() +
                                             ": its axes are not at right angles, or contradict its voxel spacing; "
                                             "resample it to a rectangular grid first.");
        if (cause.find("independent axes") != std::string::npos)
            throw Error(Errc::unsupported, "Cannot read " + file.string() +
                                               ": it has more axes than its space; write a line \"kinds: list domain "
                                               "domain domain\" that says which one is none of space.");
        throw Error(Errc::bad_input, "Cannot read " + file.string() + ": it is damaged or cut short (" + cause + ").");
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
    HeaderFacts facts;
    std::optional<StoredType> type;  ///< of the voxels in the file; none: read by the library alone
};

GridGeometry geometry_of(const fs::path& file, const itk::ImageIOBase& io) {
    const unsigned dims = io.GetNumberOfDimensions();
    GridGeometry g;
    // Arrays of one value a voxel are written with an axis of length 1 before those of space.
    unsigned first = 0;
    while (dims - first > 3 && io.GetDimensions(first) == 1) ++first;
    for (unsigned a = first + 3; a < dims; ++a)
        if (io.GetDimensions(a) > 1)
            throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it holds " +
                                               std::to_string(io.GetDimensions(a)) +
                                               " volumes (time points or channels); extract one first.");
    const unsigned used = std::min(dims - first, 3u);
    g.size = glm::ivec3(1);
    for (unsigned a = 0; a < used; ++a) {
        const unsigned from = first + a;
        checked_bytes(file.string(), std::int64_t(io.GetDimensions(from)), 1, 1, 1);
        g.size[int(a)] = int(io.GetDimensions(from));
        g.spacing[int(a)] = io.GetSpacing(from);
        g.origin[int(a)] = io.GetOrigin(from);
        const auto axis = io.GetDirection(from);
        for (unsigned r = 0; r < used; ++r) g.direction[int(a)][int(r)] = axis[first + r];
    }
    return g;
}

/// ITK's number types by their width; none of those no volume is made of.
std::optional<StoredType> stored_type(const itk::ImageIOBase& io) {
    using Component = itk::IOComponentEnum;
    const auto one_of = [&](std::initializer_list<StoredType> types) -> std::optional<StoredType> {
        for (const StoredType type : types)
            if (size_of(type) == io.GetComponentSize()) return type;
        return std::nullopt;
    };
    switch (io.GetComponentType()) {
        case Component::UCHAR:
        case Component::USHORT:
        case Component::UINT:
        case Component::ULONG:
        case Component::ULONGLONG:
            return one_of({StoredType::u8, StoredType::u16, StoredType::u32, StoredType::u64});
        case Component::CHAR:
        case Component::SHORT:
        case Component::INT:
        case Component::LONG:
        case Component::LONGLONG:
            return one_of({StoredType::i8, StoredType::i16, StoredType::i32, StoredType::i64});
        case Component::FLOAT:
        case Component::DOUBLE:
            return one_of({StoredType::f32, StoredType::f64});
        default:
            break;
    }
    return std::nullopt;
}

/// Puts right what the library does not take from the header.
void correct_geometry(const HeaderFacts& facts, GridGeometry& geometry) {
    if (facts.spacing) geometry.spacing = *facts.spacing;
    if (facts.origin) geometry.origin = *facts.origin;
    geometry.spacing *= facts.mm_per_spacing;
    geometry.origin *= facts.mm_per_origin;
    geometry.axis_names = facts.axis_names;
}

OpenedImage open_image(const fs::path& file, ItkFormat format) {
    OpenedImage image;
    if (format == ItkFormat::meta_image) image.facts = check_meta_image(file);
    if (format == ItkFormat::nrrd) image.facts = check_nrrd(file);
    if (format == ItkFormat::nifti) image.facts = check_nifti(file);
    guarded(file, [&] {
        image.io = make_io(format);
        image.io->SetFileName(file.string());
        image.io->ReadImageInformation();
    });
    if (image.io->GetNumberOfComponents() != 1)
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it has " +
                                           std::to_string(image.io->GetNumberOfComponents()) +
                                           " values a voxel (colours or vectors); only scalar volumes can be opened.");
    image.geometry = geometry_of(file, *image.io);
    correct_geometry(image.facts, image.geometry);
    image.type = image.facts.type ? image.facts.type : stored_type(*image.io);
    const std::uint64_t voxels = checked_bytes(file.string(), image.geometry.size.x, image.geometry.size.y,
                                               image.geometry.size.z, image.type ? size_of(*image.type) : 1);
    std::uint64_t found = image.facts.voxels ? image.facts.voxels->bytes : 0;
    for (const StoredVoxels& piece : image.facts.pieces) found += piece.bytes;
    if (found > 0 && (!image.type || found != voxels))
        throw Error(Errc::bad_input,
                    "Cannot read " + file.string() + ": its header says twice, and differently, how large it is.");
    return image;
}

/// The stored type as one of a volume's own, if it is.
std::optional<VoxelType> own_type(StoredType type) {
    switch (type) {
        case StoredType::u8:
            return VoxelType::u8;
        case StoredType::i8:
            return VoxelType::i8;
        case StoredType::u16:
            return VoxelType::u16;
        case StoredType::i16:
            return VoxelType::i16;
        case StoredType::f32:
            return VoxelType::f32;
        default:
            break;
    }
    return std::nullopt;
}

template <class Fn>
decltype(auto) visit_stored(StoredType type, Fn&& fn) {
    switch (type) {
        case StoredType::u8:
            return fn(std::uint8_t{});
        case StoredType::i8:
            return fn(std::int8_t{});
        case StoredType::u16:
            return fn(std::uint16_t{});
        case StoredType::i16:
            return fn(std::int16_t{});
        case StoredType::u32:
            return fn(std::uint32_t{});
        case StoredType::i32:
            return fn(std::int32_t{});
        case StoredType::u64:
            return fn(std::uint64_t{});
        case StoredType::i64:
            return fn(std::int64_t{});
        case StoredType::f32:
            return fn(float{});
        case StoredType::f64:
            break;
    }
    return fn(double{});
}

/// value = stored * slope + intercept, in the smallest type that holds whole numbers that were whole before.
template <class T>
ConvertedVoxels rescaled(VoxelBuffer stored, double slope, double intercept, const JobContext& job) {
    const std::span<const T> from(reinterpret_cast<const T*>(stored.data()), stored.size() / sizeof(T));
    VoxelBuffer values(from.size() * sizeof(float));
    auto* const to = reinterpret_cast<float*>(values.data());
    detail::in_chunks(std::int64_t(from.size()), job.part(0, 0.5), [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t i = first; i < end; ++i) to[i] = float(double(from[std::size_t(i)]) * slope + intercept);
    });
    stored = {};
    return to_smallest<float>({to, values.size() / sizeof(float)}, std::is_integral_v<T>, job.part(0.5, 1));
}

/// All voxels as they lie in the file, in the machine's byte order.
VoxelBuffer stored_voxels(const fs::path& file, const OpenedImage& image, const JobContext& job) {
    const std::size_t word = size_of(*image.type);
    VoxelBuffer voxels(std::size_t(image.geometry.voxel_count()) * word);
    if (image.facts.voxels) {
        read_stored(file, *image.facts.voxels, word, {voxels.data(), voxels.size()}, job);
        return voxels;
    }
    std::size_t at = 0;
    const std::vector<StoredVoxels>& pieces = image.facts.pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        read_stored(file, pieces[i], word, {voxels.data() + at, std::size_t(pieces[i].bytes)}, {job.stop, nullptr});
        at += std::size_t(pieces[i].bytes);
        job.checkpoint(i + 1, pieces.size());
    }
    if (!pieces.empty()) return voxels;
    itk::ImageIOBase& io = *image.io;
    itk::ImageIORegion region(io.GetNumberOfDimensions());
    for (unsigned a = 0; a < io.GetNumberOfDimensions(); ++a) region.SetSize(a, io.GetDimensions(a));
    io.SetIORegion(region);
    guarded(file, [&] { io.Read(voxels.data()); });
    job.check();
    return voxels;
}

ConvertedVoxels read_voxels(const fs::path& file, const OpenedImage& image, const JobContext& job) {
    if (!image.type)
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": its voxel type " +
                                           itk::ImageIOBase::GetComponentTypeAsString(image.io->GetComponentType()) +
                                           " is not supported.");
    const HeaderFacts& facts = image.facts;
    const bool scaled = facts.slope != 1 || facts.intercept != 0;
    const auto own = own_type(*image.type);
    VoxelBuffer stored = stored_voxels(file, image, job.part(0, own && !scaled ? 1 : 0.5));
    if (own && !scaled) return {*own, std::move(stored), {}};
    const JobContext rest = job.part(0.5, 1);
    return visit_stored(*image.type, [&](auto tag) {
        using T = decltype(tag);
        if (scaled) return rescaled<T>(std::move(stored), facts.slope, facts.intercept, rest);
        return to_smallest<T>({reinterpret_cast<const T*>(stored.data()), stored.size() / sizeof(T)},
                              std::is_integral_v<T>, rest);
    });
}

}  // namespace

glm::ivec3 itk_volume_size(const fs::path& file, ItkFormat format) { return open_image(file, format).geometry.size; }

std::optional<Volume> open_itk_volume(const fs::path& file, ItkFormat format) {
    OpenedImage image = open_image(file, format);
    const auto type = image.type ? own_type(*image.type) : std::nullopt;
    const std::optional<StoredVoxels>& voxels = image.facts.voxels;
    if (!voxels || voxels->packed || !type || format == ItkFormat::nifti) return std::nullopt;
    std::vector<Warning> warnings = std::move(image.facts.warnings);
    repair_grid(file.string(), image.geometry, warnings);
    Volume volume = open_raw({voxels->file, image.geometry, *type, voxels->big_endian, voxels->offset, true, false});
    volume.name = file.filename().string();
    volume.warnings = std::move(warnings);
    return volume;
}

Volume read_itk_volume(const fs::path& file, ItkFormat format, const JobContext& job,
                       const std::function<void(std::uint64_t)>& room) {
    OpenedImage image = open_image(file, format);
    if (room) {
        const auto type = image.type ? own_type(*image.type) : std::nullopt;
        room(std::uint64_t(image.geometry.voxel_count()) * (type ? size_of(*type) : 1));
    }
    std::vector<Warning> warnings = std::move(image.facts.warnings);
    repair_grid(file.string(), image.geometry, warnings);
    job.checkpoint(0, 1);
    ConvertedVoxels read = read_voxels(file, image, job);
    job.checkpoint(1, 1);
    if (!read.warning.empty()) warnings.push_back({read.warning, 0});
    Volume volume(image.geometry, read.type, std::move(read.voxels));
    volume.name = file.filename().string();
    volume.warnings = std::move(warnings);
    return volume;
}

}  // namespace lacuna
