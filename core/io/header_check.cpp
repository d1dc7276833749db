#include "core/io/header_check.h"

#include <nifti1.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
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
        if (s && !(*s > 0 && std::isfinite(*s)))
            refuse(file, "its " + key + " is '" + std::string(trimmed(text)) +
                             "', but spacings must be positive numbers of mm");
    }
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
    if (named == "LOCAL" || named == "Local" || named == "local" || named.starts_with("LIST") ||
        named.find('%') != std::string::npos)
        return {};
    return file.parent_path() / named;
}

HeaderFacts check_meta_image(const fs::path& file) {
    const MetaHeader header = meta_header(file);
    const Fields& f = header.fields;
    for (const char* key : {"ElementSpacing", "ElementSize"}) check_spacing(file, key, field(f, key));
    const auto dims = numbers_in<std::int64_t>(field(f, "DimSize"));
    if (!dims || dims->empty() || std::int64_t(dims->size()) != number_in<std::int64_t>(field(f, "NDims")).value_or(-1))
        refuse(file, "its DimSize '" + field(f, "DimSize") + "' does not fit its NDims '" + field(f, "NDims") + "'");
    if (const auto channels = field(f, "ElementNumberOfChannels"); !channels.empty() && channels != "1")
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it has " + channels +
                                           " values a voxel; only scalar volumes can be opened.");
    std::uint64_t need = meta_type_bytes(file, field(f, "ElementType"));
    for (const std::int64_t n : *dims) need = checked_bytes(file.string(), n, 1, 1, need);
    const std::string named = field(f, "ElementDataFile");
    const fs::path data = meta_image_data_file(file);
    const bool compressed = says_true(field(f, "CompressedData"));
    const bool local = data.empty() && lower_case(named) == "local";
    if (data.empty() && !local) return {};  // a list or a pattern: the library reports what is missing
    std::uint64_t have = local ? fs::file_size(file) - header.end : size_or_refuse(file, data, named);
    const std::int64_t skip = number_in<std::int64_t>(field(f, "HeaderSize")).value_or(0);
    const bool binary = field(f, "BinaryData").empty() || says_true(field(f, "BinaryData"));
    HeaderFacts facts;
    if (binary && !compressed) {
        const bool big = says_true(field(f, "BinaryDataByteOrderMSB")) || says_true(field(f, "ElementByteOrderMSB"));
        const std::uint64_t before = skip < 0 ? have - std::min(have, need) : std::uint64_t(skip);
        facts.plain = {local ? file : data, (local ? header.end : 0) + before, big};
    }
    if (skip < 0) return facts;  // -1: the voxels are the file's last bytes
    if (std::uint64_t(skip) > have)
        refuse(file, "its HeaderSize " + std::to_string(skip) + " is longer than the data file");
    if (binary) check_length(file, have - std::uint64_t(skip), need, compressed);
    if (compressed) facts.compressed = {local ? file : data, (local ? header.end : 0) + std::uint64_t(skip), need};
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

HeaderFacts check_nrrd(const fs::path& file) {
    const NrrdHeader header = nrrd_header(file);
    const Fields& f = header.fields;
    check_spacing(file, "spacings", field(f, "spacings"));
    const auto sizes = numbers_in<std::int64_t>(field(f, "sizes"));
    if (!sizes || sizes->empty()) refuse(file, "its sizes '" + field(f, "sizes") + "' are no whole numbers");
    std::uint64_t need = nrrd_type_bytes(file, field(f, "type"));
    for (const std::int64_t n : *sizes) need = checked_bytes(file.string(), n, 1, 1, need);

    std::string named = field(f, "data file");
    if (named.empty()) named = field(f, "datafile");
    const bool detached = f.contains("data file") || f.contains("datafile");
    if (detached && (named.starts_with("LIST") || named.find('%') != std::string::npos)) return {};
    const std::uint64_t have =
        detached ? size_or_refuse(file, file.parent_path() / named, named) : fs::file_size(file) - header.end;
    const std::string encoding = lower_case(field(f, "encoding"));
    const auto skips = [&](const char* spaced, const char* joined) {
        const std::string text = f.contains(spaced) ? field(f, spaced) : field(f, joined);
        return number_in<std::int64_t>(text).value_or(0);
    };
    const std::int64_t skip = skips("byte skip", "byteskip");
    if (skips("line skip", "lineskip") != 0 || skip < 0) return {};
    HeaderFacts facts;
    if (encoding == "raw") {
        check_length(file, have - std::min(have, std::uint64_t(skip)), need, false);
        facts.plain = {detached ? file.parent_path() / named : file, (detached ? 0 : header.end) + std::uint64_t(skip),
                       lower_case(field(f, "endian")) == "big"};
    }
    if (encoding == "gzip" || encoding == "gz") {
        check_length(file, have, need, true);
        facts.compressed = {detached ? file.parent_path() / named : file, detached ? 0 : header.end,
                            need + std::uint64_t(skip)};
    }
    return facts;
}

namespace {

template <class T>
T swapped(T value) {
    auto* bytes = reinterpret_cast<unsigned char*>(&value);
    std::reverse(bytes, bytes + sizeof(T));
    return value;
}

nifti_1_header nifti_header(const fs::path& file) {
    nifti_1_header h{};
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> in(gzopen(file.c_str(), "rb"), gzclose);
    if (!in) throw Error(Errc::io, "Cannot read " + file.string() + ": " + std::strerror(errno) + ".");
    if (gzread(in.get(), &h, sizeof h) != int(sizeof h)) refuse(file, "it is shorter than a NIfTI header of 348 bytes");
    if (h.sizeof_hdr == 540 || swapped(h.sizeof_hdr) == 540)
        throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it is NIfTI-2; convert it to NIfTI-1.");
    if (std::memcmp(h.magic, "n+1", 4) != 0 && std::memcmp(h.magic, "ni1", 4) != 0)
        refuse(file, "it is no NIfTI file (its magic word is missing)");
    if (h.dim[0] < 1 || h.dim[0] > 7) {
        for (short& d : h.dim) d = swapped(d);
        for (float& p : h.pixdim) p = swapped(p);
        h.datatype = swapped(h.datatype);
        h.bitpix = swapped(h.bitpix);
        h.vox_offset = swapped(h.vox_offset);
    }
    if (h.dim[0] < 1 || h.dim[0] > 7) refuse(file, "its number of dimensions is not within 1 to 7");
    return h;
}

}  // namespace

HeaderFacts check_nifti(const fs::path& file) {
    const nifti_1_header h = nifti_header(file);
    std::uint64_t need = std::uint64_t(std::max<int>(h.bitpix, 8)) / 8;
    for (int a = 1; a <= h.dim[0]; ++a) {
        need = checked_bytes(file.string(), h.dim[a], 1, 1, need);
        if (a > 3 && h.dim[a] > 1)
            throw Error(Errc::unsupported, "Cannot read " + file.string() + ": it holds " + std::to_string(h.dim[a]) +
                                               " volumes (time points or channels); extract one first.");
        if (a <= 3 && !(h.pixdim[a] > 0 && std::isfinite(h.pixdim[a])))
            refuse(file, "its spacing pixdim[" + std::to_string(a) + "] is " + std::to_string(h.pixdim[a]) +
                             ", but spacings must be positive numbers of mm");
    }
    HeaderFacts facts;
    std::error_code ec;
    const std::uint64_t have = fs::file_size(file, ec);
    if (std::memcmp(h.magic, "n+1", 4) == 0) {
        const bool compressed = lower_case(file.extension().string()) == ".gz";
        const auto offset = std::uint64_t(std::max(352.0f, std::isfinite(h.vox_offset) ? h.vox_offset : 0.0f));
        if (compressed) {
            check_length(file, have, need, true);
            facts.compressed = {file, 0, need + offset, true};
        } else if (have < need + offset) {  // readers agree to ignore bytes behind the voxels
            check_length(file, have, need + offset, false);
        }
    }
    const short t = h.datatype;
    facts.stored_as_integer = t == DT_UINT8 || t == DT_INT16 || t == DT_INT32 || t == DT_INT8 || t == DT_UINT16 ||
                              t == DT_UINT32 || t == DT_INT64 || t == DT_UINT64;
    return facts;
}

}  // namespace lacuna
