#include "core/render/structure_family.h"

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "core/compute/buffers.h"
#include "core/render/segment_tables.h"

namespace lacuna {

namespace {
constexpr double k_float_slack = 1e-6;  // relative: interpolation may round beyond a cell's range
}

const MacrocellGrid& SharedCells::grid(const Volume& volume, int shift, const JobContext& job) {
    const auto at = std::size_t(shift);
    if (holds(shift)) {
        found_ |= 1u << at;
    } else {
        const Stopwatch watch;
        MacrocellGrid made = build_macrocells(volume, shift, job);
        if (grids_.size() <= at) {
            grids_.resize(at + 1);
            made_ms_.resize(at + 1);
        }
        grids_[at] = std::move(made);
        made_ms_[at] = watch.ms();
        made_ |= 1u << at;
    }
    return grids_[at];
}

double SharedCells::take_found_ms(unsigned& told) {
    double sum = 0;
    for (std::size_t at = 0; at < made_ms_.size(); ++at)
        if ((found_ & ~made_ & ~told) >> at & 1u) sum += made_ms_[at];
    told |= found_ | made_;
    found_ = made_ = 0;
    return sum;
}

ValueRange SharedCells::values(const Volume& volume, int shift, const JobContext& job) {
    if (!values_) values_ = value_range(grid(volume, shift, job));  // the same for cells of every size
    return *values_;
}

std::size_t SharedCells::bytes() const {
    std::size_t sum = 0;
    for (const MacrocellGrid& g : grids_) sum += g.bytes();
    return sum;
}

VisibilityKey StructureContext::key() const {
    if (scene.mode == ViewMode::ea)
        return {VisibilityKey::Kind::opacity, scene.classification, 0, plan.integration == Integration::preintegrated};
    if (scene.mode == ViewMode::iso) return {VisibilityKey::Kind::iso, scene.classification, scene.iso};
    return {VisibilityKey::Kind::ranges, scene.classification, 0};
}

VisibilityTable StructureContext::table(ValueRange values) const {
    if (scene.mode == ViewMode::ea) return VisibilityTable::of_opacity(scene.classification, values);
    if (scene.mode == ViewMode::iso) return VisibilityTable::of_iso(scene.classification, scene.iso, values);
    return VisibilityTable::of_ranges(scene.classification, values);
}

double StructureContext::slack(ValueRange values) const {
    const double rounding = k_float_slack * std::max(std::abs(values.lo), std::abs(values.hi));
    if (scene.mode != ViewMode::ea) return rounding;
    // A table of segments shows what lies up to a bin beside a value.
    const double bins =
        plan.integration == Integration::preintegrated ? segment_slack(scene.classification, values) : 0;
    return rounding + std::max(bins, tables ? tables->slack : 0);
}

cl::Buffer StructureContext::upload(const void* data, std::size_t bytes) const {
    return uploaded_buffer(device, data, bytes);
}

ValueRange value_range(const MacrocellGrid& grid) {
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

float exit_margin(glm::ivec3 size, double step) {
    // Single precision tells positions apart to about size * 2^-23; a few of those, in samples.
    return float(1e-3 + 1e-6 * std::max({size.x, size.y, size.z}) / step);
}

void put_cells(RayParams& p, glm::ivec3 cells, int shift, const StructureContext& context) {
    for (int a = 0; a < 3; ++a) p.cells[a] = cells[a];
    p.cell_shift = shift;
    p.cell_size = float(1 << shift);
    p.exit_margin = exit_margin(context.scene.volume.geometry().size, context.plan.step);
}

}  // namespace lacuna
