#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/accel/macrocells.h"
#include "core/base/job.h"
#include "core/compute/device.h"
#include "core/render/engine.h"
#include "core/render/plan.h"
#include "core/render/scene.h"
#include "core/render/transfer_tables.h"
#include "shared/ray_params.h"

namespace lacuna {

/// A structure as a ray-casting kernel reads it.
struct BoundStructure {
    int kernel_id = 0;                ///< LACUNA_STRUCTURE of the kernel variant that traverses it
    std::vector<cl::Buffer> buffers;  ///< its arguments, in the order of STRUCTURE_ARGS in kernels/include/skip.clh
};

/// Builds acceleration structures for one volume when a plan first needs them, keeps each by what it depends on (the
/// voxels; or the voxels and the classification) and rebuilds only what an edit made stale.
class StructureCache {
public:
    explicit StructureCache(std::shared_ptr<ComputeDevice> device) : device_(std::move(device)) {}

    /// Drops everything made for another volume.
    void hold(const Volume& volume);
    /// The structure the plan names, ready for the scene; what it took goes into `build` under the structure's name.
    /// Fills the parameters its traversal reads. @param tables null for modes without a transfer function
    BoundStructure prepare(const Scene& scene, const Plan& plan, const TransferTables* tables, RayParams& params,
                           std::map<std::string, BuildRecord>& build, const JobContext& job);

    std::size_t bytes() const;
    void drop();

private:
    /// What visibility of values means depends on the mode: opacity (EA), inside (iso), or the ranges alone.
    enum class ClassKind { opacity, iso, ranges };
    struct ClassKey {
        ClassKind kind;
        Classification classification;
        double iso = 0;  ///< 0 unless kind is iso
        friend bool operator==(const ClassKey&, const ClassKey&) = default;
    };
    struct Cells {
        MacrocellGrid grid;
        ValueRange values;  ///< of all cells
        cl::Buffer ranges;
    };
    struct CellClasses {
        ClassKey key;
        std::vector<std::uint8_t> host;
        cl::Buffer device;
    };

    static ClassKey class_key(const Scene& scene);
    const Cells& cells(const Volume& volume, const JobContext& job);
    const CellClasses& classes(const Scene& scene, const TransferTables* tables);
    cl::Buffer upload(const void* data, std::size_t bytes);

    std::shared_ptr<ComputeDevice> device_;
    VoxelBuffer voxels_;  ///< of the volume held
    std::optional<Cells> cells_;
    std::optional<CellClasses> classes_;
};

}  // namespace lacuna
