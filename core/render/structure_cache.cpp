#include "core/render/structure_cache.h"

#include <set>

#include "core/base/stopwatch.h"
#include "core/render/structure_distance.h"
#include "core/render/structure_leap.h"
#include "core/render/structure_macrocells.h"
#include "core/render/structure_octree.h"
#include "core/render/structure_pyramid.h"

namespace lacuna {

StructureCache::StructureCache(std::shared_ptr<ComputeDevice> device) : device_(std::move(device)) {
    families_[Structure::macrocells] = make_macrocell_family();
    families_[Structure::octree] = make_octree_family();
    families_[Structure::pyramid] = make_pyramid_family();
    families_[Structure::leap] = make_leap_family();
    const std::shared_ptr<StructureFamily> distances = make_distance_family();
    for (const Structure kind : {Structure::pc, Structure::acd, Structure::eacd}) families_[kind] = distances;
}

void StructureCache::hold(const Volume& volume) {
    if (voxels_.data() == volume.data()) return;
    drop();
    voxels_ = volume.buffer();
}

void StructureCache::drop() {
    for (const auto& [kind, family] : families_) family->drop();
    cells_.drop();
    plan_buffers_.drop();
    class_key_.reset();
    cells_told_.clear();
    voxels_ = {};
}

std::size_t StructureCache::bytes() const {
    std::size_t sum = cells_.bytes() + plan_buffers_.bytes() + classes_.size();
    std::set<const StructureFamily*> counted;  // some serve several names
    for (const auto& [kind, family] : families_)
        if (counted.insert(family.get()).second) sum += family->bytes();
    return sum;
}

StructureCache::CellClasses StructureCache::classes(const Scene& scene, const Plan& plan, const TransferTables* tables,
                                                    const JobContext& job) {
    constexpr int k_shift = 3;
    const StructureContext context{*device_, cells_, scene, plan, tables, job};
    const MacrocellGrid& grid = cells_.grid(scene.volume, k_shift, job);
    if (VisibilityKey key = context.key(); !class_key_ || *class_key_ != key) {
        const ValueRange values = value_range(grid);
        classes_ = classify_macrocells(grid, context.table(values), context.slack(values));
        class_key_ = std::move(key);
    }
    return {grid, classes_};
}

BoundStructure StructureCache::prepare_structure(const StructureContext& context, RayParams& params,
                                                 std::map<std::string, BuildRecord>& build) {
    const Structure wanted = context.plan.structure;
    if (wanted == Structure::none) return {};
    const auto family = families_.find(wanted);
    if (family == families_.end())
        throw Error(Errc::unsupported,
                    "The structure '" + std::string(name_of(wanted)) + "' does not serve ray casting.");
    unsigned nothing = 0;
    cells_.take_found_ms(nothing);  // of others
    const Stopwatch watch;
    BoundStructure made = family->second->prepare(context, params);
    const double ms = watch.ms(), cells_ms = cells_.take_found_ms(cells_told_[wanted]);
    build[std::string(name_of(wanted))] = {made.built ? ms + cells_ms : 0.0, made.bytes};
    return made;
}

BoundStructure StructureCache::prepare(const Scene& scene, const Plan& plan, const TransferTables* tables,
                                       RayParams& params, std::map<std::string, BuildRecord>& build,
                                       const JobContext& job) {
    const StructureContext context{*device_, cells_, scene, plan, tables, job};
    BoundStructure bound = prepare_structure(context, params, build);
    plan_buffers_.add_to(bound, context, build);
    return bound;
}

}  // namespace lacuna
