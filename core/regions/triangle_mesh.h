#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lacuna {

/// An indexed triangle mesh in mm (LPS); triangles counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Signed enclosed volume (positive when oriented outwards), mm^3, by the divergence theorem.
double enclosed_volume_mm3(const TriangleMesh& mesh);
/// Total triangle area, mm^2.
double area_mm2(const TriangleMesh& mesh);
/// True if every edge is shared by exactly two triangles running against each other.
bool is_closed(const TriangleMesh& mesh);

}  // namespace lacuna
