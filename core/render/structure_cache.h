#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/render/engine.h"
#include "core/render/structure_family.h"

namespace lacuna {

/// The structures of one volume, each built when a plan first needs it.
class StructureCache {
public:
    explicit StructureCache(std::shared_ptr<ComputeDevice> device);

    /// Drops everything made for another volume.
    void hold(const Volume& volume);
    /// The structure the plan names, ready for the scene; what it took goes into `build` under the structure's name.
    /// Fills the parameters its traversal reads. @param tables null for modes without a transfer function
    BoundStructure prepare(const Scene& scene, const Plan& plan, const TransferTables* tables, RayParams& params,
                           std::map<std::string, BuildRecord>& build, const JobContext& job);

    std::size_t bytes() const;
    void drop();

private:
    std::shared_ptr<ComputeDevice> device_;
    VoxelBuffer voxels_;  ///< of the volume held
    SharedCells cells_;
    std::map<Structure, std::shared_ptr<StructureFamily>> families_;  ///< pc, acd and eacd share one
};

}  // namespace lacuna
