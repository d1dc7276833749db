#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/regions/regions.h"

namespace lacuna::neighbourhood {

/// The 13 neighbours of a voxel that come before it in scan order; the 13 others are their opposites.
/// Index k < 9: z - 1, row by row; 9..11: y - 1; 12: x - 1.
glm::ivec3 earlier_offset(int k);

/// A voxel's 26 neighbours as bits: bit k says that earlier neighbour k is in the same region, bit 13 + k that its
/// opposite is.
inline constexpr std::uint32_t k_surrounded = (1u << 26) - 1;

/// A plane neighbour below (first row) and across: how far a row neighbour may lie along x to count as adjacent;
/// -1 where no voxel of that row does.
int reach_along_x(Connectivity connectivity, int dy, int dz);

/// Share of the unit sphere (both ends) nearest to each of the 13 directions in mm; sums to 1. Numerical: 200 000
/// points, error under 1e-4. The weights of Crofton's formula on an anisotropic grid (Lehmann & Legland 2012). Over all
/// orientations a plane's area is right on average, with a deviation of 1.6 % at spacing 1:1:1, 5.6 % at 1:1:2 and
/// 7.3 % at 1:1:5; at worst 7.3, 12.6 and 23 % (faces along the grid read too small).
std::array<double, 13> direction_weights(const glm::dvec3& spacing_mm);

/// What a voxel adds to the surface and to Euler's number of its region, looked up by its neighbour bits.
class LocalMeasures {
public:
    LocalMeasures(const glm::dvec3& spacing_mm, Connectivity connectivity);

    /// In units of surface_unit_mm2(); whole numbers, so that sums do not depend on their order.
    std::int32_t surface(std::uint32_t same) const { return surface_[same & 8191u] + surface_[same >> 13]; }
    double surface_unit_mm2() const { return surface_unit_mm2_; }

    /// Euler's number: vertices less edges plus faces less cells, each counted at one voxel of the region only.
    int euler(std::uint32_t same) const {
        int sum = euler_[same & 8191u];
        if (split_corners_) sum += corners_split(same);
        return sum;
    }

private:
    static int corners_split(std::uint32_t same);

    std::vector<std::int32_t> surface_;
    std::vector<std::int8_t> euler_;
    double surface_unit_mm2_ = 0;
    bool split_corners_ = false;
};

}  // namespace lacuna::neighbourhood
