#pragma once

#include <filesystem>

#include "core/regions/triangle_mesh.h"

namespace lacuna {

/// Writes a mesh in the format its extension names: .stl (binary), .ply (binary), .obj, .vtp (ASCII XML).
/// @throws Error(bad_usage) for another extension; Error(io)
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& target);

}  // namespace lacuna
