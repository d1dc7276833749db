#pragma once

#include <string>
#include <string_view>

#include "core/volume/grid_geometry.h"

namespace lacuna {

/// The name of an axis' end: "L", "R" (x), "P", "A" (y), "H", "F" (z) of a patient, "+X", "-X" of a part.
/// @param axis  0..2 for x, y, z
std::string_view axis_end(AxisNames names, int axis, bool negative);

/// Where a direction points: the end of the axis of its largest component, and of the others that weigh as much as 25
/// degrees, the largest first: "L", "LA", "+X", "+X-Y".
std::string sides_of(AxisNames names, const glm::dvec3& direction);

/// A grid axis by the ends it runs between, from its lower to its upper end: "R–L", "-X…+X" (UTF-8).
std::string axis_span(AxisNames names, const glm::dvec3& direction);

/// A coordinate as it is told: how far on which side of a patient ("R", 12.5), a signed number of a part ("X", -12.5).
struct AxisPlace {
    std::string_view name;
    double mm = 0;
};
AxisPlace place_along(AxisNames names, int axis, double mm);

/// The axis a direction is closest to, 0..2.
int closest_axis(const glm::dvec3& direction);

}  // namespace lacuna
