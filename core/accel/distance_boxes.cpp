// The extended anisotropic chessboard distance: boxes grown from cubes.
#include <algorithm>
#include <array>
#include <bit>

#include "core/accel/distance_field.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr int k_slab = 32;           // slices a thread takes at once
constexpr int k_halo = k_box_limit;  // slices behind them that their boxes can reach
constexpr int k_levels = 5;          // windows of 1, 2, 4, 8, 16 cells
constexpr std::uint8_t k_limit = k_box_limit;

/// For every cell the least value over the 2^l x 2^l cells from it on, along two axes; cells outside limit nothing.
class WindowMinima {
public:
    /// @param axes the two axes of the window
    void build(std::vector<std::uint8_t>&& values, glm::ivec3 size, glm::ivec2 axes, int largest) {
        levels_[0] = std::move(values);
        stride_ = {along(axes.x, size), along(axes.y, size)};
        for (int l = 1; l < k_levels && (1 << l) <= largest; ++l) {
            shrink(levels_[std::size_t(l) - 1], half_, size, axes.x, 1 << (l - 1));
            shrink(half_, levels_[std::size_t(l)], size, axes.y, 1 << (l - 1));
        }
    }
    int value(std::size_t cell) const { return levels_[0][cell]; }
    /// The least over `first` x `second` cells from the cell on, all inside the slab.
    int least(std::size_t cell, int first, int second) const {
        const int level = std::bit_width(unsigned(std::min(first, second))) - 1, edge = 1 << level;
        const std::vector<std::uint8_t>& values = levels_[std::size_t(level)];
        int found = k_limit;
        for (int a = 0;; a = std::min(a + edge, first - edge)) {
            for (int b = 0;; b = std::min(b + edge, second - edge)) {
                found = std::min(found, int(values[cell + std::size_t(a) * stride_[0] + std::size_t(b) * stride_[1]]));
                if (b == second - edge) break;
            }
            if (a == first - edge) break;
        }
        return found;
    }

private:
    static std::size_t along(int axis, glm::ivec3 size) {
        return axis == 0 ? 1 : axis == 1 ? std::size_t(size.x) : std::size_t(size.x) * std::size_t(size.y);
    }
    /// to[i] = min(from[i], from[i + shift cells along the axis]).
    static void shrink(const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to, glm::ivec3 size, int axis,
                       int shift) {
        to = from;
        const std::size_t step = along(axis, size), line = step * std::size_t(size[axis]);
        const std::size_t inner = line - std::min(line, step * std::size_t(shift));
        for (std::size_t start = 0; start < from.size(); start += line)
            for (std::size_t i = 0; i < inner; ++i)
                to[start + i] = std::min(from[start + i], from[start + i + step * std::size_t(shift)]);
    }

    std::array<std::vector<std::uint8_t>, k_levels> levels_;
    std::vector<std::uint8_t> half_;
    std::array<std::size_t, 2> stride_{};
};

/// A slab of cells turned so that its octant looks towards larger coordinates.
class OctantSlab {
public:
    OctantSlab(const RegionGrid& grid, int octant, int first_slice)
        : grid_(grid), octant_(octant), first_(first_slice), size_(grid.size) {
        size_.z = std::min(k_slab + k_halo, grid.size.z - first_slice);
        copy_turned();
        measure_runs();
        measure_cubes();
        const int largest = *std::max_element(cube_.begin(), cube_.end());
        minima_[0].build(std::move(runs_[0]), size_, {1, 2}, largest);
        minima_[1].build(std::move(runs_[1]), size_, {0, 2}, largest);
        minima_[2].build(std::move(runs_[2]), size_, {0, 1}, largest);
    }

    void write(std::uint16_t* field) const {
        std::size_t i = 0;
        for (int z = 0; z < std::min(k_slab, size_.z); ++z)
            for (int y = 0; y < size_.y; ++y) {
                std::uint16_t* row = field + source_row(y, z);
                for (int x = 0; x < size_.x; ++x, ++i) row[octant_ & 1 ? size_.x - 1 - x : x] = grown(i, {x, y, z});
            }
    }

private:
    std::size_t source_row(int y, int z) const {
        const int sy = octant_ & 2 ? size_.y - 1 - y : y;
        const int sz = octant_ & 4 ? grid_.size.z - 1 - (first_ + z) : first_ + z;
        return (std::size_t(sz) * std::size_t(size_.y) + std::size_t(sy)) * std::size_t(size_.x);
    }

    void copy_turned() {
        region_.resize(std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z));
        auto out = region_.begin();
        for (int z = 0; z < size_.z; ++z)
            for (int y = 0; y < size_.y; ++y, out += size_.x) {
                const auto row = grid_.region.begin() + std::ptrdiff_t(source_row(y, z));
                if (octant_ & 1)
                    std::reverse_copy(row, row + size_.x, out);
                else
                    std::copy(row, row + size_.x, out);
            }
    }

    /// How many cells from each on, along each axis, are of one region.
    void measure_runs() {
        const std::size_t steps[3] = {1, std::size_t(size_.x), std::size_t(size_.x) * std::size_t(size_.y)};
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<std::uint8_t>& runs = runs_[std::size_t(axis)];
            runs.resize(region_.size());
            std::size_t i = region_.size();
            for (int z = size_.z - 1; z >= 0; --z)
                for (int y = size_.y - 1; y >= 0; --y)
                    for (int x = size_.x - 1; x >= 0; --x) {
                        --i;
                        const int at = axis == 0 ? x : axis == 1 ? y : z;
                        const bool last = at == size_[axis] - 1;
                        const std::size_t next = last ? i : i + steps[axis];
                        const int more = last                          ? int(k_limit)
                                         : region_[next] == region_[i] ? std::min(int(runs[next]) + 1, int(k_limit))
                                                                       : 1;
                        runs[i] = std::uint8_t(region_[i] ? more : 0);
                    }
        }
    }

    /// The ACD of the octant: one sweep, as in octant_field, up to 31.
    void measure_cubes() {
        cube_.resize(region_.size());
        std::size_t i = region_.size();
        const std::size_t dy = std::size_t(size_.x), dz = dy * std::size_t(size_.y);
        for (int z = size_.z - 1; z >= 0; --z)
            for (int y = size_.y - 1; y >= 0; --y)
                for (int x = size_.x - 1; x >= 0; --x) {
                    --i;
                    if (!region_[i]) continue;
                    int least = k_limit;
                    for (int n = 1; n < 8; ++n) {
                        const bool nx = n & 1, ny = n & 2, nz = n & 4;
                        if ((nx && x + 1 == size_.x) || (ny && y + 1 == size_.y) || (nz && z + 1 == size_.z)) continue;
                        const std::size_t j = i + (nx ? 1 : 0) + (ny ? dy : 0) + (nz ? dz : 0);
                        least = std::min(least, region_[j] == region_[i] ? int(cube_[j]) : 0);
                    }
                    cube_[i] = std::uint8_t(std::min(least + 1, int(k_limit)));
                }
    }

    std::uint16_t grown(std::size_t i, glm::ivec3 at) const {
        const int cube = cube_[i];
        if (cube == 0) return 0;
        glm::ivec3 box(cube);
        if (cube < k_limit) {
            int first = -1;
            for (int turn = 0; turn < 2; ++turn) {  // the axis that gains most, then the better of the others
                int best = -1, reach = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    if (axis == first) continue;
                    const int far = extent(i, at, axis, box);
                    if (best < 0 || gain(box, axis, far) > gain(box, best, reach)) best = axis, reach = far;
                }
                box[best] = reach;
                first = best;
            }
        }
        const int kind = region_[i] == 2 ? 0x8000 : 0;
        return std::uint16_t(box.x | box.y << 5 | box.z << 10 | kind);
    }

    static int gain(glm::ivec3 box, int axis, int far) {
        return (far - box[axis]) * (box.x * box.y * box.z / box[axis]);
    }

    /// How far the box can reach along an axis: the shortest run over its face. Cells outside the grid limit nothing.
    int extent(std::size_t i, glm::ivec3 at, int axis, glm::ivec3 box) const {
        const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
        return minima_[std::size_t(axis)].least(i, std::min(box[a], size_[a] - at[a]),
                                                std::min(box[b], size_[b] - at[b]));
    }

    const RegionGrid& grid_;
    int octant_, first_;
    glm::ivec3 size_;
    std::vector<std::uint8_t> region_, cube_;
    std::array<std::vector<std::uint8_t>, 3> runs_;
    std::array<WindowMinima, 3> minima_;
};

}  // namespace

VoxelBuffer box_field(const RegionGrid& grid, const JobContext& job) {
    const std::size_t cells = grid.region.size();
    VoxelBuffer made(8 * cells * sizeof(std::uint16_t));
    auto* field = reinterpret_cast<std::uint16_t*>(made.data());
    const int slabs = (grid.size.z + k_slab - 1) / k_slab;
    parallel_for(
        0, std::int64_t(8) * slabs,
        [&](std::int64_t i) {
            const int octant = int(i) / slabs, slab = int(i) % slabs;
            OctantSlab(grid, octant, slab * k_slab).write(field + std::size_t(octant) * cells);
        },
        job);
    return made;
}

}  // namespace lacuna
