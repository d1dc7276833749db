#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <nanoflann.hpp>

#include "core/accel/leap_distance.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {

glm::ivec3 position_of(const LabelGrid& grid, std::int64_t voxel) {
    const std::int64_t row = voxel / grid.size.x;
    return {int(voxel % grid.size.x), int(row % grid.size.y), int(row / grid.size.y)};
}

/// The labels other than its own among a voxel's six neighbours, each once.
int labels_beside(const LabelGrid& grid, glm::ivec3 p, std::int64_t voxel, std::array<std::uint32_t, 6>& found) {
    const std::int64_t stride[3] = {1, grid.size.x, std::int64_t(grid.size.x) * grid.size.y};
    const std::uint32_t own = grid.labels[voxel];
    int count = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (int side = -1; side <= 1; side += 2) {
            if (p[axis] + side < 0 || p[axis] + side >= grid.size[axis]) continue;
            const std::uint32_t label = grid.labels[voxel + side * stride[axis]];
            if (label == 0 || label == own) continue;
            if (std::find(found.begin(), found.begin() + count, label) == found.begin() + count)
                found[std::size_t(count++)] = label;
        }
    return count;
}

template <class Visit>
void each_boundary_voxel(const LabelGrid& grid, std::int64_t z, Visit&& visit) {
    std::int64_t voxel = z * grid.size.x * grid.size.y;
    std::array<std::uint32_t, 6> found{};
    for (int y = 0; y < grid.size.y; ++y)
        for (int x = 0; x < grid.size.x; ++x, ++voxel) {
            const int count = labels_beside(grid, {x, y, int(z)}, voxel, found);
            for (int i = 0; i < count; ++i) visit(found[std::size_t(i)], voxel);
        }
}

/// All offsets nearer than a distance, the centre left out.
struct Offset {
    glm::ivec3 step;
    std::int64_t stride;
};
std::vector<Offset> neighbour_list(const LabelGrid& grid, double distance_mm) {
    const glm::ivec3 reach = glm::min(glm::ivec3(glm::ceil(distance_mm / grid.spacing_mm)), grid.size);
    std::vector<Offset> list;
    for (int z = -reach.z; z <= reach.z; ++z)
        for (int y = -reach.y; y <= reach.y; ++y)
            for (int x = -reach.x; x <= reach.x; ++x) {
                const glm::ivec3 step(x, y, z);
                if (step == glm::ivec3(0) || !(glm::length(glm::dvec3(step) * grid.spacing_mm) < distance_mm)) continue;
                list.push_back({step, (std::int64_t(z) * grid.size.y + y) * grid.size.x + x});
            }
    return list;
}

bool inside(glm::ivec3 p, glm::ivec3 size) {
    return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size.x && p.y < size.y && p.z < size.z;
}

/// The boundary layer of one region as nanoflann reads it, mm.
struct Layer {
    const LabelGrid& grid;
    const std::int64_t* voxel;
    std::size_t count;

    std::size_t kdtree_get_point_count() const { return count; }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
        const auto a = glm::length_t(axis);
        return position_of(grid, voxel[i])[a] * grid.spacing_mm[a];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Layer>, Layer, 3>;

/// A tree for each region that has leap voxels.
class Forest {
public:
    Forest(const LabelGrid& grid, const BoundaryList& boundary, const std::uint16_t* leaps, const JobContext& job)
        : grid_(grid) {
        const std::size_t labels = boundary.first.size() - 1;
        std::vector<std::uint8_t> wanted(labels, 0);
        const std::int64_t slice = std::int64_t(grid.size.x) * grid.size.y;
        for (int z = 0; z < grid.size.z; ++z) {
            job.check();
            for (std::int64_t i = z * slice; i < (z + 1) * slice; ++i)
                if (leaps[i] != 0) wanted[grid.labels[i]] = 1;
        }
        layers_.resize(labels);
        trees_.resize(labels);
        parallel_for(
            0, std::int64_t(labels),
            [&](std::int64_t label) {
                const auto at = std::size_t(label);
                const auto count = std::size_t(boundary.first[at + 1] - boundary.first[at]);
                if (!wanted[at] || count == 0) return;
                layers_[at] = std::make_unique<Layer>(Layer{grid, boundary.voxel.data() + boundary.first[at], count});
                trees_[at] = std::make_unique<Tree>(3, *layers_[at], nanoflann::KDTreeSingleIndexAdaptorParams(16));
            },
            job);
    }

    /// False for a region without a boundary: it fills the volume.
    bool bounded(std::int64_t voxel) const { return trees_[grid_.labels[voxel]] != nullptr; }
    /// mm; infinite for a region without a boundary.
    double nearest(std::int64_t voxel) const {
        const Tree* tree = trees_[grid_.labels[voxel]].get();
        if (!tree) return std::numeric_limits<double>::infinity();
        const glm::dvec3 at = glm::dvec3(position_of(grid_, voxel)) * grid_.spacing_mm;
        unsigned index = 0;
        double square = 0;
        tree->knnSearch(&at.x, 1, &index, &square);
        return std::sqrt(square);
    }

private:
    const LabelGrid& grid_;
    std::vector<std::unique_ptr<Layer>> layers_;
    std::vector<std::unique_ptr<Tree>> trees_;
};

/// splitmix64 (Steele, Lea and Flood 2014) of a voxel's number, as a share of 1: the same on any number of threads.
double dice(std::uint64_t seed, std::int64_t voxel) {
    std::uint64_t x = seed * 0x9E3779B97F4A7C15ull + std::uint64_t(voxel) + 0x9E3779B97F4A7C15ull;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
    return double((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

void raise_to(std::uint16_t& entry, std::uint16_t value) {
    std::atomic_ref<std::uint16_t> shared(entry);
    std::uint16_t held = shared.load(std::memory_order_relaxed);
    while (held != 0 && held < value && !shared.compare_exchange_weak(held, value, std::memory_order_relaxed)) {
    }
}

/// Offers d - n to every leap voxel at distance n from the centre, as far as the group reaches.
void hand_out(const LabelGrid& grid, glm::ivec3 centre, double d_mm, double reach_mm, double unit_mm,
              std::uint16_t* leaps) {
    const glm::dvec3 s = grid.spacing_mm;
    const glm::ivec3 reach(glm::min(reach_mm / s, glm::dvec3(grid.size)));
    const glm::ivec3 lo = glm::max(centre - reach, glm::ivec3(0)), hi = glm::min(centre + reach, grid.size - 1);
    for (int z = lo.z; z <= hi.z; ++z)
        for (int y = lo.y; y <= hi.y; ++y) {
            const double dy = (y - centre.y) * s.y, dz = (z - centre.z) * s.z, aside = dy * dy + dz * dz;
            if (!(aside <= reach_mm * reach_mm)) continue;
            const int width = int(std::min(std::sqrt(reach_mm * reach_mm - aside) / s.x, double(grid.size.x)));
            std::uint16_t* row = leaps + (std::int64_t(z) * grid.size.y + y) * grid.size.x;
            for (int x = std::max(lo.x, centre.x - width); x <= std::min(hi.x, centre.x + width); ++x) {
                const double dx = (x - centre.x) * s.x, n = std::sqrt(dx * dx + aside);
                if (n <= reach_mm) raise_to(row[x], std::uint16_t(leap_units(d_mm - n, unit_mm)));
            }
        }
}

}  // namespace

BoundaryList boundary_list(const LabelGrid& grid, std::uint32_t labels, const JobContext& job) {
    const std::size_t slices = std::size_t(grid.size.z);
    std::vector<std::vector<std::pair<std::uint32_t, std::int64_t>>> found(slices);
    parallel_for(
        0, grid.size.z,
        [&](std::int64_t z) {
            each_boundary_voxel(grid, z, [&](std::uint32_t label, std::int64_t voxel) {
                found[std::size_t(z)].push_back({label, voxel});
            });
        },
        job);
    BoundaryList list;
    list.first.assign(std::size_t(labels) + 2, 0);
    for (const auto& slice : found)
        for (const auto& [label, voxel] : slice) ++list.first[std::size_t(label) + 1];
    for (std::size_t i = 1; i < list.first.size(); ++i) list.first[i] += list.first[i - 1];
    list.voxel.resize(std::size_t(list.first.back()));
    std::vector<std::int64_t> next(list.first.begin(), list.first.end() - 1);
    for (auto& slice : found) {
        for (const auto& [label, voxel] : slice) list.voxel[std::size_t(next[label]++)] = voxel;
        slice = {};
    }
    return list;
}

void classify_by_neighbours(const LabelGrid& grid, const BoundaryList& boundary, double unit_mm, int radius,
                            std::uint16_t* leaps, const JobContext& job) {
    parallel_bands(0, grid.voxel_count(), 64, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t i = first; i < last; ++i) leaps[i] = grid.labels[i] != 0;
    });
    const std::vector<Offset> list = neighbour_list(grid, (radius + 1) * unit_mm * (1 - 1e-12));
    const std::int64_t labels = std::int64_t(boundary.first.size()) - 1;
    parallel_bands(
        0, std::int64_t(boundary.voxel.size()), 256,
        [&](std::int64_t first, std::int64_t last) {
            auto label =
                std::upper_bound(boundary.first.begin(), boundary.first.end(), first) - boundary.first.begin() - 1;
            for (std::int64_t i = first; i < last; ++i) {
                if (i % 4096 == 0) job.check();
                while (label + 1 < labels && boundary.first[std::size_t(label) + 1] <= i) ++label;
                const std::int64_t voxel = boundary.voxel[std::size_t(i)];
                const glm::ivec3 at = position_of(grid, voxel);
                for (const Offset& o : list)
                    if (inside(at + o.step, grid.size) && grid.labels[voxel + o.stride] == std::uint32_t(label))
                        std::atomic_ref<std::uint16_t>(leaps[voxel + o.stride]).store(0, std::memory_order_relaxed);
            }
        },
        job);
}

void tree_distances(const LabelGrid& grid, const BoundaryList& boundary, double unit_mm, std::uint16_t* leaps,
                    const JobContext& job) {
    const Forest forest(grid, boundary, leaps, job.part(0, 0.1));
    const std::int64_t slice = std::int64_t(grid.size.x) * grid.size.y;
    parallel_for(
        0, grid.size.z,
        [&](std::int64_t z) {
            for (std::int64_t i = z * slice; i < (z + 1) * slice; ++i) {
                if (i % 1024 == 0) job.check();
                if (leaps[i] != 0) leaps[i] = std::uint16_t(leap_units(forest.nearest(i), unit_mm));
            }
        },
        job.part(0.1, 1));
}

void group_distances(const LabelGrid& grid, const BoundaryList& boundary, double unit_mm, int radius,
                     const CentreGroups& groups, std::uint16_t* leaps, const JobContext& job) {
    const Forest forest(grid, boundary, leaps, job.part(0, 0.1));
    const std::int64_t slice = std::int64_t(grid.size.x) * grid.size.y;
    parallel_bands(0, grid.voxel_count(), 64, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t i = first; i < last; ++i)
            if (leaps[i] != 0)
                leaps[i] = std::uint16_t(forest.bounded(i) ? std::min(radius + 1, k_leap_limit) : k_leap_limit);
    });
    const double guard_mm = (radius + 1) * unit_mm;
    parallel_for(
        0, grid.size.z,
        [&](std::int64_t z) {
            for (std::int64_t i = z * slice; i < (z + 1) * slice; ++i) {
                if (i % 1024 == 0) job.check();
                if (!(dice(groups.seed, i) < groups.probability)) continue;
                if (std::atomic_ref<std::uint16_t>(leaps[i]).load(std::memory_order_relaxed) == 0) continue;
                if (!forest.bounded(i)) continue;
                const double d = forest.nearest(i);
                hand_out(grid, position_of(grid, i), d,
                         std::max(0.0, std::min(groups.relative_radius * d, d - guard_mm)), unit_mm, leaps);
            }
        },
        job.part(0.1, 1));
}

}  // namespace lacuna
