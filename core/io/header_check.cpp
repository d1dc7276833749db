#include "core/io/header_check.h"

#include <nifti1.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/length_unit.h"
#include "core/io/raw_reader.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t k_header_limit = std::size_t(1) << 20;
// Deflate cannot shrink by more than 1032:1, so a longer claim is false and must not be allocated.
constexpr std::uint64_t k_deflate_ratio = 1040;

[[noreturn]] void refuse(const fs::path& file, const std::string& fault) {
    throw Error(Errc::bad_input, "Cannot read " + file.string() + ": " + fault + ".");
}

std::string head_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw Error(Errc::io, "Cannot read " + file.string() + ": " + std::strerror(errno) + ".");
    std::string text(k_header_limit, '\0');
    in.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(in.gcount()));
    return text;
}

std::uint64_t size_or_refuse(const fs::path& header, const fs::path& data, const std::string& named) {
    std::error_code ec;
    if (!fs::is_regular_file(data, ec))
        refuse(header, "its data file " + named + " is not there; put it beside the header");
    return fs::file_size(data, ec);
}

void check_length(const fs::path& header, std::uint64_t have, std::uint64_t need, bool compressed) {
    if (compressed) {
        if (need / k_deflate_ratio > have)
            refuse(header, "it claims " + std::to_string(need) + " bytes of voxels, more than its " +
                               std::to_string(have) +
                               " compressed bytes can hold; the file is cut or its sizes are wrong");
    } else if (have != need) {
        refuse(header, "its voxels need " + std::to_string(need) + " bytes, but there are " + std::to_string(have) +
                           "; the file is cut or its sizes are wrong");
    }
}

using Fields = std::map<std::string, std::string>;

std::string field(const Fields& fields, const std::string& key) {
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
}

bool says_true(const std::string& text) {
    return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

void check_spacing(const fs::path& file, const std::string& key, const std::string& text) {
    if (text.empty()) return;
    for (const auto piece : split(text, " \t,")) {
        const auto s = number_in<double>(piece);
        if (!s || !(*s > 0 && std::isfinite(*s)))
            refuse(file, "its " + key + " is '" + std::string(trimmed(text)) +
                             "', but spacings must be positive numbers of mm");
    }
}

/// Whether a name stands for several files: "LIST", or a pattern such as slice%03d.raw; not if there is such a file.
bool is_list(const fs::path& header, const std::string& named) {
    std::error_code ec;
    return (named.starts_with("LIST") || named.find('%') != std::string::npos) &&
           !fs::is_regular_file(header.parent_path() / named, ec);
}

void warn_of_spacing(HeaderFacts& facts) {
    facts.warnings.push_back({"The voxel spacing is not stated; 1 x 1 x 1 mm is assumed.", 0});
}

/// The factor of a unit named in a header; an unknown one is told and taken as mm.
double mm_of(const std::string& unit, HeaderFacts& facts) {
    if (trimmed(unit).empty()) return 1;
    if (const auto mm = mm_per_unit(unit)) return *mm;
    facts.warnings.push_back({"The header gives lengths in '" + unit + "', which is no known unit; mm is assumed.", 0});
    return 1;
}

struct MetaHeader {
    Fields fields;
    std::size_t end = 0;  ///< bytes of the header
};

MetaHeader meta_header(const fs::path& file) {
    const std::string text = head_of(file);
    MetaHeader header;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t stop = std::min(text.find('\n', at), text.size());
        const std::string_view line(text.data() + at, stop - at);
        at = std::min(stop + 1, text.size());
        const auto equals = line.find('=');
        if (equals == std::string_view::npos) {
            if (trimmed(line).empty()) continue;
            break;
        }
        const std::string key(trimmed(line.substr(0, equals)));
        header.fields[key] = std::string(trimmed(line.substr(equals + 1)));
        if (key == "ElementDataFile") {
            header.end = at;
            return header;
        }
    }
    refuse(file, "it is no MetaImage header (no line ElementDataFile)");
}

std::uint64_t meta_type_bytes(const fs::path& file, const std::string& type) {
    static const std::pair<std::string_view, int> k_types[] = {
        {"MET_UCHAR", 1},     {"MET_CHAR", 1},       {"MET_USHORT", 2}, {"MET_SHORT", 2},
        {"MET_UINT", 4},      {"MET_INT", 4},        {"MET_FLOAT", 4},  {"MET_DOUBLE", 8},
        {"MET_LONG_LONG", 8}, {"MET_ULONG_LONG", 8}, {"MET_LONG", 4},   {"MET_ULONG", 4}};
    for (const auto& [name, bytes] : k_types)
        if (type == name) return std::uint64_t(bytes);
    throw Error(Errc::unsupported,
                "Cannot read " + file.string() + ": its ElementType '" + type + "' is not a scalar type.");
}

}  // namespace

fs::path meta_image_data_file(const fs::path& file) {
    const std::string named = field(meta_header(file).fields, "ElementDataFile");
    if (lower_case(named) == "local" || is_list(file, named)) return {};
    return file.parent_path() / named;
}

namespace {

/// Text in place of bytes: the library takes numbers that are missing for zeros.
void check_numbers(const fs::path& header, const fs::path& data, std::uint64_t from, std::uint64_t need) {
    std::ifstream in(data, std::ios::binary);
    in.seekg(std::streamoff(from));
    std::uint64_t have = 0;
    bool inside = false;
    for (std::vector<char> piece(std::size_t(1) << 20); in;) {
        in.read(piece.data(), std::streamsize(piece.size()));
        for (std::streamsize i = 0; i < in.gcount(); ++i) {
            const bool blank = trimmed(std::string_view(&piece[std::size_t(i)], 1)).empty();
            have += !blank && !inside;
            inside = !blank;
        }
    }
    if (have < need)
        refuse(header, "its " + std::to_string(need) + " voxels are stored as text, but there are " +
                           std::to_string(have) + " numbers; the file is cut or its sizes are wrong");
}

/// The library stops reading where numbers are missing, and says so on the terminal.
void check_meta_numbers(const fs::path& file, const Fields& f, std::size_t dims) {
    const auto check = [&](const char* key, std::size_t count) {
        if (field(f, key).empty()) return;
        const auto numbers = numbers_in<double>(field(f, key));
        if (!numbers || numbers->size() != count)
            refuse(file,
                   "its " + std::string(key) + " '" + field(f, key) + "' is not " + std::to_string(count) + " numbers");
    };
    for (const char* key : {"ElementSpacing", "ElementSize", "Offset", "Position", "Origin", "CenterOfRotation"})
        check(key, dims);
    for (const char* key : {"TransformMatrix", "Rotation", "Orientation"}) check(key, dims * dims);
}

bool meta_big_endian(const fs::path& file, const Fields& f) {
    const std::string data = field(f, "BinaryDataByteOrderMSB"), element = field(f, "ElementByteOrderMSB");
    if (!data.empty() && !element.empty() && says_true(data) != says_true(element))
        refuse(file, "its BinaryDataByteOrderMSB and ElementByteOrderMSB contradict each other");
    return says_true(data) || says_true(element);
}

void read_meta_scales(const Fields& f, HeaderFacts& facts) {
    if (field(f, "ElementSpacing").empty() && field(f, "ElementSize").empty()) warn_of_spacing(facts);
    facts.mm_per_spacing = facts.mm_per_origin = glm::dvec3(mm_of(field(f, "DistanceUnits"), facts));
    const std::string slope = field(f, "ElementToIntensityFunctionSlope"),
                      offset = field(f, "ElementToIntensityFunctionOffset");
    if (number_in<double>(slope).value_or(1) != 1 || number_in<double>(offset).value_or(0) != 0)
        facts.warnings.push_back({"The header names a value scale (slope " + (slope.empty() ? "1" : slope) +
                                      ", offset " + (offset.empty() ? "0" : offset) +
                                      "), which readers of MetaImage leave out; the values are as stored.",
                                  0});
}

}  // namespace

HeaderFacts check_meta_image(const fs::path& file) {
    const MetaHeader header = meta_header(file);
    const Fields& f = header.fields;
    for (const char* key : {"ElementSpacing", "ElementSize"}) check_spacing(file, key, field(f, key));
    const auto dims = numbers_in<std::int64_t>(field(f, "DimSize"));
    if (!dims || dims->empty() || std::int64_t(dims->size()) != number_in<std::int64_t>(field(f, "NDims")).value_or(-1))
        refuse(file, "its DimSize '" + field(f, "DimSize") + "' does not fit its NDims '" + field(f, "NDims") + "'");
    check_meta_numbers(file, f, dims->size());
    if (const auto channels = field(f, "ElementNumberOfChannels"); !channels.empty() && channels != "1")
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it has " + channels +
                                           " values a voxel; only scalar volumes can be opened.");
    const std::uint64_t word = meta_type_bytes(file, field(f, "ElementType"));
    std::uint64_t need = word;
    for (const std::int64_t n : *dims) need = checked_bytes(file.string(), n, 1, 1, need);
    HeaderFacts facts;
    read_meta_scales(f, facts);
    const std::string named = field(f, "ElementDataFile");
    const fs::path data = meta_image_data_file(file);
    const bool local = data.empty() && lower_case(named) == "local";
    if (data.empty() && !local) return facts;  // a list or a pattern: the library reports what is missing
    const std::uint64_t before = local ? header.end : 0;
    const std::uint64_t end = local ? fs::file_size(file) : size_or_refuse(file, data, named);
    const bool packed = says_true(field(f, "CompressedData"));
    const std::int64_t skip = number_in<std::int64_t>(field(f, "HeaderSize")).value_or(0);
    StoredVoxels voxels{local ? file : data, before, 0, need, packed, false, meta_big_endian(file, f)};
    if (skip > 0) {  // counted from the file's first byte, of a header of its own too
        if (std::uint64_t(skip) > end || std::uint64_t(skip) < before)
            refuse(file, "its HeaderSize " + std::to_string(skip) + " does not lie within the data");
        voxels.offset = std::uint64_t(skip);
    }
    if (!field(f, "BinaryData").empty() && !says_true(field(f, "BinaryData"))) {
        check_numbers(file, voxels.file, voxels.offset, need / word);
        return facts;
    }
    if (skip < 0) {  // -1: the voxels are the file's last bytes
        if (packed) refuse(file, "its HeaderSize -1 does not go with compressed voxels");
        if (end - before > need) voxels.offset = end - need;
    }
    check_length(file, end - voxels.offset, need, packed);
    facts.voxels = voxels;
    return facts;
}

namespace {

struct NrrdHeader {
    Fields fields;
    std::size_t end = 0;
};

NrrdHeader nrrd_header(const fs::path& file) {
    const std::string text = head_of(file);
    if (!text.starts_with("NRRD")) refuse(file, "it is no NRRD file (it does not start with NRRD)");
    NrrdHeader header;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t stop = std::min(text.find('\n', at), text.size());
        const std::string_view line = trimmed(std::string_view(text).substr(at, stop - at));
        at = std::min(stop + 1, text.size());
        if (line.empty()) break;
        const auto colon = line.find(": ");
        if (line.front() == '#' || colon == std::string_view::npos) {
            if (line.ends_with(":")) header.fields[lower_case(line.substr(0, line.size() - 1))] = "";
            continue;
        }
        header.fields[lower_case(trimmed(line.substr(0, colon)))] = std::string(trimmed(line.substr(colon + 2)));
    }
    header.end = at;
    return header;
}

std::uint64_t nrrd_type_bytes(const fs::path& file, const std::string& type) {
    const std::string t = lower_case(type);
    if (t == "block")
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": its voxels are opaque blocks.");
    static const char* const k_one[] = {"signed char", "int8", "int8_t", "uchar", "unsigned char", "uint8", "uint8_t"};
    if (std::any_of(std::begin(k_one), std::end(k_one), [&](const char* n) { return t == n; })) return 1;
    if (t.find("long long") != std::string::npos || t.find("longlong") != std::string::npos ||
        t.find("64") != std::string::npos || t == "double")
        return 8;
    if (t.find("short") != std::string::npos || t.find("16") != std::string::npos) return 2;
    if (t.find("int") != std::string::npos || t == "float") return 4;
    refuse(file, "its type '" + type + "' is unknown");
}

}  // namespace

namespace {

/// The offset behind so many lines of a file.
std::uint64_t behind_lines(const fs::path& header, const fs::path& data, std::uint64_t offset, std::int64_t lines) {
    std::ifstream in(data, std::ios::binary);
    in.seekg(std::streamoff(offset));
    for (; lines > 0; --lines) {
        char c = 0;
        while (in.get(c) && c != '\n') ++offset;
        if (!in) refuse(header, "its data have fewer lines than it says to skip");
        ++offset;
    }
    return offset;
}

/// The texts between quotation marks, as NRRD writes units.
std::vector<std::string> quoted(const std::string& text) {
    std::vector<std::string> found;
    for (std::size_t from = text.find('"'); from != std::string::npos; from = text.find('"', from)) {
        const std::size_t to = text.find('"', from + 1);
        if (to == std::string::npos) break;
        found.push_back(text.substr(from + 1, to - from - 1));
        from = to + 1;
    }
    return found;
}

/// Units of length: those of space, or those of each axis where its spacing is a number alone.
void read_nrrd_units(const fs::path& file, const Fields& f, HeaderFacts& facts) {
    const bool in_space = f.contains("space directions");
    const auto units = quoted(field(f, in_space ? "space units" : "units"));
    for (std::size_t a = 0; a < std::min<std::size_t>(3, units.size()); ++a) {
        if (a > 0 && units[a] == units[0]) {
            facts.mm_per_spacing[int(a)] = facts.mm_per_spacing[0];
            continue;
        }
        if (in_space && a > 0) refuse(file, "its space units differ from axis to axis");
        facts.mm_per_spacing[int(a)] = mm_of(units[a], facts);
    }
    facts.mm_per_origin = facts.mm_per_spacing;
}

/// Spacing and origin by the positions of both ends (teem's "axis mins" and "axis maxs").
void read_nrrd_ends(const fs::path& file, const Fields& f, const std::vector<std::int64_t>& sizes, HeaderFacts& facts) {
    const auto text = [&](const char* spaced, const char* joined) {
        return f.contains(spaced) ? field(f, spaced) : field(f, joined);
    };
    const auto lo = numbers_in<double>(text("axis mins", "axismins")),
               hi = numbers_in<double>(text("axis maxs", "axismaxs"));
    const std::size_t axes = std::min<std::size_t>(3, sizes.size());
    if (!lo || !hi || lo->size() < axes || hi->size() < axes) return warn_of_spacing(facts);
    const std::string centers = field(f, f.contains("centerings") ? "centerings" : "centers");
    const auto centerings = split(centers, " \t");
    glm::dvec3 spacing(1), origin(0);
    for (std::size_t a = 0; a < axes; ++a) {
        const bool node = a < centerings.size() && lower_case(centerings[a]) == "node";
        const double steps = double(node ? std::max<std::int64_t>(1, sizes[a] - 1) : sizes[a]);
        const double step = ((*hi)[a] - (*lo)[a]) / steps;
        if (!(step > 0 && std::isfinite(step)))
            refuse(file, "its axis mins and axis maxs make no spacing, which must be a positive number of mm");
        spacing[int(a)] = step;
        origin[int(a)] = (*lo)[a] + (node ? 0 : step / 2);
    }
    facts.spacing = spacing;
    facts.origin = origin;
}

}  // namespace

HeaderFacts check_nrrd(const fs::path& file) {
    const NrrdHeader header = nrrd_header(file);
    const Fields& f = header.fields;
    check_spacing(file, "spacings", field(f, "spacings"));
    const auto sizes = numbers_in<std::int64_t>(field(f, "sizes"));
    if (!sizes || sizes->empty()) refuse(file, "its sizes '" + field(f, "sizes") + "' are no whole numbers");
    std::uint64_t need = nrrd_type_bytes(file, field(f, "type"));
    for (const std::int64_t n : *sizes) need = checked_bytes(file.string(), n, 1, 1, need);
    HeaderFacts facts;
    if (!f.contains("spacings") && !f.contains("space directions")) read_nrrd_ends(file, f, *sizes, facts);
    read_nrrd_units(file, f, facts);

    std::string named = field(f, "data file");
    if (named.empty()) named = field(f, "datafile");
    const bool detached = f.contains("data file") || f.contains("datafile");
    if (detached && is_list(file, named)) return facts;
    const fs::path data = detached ? file.parent_path() / named : file;
    const std::uint64_t end = detached ? size_or_refuse(file, data, named) : fs::file_size(file);
    const std::string encoding = lower_case(field(f, "encoding"));
    const auto skips = [&](const char* spaced, const char* joined) {
        const std::string text = f.contains(spaced) ? field(f, spaced) : field(f, joined);
        return number_in<std::int64_t>(text).value_or(0);
    };
    const std::int64_t skip = skips("byte skip", "byteskip"), lines = skips("line skip", "lineskip");
    StoredVoxels voxels{
        data, detached ? 0 : header.end, 0, need, encoding != "raw", false, lower_case(field(f, "endian")) == "big"};
    if (encoding != "raw" && encoding != "gzip" && encoding != "gz") return facts;
    if (lines > 0) voxels.offset = behind_lines(file, data, voxels.offset, lines);
    if (voxels.packed) {
        if (skip < 0) refuse(file, "its byte skip of -1 does not go with compressed voxels");
        voxels.skip = std::uint64_t(skip);
        if (__builtin_add_overflow(need, voxels.skip, &need)) refuse(file, "its byte skip is too large");
    } else if (skip < 0) {  // -1: the voxels are the file's last bytes
        if (end - voxels.offset > need) voxels.offset = end - need;
    } else {
        voxels.offset += std::min(std::uint64_t(skip), end - voxels.offset);
    }
    check_length(file, end - voxels.offset, need, voxels.packed);
    facts.voxels = voxels;
    return facts;
}

namespace {

template <class T>
T swapped(T value) {
    auto* bytes = reinterpret_cast<unsigned char*>(&value);
    std::reverse(bytes, bytes + sizeof(T));
    return value;
}

/// The header in the machine's byte order; true: it was stored the other way round.
std::pair<nifti_1_header, bool> nifti_header(const fs::path& file) {
    nifti_1_header h{};
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(gzopen(file.c_str(), "rb"), gzclose);
    if (!in) throw Error(Errc::io, "Cannot read " + file.string() + ": " + std::strerror(errno) + ".");
    if (gzread(in.get(), &h, sizeof h) != int(sizeof h))
        refuse(file, "it is cut short, or no NIfTI file: its header needs 348 bytes");
    if (h.sizeof_hdr == 540 || swapped(h.sizeof_hdr) == 540)
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it is NIfTI-2; convert it to NIfTI-1.");
    if (std::memcmp(h.magic, "ni1", 4) == 0)
        throw Error(Errc::unsupported, "Cannot read " + file.string() +
                                           ": its voxels lie in another file (.img); convert it to one .nii file.");
    if (std::memcmp(h.magic, "n+1", 4) != 0) refuse(file, "it is no NIfTI file (its magic word is missing)");
    const bool other_order = h.dim[0] < 1 || h.dim[0] > 7;
    if (other_order) {
        for (short& d : h.dim) d = swapped(d);
        for (float& p : h.pixdim) p = swapped(p);
        for (float* f : {&h.vox_offset, &h.scl_slope, &h.scl_inter}) *f = swapped(*f);
        for (short* s : {&h.datatype, &h.bitpix, &h.qform_code, &h.sform_code}) *s = swapped(*s);
    }
    if (h.dim[0] < 1 || h.dim[0] > 7) refuse(file, "its number of dimensions is not within 1 to 7");
    return {h, other_order};
}

StoredType nifti_type(const fs::path& file, const nifti_1_header& h) {
    static const std::pair<int, StoredType> k_types[] = {{DT_UINT8, StoredType::u8},    {DT_INT8, StoredType::i8},
                                                         {DT_UINT16, StoredType::u16},  {DT_INT16, StoredType::i16},
                                                         {DT_UINT32, StoredType::u32},  {DT_INT32, StoredType::i32},
                                                         {DT_UINT64, StoredType::u64},  {DT_INT64, StoredType::i64},
                                                         {DT_FLOAT32, StoredType::f32}, {DT_FLOAT64, StoredType::f64}};
    for (const auto& [code, type] : k_types) {
        if (code != h.datatype) continue;
        if (std::size_t(h.bitpix) != 8 * size_of(type))
            refuse(file, "its bitpix " + std::to_string(h.bitpix) + " does not fit its datatype " +
                             std::to_string(h.datatype));
        return type;
    }
    throw Error(Errc::unsupported, "Cannot read " + file.string() + ": its voxels are of datatype " +
                                       std::to_string(h.datatype) +
                                       " (colours, complex or single bits); only scalar volumes can be opened.");
}

std::uint64_t nifti_offset(const fs::path& file, const nifti_1_header& h) {
    if (h.vox_offset == 0 || std::isnan(h.vox_offset)) return 352;  // what the format asks for at least
    if (!(h.vox_offset >= 352 && h.vox_offset < 1e15f))
        refuse(file, "its vox_offset is " + std::to_string(h.vox_offset) + ", but must be 352 at least");
    return std::uint64_t(h.vox_offset);
}

}  // namespace

HeaderFacts check_nifti(const fs::path& file) {
    const auto [h, other_order] = nifti_header(file);
    HeaderFacts facts;
    facts.type = nifti_type(file, h);
    std::uint64_t need = size_of(*facts.type);
    for (int a = 1; a <= h.dim[0]; ++a) {
        need = checked_bytes(file.string(), h.dim[a], 1, 1, need);
        if (a > 3 && h.dim[a] > 1)
            throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it holds " + std::to_string(h.dim[a]) +
                                               " volumes (time points or channels); extract one first.");
        if (a <= 3 && !(h.pixdim[a] > 0 && std::isfinite(h.pixdim[a])))
            refuse(file, "its spacing pixdim[" + std::to_string(a) + "] is " + std::to_string(h.pixdim[a]) +
                             ", but spacings must be positive numbers of mm");
    }
    if (std::isfinite(h.scl_slope) && h.scl_slope != 0) {  // zero: no scale at all
        facts.slope = h.scl_slope;
        facts.intercept = std::isfinite(h.scl_inter) ? h.scl_inter : 0;
    }
    if (h.qform_code <= 0 && h.sform_code <= 0)
        facts.warnings.push_back(
            {"The file states no orientation (neither qform nor sform): left and right cannot be "
             "known from it.",
             0});
    const bool packed = lower_case(file.extension().string()) == ".gz";
    const bool swap = other_order == (std::endian::native == std::endian::little);
    const std::uint64_t offset = nifti_offset(file, h);
    // Readers agree to ignore bytes behind the voxels.
    facts.voxels = StoredVoxels{file, packed ? 0 : offset, packed ? offset : 0, need, packed, true, swap};
    std::error_code ec;
    const std::uint64_t have = fs::file_size(file, ec);
    if (packed || have < need + offset) check_length(file, have, need + (packed ? 0 : offset), packed);
    return facts;
}

}  // namespace lacuna
