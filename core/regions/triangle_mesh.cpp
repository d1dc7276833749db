#include "core/regions/triangle_mesh.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

double enclosed_volume_mm3(const TriangleMesh& mesh) {
    if (mesh.vertices.empty()) return 0;
    const glm::dvec3 base = mesh.vertices.front();  // any point does; a near one keeps the digits
    double six_volumes = 0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[t[0]] - base, b = mesh.vertices[t[1]] - base, c = mesh.vertices[t[2]] - base;
        six_volumes += glm::dot(a, glm::cross(b, c));
    }
    return six_volumes / 6;
}

double area_mm2(const TriangleMesh& mesh) {
    double twice = 0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[t[0]];
        twice += glm::length(glm::cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a));
    }
    return twice / 2;
}

bool is_closed(const TriangleMesh& mesh) {
    std::vector<std::uint64_t> forward, backward;
    forward.reserve(3 * mesh.triangles.size());
    backward.reserve(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[std::size_t(k)], b = t[std::size_t((k + 1) % 3)];
            if (a == b || a >= mesh.vertices.size() || b >= mesh.vertices.size()) return false;
            forward.push_back(std::uint64_t(a) << 32 | b);
            backward.push_back(std::uint64_t(b) << 32 | a);
        }
    std::sort(forward.begin(), forward.end());
    if (std::adjacent_find(forward.begin(), forward.end()) != forward.end()) return false;
    std::sort(backward.begin(), backward.end());
    return forward == backward;
}

namespace {

glm::dvec3 doubled_normal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const glm::dvec3 a = mesh.vertices[t[0]];
    return glm::cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
}

struct HalfEdge {
    std::uint64_t key;  ///< lower vertex, higher vertex
    std::uint32_t triangle;
    bool forward;  ///< runs from the lower vertex to the higher one
};

}  // namespace

double linear_deficit_mm3(const TriangleMesh& mesh, const GridGeometry& geometry) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
            edges.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), std::uint32_t(i), a < b});
        }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
        return x.key != y.key ? x.key < y.key : x.forward > y.forward;
    });
    const glm::dvec3 h2 = geometry.spacing * geometry.spacing;
    double sum = 0;
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        if (edges[i].key != edges[i + 1].key) return 0;
        const glm::dvec3 n1 = doubled_normal(mesh, mesh.triangles[edges[i].triangle]);
        const glm::dvec3 n2 = doubled_normal(mesh, mesh.triangles[edges[i + 1].triangle]);
        const glm::dvec3 e =
            mesh.vertices[std::uint32_t(edges[i].key)] - mesh.vertices[std::uint32_t(edges[i].key >> 32)];
        const double length = glm::length(e), l1 = glm::length(n1), l2 = glm::length(n2);
        if (!(length > 0 && l1 > 0 && l2 > 0)) continue;
        const glm::dvec3 u1 = n1 / l1, u2 = n2 / l2;
        const double angle = std::atan2(glm::dot(glm::cross(u1, u2), e / length), glm::dot(u1, u2));
        const glm::dvec3 middle = u1 + u2;
        if (!(glm::length(middle) > 1e-9)) continue;
        const glm::dvec3 across = glm::transpose(geometry.direction) * glm::cross(e / length, glm::normalize(middle));
        sum += length * angle * glm::dot(h2, across * across);
    }
    // A trilinear surface lies h^2/12 times the curvature inside, flat triangles a little more: measured on smooth
    // balls, 0.59 / R^2 where the former alone gives 0.50.
    return 1.18 * sum / 12;
}

void offset_to_volume(TriangleMesh& mesh, double volume_mm3, double most_mm) {
    std::vector<glm::dvec3> normals(mesh.vertices.size(), glm::dvec3(0));
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t) normals[v] += doubled_normal(mesh, t);
    for (glm::dvec3& n : normals)
        if (const double length = glm::length(n); length > 0) n /= length;
    double moved = 0;
    for (int round = 0; round < 8; ++round) {
        const double missing = volume_mm3 - enclosed_volume_mm3(mesh), area = area_mm2(mesh);
        if (!(std::abs(missing) > 1e-4 * volume_mm3) || !(area > 0)) return;
        const double step = std::clamp(moved + missing / area, -most_mm, most_mm) - moved;
        if (step == 0) return;
        for (std::size_t i = 0; i < normals.size(); ++i) mesh.vertices[i] += step * normals[i];
        moved += step;
    }
}

}  // namespace lacuna
