#include "core/regions/triangle_mesh.h"

#include <algorithm>

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

}  // namespace lacuna
