#include "core/regions/neighbourhood.h"

#include <cmath>
#include <numbers>

namespace lacuna::neighbourhood {

namespace {

int index_of_earlier(int dx, int dy, int dz) {
    if (dz == -1) return (dy + 1) * 3 + dx + 1;
    if (dy == -1) return 9 + dx + 1;
    return 12;
}

bool is_earlier(int dx, int dy, int dz) { return dz < 0 || (dz == 0 && (dy < 0 || (dy == 0 && dx < 0))); }

/// True if none of the earlier voxels that share the element (vertex, edge, face) at `side` is in the region; a zero
/// component of `side` means that the element spans the voxel along that axis.
bool owns_element(std::uint32_t earlier, const glm::ivec3& side) {
    for (int corner = 1; corner < 8; ++corner) {
        const int dx = (corner & 1) ? side.x : 0, dy = (corner & 2) ? side.y : 0, dz = (corner & 4) ? side.z : 0;
        if (is_earlier(dx, dy, dz) && (earlier >> index_of_earlier(dx, dy, dz) & 1u)) return false;
    }
    return true;
}

/// Closed cells: touching at an edge or a corner joins. An element counts at its first voxel in scan order.
int euler_of_closed_cells(std::uint32_t earlier) {
    int sum = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const int dimension = (x == 0) + (y == 0) + (z == 0);  // 0 vertex, 1 edge, 2 face, 3 cell
                if (dimension == 3 || owns_element(earlier, {x, y, z})) sum += dimension % 2 ? -1 : 1;
            }
    return sum;
}

/// Points joined through faces only: points less pairs plus full squares less full cubes, each at its last voxel.
int euler_of_face_graph(std::uint32_t earlier) {
    const auto has = [&](int dx, int dy, int dz) { return int(earlier >> index_of_earlier(dx, dy, dz) & 1u); };
    const int x = has(-1, 0, 0), y = has(0, -1, 0), z = has(0, 0, -1);
    const int xy = x & y & has(-1, -1, 0), xz = x & z & has(-1, 0, -1), yz = y & z & has(0, -1, -1);
    return 1 - x - y - z + xy + xz + yz - (xy & xz & yz & has(-1, -1, -1));
}

}  // namespace

glm::ivec3 earlier_offset(int k) {
    if (k < 9) return {k % 3 - 1, k / 3 - 1, -1};
    if (k < 12) return {k - 10, -1, 0};
    return {-1, 0, 0};
}

int reach_along_x(Connectivity connectivity, int dy, int dz) {
    const bool diagonal = dy != 0 && dz != 0;
    if (connectivity == Connectivity::c26) return 1;
    if (connectivity == Connectivity::c18) return diagonal ? 0 : 1;
    return diagonal ? -1 : 0;
}

std::array<double, 13> direction_weights(const glm::dvec3& spacing_mm) {
    constexpr int k_points = 200'000;
    std::array<glm::dvec3, 13> direction;
    for (int k = 0; k < 13; ++k) direction[k] = glm::normalize(glm::dvec3(earlier_offset(k)) * spacing_mm);

    // A Fibonacci lattice on half the sphere: equal areas to within its own fine structure.
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    std::array<std::int64_t, 13> nearest{};
    for (int i = 0; i < k_points; ++i) {
        const double z = (i + 0.5) / k_points, r = std::sqrt(1 - z * z), angle = golden_angle * i;
        const glm::dvec3 point(r * std::cos(angle), r * std::sin(angle), z);
        int best = 0;
        double best_cosine = -1;
        for (int k = 0; k < 13; ++k)
            if (const double cosine = std::abs(glm::dot(point, direction[k])); cosine > best_cosine)
                best_cosine = cosine, best = k;
        ++nearest[best];
    }
    std::array<double, 13> weights;
    for (int k = 0; k < 13; ++k) weights[k] = double(nearest[k]) / k_points;
    return weights;
}

LocalMeasures::LocalMeasures(const glm::dvec3& spacing_mm, Connectivity connectivity)
    : surface_(8192), euler_(8192), split_corners_(connectivity == Connectivity::c18) {
    // Crofton: S = 2 * sum over directions of weight * crossings * area per line (Cauchy: mean |cosine| is 1/2).
    const std::array<double, 13> weights = direction_weights(spacing_mm);
    const double cell_mm3 = spacing_mm.x * spacing_mm.y * spacing_mm.z;
    std::array<double, 13> crossing_mm2;
    double all_mm2 = 0;
    for (int k = 0; k < 13; ++k) {
        crossing_mm2[k] = 2 * weights[k] * cell_mm3 / glm::length(glm::dvec3(earlier_offset(k)) * spacing_mm);
        all_mm2 += 2 * crossing_mm2[k];
    }
    surface_unit_mm2_ = all_mm2 / double(1 << 30);  // a lone voxel's sum of 26 stays within 32 bits
    for (std::uint32_t same = 0; same < 8192; ++same) {
        std::int32_t sum = 0;
        for (int k = 0; k < 13; ++k)
            if (!(same >> k & 1u)) sum += std::int32_t(std::lround(crossing_mm2[k] / surface_unit_mm2_));
        surface_[same] = sum;
        euler_[same] =
            std::int8_t(connectivity == Connectivity::c6 ? euler_of_face_graph(same) : euler_of_closed_cells(same));
    }
}

int LocalMeasures::corners_split(std::uint32_t same) {
    // Two voxels that meet in a corner alone are apart under 18-adjacency: the corner counts twice.
    int split = 0;
    for (const int antipode : {0, 2, 6, 8}) {
        if (!(same >> antipode & 1u)) continue;
        const glm::ivec3 side = earlier_offset(antipode);
        bool alone = true;
        for (int corner = 1; corner < 7 && alone; ++corner) {
            const glm::ivec3 d((corner & 1) ? side.x : 0, (corner & 2) ? side.y : 0, (corner & 4) ? side.z : 0);
            const bool earlier = is_earlier(d.x, d.y, d.z);
            const int k = earlier ? index_of_earlier(d.x, d.y, d.z) : 13 + index_of_earlier(-d.x, -d.y, -d.z);
            alone = !(same >> k & 1u);
        }
        split += alone;
    }
    return split;
}

}  // namespace lacuna::neighbourhood
