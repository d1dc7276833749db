#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/volume/grid_geometry.h"

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

/// What a marching-cubes surface of a smooth field encloses too little, mm^3: between voxels the values are taken as
/// linear and the surface as flat triangles, which puts it inside where it is convex, by a share of h^2 times the
/// curvature along each grid axis. Integrated over the mesh by its edges' dihedral angles (a ball of R voxels lacks
/// 0.6/R^2 of its volume). 0 for a mesh that is not closed. Cost: a sort of the edges.
double linear_deficit_mm3(const TriangleMesh& mesh, const GridGeometry& geometry);

/// Moves the vertices of a closed mesh along their normals, all by the same length and at most `most_mm`, until it
/// encloses the volume asked for to 0.01 %. Meant for corrections far below a triangle's edge.
void offset_to_volume(TriangleMesh& mesh, double volume_mm3, double most_mm);

}  // namespace lacuna
