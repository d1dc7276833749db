#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/accel/brick_index.h"
#include "core/base/job.h"
#include "core/compute/device.h"
#include "core/render/device_volume.h"
#include "core/render/frame.h"
#include "core/render/structure_cache.h"
#include "core/volume/brick_grid.h"
#include "shared/brick.h"

namespace lacuna {

/// The bricks of one volume on a device: loaded when a picture needs them, kept, with the structures built over them,
/// as long as they fit into what they may take; then the one used longest ago goes first.
class BrickStream {
public:
    struct Brick {
        Volume volume;
        std::unique_ptr<DeviceVolume> voxels;
        std::unique_ptr<StructureCache> structures;

    private:
        friend class BrickStream;
        std::uint64_t used_ = 0;
        std::size_t voxel_bytes_ = 0, structure_bytes_ = 0;
    };

    /// @param index  of this volume; without one it is made when first needed (a pass over the voxels)
    BrickStream(std::shared_ptr<ComputeDevice> device, const Volume& volume, const BrickGrid& grid,
                std::shared_ptr<const BrickIndex> index);

    bool serves(const Volume& volume, const BrickGrid& grid) const;
    const BrickGrid& grid() const { return grid_; }
    /// @throws Error(io), Error(cancelled)
    const BrickIndex& index(const JobContext& job);
    /// What each brick can bring to the scene; kept for the next picture of the same classification.
    const std::vector<BrickState>& states(const Scene& scene, const Plan& plan, const TransferTables* tables,
                                          const JobContext& job);

    bool resident(std::int64_t brick) const { return bricks_.contains(brick); }
    /// The brick, loaded if it is not resident; others go so that all together stay below `budget` bytes. A uniform
    /// brick is eight voxels of its value.
    /// @throws Error(io), Error(out_of_memory), Error(cancelled)
    Brick& hold(std::int64_t brick, const BrickState& state, std::uint64_t budget, const JobContext& job);
    /// Takes note of what the brick's structures have come to; others go if that is more than there was room for.
    void settle(std::int64_t brick, std::uint64_t budget);
    /// Where the brick lies, as kernels read it; the launch's column is left 0.
    BrickParams place(std::int64_t brick) const;

    std::uint64_t bytes() const { return bytes_; }
    BrickCounts counts;  ///< of the picture being cast; whoever starts one resets it

private:
    void make_room(std::uint64_t needed, std::uint64_t budget, std::int64_t keep);

    std::shared_ptr<ComputeDevice> device_;
    Volume volume_;
    BrickGrid grid_;
    std::shared_ptr<const BrickIndex> index_;
    std::map<std::int64_t, Brick> bricks_;
    std::optional<VisibilityKey> states_key_;
    std::vector<BrickState> states_;
    std::uint64_t clock_ = 0, bytes_ = 0;
    std::size_t largest_structure_ = 0;  ///< bytes of the largest seen: what the next brick's may take
};

}  // namespace lacuna
