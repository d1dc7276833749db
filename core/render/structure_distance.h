#pragma once

#include <memory>

#include "core/render/structure_family.h"

namespace lacuna {

/// The distance structures pc, acd and eacd (Es, Keles & Isler 2006): over macro-cells of plan.cells voxels, or one
/// entry a voxel as published where plan.cells is 1. One family for the three.
std::unique_ptr<StructureFamily> make_distance_family();

}  // namespace lacuna
