#include "core/render/brick_stream.h"

#include <algorithm>
#include <cmath>

#include "core/compute/buffers.h"

namespace lacuna {

namespace {

/// Larger than any position, and still finite when a kernel computes with it.
constexpr float k_outside = 3.0e38f;

Volume uniform_volume(const Volume& like, double value) {
    GridGeometry grid = like.geometry();
    grid.size = glm::ivec3(2);
    return visit_type(like.type(), [&](auto tag) {
        using T = decltype(tag);
        return make_volume<T>(grid, [&](std::span<T> voxels) { std::fill(voxels.begin(), voxels.end(), T(value)); });
    });
}

}  // namespace

BrickStream::BrickStream(std::shared_ptr<ComputeDevice> device, const Volume& volume, const BrickGrid& grid,
                         std::shared_ptr<const BrickIndex> index)
    : device_(std::move(device)), volume_(volume), grid_(grid), index_(std::move(index)) {
    if (index_ && index_->of != volume_.identity()) index_.reset();
}

bool BrickStream::serves(const Volume& volume, const BrickGrid& grid) const {
    return volume_.identity() == volume.identity() && grid_.size == grid.size && grid_.edge == grid.edge &&
           grid_.ghost == grid.ghost;
}

const BrickIndex& BrickStream::index(const JobContext& job) {
    if (!index_) index_ = std::make_shared<const BrickIndex>(build_brick_index(volume_, job));
    return *index_;
}

const std::vector<BrickState>& BrickStream::states(const Scene& scene, const Plan& plan, const TransferTables* tables,
                                                   const JobContext& job) {
    const BrickIndex& all = index(job);
    SharedCells none;
    const StructureContext context{*device_, none, scene, plan, tables, job};
    if (VisibilityKey key = context.key(); !states_key_ || *states_key_ != key) {
        const ValueRange values = value_range(all.cells);
        states_ =
            brick_states(grid_, all, classify_macrocells(all.cells, context.table(values), context.slack(values)));
        states_key_ = std::move(key);
    }
    return states_;
}

void BrickStream::make_room(std::uint64_t needed, std::uint64_t budget, std::int64_t keep) {
    while (bytes_ + needed > budget) {
        auto oldest = bricks_.end();
        for (auto b = bricks_.begin(); b != bricks_.end(); ++b)
            if (b->first != keep && (oldest == bricks_.end() || b->second.used_ < oldest->second.used_)) oldest = b;
        if (oldest == bricks_.end()) return;
        bytes_ -= oldest->second.voxel_bytes_ + oldest->second.structure_bytes_;
        bricks_.erase(oldest);
    }
}

void BrickStream::settle(std::int64_t number, std::uint64_t budget) {
    Brick& brick = bricks_.at(number);
    const std::size_t now = brick.structures->bytes();
    bytes_ = bytes_ - brick.structure_bytes_ + now;
    brick.structure_bytes_ = now;
    largest_structure_ = std::max(largest_structure_, now);
    make_room(0, budget, number);
    counts.bytes_peak = std::max(counts.bytes_peak, bytes_);
}

BrickStream::Brick& BrickStream::hold(std::int64_t number, const BrickState& state, std::uint64_t budget,
                                      const JobContext& job) {
    auto found = bricks_.find(number);
    const bool uniform = state.content == BrickContent::uniform;
    if (found == bricks_.end()) {
        const VoxelBox box = grid_.stored(grid_.at(number));
        Brick made;
        if (uniform) {
            made.volume = uniform_volume(volume_, state.value);
        } else {
            const std::size_t bytes = std::size_t(box.voxels()) * size_of(volume_.type());
            make_room(bytes * (device_->unified_memory() ? 1 : 2) + largest_structure_, budget, number);
            made.volume = extract_box(volume_, box, {job.stop, nullptr});
            ++counts.loaded;
            counts.bytes_read += bytes;
        }
        made.voxels = std::make_unique<DeviceVolume>(*device_, made.volume);
        made.structures = std::make_unique<StructureCache>(device_);
        made.structures->hold(made.volume);
        made.voxel_bytes_ = made.volume.bytes() + made.voxels->extra_bytes();
        bytes_ += made.voxel_bytes_;
        found = bricks_.emplace(number, std::move(made)).first;
    } else if (found->second.structure_bytes_ == 0) {
        make_room(largest_structure_, budget, number);
    }
    found->second.used_ = ++clock_;
    counts.bytes_peak = std::max(counts.bytes_peak, bytes_);
    return found->second;
}

BrickParams BrickStream::place(std::int64_t number) const {
    const glm::ivec3 brick = grid_.at(number);
    const glm::ivec3 first = grid_.stored(brick).first;
    const glm::vec3 lo = grid_.lo(brick), hi = grid_.hi(brick);
    BrickParams out{};
    for (int a = 0; a < 3; ++a) {
        out.shift[a] = float(first[a]);
        out.lo[a] = std::max(lo[a], -k_outside);
        out.hi[a] = std::min(hi[a], k_outside);
    }
    return out;
}

}  // namespace lacuna
