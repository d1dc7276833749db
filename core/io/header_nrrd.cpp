#include "core/io/header_check.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
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

/// Stands before the keys of key/value pairs ("key:=value"), which are none of the format's own fields.
const std::string k_pair = ":=";

HeaderText nrrd_text(const fs::path& file) {
    const std::string text = head_of(file);
    if (!text.starts_with("NRRD")) refuse(file, "it is no NRRD file (it does not start with NRRD)");
    HeaderText header;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t stop = std::min(text.find('\n', at), text.size());
        const std::string_view line = trimmed(std::string_view(text).substr(at, stop - at));
        at = std::min(stop + 1, text.size());
        if (line.empty()) break;
        if (const auto pair = line.find(":="); pair != std::string_view::npos && pair < line.find(": ")) {
            if (line.front() != '#') header.fields[k_pair + std::string(line.substr(0, pair))] = line.substr(pair + 2);
            continue;
        }
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
std::vector<std::string> quoted_texts(const std::string& text) {
    std::vector<std::string> found;
    for (std::size_t from = text.find('"'); from != std::string::npos; from = text.find('"', from)) {
        const std::size_t to = text.find('"', from + 1);
        if (to == std::string::npos) break;
        found.push_back(text.substr(from + 1, to - from - 1));
        from = to + 1;
    }
    return found;
}

/// A field that newer files spell in two words and older ones in one.
std::string either(const Fields& f, const std::string& first, const std::string& second) {
    const std::string spaced = first + " " + second;
    return field(f, f.contains(spaced) ? spaced : first + second);
}

/// Arrays of one value a voxel may be written with axes of length 1 before the three of space. Takes those out of the
/// fields that say something of each axis.
void drop_leading_axes(Fields& f) {
    const std::string stated = field(f, "sizes");
    const auto sizes = split(stated, " \t");
    std::size_t leading = 0;
    while (sizes.size() > leading + 3 && sizes[leading] == "1") ++leading;
    if (leading == 0) return;
    for (const char* key :
         {"sizes", "spacings", "axis mins", "axismins", "axis maxs", "axismaxs", "centerings", "centers"})
        if (const auto found = f.find(key); found != f.end()) {
            std::string kept;
            const auto pieces = split(found->second, " \t");
            for (std::size_t a = leading; a < pieces.size(); ++a) kept += std::string(pieces[a]) + " ";
            found->second = kept;
        }
    if (const auto found = f.find("units"); found != f.end()) {
        std::string kept;
        const auto units = quoted_texts(found->second);
        for (std::size_t a = leading; a < units.size(); ++a) kept += "\"" + units[a] + "\" ";
        found->second = kept;
    }
}

/// Units of length: those of space, or those of each axis where its spacing is a number alone.
void read_nrrd_units(const fs::path& file, const Fields& f, HeaderFacts& facts) {
    const bool in_space = f.contains("space directions");
    const auto units = quoted_texts(field(f, in_space ? "space units" : "units"));
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
    const auto lo = numbers_in<double>(either(f, "axis", "mins")), hi = numbers_in<double>(either(f, "axis", "maxs"));
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

/// Where the voxels lie; nothing where they are in several files, or in an encoding that the library reads.
std::optional<StoredVoxels> nrrd_voxels(const fs::path& file, const HeaderText& header, std::uint64_t need) {
    const Fields& f = header.fields;
    const bool detached = f.contains("data file") || f.contains("datafile");
    const std::string named = either(f, "data", "file");
    if (detached && is_list(file, named)) {
        check_pattern(file, named);
        return std::nullopt;
    }
    const fs::path data = detached ? file.parent_path() / named : file;
    const std::uint64_t end = detached ? size_or_refuse(file, data, named) : fs::file_size(file);
    const std::string encoding = lower_case(field(f, "encoding"));
    if (encoding != "raw" && encoding != "gzip" && encoding != "gz") return std::nullopt;
    const std::int64_t skip = number_in<std::int64_t>(either(f, "byte", "skip")).value_or(0),
                       lines = number_in<std::int64_t>(either(f, "line", "skip")).value_or(0);
    StoredVoxels voxels{
        data, detached ? 0 : header.end, 0, need, encoding != "raw", false, lower_case(field(f, "endian")) == "big"};
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
    return voxels;
}

}  // namespace

HeaderFacts check_nrrd(const fs::path& file) {
    HeaderText header = nrrd_text(file);
    Fields& f = header.fields;
    drop_leading_axes(f);
    check_spacing(file, "spacings", field(f, "spacings"));
    const auto sizes = numbers_in<std::int64_t>(field(f, "sizes"));
    if (!sizes || sizes->empty()) refuse(file, "its sizes '" + field(f, "sizes") + "' are no whole numbers");
    std::uint64_t need = nrrd_type_bytes(file, field(f, "type"));
    for (const std::int64_t n : *sizes) need = checked_bytes(file.string(), n, 1, 1, need);
    HeaderFacts facts;
    if (!f.contains("spacings") && !f.contains("space directions")) read_nrrd_ends(file, f, *sizes, facts);
    read_nrrd_units(file, f, facts);
    facts.axis_names = axis_names_of(
        {FileFormat::nrrd, field(f, "space"), true, false, field(f, k_pair + std::string(k_axes_key)) == k_axes_xyz});
    facts.voxels = nrrd_voxels(file, header, need);
    return facts;
}

}  // namespace lacuna
