#include <algorithm>

#include "core/regions/region_march.h"
#include "core/regions/regions.h"
#include "core/regions/value_window.h"

namespace lacuna {

void check_box(const LabelVolume& labels, const RegionCharacteristics& region) {
    const glm::ivec3 first = region.bbox_first, extent = region.bbox_last - first + 1;
    if (glm::any(glm::lessThan(first, glm::ivec3(0))) || glm::any(glm::lessThan(extent, glm::ivec3(1))) ||
        glm::any(glm::greaterThanEqual(region.bbox_last, labels.geometry.size)) || !labels.labels)
        throw Error(Errc::bad_input, "The region's box lies outside the labels; measure these labels first.");
}

SurfaceMesher mesher_for(const LabelVolume& labels, const RegionCharacteristics& region, SurfaceLevel level) {
    check_box(labels, region);
    return {region.bbox_last - region.bbox_first + 3, region.bbox_first - 1, labels.geometry, level};
}

void march_region(const LabelVolume& labels, const RegionCharacteristics& region, const Volume* volume,
                  SurfaceMesher& mesher, const std::function<void()>& after_slice, const JobContext& job) {
    const glm::ivec3 inner = region.bbox_last - region.bbox_first + 1, extent = inner + 2;
    const glm::ivec3 first = region.bbox_first - 1;
    std::vector<std::uint8_t> inside(std::size_t(extent.x) * std::size_t(extent.y));
    std::optional<SliceReader> reader;
    if (volume) reader.emplace(*volume, first, extent);
    for (int z = 0; z < extent.z; ++z) {
        std::fill(inside.begin(), inside.end(), 0);
        for (int y = 0; z > 0 && z + 1 < extent.z && y < inner.y; ++y) {
            const std::uint32_t* row =
                labels.labels->data() +
                labels.geometry.linear_index(region.bbox_first.x, region.bbox_first.y + y, first.z + z);
            std::uint8_t* to = inside.data() + std::size_t(y + 1) * std::size_t(extent.x) + 1;
            for (int x = 0; x < inner.x; ++x) to[x] = row[x] == region.id;
        }
        mesher.push(inside.data(), reader ? reader->read(z).data() : nullptr);
        after_slice();
        job.checkpoint(std::size_t(z) + 1, std::size_t(extent.z));
    }
}

namespace {

TriangleMesh mesh_of(const LabelVolume& labels, const RegionCharacteristics& region, const Volume* volume,
                     SurfaceLevel level, const JobContext& job) {
    job.check();
    SurfaceMesher mesher = mesher_for(labels, region, level);
    march_region(
        labels, region, volume, mesher, [] {}, job);
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
