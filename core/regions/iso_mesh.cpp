#include "core/regions/iso_mesh.h"

#include <algorithm>
#include <limits>

#include "core/regions/surface_mesher.h"

namespace lacuna {

namespace {

template <class T>
TriangleMesh march(const Volume& volume, double iso, const JobContext& job) {
    const VolumeView<T> view = volume.view<T>();
    const glm::ivec3 size = view.size, extent = size + 2;
    const float level = float(iso);
    SurfaceMesher mesher(extent, glm::ivec3(-1), volume.geometry(), {level, std::numeric_limits<float>::infinity()});
    const std::size_t plane = std::size_t(extent.x) * std::size_t(extent.y);
    std::vector<std::uint8_t> inside(plane);
    std::vector<float> values(plane);
    for (int z = -1; z <= size.z; ++z) {
        std::fill(inside.begin(), inside.end(), 0);
        std::fill(values.begin(), values.end(), std::numeric_limits<float>::quiet_NaN());
        for (int y = 0; z >= 0 && z < size.z && y < size.y; ++y) {
            const T* row = view.row(y, z);
            const std::size_t to = std::size_t(y + 1) * std::size_t(extent.x) + 1;
            for (int x = 0; x < size.x; ++x) {
                values[to + std::size_t(x)] = float(row[x]);
                inside[to + std::size_t(x)] = float(row[x]) >= level;  // false for NaN
            }
        }
        mesher.push(inside.data(), values.data());
        job.checkpoint(std::size_t(z + 2), std::size_t(extent.z));
    }
    return mesher.finish();
}

}  // namespace

TriangleMesh iso_mesh(const Volume& volume, double iso, const JobContext& job) {
    TriangleMesh mesh = visit_type(volume.type(), [&](auto tag) { return march<decltype(tag)>(volume, iso, job); });
    if (mesh.triangles.empty())
        throw Error(Errc::bad_input, "No voxel reaches the isovalue, so there is no surface; choose a lower one.");
    return mesh;
}

}  // namespace lacuna
