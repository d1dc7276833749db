#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace lacuna {

/// What the axes of a volume's space are called to the person who looks: the sides of a patient's body (L R, P A, H F),
/// or X, Y, Z of a part. Positions are the same numbers either way.
enum class AxisNames { xyz, patient };

/// Where a regular grid lies in the patient's (or part's) space, in millimetres, DICOM's LPS axes: +x to the
/// patient's left, +y to the back, +z to the head. Voxel (i, j, k)'s centre is at
/// origin + direction * (i*spacing.x, j*spacing.y, k*spacing.z); the columns of `direction` are orthonormal.
struct GridGeometry {
    glm::ivec3 size{0};            ///< voxels along each axis
    glm::dvec3 spacing{1.0};       ///< mm between voxel centres, each > 0
    glm::dvec3 origin{0.0};        ///< mm, centre of voxel (0, 0, 0)
    glm::dmat3 direction{1.0};     ///< columns: the grid axes as unit vectors
    AxisNames axis_names = AxisNames::xyz;  ///< what x, y, z of its space are called; core/io/axis_rule.h says when

    std::int64_t voxel_count() const { return std::int64_t(size.x) * size.y * size.z; }
    std::int64_t linear_index(int x, int y, int z) const {
        return (std::int64_t(z) * size.y + y) * size.x + x;
    }
    double voxel_volume_mm3() const { return spacing.x * spacing.y * spacing.z; }
    double smallest_spacing_mm() const { return glm::min(spacing.x, glm::min(spacing.y, spacing.z)); }

    /// Voxel coordinates (centres at whole numbers) to mm and back.
    glm::dvec3 voxel_to_mm(const glm::dvec3& voxel) const { return origin + direction * (voxel * spacing); }
    glm::dvec3 mm_to_voxel(const glm::dvec3& mm) const {
        return glm::transpose(direction) * (mm - origin) / spacing;
    }
    /// A direction (not a position) from mm to voxel units.
    glm::dvec3 vector_to_voxel(const glm::dvec3& mm) const { return glm::transpose(direction) * mm / spacing; }

    /// Centre of the box of voxel cells, mm.
    glm::dvec3 centre_mm() const { return voxel_to_mm(0.5 * glm::dvec3(size - 1)); }
    /// Diameter of the sphere through the corners of the box of voxel cells, mm.
    double diameter_mm() const { return glm::length(glm::dvec3(size) * spacing); }
};

/// Describes the first fault of a geometry (size < 1, spacing not a positive finite number, axes not orthonormal
/// within 1e-4, origin not finite) in one sentence, or an empty string when it is sound.
const char* fault_of(const GridGeometry& geometry);

}  // namespace lacuna
