#include "core/render/plan_buffers.h"

#include <algorithm>
#include <array>

#include "core/accel/steady_blocks.h"
#include "core/base/stopwatch.h"
#include "core/compute/buffers.h"
#include "core/render/stored_gradients.h"

namespace lacuna {

namespace {

constexpr int k_value_shift = 3;   // cells that tell the range of all values
constexpr int k_steady_shift = 2;  // adaptive.clh
constexpr double k_megabyte = 1048576;

template <class T>
cl::Buffer uploaded(const StructureContext& context, const std::vector<T>& values) {
    return context.upload(values.data(), values.size() * sizeof(T));
}

double step_mm(const StructureContext& context) {
    return context.plan.step * context.scene.volume.geometry().smallest_spacing_mm();
}

/// @throws Error(out_of_memory) where a word a voxel cannot be held, with the numbers
void require_gradient_memory(const StructureContext& context) {
    const double need = 4.0 * double(context.scene.volume.geometry().voxel_count());
    const DeviceInfo& device = context.device.info();
    const double most = std::min(double(device.max_allocation_bytes), 0.5 * double(device.memory_bytes));
    if (need <= most) return;
    throw Error(Errc::out_of_memory, "Stored gradients need " + std::to_string(std::int64_t(need / k_megabyte)) +
                                         " MB, more than the " + std::to_string(std::int64_t(most / k_megabyte)) +
                                         " MB the device offers for them; take gradients on the fly.");
}

}  // namespace

bool reads_gradients(const Scene& scene, const TransferTables* tables) {
    if (scene.mode == ViewMode::iso) return true;
    return scene.mode == ViewMode::ea && (scene.shading != Shading::none || (tables && tables->uses_gradient));
}

BuildRecord PlanBuffers::hold_segments(const StructureContext& context) {
    const Stopwatch watch;
    SegmentKey key{context.scene.classification, step_mm(context)};
    if (segment_key_ && *segment_key_ == key) return {0, segment_bytes_};
    const ValueRange values = value_range(context.cells.grid(context.scene.volume, k_value_shift, context.job));
    const SegmentTables tables = make_segment_tables(context.scene.classification, values, key.step_mm);
    segment_opacity_ = uploaded(context, tables.opacity);
    segment_color_ = uploaded(context, tables.color);
    segment_visible_ = uploaded(context, tables.visible);
    const std::array<float, 2> axis{float(tables.lo), float(tables.nodes_per_unit)};
    segment_axis_ = context.upload(axis.data(), sizeof axis);
    segment_bytes_ = tables.opacity.size() * sizeof(float) + tables.color.size() * sizeof(std::uint32_t) +
                     tables.visible.size() * sizeof(std::uint32_t);
    segment_key_ = std::move(key);
    return {watch.ms(), segment_bytes_};
}

BuildRecord PlanBuffers::hold_gradients(const StructureContext& context) {
    const Stopwatch watch;
    const GradientFilter filter = context.plan.gradient;
    if (stored_filter_ == filter) return {0, stored_.size()};
    require_gradient_memory(context);
    stored_filter_.reset();
    stored_gradients_ = {};
    stored_ = {};  // the old ones go before the new ones need the memory
    const ValueRange values = value_range(context.cells.grid(context.scene.volume, k_value_shift, context.job));
    stored_ = make_stored_gradients(context.scene.volume, filter, values, context.job);
    stored_gradients_ = device_buffer(context.device, stored_.data(), stored_.size());
    stored_filter_ = filter;
    return {watch.ms(), stored_.size()};
}

BuildRecord PlanBuffers::hold_steady(const StructureContext& context) {
    const Stopwatch watch;
    VisibilityKey key = context.key();
    const MacrocellGrid& grid = context.cells.grid(context.scene.volume, k_steady_shift, context.job);
    if (!steady_key_ || *steady_key_ != key) {
        const ValueRange values = value_range(grid);
        const double slack = context.slack(values);
        std::vector<std::uint8_t> blocks;
        if (context.scene.mode == ViewMode::ea)
            blocks = steady_blocks_of_opacity(grid, PlateauTable(context.scene.classification), slack);
        else if (context.scene.mode == ViewMode::iso)
            blocks = steady_blocks_of_iso(grid, context.table(values), slack);
        else
            blocks = steady_blocks_of_values(grid, context.table(values), slack);
        steady_ = uploaded(context, blocks);
        steady_bytes_ = blocks.size();
        steady_key_ = std::move(key);
        return {watch.ms(), steady_bytes_ + grid.bytes()};
    }
    return {0, steady_bytes_ + grid.bytes()};
}

void PlanBuffers::add_to(BoundStructure& bound, const StructureContext& context,
                         std::map<std::string, BuildRecord>& build) {
    std::vector<cl::Buffer> buffers;
    const Plan& plan = context.plan;
    if (context.scene.mode == ViewMode::ea && plan.integration == Integration::preintegrated) {
        build["segments"] = hold_segments(context);
        buffers = {segment_opacity_, segment_color_, segment_visible_, segment_axis_};
        bound.options += " -DLACUNA_SEGMENT_NODES=" + std::to_string(SegmentTables::k_nodes);
    }
    if (reads_gradients(context.scene, context.tables)) {
        if (plan.gradient_store == GradientStore::stored) {
            build["gradients"] = hold_gradients(context);
            buffers.push_back(stored_gradients_);
            bound.options += " -DLACUNA_STORED_GRADIENT=1";
        } else if (plan.gradient == GradientFilter::sobel) {
            bound.options += " -DLACUNA_SOBEL=1";
        }
    }
    if (plan.sampler == Sampler::adaptive) {
        build["steady blocks"] = hold_steady(context);
        buffers.push_back(steady_);
    }
    bound.buffers.insert(bound.buffers.begin(), buffers.begin(), buffers.end());
}

std::size_t PlanBuffers::bytes() const { return segment_bytes_ + stored_.size() + steady_bytes_; }

}  // namespace lacuna
