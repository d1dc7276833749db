#pragma once

#include <cstdint>

#include "core/render/plan.h"
#include "core/render/scene.h"

namespace lacuna {

/// What a picture may take.
struct MemoryBudget {
    std::uint64_t total = 0;              ///< bytes of host and device together
    std::uint64_t device_allocation = 0;  ///< largest buffer; 0: no limit
    std::uint64_t device_total = 0;       ///< the device's own memory; 0: it shares the host's
};

/// What a program takes before the first voxel: its libraries, the driver, the driver's compiler. It lies inside the
/// limit of `MemoryBudget::total` where that is at least twice as much, else beside it.
inline constexpr std::uint64_t k_program_bytes = std::uint64_t(384) << 20;

/// 75 % of the machine's memory.
std::uint64_t default_memory_limit();

/// Whether the scene's volume can be drawn in one piece: it lies in memory, has at most 2^32 voxels, the device takes
/// it in one buffer, and all together stays within the budget.
bool fits_whole(const Scene& scene, const MemoryBudget& budget);

/// Whether the plan and the scene ask for what only the whole volume tells, so that bricks cannot serve them.
bool takes_whole_volume(const Plan& plan, const Scene& scene);

/// The plan with bricks where the volume does not fit whole, or where the plan asks for them (brick > 0): their edge,
/// what they may take together, and why.
/// @throws Error(out_of_memory) naming the least limit where not even the smallest bricks fit
Plan with_bricks(const Plan& plan, const Scene& scene, const MemoryBudget& budget);

/// Voxels a brick must store around those its positions need: 2 for gradients, and for a hit refined between two
/// samples as many as lie between these.
glm::ivec3 ghost_voxels(const Scene& scene, const Plan& plan);

}  // namespace lacuna
