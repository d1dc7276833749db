#include "app/parse.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace lacuna::cli {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// from_chars reads no leading '+'; one is allowed here.
std::string_view without_plus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    return text;
}

bool read_number(std::string_view text, double& value) {
    text = without_plus(text);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

}  // namespace

void refuse(std::string_view flag, std::string_view text, std::string_view wanted) {
    throw Error(Errc::bad_usage, fmt::format("{}: \"{}\" is not {}.", flag, text, wanted));
}

double parse_number(std::string_view flag, std::string_view text) {
    double value = 0;
    if (!read_number(text, value)) refuse(flag, text, "a number");
    return value;
}

std::int64_t parse_integer(std::string_view flag, std::string_view text, std::int64_t least, std::int64_t most) {
    const std::string_view digits = without_plus(text);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < least || value > most)
        refuse(flag, text, fmt::format("a whole number from {} to {}", least, most));
    return value;
}

std::vector<double> parse_numbers(std::string_view flag, std::string_view text, std::size_t count) {
    std::vector<double> values;
    for (const std::string_view part : split(text, ',')) {
        double value = 0;
        if (!read_number(part, value)) refuse(flag, text, fmt::format("{} numbers separated by commas", count));
        values.push_back(value);
    }
    if (values.size() != count) refuse(flag, text, fmt::format("{} numbers separated by commas", count));
    return values;
}

ValueRange parse_range(std::string_view flag, std::string_view text) {
    const std::vector<double> ends = parse_numbers(flag, text, 2);
    if (ends[0] > ends[1]) refuse(flag, text, "a range LO,HI with LO not above HI");
    return {ends[0], ends[1]};
}

glm::ivec2 parse_size(std::string_view flag, std::string_view text) {
    const std::vector<std::string_view> parts = split(text, 'x');
    glm::ivec2 size(0);
    if (parts.size() == 2) {
        for (int i = 0; i < 2; ++i) {
            const char* last = parts[std::size_t(i)].data() + parts[std::size_t(i)].size();
            const auto [end, error] = std::from_chars(parts[std::size_t(i)].data(), last, size[i]);
            if (error != std::errc() || end != last) size[i] = 0;
        }
    }
    if (size.x < 1 || size.y < 1 || size.x > 16384 || size.y > 16384)
        refuse(flag, text, "a picture size WxH, each side from 1 to 16384");
    return size;
}

double RangeEnd::resolve(const VolumeStatistics& statistics) const {
    switch (kind) {
        case Kind::smallest:
            return statistics.range.lo;
        case Kind::largest:
            return statistics.range.hi;
        case Kind::otsu:
            return otsu_threshold(statistics);
        case Kind::number:
            break;
    }
    return number;
}

std::array<RangeEnd, 2> parse_word_range(std::string_view flag, std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ',');
    std::array<RangeEnd, 2> ends;
    const char* const wanted = "a range LO,HI (each a number, min, otsu or max) with LO not above HI";
    if (parts.size() != 2) refuse(flag, text, wanted);
    for (std::size_t i = 0; i < 2; ++i) {
        RangeEnd& end = ends[i];
        if (parts[i] == "min")
            end.kind = RangeEnd::Kind::smallest;
        else if (parts[i] == "max")
            end.kind = RangeEnd::Kind::largest;
        else if (parts[i] == "otsu")
            end.kind = RangeEnd::Kind::otsu;
        else if (!read_number(parts[i], end.number))
            refuse(flag, text, wanted);
    }
    const bool numbers = ends[0].kind == RangeEnd::Kind::number && ends[1].kind == RangeEnd::Kind::number;
    if (numbers && ends[0].number > ends[1].number) refuse(flag, text, wanted);
    return ends;
}

}  // namespace lacuna::cli
