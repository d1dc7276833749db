#pragma once

#include <string>

namespace lacuna {

/// Shortest digits that read back the same, dot decimals in every locale; empty for NaN and infinity.
std::string exact_number(double value);

}  // namespace lacuna
