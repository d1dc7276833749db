#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/volume/voxel_source.h"

namespace lacuna {

/// A volume cut into bricks. Brick b owns the positions (voxel coordinates) b*edge <= p < (b+1)*edge an axis, the outer
/// ones all beyond the volume's sides too, so that every position belongs to exactly one. It stores the voxels its
/// positions are made from: one row more at the upper side, and `ghost` rows around that (2 for central differences of
/// the trilinear signal, which reach one voxel further both ways, and one for rounding at the plane between bricks).
struct BrickGrid {
    glm::ivec3 size{1};   ///< voxels of the volume
    int edge = 256;       ///< voxels from one brick to the next
    glm::ivec3 ghost{2};  ///< further voxels stored on each side, as far as the volume goes
    glm::ivec3 count{1};  ///< bricks an axis

    BrickGrid() = default;
    BrickGrid(glm::ivec3 size, int edge, glm::ivec3 ghost);

    std::int64_t bricks() const { return std::int64_t(count.x) * count.y * count.z; }
    glm::ivec3 at(std::int64_t index) const;
    std::int64_t index(glm::ivec3 brick) const {
        return (std::int64_t(brick.z) * count.y + brick.y) * count.x + brick.x;
    }
    /// The voxels a brick stores.
    VoxelBox stored(glm::ivec3 brick) const;
    /// Voxels of the largest brick.
    std::int64_t largest_stored() const;
    /// Lower and upper end of the positions it owns; -infinity and infinity on the volume's sides.
    glm::vec3 lo(glm::ivec3 brick) const;
    glm::vec3 hi(glm::ivec3 brick) const;
};

}  // namespace lacuna
