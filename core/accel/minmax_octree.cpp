#include "core/accel/minmax_octree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

using Answer = VisibilityTable::Answer;
constexpr float k_infinity = std::numeric_limits<float>::infinity();
constexpr int k_leaf_shift = 3;
constexpr int k_leaf_edge = 1 << k_leaf_shift;

/// Sum and number of finite values; a node's average is their quotient.
struct Mass {
    double sum = 0;
    double count = 0;
};

template <class T>
Mass mass_of(const VolumeView<T>& view, glm::ivec3 leaf) {
    const glm::ivec3 from = leaf * k_leaf_edge, to = glm::min(from + k_leaf_edge, view.size);
    Mass mass;
    for (int z = from.z; z < to.z; ++z)
        for (int y = from.y; y < to.y; ++y) {
            const T* row = view.row(y, z);
            if constexpr (std::is_floating_point_v<T>) {
                for (int x = from.x; x < to.x; ++x)
                    if (std::abs(row[x]) < k_infinity) mass.sum += double(row[x]), mass.count += 1;
            } else {
                int sum = 0;
                for (int x = from.x; x < to.x; ++x) sum += row[x];
                mass.sum += sum;
                mass.count += to.x - from.x;
            }
        }
    return mass;
}

/// A leaf at the edge of NaN voxels may hold none of its own finite ones and still have a range.
float average(const Mass& mass, glm::vec2 range) {
    if (range.x > range.y) return std::numeric_limits<float>::quiet_NaN();
    if (!(mass.count > 0)) return 0.5f * range.x + 0.5f * range.y;
    return std::clamp(float(mass.sum / mass.count), range.x, range.y);
}

/// Calls each(index) for the children, one level below, of a node.
template <class Each>
void for_children(const OctreeLayout& layout, int level, glm::ivec3 node, Each&& each) {
    const glm::ivec3 from = node * 2, to = glm::min(from + 2, layout.nodes[std::size_t(level - 1)]);
    for (int z = from.z; z < to.z; ++z)
        for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x) each(layout.index(level - 1, {x, y, z}));
}

/// Calls each(index, node) for the nodes of a level's slice.
template <class Each>
void for_slice(const OctreeLayout& layout, int level, int z, Each&& each) {
    const glm::ivec3 n = layout.nodes[std::size_t(level)];
    for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) each(layout.index(level, {x, y, z}), glm::ivec3(x, y, z));
}

void build_leaves(const Volume& volume, const MacrocellGrid& leaves, MinMaxOctree& tree, std::vector<Mass>& mass,
                  const JobContext& job) {
    std::copy(leaves.ranges.begin(), leaves.ranges.end(), tree.ranges.begin());
    visit_type(volume.type(), [&](auto tag) {
        const auto view = volume.view<decltype(tag)>();
        parallel_for(
            0, leaves.cells.z,
            [&](std::int64_t z) {
                for_slice(tree.layout, 0, int(z), [&](std::size_t i, glm::ivec3 leaf) {
                    mass[i] = mass_of(view, leaf);
                    tree.averages[i] = average(mass[i], tree.ranges[i]);
                });
            },
            job);
    });
}

void build_parents(MinMaxOctree& tree, std::vector<Mass>& mass, int level, const JobContext& job) {
    const auto slice = [&](std::int64_t z) {
        for_slice(tree.layout, level, int(z), [&](std::size_t i, glm::ivec3 node) {
            glm::vec2 range(k_infinity, -k_infinity);
            Mass all;
            for_children(tree.layout, level, node, [&](std::size_t child) {
                range = {std::min(range.x, tree.ranges[child].x), std::max(range.y, tree.ranges[child].y)};
                all = {all.sum + mass[child].sum, all.count + mass[child].count};
            });
            tree.ranges[i] = range;
            mass[i] = all;
            tree.averages[i] = average(all, range);
        });
    };
    parallel_for(0, tree.layout.nodes[std::size_t(level)].z, slice, job);
}

bool flat_enough(glm::vec2 range, double threshold) { return double(range.y) - double(range.x) <= threshold; }

/// What a node's children have in common, and how far their values spread.
struct Family {
    std::uint8_t common = k_node_class | k_node_flat | k_node_steady, any = 0;
    glm::vec2 range{k_infinity, -k_infinity};

    std::uint8_t parent(const std::optional<FlatRule>& flat) const {
        const bool one_class = (common & k_node_class) == (any & k_node_class);
        const std::uint8_t answer = one_class ? std::uint8_t(any & k_node_class) : std::uint8_t(Answer::some);
        std::uint8_t out = std::uint8_t(answer | (common & k_node_steady));
        if (flat && (common & k_node_flat) && flat_enough(range, flat->threshold)) out |= k_node_flat;
        return out;
    }
};

/// Smallest and largest voxel of a box of the grid, ends included; (-inf, inf) if one is not finite.
template <class T>
glm::vec2 range_in(const VolumeView<T>& view, glm::ivec3 from, glm::ivec3 to) {
    float lo = k_infinity, hi = -k_infinity;
    for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y) {
            const T* row = view.row(y, z);
            for (int x = from.x; x <= to.x; ++x) {
                const float v = float(row[x]);
                if (!(std::abs(v) < k_infinity)) return {-k_infinity, k_infinity};
                lo = std::min(lo, v);
                hi = std::max(hi, v);
            }
        }
    return {lo, hi};
}

}  // namespace

OctreeLayout::OctreeLayout(glm::ivec3 leaves) {
    std::size_t next = 0;
    for (glm::ivec3 n = leaves;; n = (n + 1) / 2) {
        nodes.push_back(n);
        first.push_back(next);
        next += std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z);
        if (n == glm::ivec3(1)) break;
    }
}

MinMaxOctree build_minmax_octree(const Volume& volume, const MacrocellGrid& leaves, const JobContext& job) {
    MinMaxOctree tree;
    tree.layout = OctreeLayout(leaves.cells);
    tree.ranges.resize(tree.layout.count());
    tree.averages.resize(tree.layout.count());
    std::vector<Mass> mass(tree.layout.count());
    build_leaves(volume, leaves, tree, mass, job.part(0, 0.9));
    for (int level = 1; level <= tree.layout.root(); ++level) build_parents(tree, mass, level, {job.stop, nullptr});
    return tree;
}

OctreeClasses classify_octree(const OctreeLayout& layout, const MacrocellGrid& leaves, const VisibilityTable& table,
                              double slack, bool steady, const std::optional<FlatRule>& flat) {
    OctreeClasses out;
    out.nodes = classify_macrocells(leaves, table, slack);
    const std::size_t count = out.nodes.size();
    for (std::size_t i = 0; i < count; ++i) {
        std::uint8_t& node = out.nodes[i];
        const bool has_nan = !leaves.has_nan.empty() && leaves.has_nan[i];
        if (flat && node != std::uint8_t(Answer::none) && !has_nan && flat_enough((*flat->ranges)[i], flat->threshold))
            node |= k_node_flat;
        else if (steady && node == std::uint8_t(Answer::all))
            node |= k_node_steady;
    }
    out.nodes.resize(layout.count());
    std::vector<glm::vec2> ranges;
    if (flat) {
        ranges = *flat->ranges;
        ranges.resize(layout.count());
    }
    for (int level = 1; level <= layout.root(); ++level)
        for (int z = 0; z < layout.nodes[std::size_t(level)].z; ++z)
            for_slice(layout, level, z, [&](std::size_t i, glm::ivec3 node) {
                Family family;
                for_children(layout, level, node, [&](std::size_t child) {
                    family.common &= out.nodes[child];
                    family.any |= out.nodes[child];
                    if (!flat) return;
                    family.range = {std::min(family.range.x, ranges[child].x),
                                    std::max(family.range.y, ranges[child].y)};
                });
                out.nodes[i] = family.parent(flat);
                if (flat) ranges[i] = family.range;
            });
    for (int level = 0; level <= layout.root(); ++level) {
        const std::size_t end = level == layout.root() ? layout.count() : layout.first[std::size_t(level) + 1];
        for (std::size_t i = layout.first[std::size_t(level)]; i < end; ++i) {
            if (out.nodes[i] != std::uint8_t(Answer::some)) out.top = level;
            out.any_flat = out.any_flat || (out.nodes[i] & k_node_flat);
        }
    }
    return out;
}

std::vector<glm::vec2> gradient_ranges(const Volume& volume, const MacrocellGrid& leaves, double threshold,
                                       const JobContext& job) {
    std::vector<glm::vec2> ranges(leaves.ranges.size(), glm::vec2(-k_infinity, k_infinity));
    const OctreeLayout layout(leaves.cells);
    visit_type(volume.type(), [&](auto tag) {
        const auto view = volume.view<decltype(tag)>();
        parallel_for(
            0, leaves.cells.z,
            [&](std::int64_t z) {
                for_slice(layout, 0, int(z), [&](std::size_t i, glm::ivec3 leaf) {
                    if (leaves.ranges[i].x > leaves.ranges[i].y || !flat_enough(leaves.ranges[i], threshold)) return;
                    ranges[i] = range_in(view, glm::max(leaf * k_leaf_edge - 1, glm::ivec3(0)),
                                         glm::min((leaf + 1) * k_leaf_edge + 1, view.size - 1));
                });
            },
            job);
    });
    return ranges;
}

}  // namespace lacuna
