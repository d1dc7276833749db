#include "core/io/header_text.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
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

void check_pattern(const fs::path& header, const std::string& named) {
    const std::size_t at = named.find('%');
    if (at == std::string::npos) return;
    constexpr std::size_t k_most_digits = 2;
    const std::size_t end = named.find_first_not_of("0123456789", at + 1);
    if (end == std::string::npos || named[end] != 'd' || end - at - 1 > k_most_digits ||
        named.find('%', end) != std::string::npos)
        refuse(header, "its data files '" + named + "' are no pattern of names with one whole number (%d) in it");
}

std::vector<std::string> names_of_pattern(const fs::path& header, const std::string& named, std::int64_t count) {
    check_pattern(header, named);
    const auto words = split(named, " \t");
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (const auto number = number_in<std::int32_t>(words[i])) numbers.push_back(*number);
    const std::int64_t first = numbers.empty() ? 1 : numbers[0];
    const std::int64_t last = numbers.size() > 1 ? numbers[1] : first + count - 1;
    const std::int64_t step = numbers.size() > 2
                                  ? numbers[2]
                                  : std::max<std::int64_t>(1, (last - first) / std::max<std::int64_t>(1, count - 1));
    constexpr std::int64_t k_most_files = 1'000'000;
    const bool sound = !words.empty() && words[0].find('%') != std::string_view::npos &&
                       numbers.size() + 1 == words.size() && numbers.size() <= 3 && step > 0 && last >= first &&
                       count <= k_most_files;
    if (!sound || (last - first) / step + 1 != count)
        refuse(header,
               "its data files '" + named + "' are not the " + std::to_string(count) + " that its sizes ask for");
    const std::size_t at = words[0].find('%'), end = words[0].find('d', at);
    const std::string_view width = words[0].substr(at + 1, end - at - 1);
    const std::size_t digits = number_in<std::size_t>(width).value_or(0);
    std::vector<std::string> names;
    for (std::int64_t i = first; i <= last; i += step) {
        std::string number = std::to_string(std::abs(i));
        const std::size_t sign = i < 0 ? 1 : 0;
        const std::size_t missing = digits > number.size() + sign ? digits - number.size() - sign : 0;
        const bool zeros = width.starts_with('0');
        number = (zeros ? "" : std::string(missing, ' ')) + (sign ? "-" : "") +
                 (zeros ? std::string(missing, '0') : "") + number;
        names.push_back(std::string(words[0].substr(0, at)) + number + std::string(words[0].substr(end + 1)));
    }
    return names;
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
