#pragma once

#include <string>
#include <vector>

#include "core/volume/volume.h"

namespace lacuna {

/// Checks what a file says of its grid and makes the axes exactly orthonormal where they are so within 1e-3 (a warning
/// with the largest position error is added above 1e-5, which is the rounding of stored decimals).
/// @throws Error(bad_input) naming `what` for a spacing that is not positive, an origin that is not finite, or worse
/// axes
void repair_grid(const std::string& what, GridGeometry& geometry, std::vector<Warning>& warnings);

}  // namespace lacuna
