#include "core/accel/distance_field.h"

#include <algorithm>
#include <array>

#include "core/accel/octant_sweep.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr std::uint8_t k_limit = k_cube_limit, k_second = 0x80;

/// The distances of one region in the slice being swept and the one before it, with one cell around them that lies
/// outside the grid and limits nothing.
class RollingSlices {
public:
    explicit RollingSlices(glm::ivec3 size)
        : stride_(std::size_t(size.x) + 2),
          now_(stride_ * (std::size_t(size.y) + 2), k_limit),
          before_(now_.size(), k_limit) {}
    void next_slice() { now_.swap(before_); }
    std::uint8_t* now(int y) { return now_.data() + std::size_t(y + 1) * stride_ + 1; }
    const std::uint8_t* before(int y) const { return before_.data() + std::size_t(y + 1) * stride_ + 1; }

private:
    std::size_t stride_;
    std::vector<std::uint8_t> now_, before_;
};

struct RowScratch {
    std::vector<std::uint8_t> nearest, bound;
    /// Two rows with k_limit cells around them that limit nothing, which stay so.
    std::array<std::vector<std::uint8_t>, 2> run;
    explicit RowScratch(int width)
        : nearest(std::size_t(width) + 2),
          bound(std::size_t(width)),
          run{std::vector<std::uint8_t>(std::size_t(width) + 2 * k_limit, k_limit), {}} {
        run[1] = run[0];
    }
};

/// d[x] = min(bound[x], d[x - step] + 1), walked in the direction of `step`; what lies before the row limits nothing.
/// By doubling: what is nearest within 2s cells is the nearer of what is nearest within s and s cells on. Each pass is
/// a loop of independent bytes, where the walk would wait for every single cell.
void run_along(const std::uint8_t* bound, std::uint8_t* d, int width, int step, RowScratch& scratch) {
    std::uint8_t *from = scratch.run[0].data() + k_limit, *to = scratch.run[1].data() + k_limit;
    std::copy_n(bound, width, from);
    for (int s = 1; s <= k_limit && s < width; s *= 2) {
        const std::uint8_t* before = from - step * s;
        for (int x = 0; x < width; ++x) {
            const auto further = std::uint8_t(before[x] + s);
            to[x] = std::min(from[x], further);
        }
        std::swap(from, to);
    }
    std::copy_n(from, width, d);
}

void bound_members(const std::uint8_t* region, int wanted, RowScratch& row, int width) {
    // bound holds the least of the neighbours: one more for a cell of the region, none for another.
    constexpr std::uint8_t k_before_limit = k_limit - 1;
    const auto kind = std::uint8_t(wanted);
    std::uint8_t* bound = row.bound.data();
    for (int x = 0; x < width; ++x) {
        const auto more = std::uint8_t(std::min(bound[x], k_before_limit) + 1);
        bound[x] = region[x] == kind ? more : std::uint8_t(0);
    }
}

/// One row of a sweep over half the 3x3x3 neighbourhood. @param ahead +1: towards larger y and z
void sweep_chessboard_row(const RollingSlices& before, RollingSlices& now, const std::uint8_t* region, int wanted,
                          int y, int ahead, int width, RowScratch& scratch) {
    const std::uint8_t *a = before.before(y - 1), *b = before.before(y), *c = before.before(y + 1);
    const std::uint8_t* d = now.now(y - ahead);
    std::uint8_t* nearest = scratch.nearest.data();
    for (int i = 0; i < width + 2; ++i)
        nearest[i] = std::min(std::min(a[i - 1], b[i - 1]), std::min(c[i - 1], d[i - 1]));
    std::uint8_t* bound = scratch.bound.data();  // local: bytes alias everything, members would be read anew each time
    for (int x = 0; x < width; ++x) bound[x] = std::min(std::min(nearest[x], nearest[x + 1]), nearest[x + 2]);
    bound_members(region, wanted, scratch, width);
}

class ChessboardSweep {
public:
    ChessboardSweep(const RegionGrid& grid, std::uint8_t* field, int region)
        : grid_(grid), field_(field), region_(region), slices_(grid.size), scratch_(grid.size.x) {}

    /// Entries of the field are those of this region alone until both sweeps are done.
    void run(int ahead, const JobContext& job) {
        const glm::ivec3 n = grid_.size;
        slices_ = RollingSlices(n);
        for (int i = 0; i < n.z; ++i) {
            job.checkpoint(std::size_t(i), std::size_t(n.z));
            const int z = ahead > 0 ? i : n.z - 1 - i;
            slices_.next_slice();
            // Rows not yet swept of this slice still hold the one before the last: they are not read.
            for (int j = 0; j < n.y; ++j) sweep_row(ahead > 0 ? j : n.y - 1 - j, z, ahead);
        }
    }

private:
    void sweep_row(int y, int z, int ahead) {
        const int width = grid_.size.x;
        const std::size_t at = (std::size_t(z) * std::size_t(grid_.size.y) + std::size_t(y)) * std::size_t(width);
        sweep_chessboard_row(slices_, slices_, grid_.region.data() + at, region_, y, ahead, width, scratch_);
        const auto top = std::uint8_t(region_ == 2 ? k_second : 0);
        std::uint8_t* out = field_ + at;
        const std::uint8_t* region = grid_.region.data() + at;
        if (ahead < 0) {  // the second sweep keeps what the first found
            std::uint8_t* bound = scratch_.bound.data();
            for (int x = 0; x < width; ++x) bound[x] = std::min(bound[x], std::uint8_t(out[x] & k_limit));
        }
        std::uint8_t* row = slices_.now(y);
        run_along(scratch_.bound.data(), row, width, ahead, scratch_);
        const auto kind = std::uint8_t(region_);
        for (int x = 0; x < width; ++x) out[x] = region[x] == kind ? std::uint8_t(row[x] | top) : out[x];
    }

    const RegionGrid& grid_;
    std::uint8_t* field_;
    int region_;
    RollingSlices slices_;
    RowScratch scratch_;
};

bool has_region(const RegionGrid& grid, std::uint8_t region) {
    return std::find(grid.region.begin(), grid.region.end(), region) != grid.region.end();
}

}  // namespace

// Towards the corner that `octant` names.
void sweep_octant(const RegionGrid& grid, int octant, std::uint8_t* field, const JobContext& job) {
    const glm::ivec3 n = grid.size, towards(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    std::array<RollingSlices, 2> slices{RollingSlices(n), RollingSlices(n)};
    const int kinds = has_region(grid, 2) ? 2 : 1;
    RowScratch scratch(n.x);
    for (int i = 0; i < n.z; ++i) {
        job.check();
        const int z = towards.z > 0 ? n.z - 1 - i : i;
        for (RollingSlices& s : slices) s.next_slice();
        for (int j = 0; j < n.y; ++j) {
            const int y = towards.y > 0 ? n.y - 1 - j : j;
            const std::size_t at = (std::size_t(z) * std::size_t(n.y) + std::size_t(y)) * std::size_t(n.x);
            const std::uint8_t* region = grid.region.data() + at;
            for (int kind = 0; kind < kinds; ++kind) {
                RollingSlices& s = slices[std::size_t(kind)];
                const std::uint8_t *a = s.before(y), *b = s.before(y + towards.y), *c = s.now(y + towards.y);
                std::uint8_t* nearest = scratch.nearest.data();
                for (int x = 0; x < n.x + 2; ++x) nearest[x] = std::min(std::min(a[x - 1], b[x - 1]), c[x - 1]);
                std::uint8_t* bound = scratch.bound.data();
                const std::uint8_t* beside = nearest + 1 + towards.x;
                for (int x = 0; x < n.x; ++x) bound[x] = std::min(nearest[x + 1], beside[x]);
                bound_members(region, kind + 1, scratch, n.x);
                run_along(scratch.bound.data(), s.now(y), n.x, -towards.x, scratch);
            }
            const std::uint8_t *first = slices[0].now(y), *second = slices[1].now(y);
            std::uint8_t* out = field + at;
            if (kinds == 1)
                std::copy_n(first, n.x, field + at);
            else
                for (int x = 0; x < n.x; ++x) out[x] = region[x] == 2 ? std::uint8_t(second[x] | k_second) : first[x];
        }
    }
}

VoxelBuffer chessboard_field(const RegionGrid& grid, const JobContext& job) {
    VoxelBuffer made(grid.region.size());
    auto* field = reinterpret_cast<std::uint8_t*>(made.data());
    std::fill_n(field, grid.region.size(), std::uint8_t(0));
    const int kinds = has_region(grid, 2) ? 2 : 1;
    for (int kind = 1; kind <= kinds; ++kind) {
        const double from = double(kind - 1) / kinds, half = 0.5 / kinds;
        ChessboardSweep sweep(grid, field, kind);
        sweep.run(+1, job.part(from, from + half));
        sweep.run(-1, job.part(from + half, from + 2 * half));
    }
    return made;
}

std::vector<int> octants_of(OctantSet set) {
    std::vector<int> members;
    for (int octant = 0; octant < 8; ++octant)
        if (set >> octant & 1) members.push_back(octant);
    return members;
}

void fill_cubes(const RegionGrid& grid, OctantSet octants, std::uint8_t* field, const JobContext& job) {
    const std::size_t cells = grid.region.size();
    const std::vector<int> wanted = octants_of(octants);
    const JobContext poll{job.stop, nullptr};
    parallel_for(
        0, std::int64_t(wanted.size()),
        [&](std::int64_t i) {
            const int octant = wanted[std::size_t(i)];
            sweep_octant(grid, octant, field + std::size_t(octant) * cells, poll);
        },
        job);
}

VoxelBuffer octant_field(const RegionGrid& grid, const JobContext& job) {
    VoxelBuffer made(8 * grid.region.size());
    fill_cubes(grid, k_all_octants, reinterpret_cast<std::uint8_t*>(made.data()), job);
    return made;
}

}  // namespace lacuna
