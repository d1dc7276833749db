#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view k_blank = " \t\r\n\f\v";
    const auto from = text.find_first_not_of(k_blank);
    if (from == std::string_view::npos) return {};
    return text.substr(from, text.find_last_not_of(k_blank) - from + 1);
}

inline std::string lower_case(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return out;
}

/// The non-empty pieces between any of the separating characters.
inline std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        const auto end = text.find_first_of(separators);
        if (end != 0) pieces.push_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return pieces;
}
std::vector<std::string_view> split(std::string&& text,
                                    std::string_view separators) = delete;  // of which nothing is left

/// A whole text as one number of type T, whatever the locale; nothing if any character is left over.
template <class T>
std::optional<T> number_in(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    T value{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
    return value;
}

/// All numbers of a list, or nothing if one piece is not a number.
template <class T>
std::optional<std::vector<T>> numbers_in(std::string_view text, std::string_view separators = " \t,") {
    std::vector<T> out;
    for (const auto piece : split(trimmed(text), separators)) {
        const auto value = number_in<T>(piece);
        if (!value) return std::nullopt;
        out.push_back(*value);
    }
    return out;
}

}  // namespace lacuna
