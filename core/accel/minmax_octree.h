#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/accel/macrocells.h"
#include "core/base/job.h"
#include "core/classify/classification.h"

namespace lacuna {

/// Where the nodes of a full octree over a grid of leaves lie: level 0 are the leaves, the last level is the root.
/// The volume is padded to powers of two in thought only: nodes that would hold nothing but padding are not stored.
struct OctreeLayout {
    std::vector<glm::ivec3> nodes;   ///< nodes an axis, a level
    std::vector<std::size_t> first;  ///< index of the level's first node; x fastest within a level

    OctreeLayout() = default;
    explicit OctreeLayout(glm::ivec3 leaves);
    int root() const { return int(nodes.size()) - 1; }
    std::size_t count() const { return first.back() + 1; }
    std::size_t index(int level, glm::ivec3 node) const {
        const glm::ivec3 n = nodes[std::size_t(level)];
        return first[std::size_t(level)] +
               (std::size_t(node.z) * std::size_t(n.y) + std::size_t(node.y)) * std::size_t(n.x) + std::size_t(node.x);
    }
};

/// The full min-max-average octree of Lesar 2015, section 4: built down to leaves of 8^3 voxels (below, rays march),
/// so that the nodes number about 1/448 of the voxels. A node's range is taken over its closed cell, the neighbours'
/// first layer included (MacrocellGrid): trilinear samples anywhere in the node lie in it. Depends on the voxels only.
struct MinMaxOctree {
    OctreeLayout layout;
    std::vector<glm::vec2> ranges;  ///< (inf, -inf) where there is no finite value
    std::vector<float> averages;    ///< of the node's own finite voxels, within its range; NaN where there is none

    std::size_t bytes() const { return ranges.size() * sizeof(glm::vec2) + averages.size() * sizeof(float); }
};

/// Builds the tree on all threads. @param leaves the volume's cells of 8^3 voxels (build_macrocells with shift 3)
/// @throws Error(cancelled). Cost: one pass over the voxels (256^3 u16: about 10 ms on 2 cores)
MinMaxOctree build_minmax_octree(const Volume& volume, const MacrocellGrid& leaves, const JobContext& job = {});

/// What a node's byte says besides its class (VisibilityTable::Answer in the two low bits).
inline constexpr std::uint8_t k_node_class = 3;
inline constexpr std::uint8_t k_node_flat = 4;    ///< visible and homogeneous: its average stands for every sample
inline constexpr std::uint8_t k_node_steady = 8;  ///< nothing below it can be skipped or taken as a run

/// When leaves count as homogeneous.
struct FlatRule {
    double threshold = 0;                            ///< largest difference of values; 0: constant
    const std::vector<glm::vec2>* ranges = nullptr;  ///< a leaf each: over every voxel its samples can touch
};

struct OctreeClasses {
    std::vector<std::uint8_t> nodes;  ///< one byte a node, in the layout's order
    int top = -1;                     ///< highest level with a node that can be skipped, is steady or flat; -1: none
    bool any_flat = false;
};

/// Classes of all nodes. Leaves ask the table for their range widened by `slack`; a parent is none (all) when its
/// children are, which is never less than asking for the parent's own range.
/// @param steady mark nodes in which every value is visible, for modes that cannot skip those
/// @param flat null: no homogeneous nodes. Cost: well under 1 ms for 256^3
OctreeClasses classify_octree(const OctreeLayout& layout, const MacrocellGrid& leaves, const VisibilityTable& table,
                              double slack, bool steady, const std::optional<FlatRule>& flat);

/// Ranges for FlatRule where gradients are taken too: of the leaves no wider than `threshold` and without NaN, over one
/// voxel more on each side, which central differences read; (-inf, inf) for all other leaves.
std::vector<glm::vec2> gradient_ranges(const Volume& volume, const MacrocellGrid& leaves, double threshold,
                                       const JobContext& job = {});

}  // namespace lacuna
