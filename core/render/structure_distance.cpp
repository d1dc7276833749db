#include "core/render/structure_distance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>

#include "core/accel/distance_field.h"
#include "core/accel/voxel_regions.h"
#include "core/compute/buffers.h"
#include "core/render/packet_spans.h"

namespace lacuna {

namespace {

/// What the second kind of region is to the kernel: LACUNA_REGIONS of skip_distance.clh.
enum class SecondKind { busy, inside, homogeneous };

bool takes_extremes(ViewMode mode) {
    return mode == ViewMode::mip || mode == ViewMode::minip || mode == ViewMode::lmip;
}

/// What a structure's field tells apart besides empty cells: nothing else, cells inside the object, or cells that may
/// show something (so that where nothing can be skipped nothing needs to be asked).
RegionGrid macrocell_regions(const MacrocellGrid& grid, std::vector<std::uint8_t>&& classes, bool inside, bool busy) {
    using Answer = VisibilityTable::Answer;
    constexpr auto k_none = std::uint8_t(Answer::none), k_all = std::uint8_t(Answer::all);
    const std::uint8_t of_all = inside || busy ? 2 : 0, of_some = busy ? 2 : 0;
    for (std::uint8_t& c : classes) c = c == k_none ? 1 : c == k_all ? of_all : of_some;  // a loop for vectors
    return {grid.cells, std::move(classes)};
}

std::size_t entry_bytes(Structure structure) {
    return structure == Structure::pc ? 1 : structure == Structure::acd ? 8 : 16;  // of a cell
}

void fill_field(Structure structure, const RegionGrid& regions, OctantSet octants, SecondKind second,
                VoxelBuffer& entries, const JobContext& job) {
    if (structure == Structure::pc) {
        entries = chessboard_field(regions, job);
    } else if (structure == Structure::acd) {
        fill_cubes(regions, octants, reinterpret_cast<std::uint8_t*>(entries.data()), job);
    } else {
        // How far a ray need not ask again is worth no more than a cube.
        fill_boxes(regions, octants, reinterpret_cast<std::uint16_t*>(entries.data()), job,
                   second == SecondKind::busy ? Extend::first_only : Extend::both);
    }
}

constexpr double k_megabyte = 1048576;

/// @throws Error(out_of_memory) where entries a voxel cannot be held, with the numbers
void require_memory(const StructureContext& context) {
    const auto voxels = double(context.scene.volume.geometry().voxel_count());
    const Structure structure = context.plan.structure;
    const auto entry = double(entry_bytes(structure));
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
    bool enters = false;  ///< rays may start inside the object: what lies in it is a region of its own
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
            held.key.reset();
            held.made = 0;
            held.regions = voxelwise ? regions_of_voxels(context, grid, key, second)
                                     : regions_of_cells(context, grid, second, key.enters);
            if (!voxelwise) held.frontier.hold(held.regions, shift);
            held.key = std::move(key);
        }
        bound.built |= make_entries(context, held, second, params);
        if (voxelwise)
            put_cells(params, context.scene.volume.geometry().size, 0, context);
        else
            put_cells(params, grid.cells, shift, context);
        bound.buffers = {held.buffer};
        if (ranges) bound.buffers.push_back(ranges_);
        bound.bytes = held.bytes() + grid.bytes();
        bound.options = " -DLACUNA_DISTANCE=" + std::to_string(int(plan.structure) - int(Structure::pc)) +
                        " -DLACUNA_REGIONS=" + std::to_string(int(second)) +
                        " -DLACUNA_RANGES_OF_CELLS=" + (ranges ? "1" : "0");
        // Gradients inside a homogeneous region are zero, unless the plan lets them turn.
        if (held.key->angle_deg > 0) bound.options += " -DLACUNA_RUN_GRADIENT=1";
        if (takes_spans(context)) bind_spans(context, held, params, bound);
        return bound;
    }

    void drop() override { *this = {}; }
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const Field& f : fields_) sum += f.bytes();
        return sum + spans_.size();
    }

private:
    static constexpr int k_value_shift = 3;  ///< cells that tell the range of all values

    struct Field {
        std::optional<FieldKey> key;
        RegionGrid regions;   ///< of cells, for octants not asked for yet; of voxels none once they are made
        OctantSet made = 0;   ///< octants whose entries are there
        VoxelBuffer entries;  ///< kept from one key to the next: fresh memory costs more than a small field
        cl::Buffer buffer;    ///< of the entries in place, where the device shares the host's memory
        PacketSpans frontier;

        std::size_t bytes() const { return entries.size() + regions.region.size(); }
    };

    /// Makes the entries that rays of this view ask for and that are not there. @return whether there were any
    static bool make_entries(const StructureContext& context, Field& held, SecondKind second, const RayParams& params) {
        const Structure structure = context.plan.structure;
        const bool voxelwise = context.plan.cells == 1;
        const int margin_px = 2 * std::max(context.plan.sparse, 1) + 16;
        const OctantSet needed = structure == Structure::pc || voxelwise || context.plan.brick > 0
                                     ? k_all_octants
                                     : octants_of_rays(params, margin_px);
        if ((held.made & needed) == needed) return false;
        const std::size_t bytes = held.regions.region.size() * entry_bytes(structure);
        if (held.entries.size() != bytes) {
            held.buffer = {};
            held.entries = {};  // the old one goes before the new one needs the memory
            held.made = 0;
            if (structure != Structure::pc) held.entries = VoxelBuffer(bytes);
        }
        const OctantSet missing = needed & ~held.made;
        fill_field(structure, held.regions, missing, second, held.entries,
                   voxelwise ? context.job.part(0.2, 1) : context.job);
        held.buffer = device_buffer(context.device, held.entries.data(), held.entries.size());
        held.made |= missing;
        if (voxelwise) held.regions = {};
        return true;
    }

    /// Spans serve the kernels that walk samples of a whole picture.
    static bool takes_spans(const StructureContext& context) {
        const Plan& plan = context.plan;
        if (plan.cells == 1 || plan.brick > 0 || plan.sparse >= 2) return false;
        if (context.scene.mode == ViewMode::iso) return plan.refine != Refinement::cubic;
        return context.scene.mode == ViewMode::ea && plan.integration != Integration::preintegrated;
    }

    void bind_spans(const StructureContext& context, const Field& held, const RayParams& params,
                    BoundStructure& bound) {
        constexpr int k_group_packets = 4;  // pictures are padded to whole work-groups
        const glm::ivec2 packets = (context.scene.size + 15) / 16 * k_group_packets;
        const std::size_t bytes = std::size_t(packets.x) * std::size_t(packets.y) * sizeof(glm::vec2);
        if (spans_.size() != bytes) {
            spans_buffer_ = {};
            spans_ = VoxelBuffer(bytes);
        }
        held.frontier.project(params, packets, reinterpret_cast<glm::vec2*>(spans_.data()));
        spans_buffer_ = device_buffer(context.device, spans_.data(), spans_.size());
        bound.buffers.push_back(spans_buffer_);
        bound.options += " -DLACUNA_SPANS=1";
    }

    static SecondKind second_kind(const StructureContext& context) {
        if (context.scene.mode == ViewMode::iso) return SecondKind::inside;
        return context.scene.mode == ViewMode::ea && context.plan.cells == 1 ? SecondKind::homogeneous
                                                                             : SecondKind::busy;
    }

    static FieldKey key_of(const StructureContext& context, SecondKind second) {
        FieldKey key{context.key(), context.plan.cells};
        key.enters = second == SecondKind::inside && context.plan.cells != 1 &&
                     std::any_of(context.scene.cuts.begin(), context.scene.cuts.end(),
                                 [](const CuttingPlane& cut) { return !cut.cap; });
        if (second != SecondKind::homogeneous) return key;
        key.homogeneity = context.plan.homogeneity;
        key.gradients = context.scene.shading != Shading::none || (context.tables && context.tables->uses_gradient);
        key.angle_deg = key.gradients ? context.plan.homogeneity_angle_deg : 0;
        return key;
    }

    static RegionGrid regions_of_cells(const StructureContext& context, const MacrocellGrid& grid, SecondKind second,
                                       bool enters) {
        const ValueRange values = context.cells.values(context.scene.volume, grid.shift, context.job);
        const double slack = context.slack(values);
        const bool threshold = context.scene.mode == ViewMode::iso && context.scene.classification.ranges.empty();
        return macrocell_regions(grid,
                                 threshold ? classify_macrocells(grid, context.scene.iso, slack)
                                           : classify_macrocells(grid, context.table(values), slack),
                                 enters, second == SecondKind::busy);
    }

    static RegionGrid regions_of_voxels(const StructureContext& context, const MacrocellGrid& grid, const FieldKey& key,
                                        SecondKind second) {
        using Second = VoxelRules::Second;
        const ValueRange values = context.cells.values(context.scene.volume, grid.shift, context.job);
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
    VoxelBuffer spans_;            ///< of the last view
    cl::Buffer spans_buffer_;
    cl::Buffer ranges_;
    int ranges_shift_ = -1;
};

}  // namespace

std::unique_ptr<StructureFamily> make_distance_family() { return std::make_unique<DistanceFamily>(); }

}  // namespace lacuna
