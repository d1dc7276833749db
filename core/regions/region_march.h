#pragma once

#include <functional>

#include "core/regions/regions.h"
#include "core/regions/surface_mesher.h"

namespace lacuna {

/// @throws Error(bad_input) if the row's box does not lie in the labels
void check_box(const LabelVolume& labels, const RegionCharacteristics& region);

/// Hands one region to the mesher made for it, slice by slice of its box padded by a voxel on each side.
/// @param volume      whose values place the vertices; null: half way
/// @param after_slice  called behind each slice, where what is finished may be taken
void march_region(const LabelVolume& labels, const RegionCharacteristics& region, const Volume* volume,
                  SurfaceMesher& mesher, const std::function<void()>& after_slice, const JobContext& job);

/// The mesher march_region() needs.
SurfaceMesher mesher_for(const LabelVolume& labels, const RegionCharacteristics& region, SurfaceLevel level);

}  // namespace lacuna
