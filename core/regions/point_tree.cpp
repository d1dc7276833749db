#include "core/regions/point_tree.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

namespace {

constexpr std::uint32_t k_leaf_points = 16;

double squared_distance(const glm::dvec3& p, const glm::vec3& lo, const glm::vec3& hi) {
    const glm::dvec3 out = glm::max(glm::max(glm::dvec3(lo) - p, p - glm::dvec3(hi)), 0.0);
    return glm::dot(out, out);
}

}  // namespace

PointTree::PointTree(std::vector<Point> points) : points_(std::move(points)) {
    if (points_.empty()) return;
    nodes_.reserve(points_.size() / (k_leaf_points / 4) + 2);
    build(0, std::uint32_t(points_.size()));
}

std::uint32_t PointTree::build(std::uint32_t begin, std::uint32_t end) {
    const auto index = std::uint32_t(nodes_.size());
    Node node{points_[begin].mm, points_[begin].mm, begin, end, 0, points_[begin].tag};
    for (std::uint32_t i = begin; i < end; ++i) {
        node.lo = glm::min(node.lo, points_[i].mm);
        node.hi = glm::max(node.hi, points_[i].mm);
        if (points_[i].tag != node.tag) node.tag = k_any;
    }
    nodes_.push_back(node);
    if (end - begin <= k_leaf_points) return index;
    const glm::vec3 side = node.hi - node.lo;
    const int axis = side.x >= side.y && side.x >= side.z ? 0 : (side.y >= side.z ? 1 : 2);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [axis](const Point& a, const Point& b) { return a.mm[axis] < b.mm[axis]; });
    build(begin, middle);
    const std::uint32_t right = build(middle, end);
    nodes_[index].right = right;
    return index;
}

double PointTree::nearest_mm(const glm::dvec3& from, std::uint32_t but, double bound_mm) const {
    if (points_.empty()) return bound_mm;
    double best = bound_mm * bound_mm;
    struct Pending {
        std::uint32_t node;
        double squared;
    };
    Pending stack[64];  // the tree is balanced: its depth is the logarithm of at most 2^32 points
    int depth = 0;
    stack[depth++] = {0, squared_distance(from, nodes_[0].lo, nodes_[0].hi)};
    while (depth > 0) {
        const Pending next = stack[--depth];
        const Node& node = nodes_[next.node];
        if (!(next.squared < best) || (but != k_any && node.tag == but)) continue;
        if (node.right == 0) {
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                if (but != k_any && points_[i].tag == but) continue;
                const glm::dvec3 d = glm::dvec3(points_[i].mm) - from;
                best = std::min(best, glm::dot(d, d));
            }
            continue;
        }
        const std::uint32_t left = next.node + 1;
        Pending near{left, squared_distance(from, nodes_[left].lo, nodes_[left].hi)};
        Pending far{node.right, squared_distance(from, nodes_[node.right].lo, nodes_[node.right].hi)};
        if (far.squared < near.squared) std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
    return std::sqrt(best);
}

}  // namespace lacuna
