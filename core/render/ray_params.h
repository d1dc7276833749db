#pragma once

#include "core/render/plan.h"
#include "core/render/scene.h"
#include "core/render/transfer_tables.h"
#include "shared/ray_params.h"

namespace lacuna {

/// The kernels' parameters for a scene under a plan, less those of its structure (StructureCache): everything in voxel
/// coordinates, single precision, from doubles.
/// @param stored_size  voxels stored an axis on the device (at least 2)
/// @param tables       may be null for modes without a transfer function
RayParams make_ray_params(const Scene& scene, const Plan& plan, glm::ivec3 stored_size, const TransferTables* tables);

/// Puts in another volume's voxels: its size, that stored, and the strides. What describes rays stays.
void put_volume(RayParams& params, glm::ivec3 size, glm::ivec3 stored_size);

}  // namespace lacuna
