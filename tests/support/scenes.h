#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/render/plan.h"
#include "core/render/scene.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"

namespace lacuna::test {

/// Volumes that break indexing: odd sizes, thin axes, flat values, NaN, anisotropic and oblique grids.
struct NamedVolume {
    std::string name;
    Volume volume;
};

/// A smooth bumpy ball, value 0..amplitude, of any size and type.
template <class T>
Volume bumpy_ball(glm::ivec3 size, glm::dvec3 spacing, double amplitude, double offset = 0) {
    GridGeometry grid;
    grid.size = size;
    grid.spacing = spacing;
    grid.origin = {3, -7, 11};
    return make_volume<T>(grid, [&](auto voxels) {
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 p = (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(size) * 2.0 - 1.0;
                    const double bumps = 0.08 * std::sin(9 * p.x) * std::cos(7 * p.y + 4 * p.z);
                    const double v = 1.0 / (1.0 + std::exp(14 * (glm::length(p) - 0.7 + bumps)));
                    voxels[i++] = T(offset + amplitude * v);
                }
    });
}

/// Turns a grid's axes by a rotation about (1, 2, 3).
inline Volume oblique(Volume volume, double degrees) {
    GridGeometry grid = volume.geometry();
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 3));
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    for (int a = 0; a < 3; ++a) {
        const glm::dvec3 v = grid.direction[a];
        grid.direction[a] = v * c + glm::cross(axis, v) * s + axis * glm::dot(axis, v) * (1 - c);
    }
    return Volume(grid, volume.type(), volume.buffer());
}

inline std::vector<NamedVolume> ugly_volumes() {
    std::vector<NamedVolume> all;
    all.push_back({"odd_u8", bumpy_ball<std::uint8_t>({37, 29, 23}, {1, 1, 1}, 240)});
    all.push_back({"signed_i8", bumpy_ball<std::int8_t>({21, 33, 17}, {0.5, 0.5, 0.8}, 200, -100)});
    all.push_back({"u16_1_1_5", bumpy_ball<std::uint16_t>({40, 41, 13}, {1, 1, 5}, 60000)});
    all.push_back({"i16_oblique", oblique(bumpy_ball<std::int16_t>({33, 34, 35}, {0.7, 0.9, 1.3}, 3000, -1000), 33)});
    Volume with_nan = bumpy_ball<float>({25, 26, 27}, {1, 1, 1}, 1);
    auto* voxels = reinterpret_cast<float*>(with_nan.buffer().data());
    for (int i = 0; i < 400; ++i) voxels[(i * 7919) % (25 * 26 * 27)] = std::nanf("");
    all.push_back({"nan_f32", with_nan});
    all.push_back({"flat_u8", bumpy_ball<std::uint8_t>({9, 9, 9}, {1, 1, 1}, 0, 100)});
    all.push_back({"one_voxel", bumpy_ball<std::uint16_t>({1, 1, 1}, {1, 1, 1}, 0, 1000)});
    all.push_back({"one_by_one", bumpy_ball<std::int16_t>({1, 1, 30}, {1, 1, 1}, 900)});
    all.push_back({"one_slice", bumpy_ball<float>({30, 20, 1}, {1, 1, 3}, 1)});
    return all;
}

/// A scene on a volume with everything fitted, small enough for many renderings.
inline Scene small_scene(const Volume& volume, ViewMode mode, glm::ivec2 size = {61, 47}) {
    Scene scene = default_scene(volume, compute_statistics(volume));
    scene.mode = mode;
    scene.size = size;
    scene.camera.azimuth_deg = 33;
    scene.camera.elevation_deg = 21;
    return scene;
}

}  // namespace lacuna::test
