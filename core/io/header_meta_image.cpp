#include "core/io/header_check.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/axis_rule.h"
#include "core/io/header_text.h"
#include "core/io/raw_reader.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace fs = std::filesystem;
using namespace headers;

namespace {

bool says_true(const std::string& text) {
    return !text.empty() && (text[0] == 'T' || text[0] == 't' || text[0] == '1');
}

HeaderText meta_text(const fs::path& file) {
    const std::string text = head_of(file);
    HeaderText header;
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
    const std::string named = field(meta_text(file).fields, "ElementDataFile");
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

/// The names behind "ElementDataFile = LIST", one a line.
std::vector<std::string> names_of_list(const fs::path& file, std::size_t header_end, std::size_t count) {
    const std::string text = head_of(file);
    std::vector<std::string> names;
    for (const auto line : split(std::string_view(text).substr(header_end), "\n"))
        if (!trimmed(line).empty()) names.emplace_back(trimmed(line));
    if (names.size() != count)
        refuse(file, "it lists " + std::to_string(names.size()) + " data files, but its sizes ask for " +
                         std::to_string(count));
    return names;
}

/// Voxels in several files, each a slice, or as many axes as a LIST says. The library takes what is missing for zeros
/// without a word, so they are read like those of one file.
std::vector<StoredVoxels> meta_pieces(const fs::path& file, const HeaderText& header,
                                      const std::vector<std::int64_t>& dims, std::uint64_t need) {
    const Fields& f = header.fields;
    const std::string named = field(f, "ElementDataFile");
    const bool pattern = !named.starts_with("LIST");
    if (!field(f, "BinaryData").empty() && !says_true(field(f, "BinaryData")))
        throw Error(Errc::unsupported,
                    "Cannot read " + file.string() + ": its voxels are stored as text in several files.");
    std::size_t own_axes = dims.size() - 1;
    if (!pattern)
        if (const auto said = number_in<std::size_t>(std::string_view(named).substr(4)))
            own_axes = *said >= 1 && *said <= dims.size() ? *said : own_axes;
    std::int64_t count = 1;
    for (std::size_t a = own_axes; a < dims.size(); ++a) count *= dims[a];
    const auto names =
        pattern ? names_of_pattern(file, named, count) : names_of_list(file, header.end, std::size_t(count));
    const bool packed = says_true(field(f, "CompressedData"));
    const std::int64_t skip = number_in<std::int64_t>(field(f, "HeaderSize")).value_or(0);
    if (skip < 0 && packed) refuse(file, "its HeaderSize -1 does not go with compressed voxels");
    const std::uint64_t bytes = need / std::uint64_t(count);
    std::vector<StoredVoxels> pieces;
    for (const std::string& name : names) {
        const fs::path data = file.parent_path() / name;
        const std::uint64_t end = size_or_refuse(file, data, name);
        if (skip > 0 && std::uint64_t(skip) > end)
            refuse(file, "its HeaderSize " + std::to_string(skip) + " does not lie within the data");
        const std::uint64_t offset = skip < 0 ? end - std::min(end, bytes) : std::uint64_t(skip);
        check_length(data, end - offset, bytes, packed);
        pieces.push_back({data, offset, 0, bytes, packed, false, meta_big_endian(file, f)});
    }
    return pieces;
}

}  // namespace

HeaderFacts check_meta_image(const fs::path& file) {
    const HeaderText header = meta_text(file);
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
    facts.axis_names = axis_names_of({FileFormat::meta_image, field(f, "AnatomicalOrientation")});
    read_meta_scales(f, facts);
    const std::string named = field(f, "ElementDataFile");
    const fs::path data = meta_image_data_file(file);
    const bool local = data.empty() && lower_case(named) == "local";
    if (data.empty() && !local) {
        facts.pieces = meta_pieces(file, header, *dims, need);
        return facts;
    }
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

}  // namespace lacuna
