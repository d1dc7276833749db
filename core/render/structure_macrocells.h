#pragma once

#include <memory>

#include "core/render/structure_family.h"

namespace lacuna {

/// Min-max macro-cells of 8^3 voxels: classified anew when the transfer function, isovalue or ranges change.
std::unique_ptr<StructureFamily> make_macrocell_family();

}  // namespace lacuna
