#include "core/regions/surface_mesher.h"

#include <algorithm>

#include "core/regions/marching_table.h"

namespace lacuna {

namespace {

glm::ivec3 corner_offset(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2 & 1}; }

}  // namespace

SurfaceMesher::SurfaceMesher(const glm::ivec3& extent, const glm::ivec3& first, const GridGeometry& geometry,
                             SurfaceLevel level)
    : extent_(extent),
      first_(first),
      geometry_(geometry),
      level_(level),
      plane_(std::size_t(extent.x) * std::size_t(extent.y)) {
    for (auto& slice : inside_) slice.assign(plane_, 0);
    for (auto& ids : along_) ids.assign(plane_, k_none);
    for (auto& ids : along_upper_) ids.assign(plane_, k_none);
}

void SurfaceMesher::push(const std::uint8_t* inside, const float* values) {
    std::swap(inside_[0], inside_[1]);
    std::swap(values_[0], values_[1]);
    std::copy(inside, inside + plane_, inside_[1].begin());
    has_values_ = values != nullptr;
    if (has_values_) values_[1].assign(values, values + plane_);
    if (slices_++ > 0) march_slab();
}

TriangleMesh SurfaceMesher::take() {
    TriangleMesh kept;
    for (std::size_t axis = 0; axis < 2; ++axis)  // the next slab uses the vertices of its lower slice again
        for (std::uint32_t& id : along_[axis]) {
            if (id == k_none) continue;
            kept.vertices.push_back(mesh_.vertices[id]);
            id = std::uint32_t(kept.vertices.size() - 1);
        }
    TriangleMesh done = finish();
    mesh_ = std::move(kept);
    return done;
}

TriangleMesh SurfaceMesher::finish() {
    if (glm::determinant(geometry_.direction) < 0)  // a mirrored grid turns the triangles inside out
        for (auto& t : mesh_.triangles) std::swap(t[1], t[2]);
    return std::move(mesh_);
}

void SurfaceMesher::march_slab() {
    for (int y = 0; y + 1 < extent_.y; ++y) {
        const std::size_t row = std::size_t(y) * std::size_t(extent_.x), next = row + std::size_t(extent_.x);
        const std::uint8_t *a = inside_[0].data() + row, *b = inside_[0].data() + next;
        const std::uint8_t *c = inside_[1].data() + row, *d = inside_[1].data() + next;
        int left = a[0] | b[0] << 2 | c[0] << 4 | d[0] << 6;  // corners 0, 2, 4, 6
        for (int x = 0; x + 1 < extent_.x; ++x) {
            const int right = a[x + 1] | b[x + 1] << 2 | c[x + 1] << 4 | d[x + 1] << 6;
            const int corners = left | right << 1;
            left = right;
            if (corners != 0 && corners != 255) march_cube(x, y, corners);
        }
    }
    for (int axis = 0; axis < 2; ++axis) {  // the upper slice becomes the lower one
        along_[std::size_t(axis)].swap(along_upper_[std::size_t(axis)]);
        std::fill(along_upper_[std::size_t(axis)].begin(), along_upper_[std::size_t(axis)].end(), k_none);
    }
    std::fill(along_[2].begin(), along_[2].end(), k_none);
}

std::uint32_t SurfaceMesher::add_vertex(const glm::dvec3& window_voxel) {
    mesh_.vertices.push_back(geometry_.voxel_to_mm(window_voxel + glm::dvec3(first_)));
    return std::uint32_t(mesh_.vertices.size() - 1);
}

float SurfaceMesher::value_at(int x, int y, int upper) const {
    return values_[std::size_t(upper)][std::size_t(y) * std::size_t(extent_.x) + std::size_t(x)];
}

/// The vertex along a cube edge, made at its first use.
std::uint32_t SurfaceMesher::vertex_on(int edge, int x, int y, int corners) {
    const auto [low, high] = corners_of_edge(edge);
    const glm::ivec3 from = corner_offset(low), to = corner_offset(high);
    const auto axis = std::size_t(edge / 4);
    auto& ids = axis < 2 && from.z == 1 ? along_upper_[axis] : along_[axis];
    std::uint32_t& id = ids[std::size_t(y + from.y) * std::size_t(extent_.x) + std::size_t(x + from.x)];
    if (id != k_none) return id;
    double share = 0.5;
    if (has_values_) {
        const float at_low = value_at(x + from.x, y + from.y, from.z), at_high = value_at(x + to.x, y + to.y, to.z);
        share = corners >> low & 1 ? level_.crossing(at_low, at_high) : 1 - level_.crossing(at_high, at_low);
    }
    const glm::dvec3 cube(x, y, slices_ - 2);
    return id = add_vertex(cube + glm::mix(glm::dvec3(from), glm::dvec3(to), share));
}

void SurfaceMesher::march_cube(int x, int y, int corners) {
    const MarchingCase& shape = marching_cases()[std::size_t(corners)];
    for (const auto& loop : shape.fans) {
        const std::uint32_t apex = vertex_on(loop[0], x, y, corners);
        for (std::size_t k = 1; k + 1 < loop.size(); ++k)
            mesh_.triangles.push_back({apex, vertex_on(loop[k], x, y, corners), vertex_on(loop[k + 1], x, y, corners)});
    }
    for (const auto& loop : shape.wheels) {
        glm::dvec3 middle(0);
        for (const int edge : loop) middle += mesh_.vertices[vertex_on(edge, x, y, corners)] / double(loop.size());
        mesh_.vertices.push_back(middle);
        const auto hub = std::uint32_t(mesh_.vertices.size() - 1);
        for (std::size_t k = 0; k < loop.size(); ++k)
            mesh_.triangles.push_back(
                {hub, vertex_on(loop[k], x, y, corners), vertex_on(loop[(k + 1) % loop.size()], x, y, corners)});
    }
}

}  // namespace lacuna
