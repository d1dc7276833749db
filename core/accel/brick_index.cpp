#include "core/accel/brick_index.h"

#include <algorithm>

#include "core/volume/volume_pieces.h"

namespace lacuna {

namespace {

constexpr int k_shift = 4;

std::size_t cell_index(const MacrocellGrid& grid, int x, int y, int z) {
    return (std::size_t(z) * std::size_t(grid.cells.y) + std::size_t(y)) * std::size_t(grid.cells.x) + std::size_t(x);
}

/// Puts a piece's cells where they belong in the volume's. Its own voxels make whole cells; the row and slice it shares
/// with the next piece would make one more, which is the next piece's.
void put_cells(MacrocellGrid& all, const VolumePiece& piece) {
    const MacrocellGrid part = build_macrocells(piece.volume, k_shift);
    const glm::ivec3 first = piece.box.first >> k_shift, own = ((piece.own - 1) >> k_shift) + 1;
    for (int z = 0; z < own.z; ++z)
        for (int y = 0; y < own.y; ++y)
            for (int x = 0; x < own.x; ++x) {
                const std::size_t from = cell_index(part, x, y, z),
                                  to = cell_index(all, first.x + x, first.y + y, first.z + z);
                all.ranges[to] = part.ranges[from];
                if (!part.has_nan.empty()) all.has_nan[to] = part.has_nan[from];
            }
}

}  // namespace

BrickIndex build_brick_index(const Volume& volume, const JobContext& job) {
    BrickIndex index;
    index.of = volume.identity();
    if (volume.in_memory()) {
        index.cells = build_macrocells(volume, k_shift, job.part(0, 0.5));
        index.statistics = compute_statistics(volume, job.part(0.5, 1));
        return index;
    }
    index.cells.shift = k_shift;
    index.cells.cells = ((volume.geometry().size - 1) >> k_shift) + 1;
    const glm::ivec3 n = index.cells.cells;
    index.cells.ranges.resize(std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z));
    const bool floats = volume.type() == VoxelType::f32;
    if (floats) index.cells.has_nan.resize(index.cells.ranges.size());
    StatisticsGatherer gatherer(volume.type());
    for_each_piece(
        volume, 1 << k_shift,
        [&](const VolumePiece& piece) {
            put_cells(index.cells, piece);
            gatherer.add(piece);
        },
        job.part(0, floats ? 0.5 : 1));
    if (gatherer.needs_second_pass()) {
        gatherer.begin_second_pass();
        for_each_piece(
            volume, 1 << k_shift, [&](const VolumePiece& piece) { gatherer.add(piece); }, job.part(0.5, 1));
    }
    index.statistics = gatherer.finish();
    return index;
}

std::vector<BrickState> brick_states(const BrickGrid& grid, const BrickIndex& index,
                                     const std::vector<std::uint8_t>& classes) {
    std::vector<BrickState> states(std::size_t(grid.bricks()));
    const MacrocellGrid& cells = index.cells;
    for (std::size_t b = 0; b < states.size(); ++b) {
        const VoxelBox box = grid.stored(grid.at(std::int64_t(b)));
        const glm::ivec3 first = box.first >> cells.shift, last = (box.first + box.size - 1) >> cells.shift;
        bool seen = false, nan = false;
        float lo = cells.ranges[cell_index(cells, first.x, first.y, first.z)].x, hi = lo;
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x) {
                    const std::size_t c = cell_index(cells, x, y, z);
                    seen = seen || classes[c] != std::uint8_t(VisibilityTable::Answer::none);
                    nan = nan || (!cells.has_nan.empty() && cells.has_nan[c]);
                    lo = std::min(lo, cells.ranges[c].x);
                    hi = std::max(hi, cells.ranges[c].y);
                }
        if (!seen)
            states[b].content = BrickContent::empty;
        else if (lo == hi && !nan)
            states[b] = {BrickContent::uniform, double(lo)};
    }
    return states;
}

}  // namespace lacuna
