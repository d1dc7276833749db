#pragma once

#include "core/session/document.h"

namespace lacuna {

/// Shifts and widens, as window and level are dragged on a slice, what turns values into what the 3D view's mode shows:
/// the isovalue (iso, shear-warp; shifted only), the transfer function (ea, projections in its colours), the
/// projection's grey window. The function's points keep their order, colours and opacities; its middle is that between
/// its first and last point.
/// @param values  of the volume
/// @param higher  shift of the level, as a share of the width (isovalue: of the volume's values)
/// @param wider   logarithm of the factor on the width
ViewSettings with_levels(const ViewSettings& settings, ValueRange values, double higher, double wider);

}  // namespace lacuna
