// The extended anisotropic chessboard distance: boxes grown from cubes.
#include <algorithm>
#include <array>
#include <bit>

#include "core/accel/distance_field.h"
#include "core/accel/octant_sweep.h"
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
        const std::uint8_t* values = levels_[std::size_t(level)].data();
        if (first <= 2 * edge && second <= 2 * edge) {  // four windows cover it: nearly always
            const std::uint8_t* corner = values + cell;
            const std::size_t a = std::size_t(first - edge) * stride_[0], b = std::size_t(second - edge) * stride_[1];
            return std::min(std::min(corner[0], corner[a]), std::min(corner[b], corner[a + b]));
        }
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
        for (std::size_t start = 0; start < from.size(); start += line) {
            const std::uint8_t *here = from.data() + start, *there = here + step * std::size_t(shift);
            std::uint8_t* out = to.data() + start;
            for (std::size_t i = 0; i < inner; ++i) out[i] = std::min(here[i], there[i]);
        }
    }

    std::array<std::vector<std::uint8_t>, k_levels> levels_;
    std::vector<std::uint8_t> half_;
    std::array<std::size_t, 2> stride_{};
};

/// A slab of cells turned so that its octant looks towards larger coordinates.
class OctantSlab {
public:
    /// @param cubes  the octant's cubes, of the whole grid
    OctantSlab(const RegionGrid& grid, int octant, const std::uint8_t* cubes, Extend extend, int first_slice)
        : grid_(grid), octant_(octant), extend_(extend), first_(first_slice), size_(grid.size) {
        size_.z = std::min(k_slab + k_halo, grid.size.z - first_slice);
        copy_turned(grid.region.data(), region_);
        copy_turned(cubes, cube_);
        for (std::uint8_t& c : cube_) c = std::min(std::uint8_t(c & k_cube_limit), k_limit);
        measure_runs();
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

    void copy_turned(const std::uint8_t* from, std::vector<std::uint8_t>& to) const {
        to.resize(std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z));
        auto out = to.begin();
        for (int z = 0; z < size_.z; ++z)
            for (int y = 0; y < size_.y; ++y, out += size_.x) {
                const std::uint8_t* row = from + source_row(y, z);
                if (octant_ & 1)
                    std::reverse_copy(row, row + size_.x, out);
                else
                    std::copy(row, row + size_.x, out);
            }
    }

    /// How many cells from each on, along each axis, are of one region: row by row, from the far end.
    void measure_runs() {
        for (std::vector<std::uint8_t>& runs : runs_) runs.resize(region_.size());
        const std::size_t dy = std::size_t(size_.x), dz = dy * std::size_t(size_.y);
        for (int z = size_.z - 1; z >= 0; --z)
            for (int y = size_.y - 1; y >= 0; --y) {
                const std::size_t at = std::size_t(z) * dz + std::size_t(y) * dy;
                run_along_row(at);
                run_across_rows(runs_[1], at, y + 1 == size_.y ? 0 : dy);
                run_across_rows(runs_[2], at, z + 1 == size_.z ? 0 : dz);
            }
    }

    void run_along_row(std::size_t at) {
        const std::uint8_t* region = region_.data() + at;
        std::uint8_t* runs = runs_[0].data() + at;
        int run = k_limit;  // cells outside the grid limit nothing
        for (int x = size_.x - 1; x >= 0; --x) {
            const bool goes_on = x + 1 == size_.x || region[x + 1] == region[x];
            run = goes_on ? std::min(run + 1, int(k_limit)) : 1;
            runs[x] = std::uint8_t(region[x] ? run : 0);
        }
    }

    /// @param step  to the next row along the axis; 0: this is the last one
    void run_across_rows(std::vector<std::uint8_t>& all, std::size_t at, std::size_t step) {
        const std::uint8_t *here = region_.data() + at, *there = here + step, *next = all.data() + at + step;
        std::uint8_t* runs = all.data() + at;
        const int width = size_.x;
        if (step == 0) {
            for (int x = 0; x < width; ++x) runs[x] = here[x] ? k_limit : std::uint8_t(0);
            return;
        }
        constexpr std::uint8_t k_before_limit = k_limit - 1;
        for (int x = 0; x < width; ++x) {
            const auto more = std::uint8_t(std::min(next[x], k_before_limit) + 1);
            const std::uint8_t run = there[x] == here[x] ? more : std::uint8_t(1);
            runs[x] = here[x] ? run : std::uint8_t(0);
        }
    }

    std::uint16_t grown(std::size_t i, glm::ivec3 at) const {
        const int cube = cube_[i];
        if (cube == 0) return 0;
        glm::ivec3 box(cube);
        if (cube < k_limit && (extend_ == Extend::both || region_[i] == 1)) {
            // All faces of the cube have one area, and so have the two after the first extension: the axis that gains
            // most is the one that reaches farthest.
            const glm::ivec3 reach(extent(i, at, 0, box), extent(i, at, 1, box), extent(i, at, 2, box));
            const int first = reach.y > reach.x ? (reach.z > reach.y ? 2 : 1) : (reach.z > reach.x ? 2 : 0);
            box[first] = reach[first];
            const int second = first == 0 ? 1 : 0, third = first == 2 ? 1 : 2;
            const int far = extent(i, at, second, box), farther = extent(i, at, third, box);
            if (farther > far)
                box[third] = farther;
            else
                box[second] = far;
        }
        const int kind = region_[i] == 2 ? 0x8000 : 0;
        return std::uint16_t(box.x | box.y << 5 | box.z << 10 | kind);
    }

    /// How far the box can reach along an axis: the shortest run over its face. Cells outside the grid limit nothing.
    int extent(std::size_t i, glm::ivec3 at, int axis, glm::ivec3 box) const {
        const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
        return minima_[std::size_t(axis)].least(i, std::min(box[a], size_[a] - at[a]),
                                                std::min(box[b], size_[b] - at[b]));
    }

    const RegionGrid& grid_;
    int octant_;
    Extend extend_;
    int first_;
    glm::ivec3 size_;
    std::vector<std::uint8_t> region_, cube_;
    std::array<std::vector<std::uint8_t>, 3> runs_;
    std::array<WindowMinima, 3> minima_;
};

}  // namespace

void fill_boxes(const RegionGrid& grid, OctantSet octants, std::uint16_t* field, const JobContext& job, Extend extend) {
    const std::size_t cells = grid.region.size();
    const int slabs = (grid.size.z + k_slab - 1) / k_slab;
    const std::vector<int> wanted = octants_of(octants);
    const JobContext poll{job.stop, nullptr};
    const auto write_slab = [&](int octant, const std::uint8_t* cubes, std::int64_t slab) {
        poll.check();
        OctantSlab(grid, octant, cubes, extend, int(slab) * k_slab).write(field + std::size_t(octant) * cells);
    };
    if (int(wanted.size()) < thread_count()) {  // the slabs of one keep the threads busy
        std::vector<std::uint8_t> cubes(cells);
        for (const int octant : wanted) {
            sweep_octant(grid, octant, cubes.data(), poll);
            parallel_for(
                0, slabs, [&](std::int64_t slab) { write_slab(octant, cubes.data(), slab); }, poll);
        }
        return;
    }
    parallel_for(
        0, std::int64_t(wanted.size()),
        [&](std::int64_t i) {
            const int octant = wanted[std::size_t(i)];
            std::vector<std::uint8_t> cubes(cells);
            sweep_octant(grid, octant, cubes.data(), poll);
            for (int slab = 0; slab < slabs; ++slab) write_slab(octant, cubes.data(), slab);
        },
        job);
}

VoxelBuffer box_field(const RegionGrid& grid, const JobContext& job, Extend extend) {
    VoxelBuffer made(8 * grid.region.size() * sizeof(std::uint16_t));
    fill_boxes(grid, k_all_octants, reinterpret_cast<std::uint16_t*>(made.data()), job, extend);
    return made;
}

}  // namespace lacuna
