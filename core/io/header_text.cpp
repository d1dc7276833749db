#include "core/io/header_text.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "core/io/length_unit.h"
#include "core/io/text_fields.h"

namespace lacuna::headers {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t k_header_limit = std::size_t(1) << 20;
// Deflate cannot shrink by more than 1032:1, so a longer claim is false and must not be allocated.
constexpr std::uint64_t k_deflate_ratio = 1040;

}  // namespace

void refuse(const fs::path& file, const std::string& fault) {
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

std::string field(const Fields& fields, const std::string& key) {
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
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

bool is_list(const fs::path& header, const std::string& named) {
    std::error_code ec;
    return (named.starts_with("LIST") || named.find('%') != std::string::npos) &&
           !fs::is_regular_file(header.parent_path() / named, ec);
}

void warn_of_spacing(HeaderFacts& facts) {
    facts.warnings.push_back({"The voxel spacing is not stated; 1 x 1 x 1 mm is assumed.", 0});
}

double mm_of(const std::string& unit, HeaderFacts& facts) {
    if (trimmed(unit).empty()) return 1;
    if (const auto mm = mm_per_unit(unit)) return *mm;
    facts.warnings.push_back({"The header gives lengths in '" + unit + "', which is no known unit; mm is assumed.", 0});
    return 1;
}

}  // namespace lacuna::headers
