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
    voxels_ = {};
}

std::size_t StructureCache::bytes() const {
    std::size_t sum = cells_.bytes();
    std::set<const StructureFamily*> counted;  // some serve several names
    for (const auto& [kind, family] : families_)
        if (counted.insert(family.get()).second) sum += family->bytes();
    return sum;
}

BoundStructure StructureCache::prepare(const Scene& scene, const Plan& plan, const TransferTables* tables,
                                       RayParams& params, std::map<std::string, BuildRecord>& build,
                                       const JobContext& job) {
    if (plan.structure == Structure::none) return {};
    const auto family = families_.find(plan.structure);
    if (family == families_.end())
        throw Error(Errc::unsupported,
                    "The structure '" + std::string(name_of(plan.structure)) + "' does not serve ray casting.");
    const Stopwatch watch;
    const BoundStructure made = family->second->prepare({*device_, cells_, scene, plan, tables, job}, params);
    build[std::string(name_of(plan.structure))] = {made.built ? watch.ms() : 0.0, made.bytes};
    return made;
}

}  // namespace lacuna
