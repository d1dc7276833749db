#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/inspect/defect_measures.h"

namespace lacuna::inspect {

namespace {

/// Points of the part's outer surface: between each voxel of the part and its neighbour outside, where the values pass
/// the threshold; on the frame, the faces of the voxels there. Only in slices [begin, end).
template <class T>
void surface_points(const Volume& volume, const MaskVolume& part, double threshold, int begin, int end,
                    std::vector<PointTree::Point>& points) {
    const GridGeometry& g = volume.geometry();
    const VolumeView<T> view = volume.view<T>();
    const std::uint8_t* mask = part.labels->data();
    const std::int64_t step[3] = {1, g.size.x, std::int64_t(g.size.x) * g.size.y};
    const auto add = [&](const glm::ivec3& p, int axis, double offset) {
        glm::dvec3 at(p);
        at[axis] += offset;
        points.push_back({glm::vec3(g.voxel_to_mm(at)), 0});
    };
    for (int z = begin; z < end; ++z)
        for (int y = 0; y < g.size.y; ++y)
            for (int x = 0; x < g.size.x; ++x) {
                const std::int64_t i = g.linear_index(x, y, z);
                if (!mask[i]) continue;
                const glm::ivec3 p(x, y, z);
                for (int axis = 0; axis < 3; ++axis)
                    for (const int side : {-1, 1}) {
                        if (g.size[axis] == 1) continue;
                        const int next = p[axis] + side;
                        if (next < 0 || next >= g.size[axis]) {
                            add(p, axis, 0.5 * side);
                            continue;
                        }
                        const std::int64_t k = i + side * step[axis];
                        if (mask[k]) continue;
                        const double a = double(view.data[i]), b = double(view.data[k]);
                        const double share = a >= threshold && b < threshold ? (a - threshold) / (a - b) : 0.5;
                        add(p, axis, side * (std::isfinite(share) ? share : 0.5));
                    }
            }
}

std::vector<PointTree::Point> outer_surface(const Volume& volume, const MaskVolume& part, double threshold,
                                            const JobContext& job) {
    const int depth = volume.geometry().size.z, bands = std::min(depth, 64);
    std::vector<std::vector<PointTree::Point>> pieces(static_cast<std::size_t>(bands));
    parallel_for(
        0, bands,
        [&](std::int64_t b) {
            const int begin = int(depth * b / bands), end = int(depth * (b + 1) / bands);
            visit_type(volume.type(), [&](auto tag) {
                surface_points<decltype(tag)>(volume, part, threshold, begin, end, pieces[std::size_t(b)]);
            });
        },
        job);
    std::size_t count = 0;
    for (const auto& piece : pieces) count += piece.size();
    // An open foam has surface everywhere; a share of it keeps the tree within a byte or two a voxel.
    const auto most = std::size_t(std::max<std::int64_t>(volume.geometry().voxel_count() / 16, 100'000));
    const std::size_t stride = (count + most - 1) / most;
    std::vector<PointTree::Point> all;
    all.reserve(count / std::max<std::size_t>(1, stride) + 1);
    std::size_t i = 0;
    for (auto& piece : pieces) {
        for (const PointTree::Point& point : piece)
            if (stride <= 1 || i++ % stride == 0) all.push_back(point);
        std::vector<PointTree::Point>().swap(piece);
    }
    return all;
}

}  // namespace

void set_distances(const Volume& volume, const MaskVolume& part, double threshold, const Surroundings& s,
                   std::vector<Defect>& defects, const std::vector<std::vector<PointTree::Point>>& points,
                   const JobContext& job) {
    if (defects.empty()) return;
    const PointTree surface(outer_surface(volume, part, threshold, job.part(0, 0.2)));
    std::vector<PointTree::Point> all;
    for (const auto& own : points) all.insert(all.end(), own.begin(), own.end());
    const PointTree others(std::move(all));
    const glm::dvec3 h = volume.geometry().spacing;
    const double coarsest = std::max({h.x, h.y, h.z});
    // Both surfaces move by the threshold's shift (a quarter of sigma for 10 %) and by the grid's rounding.
    const double margin = s.binary ? 0.5 * coarsest : 2 * 0.2533 * s.sigma_mm + 0.1 * coarsest;
    parallel_for(
        0, std::int64_t(defects.size()),
        [&](std::int64_t i) {
            Defect& d = defects[std::size_t(i)];
            double to_surface = std::numeric_limits<double>::infinity(), gap = to_surface;
            for (const PointTree::Point& p : points[std::size_t(i)]) {
                to_surface = surface.nearest_mm(glm::dvec3(p.mm), PointTree::k_any, to_surface);
                gap = others.nearest_mm(glm::dvec3(p.mm), d.id, gap);
            }
            if (d.touches_border) to_surface = 0;
            d.surface_distance_mm = {to_surface, std::max(0.0, to_surface - margin), to_surface + margin};
            d.gap_mm = gap;
        },
        job.part(0.2, 1));
}

}  // namespace lacuna::inspect
