#include "core/render/structure_distance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>

#include "core/accel/distance_field.h"
#include "core/accel/voxel_regions.h"
#include "core/compute/buffers.h"

namespace lacuna {

namespace {

/// What the second kind of region is to the kernel: LACUNA_REGIONS of skip_distance.clh.
enum class SecondKind { busy, inside, homogeneous };

bool takes_extremes(ViewMode mode) {
    return mode == ViewMode::mip || mode == ViewMode::minip || mode == ViewMode::lmip;
}

/// Empty cells, and those the mode can treat as a region of their own: for iso the cells inside the object, else
/// all that may show something, so that where nothing can be skipped nothing needs to be asked.
RegionGrid macrocell_regions(const MacrocellGrid& grid, std::vector<std::uint8_t>&& classes, SecondKind second) {
    using Answer = VisibilityTable::Answer;
    for (std::uint8_t& c : classes) {
        const auto answer = Answer(c);
        if (answer == Answer::none)
            c = 1;
        else
            c = answer == Answer::all || second == SecondKind::busy ? 2 : 0;
    }
    return {grid.cells, std::move(classes)};
}

VoxelBuffer make_field(Structure structure, const RegionGrid& regions, SecondKind second, const JobContext& job) {
    if (structure == Structure::pc) return chessboard_field(regions, job);
    if (structure == Structure::acd) return octant_field(regions, job);
    // How far a ray need not ask again is worth no more than a cube.
    return box_field(regions, job, second == SecondKind::busy ? Extend::first_only : Extend::both);
}

constexpr double k_megabyte = 1048576;

/// @throws Error(out_of_memory) where entries a voxel cannot be held, with the numbers
void require_memory(const StructureContext& context) {
    const auto voxels = double(context.scene.volume.geometry().voxel_count());
    const Structure structure = context.plan.structure;
    const double entry = structure == Structure::pc ? 1 : structure == Structure::acd ? 8 : 16;
    const DeviceInfo& device = context.device.info();
    const double most =
        std::min({double(device.max_allocation_bytes), 0.5 * double(device.memory_bytes), 2147483647.0});
    if (voxels * entry <= most) return;
    throw Error(Errc::out_of_memory, "The structure '" + std::string(name_of(structure)) + "' needs " +
                                         std::to_string(std::int64_t(voxels * entry / k_megabyte)) +
                                         " MB with an entry a voxel, more than the " +
                                         std::to_string(std::int64_t(most / k_megabyte)) +
                                         " MB the device offers for it; take macro-cells of 4, 8 or 16 voxels.");
}

/// Everything a field depends on besides the voxels.
struct FieldKey {
    VisibilityKey visibility;
    int cells = 0;
    double homogeneity = 0, angle_deg = 0;  ///< 0 unless regions are homogeneous ones
    bool gradients = false;
    friend bool operator==(const FieldKey&, const FieldKey&) = default;
};

class DistanceFamily final : public StructureFamily {
public:
    BoundStructure prepare(const StructureContext& context, RayParams& params) override {
        const Plan& plan = context.plan;
        const SecondKind second = second_kind(context);
        const bool voxelwise = plan.cells == 1, ranges = takes_extremes(context.scene.mode) && !voxelwise;
        if (voxelwise) require_memory(context);
        const int shift = voxelwise ? k_value_shift : std::countr_zero(unsigned(plan.cells));
        const MacrocellGrid& grid = context.cells.grid(context.scene.volume, shift, context.job);

        BoundStructure bound{.kernel_id = 4};
        bound.runs = second == SecondKind::homogeneous;
        if (ranges) bound.built = upload_ranges(context, grid);
        Field& held = fields_[std::size_t(plan.structure) - std::size_t(Structure::pc)];
        if (FieldKey key = key_of(context, second); !held.key || *held.key != key) {
            held.entries = {};  // the old one goes before the new one needs the memory
            held.key.reset();
            Field made;
            const RegionGrid regions =
                voxelwise ? regions_of_voxels(context, grid, key, second) : regions_of_cells(context, grid, second);
            made.entries =
                make_field(plan.structure, regions, second, voxelwise ? context.job.part(0.2, 1) : context.job);
            made.buffer = device_buffer(context.device, made.entries.data(), made.entries.size());
            made.key = std::move(key);
            held = std::move(made);
            bound.built = true;
        }
        if (voxelwise)
            put_cells(params, context.scene.volume.geometry().size, 0, context);
        else
            put_cells(params, grid.cells, shift, context);
        bound.buffers = {held.buffer};
        if (ranges) bound.buffers.push_back(ranges_);
        bound.bytes = held.entries.size() + grid.bytes();
        bound.options = " -DLACUNA_DISTANCE=" + std::to_string(int(plan.structure) - int(Structure::pc)) +
                        " -DLACUNA_REGIONS=" + std::to_string(int(second)) +
                        " -DLACUNA_RANGES_OF_CELLS=" + (ranges ? "1" : "0");
        // Gradients inside a homogeneous region are zero, unless the plan lets them turn.
        if (held.key->angle_deg > 0) bound.options += " -DLACUNA_RUN_GRADIENT=1";
        return bound;
    }

    void drop() override { *this = {}; }
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const Field& f : fields_) sum += f.entries.size();
        return sum;
    }

private:
    static constexpr int k_value_shift = 3;  ///< cells that tell the range of all values

    struct Field {
        std::optional<FieldKey> key;
        VoxelBuffer entries;
        cl::Buffer buffer;  ///< of the entries in place, where the device shares the host's memory
    };

    static SecondKind second_kind(const StructureContext& context) {
        if (context.scene.mode == ViewMode::iso) return SecondKind::inside;
        return context.scene.mode == ViewMode::ea && context.plan.cells == 1 ? SecondKind::homogeneous
                                                                             : SecondKind::busy;
    }

    static FieldKey key_of(const StructureContext& context, SecondKind second) {
        FieldKey key{context.key(), context.plan.cells};
        if (second != SecondKind::homogeneous) return key;
        key.homogeneity = context.plan.homogeneity;
        key.gradients = context.scene.shading != Shading::none || (context.tables && context.tables->uses_gradient);
        key.angle_deg = key.gradients ? context.plan.homogeneity_angle_deg : 0;
        return key;
    }

    static RegionGrid regions_of_cells(const StructureContext& context, const MacrocellGrid& grid, SecondKind second) {
        const ValueRange values = value_range(grid);
        return macrocell_regions(grid, classify_macrocells(grid, context.table(values), context.slack(values)), second);
    }

    static RegionGrid regions_of_voxels(const StructureContext& context, const MacrocellGrid& grid, const FieldKey& key,
                                        SecondKind second) {
        using Second = VoxelRules::Second;
        const ValueRange values = value_range(grid);
        const VisibilityTable visible = context.table(values);
        const HomogeneityTable alike(context.scene.classification, values, key.homogeneity);
        VoxelRules rules{visible, context.slack(values)};
        rules.second = second == SecondKind::homogeneous ? Second::homogeneous
                       : second == SecondKind::inside    ? Second::all_visible
                                                         : Second::busy;
        rules.alike = &alike;
        rules.gradients = key.gradients;
        rules.angle_deg = key.angle_deg;
        return voxel_regions(context.scene.volume, rules, context.job.part(0, 0.2));
    }

    bool upload_ranges(const StructureContext& context, const MacrocellGrid& grid) {
        if (ranges_() && ranges_shift_ == grid.shift) return false;
        ranges_ = context.upload(grid.ranges.data(), grid.ranges.size() * sizeof(glm::vec2));
        ranges_shift_ = grid.shift;
        return true;
    }

    std::array<Field, 3> fields_;  ///< pc, acd, eacd
    cl::Buffer ranges_;
    int ranges_shift_ = -1;
};

}  // namespace

std::unique_ptr<StructureFamily> make_distance_family() { return std::make_unique<DistanceFamily>(); }

}  // namespace lacuna
