#pragma once

#include <optional>
#include <string_view>

#include "core/io/text_fields.h"

namespace lacuna {

/// Millimetres in a unit of length, as headers spell it ("mm", "um", "micron", "nm", "cm", "m", "inch"); nothing for
/// an unknown one.
inline std::optional<double> mm_per_unit(std::string_view unit) {
    static constexpr std::pair<std::string_view, double> k_units[] = {
        {"mm", 1.0},           {"millimeter", 1.0}, {"millimetre", 1.0}, {"millimeters", 1.0}, {"millimetres", 1.0},
        {"m", 1000.0},         {"meter", 1000.0},   {"metre", 1000.0},   {"cm", 10.0},         {"centimeter", 10.0},
        {"um", 1e-3},          {"micron", 1e-3},    {"microns", 1e-3},   {"micrometer", 1e-3}, {"micrometre", 1e-3},
        {"\xc2\xb5m", 1e-3},   {"\xce\xbcm", 1e-3}, {"\xb5m", 1e-3},     {"nm", 1e-6},         {"nanometer", 1e-6},
        {"micrometers", 1e-3}, {"nanometre", 1e-6}, {"inch", 25.4},      {"in", 25.4}};
    const std::string word = lower_case(trimmed(unit));
    for (const auto& [name, mm] : k_units)
        if (word == name) return mm;
    return std::nullopt;
}

}  // namespace lacuna
