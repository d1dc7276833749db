#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/accel/macrocells.h"
#include "core/base/job.h"
#include "core/compute/device.h"
#include "core/render/plan.h"
#include "core/render/scene.h"
#include "core/render/transfer_tables.h"
#include "shared/ray_params.h"

namespace lacuna {

/// A structure as a ray-casting kernel reads it.
struct BoundStructure {
    int kernel_id = 0;  ///< LACUNA_STRUCTURE of the kernel variant that traverses it
    /// Its arguments, in the order of STRUCTURE_ARGS in its kernels/include/skip_*.clh.
    std::vector<cl::Buffer> buffers = {};
    bool runs = false;       ///< LACUNA_RUNS: it can answer "n samples of this value"
    bool built = false;      ///< something had to be built for this frame
    std::size_t bytes = 0;   ///< held for this structure, the min-max cells it was derived from included
    cl::Buffer volume = {};  ///< voxels to sample instead of the scene's, of the same size and type; else none
    std::optional<std::string> own_kernel = {};  ///< a kernel of its own instead of the mode's: file and function
    std::string options = {};                    ///< further options of the kernel variant, each with a space before it
    bool runs_of_class = false;                  ///< its runs also have one region class (scene.h)
};

/// What visibility of values means depends on the mode: opacity (EA), inside (iso), or the ranges alone (MIP family).
/// Two scenes with equal keys show the same values.
struct VisibilityKey {
    enum class Kind { opacity, iso, ranges } kind = Kind::opacity;
    Classification classification;
    double iso = 0;         ///< 0 unless kind is iso
    bool segments = false;  ///< queries are widened for tables of pre-integrated segments
    friend bool operator==(const VisibilityKey&, const VisibilityKey&) = default;
};

/// The min-max cells of the volume held, built once a volume for whoever derives a structure from them.
class SharedCells {
public:
    /// The grid with cells of 2^shift voxels. Cost: one pass over the voxels the first time.
    const MacrocellGrid& grid(const Volume& volume, int shift, const JobContext& job);
    /// What making the grids took that were asked for since the last call and were there already, ms; of what was made
    /// since, the caller's own clock tells. `told` are bits by shift, of grids the caller knows of: they are left out,
    /// and added.
    double take_found_ms(unsigned& told);
    /// The smallest and largest value of all its cells, found once.
    ValueRange values(const Volume& volume, int shift, const JobContext& job);
    bool holds(int shift) const { return shift < int(grids_.size()) && !grids_[std::size_t(shift)].ranges.empty(); }
    void drop() { *this = {}; }
    std::size_t bytes() const;

private:
    std::vector<MacrocellGrid> grids_;  // by shift
    std::vector<double> made_ms_;       // likewise
    unsigned found_ = 0, made_ = 0;     // bits by shift, since take_found_ms()
    std::optional<ValueRange> values_;
};

/// Everything a family needs to make its structure for one frame.
struct StructureContext {
    ComputeDevice& device;
    SharedCells& cells;
    const Scene& scene;
    const Plan& plan;
    const TransferTables* tables;  ///< null for modes without a transfer function
    const JobContext& job;

    VisibilityKey key() const;
    /// The table for key() over a range of values, and how far a query must be widened because the kernels' own tables
    /// and interpolation round (in the volume's unit).
    VisibilityTable table(ValueRange values) const;
    double slack(ValueRange values) const;
    cl::Buffer upload(const void* data, std::size_t bytes) const;
};

/// Smallest and largest value of all cells; {0, 0} when no cell has any.
ValueRange value_range(const MacrocellGrid& grid);
/// How near (in samples) to a cell's far face a sample must lie to count as behind it, in a volume of this size.
float exit_margin(glm::ivec3 size, double step);
/// Puts the grid into the kernel's parameters: cells, cell_shift, cell_size, exit_margin.
void put_cells(RayParams& params, glm::ivec3 cells, int shift, const StructureContext& context);

/// One kind of structure: keeps what it built by what it depends on, rebuilds only what an edit made stale.
class StructureFamily {
public:
    virtual ~StructureFamily() = default;
    /// Ready for the scene under the plan; fills the parameters its traversal reads. A cancelled build leaves nothing.
    virtual BoundStructure prepare(const StructureContext& context, RayParams& params) = 0;
    virtual void drop() = 0;
    virtual std::size_t bytes() const = 0;  ///< without the shared cells
};

}  // namespace lacuna
