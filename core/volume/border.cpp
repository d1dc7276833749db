#include "core/volume/border.h"

namespace lacuna {

double border_share(const Volume& volume, const VoxelBox& box, const std::function<bool(double value)>& counts) {
    constexpr int k_most = 128;  // places along an edge
    if (!volume.in_memory()) return 0;
    std::int64_t seen = 0, counted = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const int step_u = (box.size[u] + k_most - 1) / k_most, step_v = (box.size[v] + k_most - 1) / k_most;
        for (const int side : {0, box.size[axis] - 1})
            for (int a = 0; a < box.size[u]; a += step_u)
                for (int b = 0; b < box.size[v]; b += step_v) {
                    glm::ivec3 at = box.first;
                    at[axis] += side;
                    at[u] += a;
                    at[v] += b;
                    ++seen;
                    counted += counts(volume.value(at.x, at.y, at.z)) ? 1 : 0;
                }
    }
    return seen == 0 ? 0 : double(counted) / double(seen);
}

}  // namespace lacuna
