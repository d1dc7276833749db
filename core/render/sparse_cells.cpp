#include "core/render/sparse_cells.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/render/shading.h"

namespace lacuna {

namespace {

constexpr float k_far_away = std::numeric_limits<float>::infinity();

/// Where a box of positions lies in the picture: pixels it may cover, and its farthest point along the rays.
struct Footprint {
    glm::dvec2 lo{0}, hi{0};
    double far_mm = 0;
};

class Projector {
public:
    Projector(const Scene& scene, int shift)
        : geometry_(scene.volume.geometry()),
          rays_(resolve(scene.camera, geometry_, scene.size)),
          edge_(1 << shift),
          diagonal_mm_(glm::length(glm::dvec3(edge_ + 1) * geometry_.spacing)) {}

    double diagonal_mm() const { return diagonal_mm_; }

    /// @param cell  indices; border cells reach half a voxel beyond the outermost centres
    Footprint of(const glm::ivec3& cell) const {
        const glm::dvec3 last(geometry_.size - 1);
        glm::dvec3 lo = glm::dvec3(cell * edge_), hi = glm::min(lo + double(edge_), last);
        for (int a = 0; a < 3; ++a) {
            if (cell[a] == 0) lo[a] = -0.5;
            if (hi[a] >= last[a]) hi[a] = last[a] + 0.5;
        }
        Footprint f{glm::dvec2(1e30), glm::dvec2(-1e30), -1e30};
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 mm =
                geometry_.voxel_to_mm({corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z});
            const double ahead = glm::dot(mm - rays_.eye, rays_.forward);
            if (rays_.perspective && !(ahead > 1e-6)) return {glm::dvec2(-1e30), glm::dvec2(1e30), 1e30};
            const glm::dvec2 at = rays_.project(mm);
            f.lo = glm::min(f.lo, at);
            f.hi = glm::max(f.hi, at);
            f.far_mm = std::max(f.far_mm, rays_.perspective ? glm::length(mm - rays_.eye) : ahead);
        }
        return f;
    }

private:
    GridGeometry geometry_;
    ViewRays rays_;
    int edge_;
    double diagonal_mm_;
};

/// An object that fills the volume to its border shows the border itself.
bool on_border(glm::ivec3 cell, glm::ivec3 cells) {
    for (int a = 0; a < 3; ++a)
        if (cell[a] == 0 || cell[a] == cells[a] - 1) return true;
    return false;
}

/// What a block's four cast rays allow a cell without being looked at again.
struct BlockBound {
    float in_front_mm = -k_far_away;               ///< a visible cell must reach at least so far
    float least = -k_far_away, most = k_far_away;  ///< grey levels a cell may reach
};

std::vector<BlockBound> bounds_of(const Scene& scene, const Frame& cast, const SparseGrid& grid, double diagonal_mm,
                                  double gradient) {
    const glm::ivec2 blocks = grid.blocks();
    std::vector<BlockBound> bounds(std::size_t(blocks.x) * std::size_t(blocks.y));
    for (int y = 0; y < blocks.y; ++y)
        for (int x = 0; x < blocks.x; ++x) {
            BlockBound& bound = bounds[std::size_t(y) * std::size_t(blocks.x) + std::size_t(x)];
            float near_mm = k_far_away, most = -k_far_away, least = k_far_away, alpha = 0;
            for (const int dy : {0, 1})
                for (const int dx : {0, 1}) {
                    const int cx = std::min(x + dx, cast.size.x - 1), cy = std::min(y + dy, cast.size.y - 1);
                    const std::size_t at = std::size_t(cy) * std::size_t(cast.size.x) + std::size_t(cx);
                    near_mm = std::min(near_mm, cast.depth_mm[at]);
                    alpha = std::max(alpha, cast.color[at].a);
                    most = std::max(most, cast.color[at].r);
                    least = std::min(least, cast.color[at].a > 0 ? cast.color[at].r : 1.0f);
                }
            switch (scene.mode) {
                case ViewMode::iso:
                    bound.in_front_mm = std::isinf(near_mm) ? k_far_away : float(near_mm - diagonal_mm);
                    break;
                case ViewMode::ea:
                    if (alpha <= float(gradient)) bound.in_front_mm = k_far_away;
                    break;
                case ViewMode::mip:
                    if (!scene.color_by_tf) bound.most = most + float(gradient);
                    break;
                case ViewMode::minip:
                    if (!scene.color_by_tf) bound.least = least - float(gradient);
                    break;
                default:
                    break;
            }
        }
    return bounds;
}

}  // namespace

std::vector<std::uint8_t> blocks_with_hidden_cells(const Scene& scene, const Frame& cast, const SparseGrid& grid,
                                                   const MacrocellGrid& cells, const std::vector<std::uint8_t>& classes,
                                                   double gradient, const JobContext& job) {
    const Projector projector(scene, cells.shift);
    const std::vector<BlockBound> bounds = bounds_of(scene, cast, grid, projector.diagonal_mm(), gradient);
    const glm::ivec2 blocks = grid.blocks();
    std::vector<std::uint8_t> marks(bounds.size());
    const bool surface = scene.mode == ViewMode::iso;
    parallel_for(
        0, cells.cells.z,
        [&](std::int64_t z) {
            std::size_t at = std::size_t(z) * std::size_t(cells.cells.x) * std::size_t(cells.cells.y);
            for (int y = 0; y < cells.cells.y; ++y)
                for (int x = 0; x < cells.cells.x; ++x, ++at) {
                    const auto answer = VisibilityTable::Answer(classes[at]);
                    // A surface lies only where some values are inside and some are not.
                    if (answer == VisibilityTable::Answer::none ||
                        (surface && answer == VisibilityTable::Answer::all && !on_border({x, y, int(z)}, cells.cells)))
                        continue;
                    const Footprint f = projector.of({x, y, int(z)});
                    const glm::ivec2 first =
                        glm::ivec2(glm::clamp(glm::floor(f.lo / double(grid.k)), glm::dvec2(0), glm::dvec2(blocks)));
                    const glm::ivec2 last = glm::ivec2(
                        glm::clamp(glm::floor(f.hi / double(grid.k)), glm::dvec2(-1), glm::dvec2(blocks - 1)));
                    const auto lowest = float(grey_level(scene.window, cells.ranges[at].x));
                    const auto highest = float(grey_level(scene.window, cells.ranges[at].y));
                    for (int by = first.y; by <= last.y; ++by)
                        for (int bx = first.x; bx <= last.x; ++bx) {
                            const std::size_t block = std::size_t(by) * std::size_t(blocks.x) + std::size_t(bx);
                            const BlockBound& bound = bounds[block];
                            if (float(f.far_mm) < bound.in_front_mm || highest > bound.most || lowest < bound.least)
                                std::atomic_ref(marks[block]).store(1, std::memory_order_relaxed);
                        }
                }
        },
        job);
    return marks;
}

}  // namespace lacuna
