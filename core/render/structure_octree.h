#pragma once

#include <memory>

#include "core/render/structure_family.h"

namespace lacuna {

/// The full min-max-average octree with kd-restart (Lesar 2015; minmax_octree.h): built once a volume, its nodes'
/// classes anew when the transfer function, isovalue, ranges or Plan::homogeneity change.
std::unique_ptr<StructureFamily> make_octree_family();

}  // namespace lacuna
