#include "core/render/structure_distance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "core/accel/distance_field.h"
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

VoxelBuffer make_field(Structure structure, const RegionGrid& regions, const JobContext& job) {
    if (structure == Structure::pc) return chessboard_field(regions, job);
    return structure == Structure::acd ? octant_field(regions, job) : box_field(regions, job);
}

class DistanceFamily final : public StructureFamily {
public:
    BoundStructure prepare(const StructureContext& context, RayParams& params) override {
        const Plan& plan = context.plan;
        const int shift = std::countr_zero(unsigned(plan.cells));
        const SecondKind second = context.scene.mode == ViewMode::iso ? SecondKind::inside : SecondKind::busy;
        const bool ranges = takes_extremes(context.scene.mode);
        const MacrocellGrid& grid = context.cells.grid(context.scene.volume, shift, context.job);

        BoundStructure bound{.kernel_id = 4};
        if (ranges) bound.built = upload_ranges(context, grid);
        Field& held = fields_[std::size_t(plan.structure) - std::size_t(Structure::pc)];
        if (VisibilityKey key = context.key(); !held.key || held.shift != shift || *held.key != key) {
            Field made;
            const ValueRange values = value_range(grid);
            auto classes = classify_macrocells(grid, context.table(values), context.slack(values));
            const RegionGrid regions = macrocell_regions(grid, std::move(classes), second);
            made.entries = make_field(plan.structure, regions, context.job);
            made.buffer = device_buffer(context.device, made.entries.data(), made.entries.size());
            made.shift = shift;
            made.key = std::move(key);
            held = std::move(made);
            bound.built = true;
        }
        put_cells(params, grid.cells, shift, context);
        bound.buffers = {held.buffer};
        if (ranges) bound.buffers.push_back(ranges_);
        bound.bytes = held.entries.size() + grid.bytes();
        bound.options = " -DLACUNA_DISTANCE=" + std::to_string(int(plan.structure) - int(Structure::pc)) +
                        " -DLACUNA_REGIONS=" + std::to_string(int(second)) +
                        " -DLACUNA_RANGES_OF_CELLS=" + (ranges ? "1" : "0");
        return bound;
    }

    void drop() override { *this = {}; }
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const Field& f : fields_) sum += f.entries.size();
        return sum;
    }

private:
    struct Field {
        std::optional<VisibilityKey> key;
        int shift = -1;
        VoxelBuffer entries;
        cl::Buffer buffer;  ///< of the entries in place, where the device shares the host's memory
    };

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
