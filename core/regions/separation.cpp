#include "core/regions/separation.h"

#include "core/base/parallel.h"

namespace lacuna {

std::vector<Separation> separations(const PointTree& surface, const std::vector<std::vector<PointTree::Point>>& bodies,
                                    const JobContext& job) {
    std::vector<PointTree::Point> all;
    for (const auto& own : bodies) all.insert(all.end(), own.begin(), own.end());
    const PointTree others(std::move(all));
    constexpr double k_none = std::numeric_limits<double>::infinity();
    std::vector<Separation> found(bodies.size(), {k_none, k_none});
    parallel_for(
        0, std::int64_t(bodies.size()),
        [&](std::int64_t i) {
            Separation& s = found[std::size_t(i)];
            for (const PointTree::Point& p : bodies[std::size_t(i)]) {
                s.to_surface_mm = surface.nearest_mm(glm::dvec3(p.mm), PointTree::k_any, s.to_surface_mm);
                s.gap_mm = others.nearest_mm(glm::dvec3(p.mm), p.tag, s.gap_mm);
            }
        },
        job);
    return found;
}

}  // namespace lacuna
