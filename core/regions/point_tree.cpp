#include "core/regions/point_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace lacuna {

namespace {

constexpr std::uint32_t k_leaf_points = 16;
constexpr std::size_t k_block_points = 32;  ///< asked for at once

}  // namespace

PointTree::PointTree(std::vector<Point> points) : points_(std::move(points)) {
    if (points_.empty()) return;
    nodes_.reserve(points_.size() / (k_leaf_points / 4) + 2);
    build(0, std::uint32_t(points_.size()));
}

PointTree::Box PointTree::box_of(std::span<const Point> points) {
    Box box{points.front().mm, points.front().mm};
    for (const Point& p : points) {
        box.lo = glm::min(box.lo, p.mm);
        box.hi = glm::max(box.hi, p.mm);
    }
    return box;
}

double PointTree::squared_distance(const Box& a, const Box& b) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double below = double(glm::value_ptr(a.lo)[axis]) - double(glm::value_ptr(b.hi)[axis]);
        const double above = double(glm::value_ptr(b.lo)[axis]) - double(glm::value_ptr(a.hi)[axis]);
        const double out = std::max(0.0, std::max(below, above));
        sum += out * out;
    }
    return sum;
}

/// Puts the lower half along the longest side first.
void PointTree::halve(std::span<Point> points, const Box& box) {
    const glm::vec3 side = box.hi - box.lo;
    const int axis = side.x >= side.y && side.x >= side.z ? 0 : (side.y >= side.z ? 1 : 2);
    std::nth_element(
        points.begin(), points.begin() + std::ptrdiff_t(points.size() / 2), points.end(),
        [axis](const Point& a, const Point& b) { return glm::value_ptr(a.mm)[axis] < glm::value_ptr(b.mm)[axis]; });
}

std::uint32_t PointTree::build(std::uint32_t begin, std::uint32_t end) {
    const auto index = std::uint32_t(nodes_.size());
    const std::span<Point> mine(points_.data() + begin, end - begin);
    Node node{box_of(mine), begin, end, 0, mine.front().tag};
    for (const Point& p : mine)
        if (p.tag != node.tag) node.tag = k_any;
    nodes_.push_back(node);
    if (end - begin <= k_leaf_points) return index;
    halve(mine, node.box);
    const std::uint32_t middle = begin + (end - begin) / 2;
    build(begin, middle);
    const std::uint32_t right = build(middle, end);
    nodes_[index].right = right;
    return index;
}

/// Hands the leaves that may hold a point nearer to the box than `best` to leaf(node), the nearer ones first, until it
/// says false. @param best  squared; leaf() may lower it
template <class Leaf>
void PointTree::visit_leaves(const Box& from, std::uint32_t but, const double& best, Leaf leaf) const {
    struct Pending {
        std::uint32_t node;
        double squared;
    };
    Pending stack[64];  // the tree is balanced: its depth is the logarithm of at most 2^32 points
    int depth = 0;
    stack[depth++] = {0, squared_distance(from, nodes_[0].box)};
    while (depth > 0) {
        const Pending next = stack[--depth];
        const Node& node = nodes_[next.node];
        if (!(next.squared < best) || (but != k_any && node.tag == but)) continue;
        if (node.right == 0) {
            if (!leaf(node)) return;
            continue;
        }
        const std::uint32_t left = next.node + 1;
        Pending near{left, squared_distance(from, nodes_[left].box)};
        Pending far{node.right, squared_distance(from, nodes_[node.right].box)};
        if (far.squared < near.squared) std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
}

double PointTree::nearest_squared(std::span<Point> from, std::uint32_t but, double best) const {
    const Box box = box_of(from);
    if (from.size() > k_block_points) {
        bool any = false;
        visit_leaves(box, but, best, [&any](const Node&) {
            any = true;
            return false;
        });
        if (!any) return best;
        halve(from, box);
        best = nearest_squared(from.first(from.size() / 2), but, best);
        return nearest_squared(from.subspan(from.size() / 2), but, best);
    }
    visit_leaves(box, but, best, [&](const Node& node) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const Point& there = points_[i];
            if ((but != k_any && there.tag == but) || !(squared_distance(box, {there.mm, there.mm}) < best)) continue;
            for (const Point& here : from) {
                const glm::dvec3 d = glm::dvec3(there.mm) - glm::dvec3(here.mm);
                best = std::min(best, glm::dot(d, d));
            }
        }
        return true;
    });
    return best;
}

double PointTree::nearest_mm(std::span<Point> from, std::uint32_t but, double bound_mm) const {
    if (points_.empty() || from.empty()) return bound_mm;
    const double best = nearest_squared(from, but, bound_mm * bound_mm);
    return best < bound_mm * bound_mm ? std::sqrt(best) : bound_mm;
}

}  // namespace lacuna
