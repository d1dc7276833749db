#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/render/engine.h"
#include "core/render/plan_buffers.h"
#include "core/render/structure_family.h"

namespace lacuna {

/// The structures of one volume, each built when a plan first needs it.
class StructureCache {
public:
    explicit StructureCache(std::shared_ptr<ComputeDevice> device);

    /// Drops everything made for another volume.
    void hold(const Volume& volume);
    /// The structure the plan names and what else its kernels read (PlanBuffers), ready for the scene; what each took
    /// goes into `build` under its name; min-max cells count with every structure made of them, the first time it is,
    /// whoever made them. Fills the parameters its traversal reads. @param tables null for modes without
    /// a transfer function
    BoundStructure prepare(const Scene& scene, const Plan& plan, const TransferTables* tables, RayParams& params,
                           std::map<std::string, BuildRecord>& build, const JobContext& job);

    /// The min-max cells and what each can show (VisibilityTable::Answer) in the scene's mode.
    struct CellClasses {
        const MacrocellGrid& grid;
        const std::vector<std::uint8_t>& classes;
    };
    CellClasses classes(const Scene& scene, const Plan& plan, const TransferTables* tables, const JobContext& job);

    std::size_t bytes() const;
    void drop();

private:
    BoundStructure prepare_structure(const StructureContext& context, RayParams& params,
                                     std::map<std::string, BuildRecord>& build);

    std::shared_ptr<ComputeDevice> device_;
    VoxelBuffer voxels_;  ///< of the volume held
    SharedCells cells_;
    PlanBuffers plan_buffers_;
    std::vector<std::uint8_t> classes_;  ///< for class_key_
    std::optional<VisibilityKey> class_key_;
    std::map<Structure, std::shared_ptr<StructureFamily>> families_;  ///< pc, acd and eacd share one
    std::map<Structure, unsigned> cells_told_;  ///< cells that were counted with a structure, bits by shift
};

}  // namespace lacuna
