#include <algorithm>

#include "core/regions/regions.h"
#include "core/regions/surface_mesher.h"

namespace lacuna {

namespace {

/// Values of one padded slice; outside the grid NaN.
template <class T>
void read_slice(const VolumeView<T>& view, const glm::ivec3& first, const glm::ivec3& extent, int z, float* out) {
    std::fill(out, out + std::size_t(extent.x) * std::size_t(extent.y), std::numeric_limits<float>::quiet_NaN());
    if (z < 0 || z >= view.size.z) return;
    const int x0 = std::max(0, -first.x), x1 = std::min(extent.x, view.size.x - first.x);
    for (int y = std::max(0, -first.y); y < std::min(extent.y, view.size.y - first.y); ++y) {
        const T* row = view.row(first.y + y, z);
        float* to = out + std::size_t(y) * std::size_t(extent.x);
        for (int x = x0; x < x1; ++x) to[x] = float(row[first.x + x]);
    }
}

TriangleMesh mesh_of(const LabelVolume& labels, const RegionCharacteristics& region, const Volume* volume,
                     SurfaceLevel level, const JobContext& job) {
    const std::vector<std::uint8_t> mask = region_mask(labels, region);
    job.check();
    const glm::ivec3 inner = region.bbox_last - region.bbox_first + 1, extent = inner + 2;
    const glm::ivec3 first = region.bbox_first - 1;
    SurfaceMesher mesher(extent, first, labels.geometry, level);
    const std::size_t plane = std::size_t(extent.x) * std::size_t(extent.y);
    std::vector<std::uint8_t> inside(plane);
    std::vector<float> values(volume ? plane : 0);
    for (int z = 0; z < extent.z; ++z) {
        std::fill(inside.begin(), inside.end(), 0);
        if (z > 0 && z + 1 < extent.z)
            for (int y = 0; y < inner.y; ++y)
                std::copy_n(mask.begin() + (std::int64_t(z - 1) * inner.y + y) * inner.x, inner.x,
                            inside.begin() + std::int64_t(y + 1) * extent.x + 1);
        if (volume)
            visit_type(volume->type(), [&](auto tag) {
                read_slice(volume->view<decltype(tag)>(), first, extent, first.z + z, values.data());
            });
        mesher.push(inside.data(), volume ? values.data() : nullptr);
        job.checkpoint(std::size_t(z) + 1, std::size_t(extent.z));
    }
    return mesher.finish();
}

}  // namespace

TriangleMesh region_mesh(const LabelVolume& labels, const RegionCharacteristics& region, const JobContext& job) {
    return mesh_of(labels, region, nullptr, {}, job);
}

TriangleMesh region_mesh(const Volume& volume, const ValueRange& range, const LabelVolume& labels,
                         const RegionCharacteristics& region, const JobContext& job) {
    if (volume.geometry().size != labels.geometry.size)
        throw Error(Errc::bad_input, "The labels do not lie on the volume's grid; make them from this volume.");
    return mesh_of(labels, region, &volume, {float(range.lo), float(range.hi)}, job);
}

}  // namespace lacuna
