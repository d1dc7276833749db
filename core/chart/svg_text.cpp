#include "core/chart/svg_text.h"

#include <fmt/format.h>

#include <cstdint>
#include <map>

namespace lacuna {

namespace {

std::uint32_t fnv1a(std::string_view text) {
    std::uint32_t hash = 2166136261u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}

/// Replaces every id, where it is set and where it is meant, by prefix + its rank of first appearance.
std::string rename_ids(std::string_view svg, std::string_view prefix) {
    constexpr std::string_view k_openers[] = {" id=\"", "href=\"#", "url(#"};
    std::map<std::string, std::size_t, std::less<>> rank;
    std::string out;
    out.reserve(svg.size());
    std::size_t at = 0;
    while (at < svg.size()) {
        std::size_t next = std::string_view::npos;
        std::string_view opener;
        for (const std::string_view candidate : k_openers) {
            const std::size_t found = svg.find(candidate, at);
            if (found < next) next = found, opener = candidate;
        }
        if (next == std::string_view::npos) break;
        const std::size_t begin = next + opener.size();
        const std::size_t end = svg.find_first_of("\")", begin);
        const std::string_view id = svg.substr(begin, end - begin);
        const std::size_t number = rank.emplace(std::string(id), rank.size()).first->second;
        out += svg.substr(at, begin - at);
        out += fmt::format("{}{}", prefix, number);
        at = end;
    }
    out += svg.substr(at);
    return out;
}

/// Length of the UTF-8 sequence at the start of the text; 0 for what is none (overlong forms and surrogates included).
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    if ((lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xed && byte(1) > 0x9f) || (lead == 0xf0 && byte(1) < 0x90) ||
        (lead == 0xf4 && byte(1) > 0x8f))
        return 0;
    return length;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    return out;
}

std::string valid_utf8(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        const auto first = static_cast<unsigned char>(text[0]);
        const bool control = length == 1 && (first == 0x7f || (first < 0x20 && first != '\n' && first != '\t'));
        if (length == 0 || control)
            out += '?';
        else
            out += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out;
}

std::string inline_svg(std::string_view svg, std::string_view title) {
    const std::size_t start = svg.find("<svg");
    if (start != std::string_view::npos) svg.remove_prefix(start);
    const std::string prefix = fmt::format("c{:08x}-", fnv1a(rename_ids(svg, "")) ^ fnv1a(title));
    std::string out = rename_ids(svg, prefix);
    if (const std::size_t end = out.find('>'); !title.empty() && end != std::string::npos)
        out.insert(end + 1, fmt::format("\n<title>{}</title>", xml_escaped(valid_utf8(title))));
    return out;
}

}  // namespace lacuna
