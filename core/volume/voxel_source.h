#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "core/base/job.h"

namespace lacuna {

/// A box of voxels of a grid: [first, first + size).
struct VoxelBox {
    glm::ivec3 first{0}, size{0};
    std::int64_t voxels() const { return std::int64_t(size.x) * size.y * size.z; }
    friend bool operator==(const VoxelBox&, const VoxelBox&) = default;
};

/// Voxels that need not lie in memory: what a Volume too large for it is made of. Type and grid are the Volume's.
class VoxelSource {
public:
    virtual ~VoxelSource() = default;
    /// Puts the voxels of a box at `out`, in the volume's type, x fastest, without gaps. Works on several threads
    /// itself; may be called from several threads. Cost: the bytes of the rows touched.
    /// @pre the box lies inside the grid. @throws Error(io), Error(cancelled)
    virtual void read(const VoxelBox& box, std::byte* out, const JobContext& job = {}) const = 0;
};

}  // namespace lacuna
