#include <cmath>
#include <map>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/io/length_unit.h"
#include "core/io/raw_reader.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t k_sidecar_limit = 1 << 20;

[[noreturn]] void refuse(const fs::path& sidecar, const std::string& fault) {
    throw Error(Errc::bad_input, sidecar.string() + " does not describe a raw volume: " + fault + ".");
}

/// Lines `key SEPARATOR value` before any section and within each: "section/key" -> value, keys in lower case.
using Fields = std::map<std::string, std::string>;

const std::string& field(const Fields& fields, const std::string& key) {
    static const std::string k_none;
    const auto found = fields.find(key);
    return found == fields.end() ? k_none : found->second;
}

glm::ivec3 size_in(const fs::path& sidecar, const std::string& key, const std::string& text) {
    const auto n = numbers_in<std::int64_t>(text);
    if (!n || n->size() != 3) refuse(sidecar, "'" + key + "' must be three whole numbers");
    checked_bytes(sidecar.string(), (*n)[0], (*n)[1], (*n)[2], 1);
    return {int((*n)[0]), int((*n)[1]), int((*n)[2])};
}

glm::dvec3 spacing_in(const fs::path& sidecar, const std::string& key, const std::string& text, double mm_per_unit) {
    const auto s = numbers_in<double>(text);
    if (!s || s->size() != 3) refuse(sidecar, "'" + key + "' must be three numbers");
    const glm::dvec3 spacing = glm::dvec3((*s)[0], (*s)[1], (*s)[2]) * mm_per_unit;
    for (int a = 0; a < 3; ++a)
        if (!(spacing[a] > 0 && std::isfinite(spacing[a])))
            refuse(sidecar, "the spacing '" + key + "' is " + std::string(trimmed(text)) + ", but must be positive");
    return spacing;
}

fs::path data_file(const fs::path& sidecar, const std::string& key, const std::string& named) {
    if (named.empty()) refuse(sidecar, "'" + key + "' is missing");
    fs::path file = sidecar.parent_path() / fs::path(named);
    std::error_code ec;
    if (!fs::is_regular_file(file, ec))
        throw Error(Errc::bad_input, sidecar.string() + " names the data file " + named +
                                         ", which is not there; put it beside the header.");
    return file;
}

void read_dat_geometry(const fs::path& sidecar, const Fields& fields, RawLayout& layout) {
    if (const auto& text = field(fields, "origin"); !text.empty()) {
        const auto o = numbers_in<double>(text);
        if (!o || o->size() != 3) refuse(sidecar, "'Origin' must be three numbers");
        layout.geometry.origin = {(*o)[0], (*o)[1], (*o)[2]};
    }
    if (const auto& text = field(fields, "direction"); !text.empty()) {
        const auto d = numbers_in<double>(text);
        if (!d || d->size() != 9) refuse(sidecar, "'Direction' must be nine numbers");
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) layout.geometry.direction[c][r] = (*d)[std::size_t(3 * c + r)];
    }
}

}  // namespace

RawLayout read_dat(const fs::path& sidecar) {
    Fields fields;
    const std::string text = read_file(sidecar, k_sidecar_limit);
    for (const std::string_view line : split(text, "\n")) {
        const auto at = line.find_first_of(":=");
        if (at == std::string_view::npos) continue;
        fields[lower_case(trimmed(line.substr(0, at)))] = std::string(trimmed(line.substr(at + 1)));
    }
    RawLayout layout;
    layout.file = data_file(sidecar, "ObjectFileName", field(fields, "objectfilename"));
    layout.geometry.size = size_in(sidecar, "Resolution", field(fields, "resolution"));
    if (const auto& spacing = field(fields, "slicethickness"); !spacing.empty()) {
        layout.geometry.spacing = spacing_in(sidecar, "SliceThickness", spacing, 1.0);
        layout.spacing_known = true;
    }
    static const std::pair<std::string_view, VoxelType> k_formats[] = {
        {"uchar", VoxelType::u8},   {"char", VoxelType::i8},   {"byte", VoxelType::u8},    {"ushort", VoxelType::u16},
        {"short", VoxelType::i16},  {"float", VoxelType::f32}, {"uint8", VoxelType::u8},   {"int8", VoxelType::i8},
        {"uint16", VoxelType::u16}, {"int16", VoxelType::i16}, {"float32", VoxelType::f32}};
    const std::string format = lower_case(field(fields, "format"));
    bool known = false;
    for (const auto& [word, type] : k_formats)
        if (format == word) layout.type = type, known = true;
    if (!known)
        refuse(sidecar, "the Format '" + field(fields, "format") + "' is none of UCHAR CHAR USHORT SHORT FLOAT");
    for (const char* key : {"byteorder", "endian", "endianness"})
        if (lower_case(field(fields, key)).starts_with("big")) layout.big_endian = true;
    read_dat_geometry(sidecar, fields, layout);
    return layout;
}

namespace {

VoxelType vgi_type(const fs::path& sidecar, const std::string& kind, const std::string& bits_text) {
    const int bits = number_in<int>(bits_text).value_or(0);
    const std::string name = lower_case(kind);
    if (name == "float" && bits == 32) return VoxelType::f32;
    if (name.starts_with("unsigned") && bits == 8) return VoxelType::u8;
    if (name.starts_with("unsigned") && bits == 16) return VoxelType::u16;
    if (name.starts_with("signed") && bits == 8) return VoxelType::i8;
    if (name.starts_with("signed") && bits == 16) return VoxelType::i16;
    throw Error(Errc::unsupported, sidecar.string() + " stores voxels as '" + kind + "' of '" + bits_text +
                                       "' bits; supported are 8 and 16 bit integers and 32 bit floats.");
}

double mm_per_vgi_unit(const fs::path& sidecar, const std::string& unit) {
    if (trimmed(unit).empty()) return 1;
    if (const auto mm = mm_per_unit(unit)) return *mm;
    throw Error(Errc::unsupported, sidecar.string() + " gives the resolution in '" + unit + "'; use mm.");
}

}  // namespace

RawLayout read_vgi(const fs::path& sidecar) {
    Fields fields;
    std::string section;
    int files = 0;
    const std::string text = read_file(sidecar, k_sidecar_limit);
    for (std::string_view line : split(text, "\n")) {
        line = trimmed(line);
        if (line.starts_with("[") && line.ends_with("]")) {
            section = lower_case(line.substr(1, line.size() - 2));
            files += section.size() > 4 && section.starts_with("file") && section[4] >= '0' && section[4] <= '9';
            continue;
        }
        const auto at = line.find('=');
        if (at == std::string_view::npos) continue;
        fields.emplace(section + "/" + lower_case(trimmed(line.substr(0, at))),
                       std::string(trimmed(line.substr(at + 1))));
    }
    if (files == 0) refuse(sidecar, "it has no [file1] section");
    if (files > 1)
        throw Error(Errc::unsupported, sidecar.string() + " joins " + std::to_string(files) +
                                           " data files; export the volume as one raw file.");
    RawLayout layout;
    layout.file = data_file(sidecar, "Name", field(fields, "file1/name"));
    const auto pick = [&](const std::string& key) {
        const std::string& own = field(fields, "file1/" + key);
        return own.empty() ? field(fields, "representation/" + key) : own;
    };
    if (const std::string form = lower_case(field(fields, "file1/fileformat")); !form.empty() && form != "raw")
        throw Error(Errc::unsupported, sidecar.string() + " names a data file of format '" + form + "', not raw.");
    layout.geometry.size = size_in(sidecar, "Size", pick("size"));
    layout.type = vgi_type(sidecar, pick("datatype"), pick("bitsperelement"));
    if (const auto& skip = field(fields, "file1/skipheader"); !skip.empty()) {
        const auto bytes = number_in<std::uint64_t>(skip);
        if (!bytes) refuse(sidecar, "'SkipHeader' is not a number of bytes");
        layout.offset = *bytes;
    }
    if (const auto& resolution = field(fields, "geometry/resolution"); !resolution.empty()) {
        layout.geometry.spacing =
            spacing_in(sidecar, "resolution", resolution, mm_per_vgi_unit(sidecar, field(fields, "geometry/unit")));
        layout.spacing_known = true;
    }
    for (const char* key : {"file1/endian", "file1/endianness", "file1/byteorder"})
        if (lower_case(field(fields, key)).starts_with("big")) layout.big_endian = true;
    return layout;
}

}  // namespace lacuna
