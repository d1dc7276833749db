#include "core/render/structure_cache.h"

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "core/compute/buffers.h"

namespace lacuna {

namespace {

constexpr double k_float_slack = 1e-6;  // relative: interpolation may round beyond a cell's range

ValueRange range_of_cells(const MacrocellGrid& grid) {
    ValueRange values{0, 0};
    bool any = false;
    for (const glm::vec2& r : grid.ranges) {
        if (r.x > r.y) continue;
        values =
            any ? ValueRange{std::min(values.lo, double(r.x)), std::max(values.hi, double(r.y))} : ValueRange{r.x, r.y};
        any = true;
    }
    return values;
}

void put_cells(RayParams& p, const MacrocellGrid& grid, glm::ivec3 voxels, double step) {
    for (int a = 0; a < 3; ++a) p.cells[a] = grid.cells[a];
    p.cell_shift = grid.shift;
    p.cell_size = float(1 << grid.shift);
    // Single precision tells positions apart to about size * 2^-23; a few of those, in samples.
    const int longest = std::max({voxels.x, voxels.y, voxels.z});
    p.exit_margin = float(1e-3 + 1e-6 * longest / step);
}

}  // namespace

void StructureCache::hold(const Volume& volume) {
    if (voxels_.data() == volume.data()) return;
    drop();
    voxels_ = volume.buffer();
}

void StructureCache::drop() {
    classes_.reset();
    cells_.reset();
    voxels_ = {};
}

std::size_t StructureCache::bytes() const {
    return (cells_ ? cells_->grid.bytes() : 0) + (classes_ ? classes_->host.size() : 0);
}

cl::Buffer StructureCache::upload(const void* data, std::size_t bytes) {
    cl::Buffer buffer = scratch_buffer(*device_, bytes);
    device_->queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, data);
    return buffer;
}

const StructureCache::Cells& StructureCache::cells(const Volume& volume, const JobContext& job) {
    if (!cells_) {
        Cells made{build_macrocells(volume, 3, job), {}, {}};
        made.values = range_of_cells(made.grid);
        made.ranges = upload(made.grid.ranges.data(), made.grid.ranges.size() * sizeof(glm::vec2));
        cells_ = std::move(made);
    }
    return *cells_;
}

StructureCache::ClassKey StructureCache::class_key(const Scene& scene) {
    if (scene.mode == ViewMode::ea) return {ClassKind::opacity, scene.classification, 0};
    if (scene.mode == ViewMode::iso) return {ClassKind::iso, scene.classification, scene.iso};
    return {ClassKind::ranges, scene.classification, 0};
}

const StructureCache::CellClasses& StructureCache::classes(const Scene& scene, const TransferTables* tables) {
    ClassKey key = class_key(scene);
    if (classes_ && classes_->key == key) return *classes_;
    const ValueRange values = cells_->values;
    const VisibilityTable table =
        key.kind == ClassKind::opacity ? VisibilityTable::of_opacity(scene.classification, values)
        : key.kind == ClassKind::iso   ? VisibilityTable::of_iso(scene.classification, scene.iso, values)
                                       : VisibilityTable::of_ranges(scene.classification, values);
    double slack = k_float_slack * std::max(std::abs(values.lo), std::abs(values.hi));
    if (key.kind == ClassKind::opacity && tables) slack += tables->slack;
    CellClasses made{std::move(key), classify_macrocells(cells_->grid, table, slack), {}};
    made.device = upload(made.host.data(), made.host.size());
    classes_ = std::move(made);
    return *classes_;
}

BoundStructure StructureCache::prepare(const Scene& scene, const Plan& plan, const TransferTables* tables,
                                       RayParams& params, std::map<std::string, BuildRecord>& build,
                                       const JobContext& job) {
    if (plan.structure == Structure::none) return {};
    const Stopwatch watch;
    const bool cached = cells_ && classes_ && classes_->key == class_key(scene);
    const Cells& grid = cells(scene.volume, job);
    const CellClasses& visible = classes(scene, tables);
    put_cells(params, grid.grid, scene.volume.geometry().size, plan.step);
    build[std::string(name_of(plan.structure))] = {cached ? 0.0 : watch.ms(), bytes()};
    return {1, {visible.device, grid.ranges}};
}

}  // namespace lacuna
