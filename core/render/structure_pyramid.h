#pragma once

#include <memory>

#include "core/render/structure_family.h"

namespace lacuna {

/// The pyramid of binary volumes (Levoy 1988; binary_pyramid.h): built anew when the transfer function, isovalue or
/// ranges change. Bits hold no values: the MIP family skips only what lies outside segmentation ranges.
std::unique_ptr<StructureFamily> make_pyramid_family();

}  // namespace lacuna
