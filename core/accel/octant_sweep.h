#pragma once

#include "core/accel/distance_field.h"

namespace lacuna {

/// One octant of octant_field: `field` has a byte a cell.
void sweep_octant(const RegionGrid& grid, int octant, std::uint8_t* field, const JobContext& job);

}  // namespace lacuna
