#include "core/render/shear_factor.h"

namespace lacuna {

Shear::Shear(const ViewRays& rays, const GridGeometry& geometry, int regions) {
    const glm::dvec3 along = geometry.vector_to_voxel(rays.forward);
    direction = slice_direction(along, regions);
    const int axis = direction.axis, u = direction.u_axis(), v = direction.v_axis();
    slope = glm::dvec2(along[u], along[v]) / along[axis];
    slice_mm = 1 / std::fabs(along[axis]);

    const double last = geometry.size[axis] - 1;
    shift = glm::ceil(glm::max(last * slope, glm::dvec2(0))) + 2.0;
    size = glm::ivec2(geometry.size[u], geometry.size[v]) + glm::ivec2(glm::ceil(last * glm::abs(slope))) + 5;

    const auto sheared = [&](const glm::dvec3& mm) {
        const glm::dvec3 voxel = geometry.mm_to_voxel(mm);
        return glm::dvec2(voxel[u], voxel[v]) - voxel[axis] * slope + shift;
    };
    at_first = sheared(rays.origin(0, 0));
    per_column = sheared(rays.origin(1, 0)) - at_first;
    per_row = sheared(rays.origin(0, 1)) - at_first;

    const auto depth_of = [&](const glm::dvec3& voxel) {
        return glm::dot(geometry.voxel_to_mm(voxel) - rays.eye, rays.forward);
    };
    depth_origin_mm = depth_of(glm::dvec3(0));
    for (int a = 0; a < 3; ++a) {
        glm::dvec3 one(0);
        one[a == 0 ? u : a == 1 ? v : axis] = 1;
        depth_per_voxel_mm[a] = depth_of(one) - depth_origin_mm;
    }
}

}  // namespace lacuna
