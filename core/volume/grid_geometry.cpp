#include "core/volume/grid_geometry.h"

#include <cmath>

namespace lacuna {

const char* fault_of(const GridGeometry& g) {
    for (int a = 0; a < 3; ++a) {
        if (g.size[a] < 1) return "an axis has no voxels";
        if (!(std::isfinite(g.spacing[a]) && g.spacing[a] > 0)) return "the voxel spacing is not a positive number";
        if (!std::isfinite(g.origin[a])) return "the origin is not a finite position";
    }
    constexpr double k_most_voxels = 4.6e18;  // 2^62: counts of bytes leave 64 bits beyond
    if (!(double(g.size.x) * double(g.size.y) * double(g.size.z) <= k_most_voxels)) return "it has too many voxels";
    if (!(std::isnormal(g.voxel_volume_mm3()) && std::isfinite(g.diameter_mm())))
        return "the voxel spacing is too small or too large to calculate with";
    const glm::dmat3 product = glm::transpose(g.direction) * g.direction;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!(std::abs(product[c][r] - (c == r ? 1.0 : 0.0)) <= 1e-4)) return "the grid axes are not orthonormal";
    return "";
}

}  // namespace lacuna
