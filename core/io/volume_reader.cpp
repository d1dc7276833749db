#include "core/io/volume_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <mutex>

#include "core/base/parallel.h"
#include "core/io/dicom_reader.h"
#include "core/io/dicom_source.h"
#include "core/io/grid_repair.h"
#include "core/io/open_limit.h"
#include "core/io/plain_file.h"
#include "core/io/text_fields.h"
#include "core/io/tiff_reader.h"
#include "core/volume/samples.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_sample = "sample:";
constexpr std::uint64_t k_any_size = ~std::uint64_t(0);

bool is_sample(const std::string& input) { return input.starts_with(k_sample); }

/// NAME[@SIZE] behind `sample:`, SIZE one number for all axes or WxHxD.
std::pair<std::string, SampleOptions> sample_call(const std::string& input) {
    std::string name = input.substr(k_sample.size());
    SampleOptions options;
    if (const auto at = name.find('@'); at != std::string::npos) {
        const std::string size = name.substr(at + 1);
        const auto dims = numbers_in<int>(size, "x");
        const bool sound = dims && (dims->size() == 1 || dims->size() == 3) &&
                           std::count(size.begin(), size.end(), 'x') == std::ptrdiff_t(dims->size()) - 1 &&
                           *std::min_element(dims->begin(), dims->end()) >= 1;
        if (!sound)
            throw Error(Errc::bad_usage, "The size in '" + input + "' is not a number of voxels; write for example " +
                                             "sample:casting@192 or sample:casting@256x256x128.");
        options.dims = dims->size() == 1 ? glm::ivec3(dims->front()) : glm::ivec3((*dims)[0], (*dims)[1], (*dims)[2]);
        name.resize(at);
    }
    return {name, options};
}

/// A file of other files, or a packed one, by its first bytes: ZIP, GZIP, 7z, RAR, XZ, BZIP2.
bool looks_packed(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, 6> bytes{};
    in.read(bytes.data(), std::streamsize(bytes.size()));
    const std::string_view first(bytes.data(), std::size_t(in.gcount()));
    for (const std::string_view sign :
         {std::string_view("PK\3\4"), std::string_view("PK\5\6"), std::string_view("\x1f\x8b"),
          std::string_view("7z\xbc\xaf\x27\x1c"), std::string_view("Rar!"), std::string_view("\xfd\x37zXZ"),
          std::string_view("BZh")})
        if (first.starts_with(sign)) return true;
    return false;
}

/// A DICOM file that the extension does not tell must be one by content.
void require_dicom(const fs::path& file) {
    if (looks_like_dicom(file)) return;
    require_bytes(file);
    if (looks_packed(file))
        throw Error(Errc::unsupported,
                    "Cannot read " + file.string() + ": of packed files only .nii.gz is read; unpack it first.");
    throw Error(Errc::bad_input, "Cannot read " + file.string() +
                                     ": it is neither DICOM nor named .mhd .mha .nrrd .nhdr .nii .nii.gz .hdr .tif "
                                     ".tiff .raw .img .vol .dat or .vgi; if it is a raw volume, import it as one "
                                     "(--raw).");
}

SeriesEntry file_entry(const fs::path& path, glm::ivec3 size, std::vector<fs::path> files) {
    SeriesEntry entry;
    entry.number = 1;
    entry.description = path.filename().empty() ? path.parent_path().filename().string() : path.filename().string();
    entry.size = size;
    entry.slices = size.z;
    entry.files = std::move(files);
    return entry;
}

/// The series a call means: the only one, or the one --series names by number or UID.
const SeriesEntry& chosen_series(const std::string& input, const std::vector<SeriesEntry>& found,
                                 const std::string& wanted) {
    if (wanted.empty()) {
        if (found.size() == 1) return found.front();
        throw AmbiguousInput(input + " holds " + std::to_string(found.size()) +
                                 " volumes; choose one with --series N or --series UID:\n" + format_series(found),
                             found);
    }
    const auto number = number_in<int>(wanted);
    const SeriesEntry* match = nullptr;
    for (const SeriesEntry& entry : found) {
        const bool hit = number ? entry.number == *number : entry.uid == wanted;
        if (!hit) continue;
        if (match) {
            throw Error(Errc::bad_usage, "Several volumes of " + input + " carry the UID " + wanted +
                                             "; choose one by its number:\n" + format_series(found));
        }
        match = &entry;
    }
    if (match) return *match;
    throw Error(Errc::bad_usage,
                "There is no series '" + wanted + "' in " + input + "; it holds:\n" + format_series(found));
}

/// Names of files right in the folder that are volumes of their own, at most three.
std::string volume_files_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ec;
    for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec))
        if (at->is_regular_file(ec) && format_by_name(at->path()) != FileFormat::dicom)
            names.push_back(at->path().filename().string());
    std::sort(names.begin(), names.end());
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, names.size()); ++i) text += (i ? ", " : "") + names[i];
    return names.size() > 3 ? text + ", ..." : text;
}

/// The DICOM series under a folder; none if it holds a TIFF stack instead, and an Error if it holds neither.
std::vector<SeriesEntry> dicom_in_folder(const fs::path& folder, const JobContext& job) {
    try {
        return find_dicom_series(folder, job);
    } catch (const Error& e) {
        if (e.code() != Errc::bad_input) throw;
        if (!tiff_stack(folder).empty()) return {};
        if (const std::string names = volume_files_in(folder); !names.empty())
            throw Error(Errc::bad_input,
                        "The folder " + folder.string() + " holds no DICOM images but " + names + "; name the file.");
        throw;
    }
    return {};
}

/// @throws Error(out_of_memory) naming both numbers
void require_room(std::uint64_t bytes, std::uint64_t most_bytes) {
    if (bytes <= most_bytes) return;
    throw Error(Errc::out_of_memory, "The volume takes " + std::to_string((bytes + (1 << 20) - 1) >> 20) +
                                         " MB of memory, but only " + std::to_string(most_bytes >> 20) +
                                         " MB may be used.");
}

std::uint64_t voxels_in(const glm::ivec3& size) {
    const glm::ivec3 n = glm::max(size, 0);
    return std::uint64_t(n.x) * std::uint64_t(n.y) * std::uint64_t(n.z);
}

/// NaN and infinite voxels are kept, but nobody should be surprised by them; nor by values that single precision, which
/// devices calculate in, cannot tell apart or subtract from one another.
void warn_of_numbers(Volume& volume, const JobContext& job) {
    if (volume.type() != VoxelType::f32) return;
    const auto voxels = volume.view<float>().voxels();
    std::mutex mutex;
    std::int64_t odd = 0;
    float least = std::numeric_limits<float>::infinity(), most = -least;
    parallel_bands(
        0, std::int64_t(voxels.size()), 8 * thread_count(),
        [&](std::int64_t from, std::int64_t to) {
            std::int64_t odd_here = 0;
            float least_here = std::numeric_limits<float>::infinity(), most_here = -least_here;
            for (std::int64_t i = from; i < to; ++i) {
                const float v = voxels[std::size_t(i)];
                const bool finite = std::isfinite(v);
                odd_here += !finite;
                least_here = finite && v < least_here ? v : least_here;
                most_here = finite && v > most_here ? v : most_here;
            }
            const std::lock_guard lock(mutex);
            odd += odd_here;
            least = std::min(least, least_here);
            most = std::max(most, most_here);
        },
        job);
    if (odd > 0)
        volume.warnings.push_back({std::to_string(odd) + " voxels are not a finite number (NaN or infinite).", 0});
    const double span = double(most) - double(least), farthest = std::max(std::fabs(least), std::fabs(most));
    if (least <= most &&
        (span > std::numeric_limits<float>::max() || (farthest > 0 && farthest < std::numeric_limits<float>::min())))
        volume.warnings.push_back(
            {fmt::format("The values, {:.3g} to {:.3g}, are beyond what pictures can be calculated "
                         "with; scale them before you trust one.",
                         least, most),
             0});
}

std::string spacing_text(const Volume& volume) {
    const glm::dvec3 s = volume.geometry().spacing;
    return fmt::format("{:.6g} x {:.6g} x {:.6g}", s.x, s.y, s.z);
}

/// The same voxels on a grid of another spacing.
Volume with_spacing(const Volume& volume, const glm::dvec3& spacing_mm, const std::string& what) {
    GridGeometry geometry = volume.geometry();
    geometry.spacing = spacing_mm;
    std::vector<Warning> warnings;
    repair_grid(what, geometry, warnings);
    Volume out = volume.source() ? Volume(geometry, volume.type(), volume.source())
                                 : Volume(geometry, volume.type(), volume.buffer());
    out.name = volume.name;
    out.unit = volume.unit;
    out.dicom = volume.dicom;
    for (const Warning& w : volume.warnings)
        if (!w.text.starts_with("The voxel spacing is not stated")) out.warnings.push_back(w);
    if (out.dicom)
        out.warnings.push_back(
            {"The spacing was given by hand; the DICOM files name " + spacing_text(volume) + " mm."});
    return out;
}

fs::path existing(const std::string& input) {
    std::error_code ec;
    if (input.empty() || !fs::exists(input, ec))
        throw Error(Errc::io, "Cannot open '" + input + "': there is no such file or folder.");
    return input;
}

}  // namespace

std::string format_series(const std::vector<SeriesEntry>& entries) {
    std::string text;
    for (const SeriesEntry& e : entries) {
        if (!text.empty()) text += '\n';
        text += "  " + std::to_string(e.number) + "  " + (e.description.empty() ? "(no description)" : e.description) +
                "  " + std::to_string(e.size.x) + "x" + std::to_string(e.size.y) + "x" + std::to_string(e.size.z) +
                "  " + std::to_string(e.slices) + " slices  " + e.uid;
    }
    return text;
}

std::vector<SeriesEntry> list_series(const std::string& input, const JobContext& job) {
    if (is_sample(input)) {
        const auto [name, options] = sample_call(input);
        return {file_entry(fs::path(input), options.dims, {})};
    }
    const fs::path path = existing(input);
    if (fs::is_directory(path)) {
        auto found = dicom_in_folder(path, job);
        if (!found.empty()) return found;
        const auto files = tiff_stack(path);
        if (files.empty()) refuse_folder(input);
        return {file_entry(path, tiff_size(files), files)};
    }
    const FileFormat format = format_of(path, {});
    if (format != FileFormat::dicom) return {file_entry(path, plain_size(path, format), {path})};
    require_dicom(path);
    return find_dicom_series(path, job);
}

namespace {

void check_sample_options(const std::string& input, const OpenOptions& options) {
    if (!options.raw.empty() || options.spacing_mm || (!options.series.empty() && options.series != "1"))
        throw Error(Errc::bad_usage, "A built-in sample such as " + input +
                                         " is made with its own grid; leave out --raw, --spacing and --series.");
}

}  // namespace

std::optional<Volume> open_volume_in_parts(const std::string& input, const OpenOptions& options) {
    if (is_sample(input)) {
        const auto [name, sample] = sample_call(input);
        check_sample_options(input, options);
        return sample_in_parts(name, sample);
    }
    const fs::path path = existing(input);
    if (fs::is_directory(path)) return std::nullopt;
    std::optional<Volume> volume = open_plain_in_parts(path, format_of(path, options), options);
    if (!volume) return volume;
    if (options.spacing_mm) volume = with_spacing(*volume, *options.spacing_mm, input);
    volume->name = file_entry(path, {}, {}).description;
    return volume;
}

std::optional<AnalyticSample> open_sample(const std::string& input, const JobContext& job) {
    if (!is_sample(input)) return std::nullopt;
    const auto [name, options] = sample_call(input);
    return make_sample(name, options, job);
}

Volume open_volume(const std::string& input, const OpenOptions& options, const JobContext& job) {
    return open_volume_within(input, options, k_any_size, job);
}

Volume open_volume_within(const std::string& input, const OpenOptions& options, std::uint64_t most_bytes,
                          const JobContext& job) {
    if (is_sample(input)) {
        const auto [name, sample] = sample_call(input);
        check_sample_options(input, options);
        require_room(sample_in_parts(name, sample).total_bytes(), most_bytes);
        Volume volume = make_sample(name, sample, job).volume;
        if (volume.name.empty()) volume.name = input;
        return volume;
    }
    const fs::path path = existing(input);
    const bool folder = fs::is_directory(path);
    FileFormat format = folder ? FileFormat::dicom : format_of(path, options);
    if (format == FileFormat::dicom) {
        if (!folder) require_dicom(path);
        const JobContext scan = job.part(0, 0.2);
        const auto found = folder ? dicom_in_folder(path, scan) : find_dicom_series(path, scan);
        if (!found.empty()) {
            const SeriesEntry& chosen = chosen_series(input, found, options.series);
            require_room(voxels_in(chosen.size), most_bytes);  // a voxel has a byte at least
            Volume volume = read_dicom_series(chosen, options, job.part(0.2, 1));
            warn_of_numbers(volume, {job.stop, nullptr});
            return options.spacing_mm ? with_spacing(volume, *options.spacing_mm, input) : volume;
        }
        if (!folder) throw Error(Errc::bad_input, "Cannot read " + input + ": this DICOM file holds no image.");
        format = FileFormat::tiff;
    }
    if (!options.series.empty() && options.series != "1")
        throw Error(Errc::bad_usage,
                    "There is no series '" + options.series + "' in " + input + "; it holds one volume.");
    std::function<void(std::uint64_t)> room;
    if (most_bytes != k_any_size) room = [&](std::uint64_t bytes) { require_room(bytes, most_bytes); };
    Volume volume = read_plain(path, format, options, room, job.part(folder ? 0.2 : 0, 0.95));
    if (options.spacing_mm) volume = with_spacing(volume, *options.spacing_mm, input);
    volume.name = file_entry(path, {}, {}).description;
    warn_of_numbers(volume, job.part(0.95, 1));
    job.checkpoint(1, 1);
    job.check();
    return volume;
}

std::shared_ptr<const DicomSource> find_dicom_source(const std::string& input, const OpenOptions& options,
                                                     const JobContext& job) {
    if (is_sample(input)) return nullptr;
    const fs::path path = existing(input);
    const bool folder = fs::is_directory(path);
    if (!folder && format_of(path, options) != FileFormat::dicom) return nullptr;
    const auto found = folder ? dicom_in_folder(path, job) : find_dicom_series(path, job);
    return found.empty() ? nullptr : dicom_source_of(chosen_series(input, found, options.series), job);
}

}  // namespace lacuna
