#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/regions/triangle_mesh.h"
#include "core/volume/grid_geometry.h"

namespace lacuna {

/// Where along an edge from an inside to an outside voxel the surface lies: the inside has values of [lo, hi], so it is
/// passed where the value, taken as linear, leaves that range; half way where the outside value lies in it too (another
/// region, the frame) or is NaN.
struct SurfaceLevel {
    float lo = -std::numeric_limits<float>::infinity(), hi = std::numeric_limits<float>::infinity();

    double crossing(float inside, float outside) const {
        const double a = inside, b = outside;
        double share = 0.5;
        if (b > double(hi) && a <= double(hi))
            share = (double(hi) - a) / (b - a);
        else if (b < double(lo) && a >= double(lo))
            share = (a - double(lo)) / (a - b);
        // Away from the ends: a vertex there would coincide with those of other edges. False for NaN.
        return share > 1e-3 ? (share < 1 - 1e-3 ? share : 1 - 1e-3) : (share <= 1e-3 ? 1e-3 : 0.5);
    }
};

/// Marching cubes over a window of a grid, handed in slice by slice: closed and outward-oriented when the window's
/// outermost layer is outside.
class SurfaceMesher {
public:
    /// @param extent  of the window in voxels
    /// @param first   the window's voxel (0, 0, 0) in the grid
    SurfaceMesher(const glm::ivec3& extent, const glm::ivec3& first, const GridGeometry& geometry, SurfaceLevel level);

    /// The next slice: extent.x * extent.y entries each, 1 inside, 0 outside; `values` may be null: all half way.
    void push(const std::uint8_t* inside, const float* values);
    /// What is finished so far, and forgets it: taken after every push, the mesher holds two slices' vertices at most.
    /// The pieces together are the surface; vertices on the slice between two pieces stand in both.
    TriangleMesh take();
    /// The surface, or what was not taken of it.
    TriangleMesh finish();

private:
    static constexpr std::uint32_t k_none = 0xFFFFFFFFu;

    void march_slab();
    void march_cube(int x, int y, int corners);
    std::uint32_t add_vertex(const glm::dvec3& window_voxel);
    std::uint32_t vertex_on(int edge, int x, int y, int corners);
    float value_at(int x, int y, int upper) const;

    glm::ivec3 extent_, first_;
    GridGeometry geometry_;
    SurfaceLevel level_;
    int slices_ = 0;
    bool has_values_ = false;
    std::size_t plane_;
    std::array<std::vector<std::uint8_t>, 2> inside_;
    std::array<std::vector<float>, 2> values_;
    std::array<std::vector<std::uint32_t>, 3> along_;        // vertices on edges along x, y of the lower slice, and z
    std::array<std::vector<std::uint32_t>, 2> along_upper_;  // along x, y of the upper slice
    TriangleMesh mesh_;
};

}  // namespace lacuna
