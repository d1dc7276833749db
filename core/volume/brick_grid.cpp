#include "core/volume/brick_grid.h"

#include <limits>

namespace lacuna {

namespace {
constexpr float k_infinity = std::numeric_limits<float>::infinity();
}

BrickGrid::BrickGrid(glm::ivec3 volume, int brick_edge, glm::ivec3 ghost_voxels)
    : size(volume), edge(brick_edge), ghost(ghost_voxels) {
    // Positions run from 0 to n - 1, both ends included.
    for (int a = 0; a < 3; ++a) count[a] = glm::max(1, int((std::int64_t(size[a]) - 1 + edge - 1) / edge));
}

glm::ivec3 BrickGrid::at(std::int64_t i) const {
    return {int(i % count.x), int(i / count.x % count.y), int(i / count.x / count.y)};
}

VoxelBox BrickGrid::stored(glm::ivec3 brick) const {
    VoxelBox box;
    for (int a = 0; a < 3; ++a) {
        const std::int64_t from = std::int64_t(brick[a]) * edge - ghost[a];
        const std::int64_t to = std::int64_t(brick[a] + 1) * edge + ghost[a];  // included
        box.first[a] = int(glm::max<std::int64_t>(from, 0));
        box.size[a] = int(glm::min<std::int64_t>(to, size[a] - 1)) - box.first[a] + 1;
    }
    return box;
}

std::int64_t BrickGrid::largest_stored() const {
    std::int64_t voxels = 1;
    for (int a = 0; a < 3; ++a) voxels *= glm::min<std::int64_t>(size[a], std::int64_t(edge) + 2 * ghost[a] + 1);
    return voxels;
}

glm::vec3 BrickGrid::lo(glm::ivec3 brick) const {
    glm::vec3 out;
    for (int a = 0; a < 3; ++a) out[a] = brick[a] == 0 ? -k_infinity : float(std::int64_t(brick[a]) * edge);
    return out;
}

glm::vec3 BrickGrid::hi(glm::ivec3 brick) const {
    glm::vec3 out;
    for (int a = 0; a < 3; ++a)
        out[a] = brick[a] == count[a] - 1 ? k_infinity : float(std::int64_t(brick[a] + 1) * edge);
    return out;
}

}  // namespace lacuna
