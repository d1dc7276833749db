#pragma once

#include <memory>

#include "core/render/structure_family.h"

namespace lacuna {

/// Leaps through homogeneous regions (Frey & Ertl 2009; leap_volume.h). Depends on the voxels, Plan::homogeneity (how
/// wide a region's values may be) and Plan::leap; not on the transfer function, isovalue or ranges. Built anew for a
/// longer step than the one it was built for.
std::unique_ptr<StructureFamily> make_leap_family();

}  // namespace lacuna
