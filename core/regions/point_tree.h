#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

namespace lacuna {

/// Points with a tag each, kept for nearest-neighbour queries: a balanced tree of bounding boxes (split at the median
/// of the longest side). Build O(n log n), 16 bytes a point and 5 a point for the tree; a query is O(log n) on
/// surfaces.
class PointTree {
public:
    struct Point {
        glm::vec3 mm;
        std::uint32_t tag;
    };
    static constexpr std::uint32_t k_any = 0xFFFFFFFFu;

    PointTree() = default;
    explicit PointTree(std::vector<Point> points);

    bool empty() const { return points_.empty(); }

    /// The shortest way from any of `from` (put into another order) to a point whose tag is not `but` (k_any: all
    /// points count), or `bound_mm` if none is nearer than that. Whole subtrees of one tag are passed over, and of
    /// `from` all that lies farther away than what is found already: some 30 steps for every 32 points at most, on
    /// surfaces.
    double nearest_mm(std::span<Point> from, std::uint32_t but = k_any,
                      double bound_mm = std::numeric_limits<double>::infinity()) const;

private:
    struct Box {
        glm::vec3 lo, hi;
    };
    struct Node {
        Box box;
        std::uint32_t begin, end;
        std::uint32_t right;  ///< the left child follows its parent; 0: a leaf
        std::uint32_t tag;    ///< of all its points, or k_any where they differ
    };
    static Box box_of(std::span<const Point> points);
    static double squared_distance(const Box& a, const Box& b);
    static void halve(std::span<Point> points, const Box& box);
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);
    double nearest_squared(std::span<Point> from, std::uint32_t but, double best) const;
    template <class Leaf>
    void visit_leaves(const Box& from, std::uint32_t but, const double& best, Leaf leaf) const;

    std::vector<Point> points_;
    std::vector<Node> nodes_;
};

}  // namespace lacuna
