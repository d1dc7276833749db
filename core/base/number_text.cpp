#include "core/base/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {

// fmt without 'L' never asks the locale: always a dot.
std::string exact_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

}  // namespace lacuna
