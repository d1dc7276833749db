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
            std::vector<PointTree::Point> own = bodies[std::size_t(i)];
            if (own.empty()) return;
            found[std::size_t(i)] = {surface.nearest_mm(own), others.nearest_mm(own, own.front().tag)};
        },
        job);
    return found;
}

}  // namespace lacuna
