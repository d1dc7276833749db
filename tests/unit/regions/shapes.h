#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "core/regions/regions.h"

namespace lacuna::test {

inline GridGeometry grid(const glm::ivec3& size, const glm::dvec3& spacing = glm::dvec3(1)) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return geometry;
}

/// A volume of T whose voxel (x, y, z) is value(x, y, z).
template <class T, class Value>
Volume volume_of(const GridGeometry& geometry, Value value) {
    return make_volume<T>(geometry, [&](std::span<T> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < geometry.size.z; ++z)
            for (int y = 0; y < geometry.size.y; ++y)
                for (int x = 0; x < geometry.size.x; ++x) voxels[i++] = T(value(x, y, z));
    });
}

/// 100 where inside(position in mm) holds, 0 elsewhere.
using Shape = std::function<bool(const glm::dvec3& mm)>;
inline Volume mask_volume(const GridGeometry& geometry, const Shape& inside) {
    return volume_of<std::uint8_t>(geometry, [&](int x, int y, int z) {
        return inside(geometry.voxel_to_mm({x, y, z})) ? 100 : 0;
    });
}

inline RegionTable regions_of(const Volume& volume, Connectivity connectivity = Connectivity::c6,
                              std::int64_t min_voxels = 1) {
    RegionOptions options;
    options.threshold = ValueRange{50, 150};
    options.connectivity = connectivity;
    options.min_voxels = min_voxels;
    return find_regions(volume, options);
}

inline RegionTable grown(const Volume& volume, double width, Connectivity connectivity = Connectivity::c6,
                         std::int64_t min_voxels = 1) {
    RegionOptions options;
    options.range_width = width;
    options.connectivity = connectivity;
    options.min_voxels = min_voxels;
    return find_regions(volume, options);
}

inline Shape ball(const glm::dvec3& centre, double radius) {
    return [=](const glm::dvec3& p) { return glm::dot(p - centre, p - centre) <= radius * radius; };
}

inline Shape shell(const glm::dvec3& centre, double inner, double outer) {
    return [=](const glm::dvec3& p) {
        const double d = glm::length(p - centre);
        return d >= inner && d <= outer;
    };
}

inline Shape torus(const glm::dvec3& centre, double ring, double tube) {
    return [=](const glm::dvec3& p) {
        const glm::dvec3 q = p - centre;
        return std::hypot(std::hypot(q.x, q.y) - ring, q.z) <= tube;
    };
}

/// A plate of the given thickness and disc radius across `normal`.
inline Shape disc(const glm::dvec3& centre, const glm::dvec3& normal, double radius, double thickness) {
    const glm::dvec3 n = glm::normalize(normal);
    return [=](const glm::dvec3& p) {
        const double height = glm::dot(p - centre, n);
        return std::abs(height) <= thickness / 2 && glm::length(p - centre - height * n) <= radius;
    };
}

/// The same pseudo-random sequence everywhere.
class Noise {
public:
    explicit Noise(std::uint64_t seed) : state_(seed * 2654435761u + 88172645463325252ull) {}
    std::uint32_t next() {
        state_ ^= state_ << 13, state_ ^= state_ >> 7, state_ ^= state_ << 17;
        return std::uint32_t(state_ >> 32);
    }
    int below(int n) { return int(next() % std::uint32_t(n)); }

private:
    std::uint64_t state_;
};

}  // namespace lacuna::test
