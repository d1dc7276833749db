#include <limits>

#include "core/regions/marching_table.h"
#include "core/regions/regions.h"

namespace lacuna {

namespace {

/// Marching cubes over a mask with one layer of outside round it; a slab between two slices at a time.
class MaskMesher {
public:
    MaskMesher(const std::vector<std::uint8_t>& mask, const glm::ivec3& extent, const glm::ivec3& first,
               const GridGeometry& geometry)
        : mask_(mask),
          extent_(extent),
          first_(first),
          geometry_(geometry),
          pitch_(std::size_t(extent.x) + 2),
          plane_(pitch_ * (std::size_t(extent.y) + 2)) {
        for (auto& ids : along_) ids.assign(plane_, k_none);
        for (auto& ids : along_upper_) ids.assign(plane_, k_none);
    }

    TriangleMesh run(const JobContext& job) {
        for (int z = -1; z < extent_.z; ++z) {
            for (int y = -1; y < extent_.y; ++y)
                for (int x = -1; x < extent_.x; ++x) march_cube({x, y, z});
            for (int axis = 0; axis < 2; ++axis) {  // the upper slice becomes the lower one
                along_[axis].swap(along_upper_[axis]);
                along_upper_[axis].assign(plane_, k_none);
            }
            along_[2].assign(plane_, k_none);
            job.checkpoint(std::size_t(z) + 2, std::size_t(extent_.z) + 1);
        }
        return std::move(mesh_);
    }

private:
    static constexpr std::uint32_t k_none = std::numeric_limits<std::uint32_t>::max();

    bool inside(const glm::ivec3& p) const {
        if (p.x < 0 || p.y < 0 || p.z < 0 || p.x >= extent_.x || p.y >= extent_.y || p.z >= extent_.z) return false;
        return mask_[(std::size_t(p.z) * std::size_t(extent_.y) + std::size_t(p.y)) * std::size_t(extent_.x) +
                     std::size_t(p.x)] != 0;
    }

    static glm::ivec3 corner_offset(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2 & 1}; }

    std::uint32_t add_vertex(const glm::dvec3& mask_voxel) {
        mesh_.vertices.push_back(geometry_.voxel_to_mm(mask_voxel + glm::dvec3(first_)));
        return std::uint32_t(mesh_.vertices.size() - 1);
    }

    /// The vertex half way along a cube edge, made at its first use.
    std::uint32_t vertex_on(int edge, const glm::ivec3& cube) {
        const auto [low, high] = corners_of_edge(edge);
        const glm::ivec3 from = corner_offset(low), base = cube + from;
        const int axis = edge / 4;
        auto& ids = axis < 2 && from.z == 1 ? along_upper_[axis] : along_[axis];
        std::uint32_t& id = ids[std::size_t(base.y + 1) * pitch_ + std::size_t(base.x + 1)];
        if (id == k_none) id = add_vertex(0.5 * (glm::dvec3(base) + glm::dvec3(cube + corner_offset(high))));
        return id;
    }

    void march_cube(const glm::ivec3& cube) {
        int corners = 0;
        for (int c = 0; c < 8; ++c) corners |= int(inside(cube + corner_offset(c))) << c;
        if (corners == 0 || corners == 255) return;
        const MarchingCase& shape = marching_cases()[std::size_t(corners)];
        for (const auto& loop : shape.fans) {
            const std::uint32_t apex = vertex_on(loop[0], cube);
            for (std::size_t k = 1; k + 1 < loop.size(); ++k)
                mesh_.triangles.push_back({apex, vertex_on(loop[k], cube), vertex_on(loop[k + 1], cube)});
        }
        for (const auto& loop : shape.wheels) {
            glm::dvec3 middle(0);
            for (const int edge : loop) {
                const auto [low, high] = corners_of_edge(edge);
                middle += 0.5 * glm::dvec3(corner_offset(low) + corner_offset(high)) / double(loop.size());
            }
            const std::uint32_t hub = add_vertex(glm::dvec3(cube) + middle);
            for (std::size_t k = 0; k < loop.size(); ++k)
                mesh_.triangles.push_back(
                    {hub, vertex_on(loop[k], cube), vertex_on(loop[(k + 1) % loop.size()], cube)});
        }
    }

    const std::vector<std::uint8_t>& mask_;
    glm::ivec3 extent_, first_;
    const GridGeometry& geometry_;
    std::size_t pitch_, plane_;
    std::array<std::vector<std::uint32_t>, 3> along_;        // vertices on edges along x, y of the lower slice, and z
    std::array<std::vector<std::uint32_t>, 2> along_upper_;  // along x, y of the upper slice
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh region_mesh(const LabelVolume& labels, const RegionCharacteristics& region, const JobContext& job) {
    const std::vector<std::uint8_t> mask = region_mask(labels, region);
    job.check();
    TriangleMesh mesh =
        MaskMesher(mask, region.bbox_last - region.bbox_first + 1, region.bbox_first, labels.geometry).run(job);
    if (glm::determinant(labels.geometry.direction) < 0)  // a mirrored grid turns the triangles inside out
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

}  // namespace lacuna
