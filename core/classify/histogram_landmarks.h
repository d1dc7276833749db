#pragma once

#include <cstdint>
#include <vector>

#include "core/volume/volume.h"

namespace lacuna {

/// Values at which a histogram has its clear peaks and, between them, its deepest valleys, ascending: where a point of
/// a transfer function belongs. Counts are taken as log(1 + n) in at most 256 bins and smoothed by (1 2 1)/4 twice; a
/// peak counts if the valleys beside it are at least 8 % of the highest peak deeper. A flat or empty histogram has
/// none.
std::vector<double> histogram_landmarks(const std::vector<std::uint64_t>& counts, ValueRange range);

}  // namespace lacuna
