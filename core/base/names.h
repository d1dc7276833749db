#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/error.h"

namespace lacuna {

/// The values of an enumeration and the words users know them by, in the order they are listed.
template <class Value, std::size_t N>
using NameTable = std::array<std::pair<Value, std::string_view>, N>;

/// The word for a value; empty for one the table lacks.
template <class Value, std::size_t N>
std::string_view name_in(const NameTable<Value, N>& names, Value wanted) {
    for (const auto& [value, name] : names)
        if (value == wanted) return name;
    return "";
}

/// The value of a word. @param what what is named, e.g. "view mode" @throws Error(bad_usage) listing the known words
template <class Value, std::size_t N>
Value parse_name(const NameTable<Value, N>& names, std::string_view text, std::string_view what) {
    std::string known;
    for (const auto& [value, name] : names) {
        if (name == text) return value;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    throw Error(Errc::bad_usage,
                "There is no " + std::string(what) + " '" + std::string(text) + "'; known are " + known + ".");
}

}  // namespace lacuna
