#pragma once

#include <string>
#include <string_view>

namespace lacuna {

/// A field of a CSV line (RFC 4180), quoted where it must be.
std::string csv_field(std::string_view text);

}  // namespace lacuna
