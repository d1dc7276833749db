#pragma once

#include <random>

#include "tests/support/scenes.h"

namespace lacuna::test {

// Scenes nobody chose: random volumes, transfer functions, cameras.

using Random = std::mt19937;

inline double between(Random& random, double lo, double hi) { return std::uniform_real_distribution(lo, hi)(random); }

/// Balls, thin walls and noise. @param finer  so many times the voxels along each axis
inline Volume random_volume(Random& random, double finer = 1) {
    GridGeometry grid;
    for (int axis = 0; axis < 3; ++axis) {
        grid.size[axis] = int(finer * between(random, 20, 40));
        grid.spacing[axis] = between(random, 0.6, 1.8);
    }
    struct Ball {
        glm::dvec3 centre;
        double radius, value;
    };
    std::vector<Ball> balls(4);
    for (Ball& ball : balls)
        ball = {glm::dvec3(between(random, 0, 1), between(random, 0, 1), between(random, 0, 1)),
                between(random, 0.05, 0.35), between(random, 5000, 40000)};
    const double wall = between(random, 0.2, 0.8), thickness = between(random, 0.01, 0.06);
    const double noise = between(random, 0, 1500);
    return make_volume<std::uint16_t>(grid, [&](auto voxels) {
        std::size_t i = 0;
        for (int z = 0; z < grid.size.z; ++z)
            for (int y = 0; y < grid.size.y; ++y)
                for (int x = 0; x < grid.size.x; ++x) {
                    const glm::dvec3 p = (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(grid.size);
                    double value = between(random, 0, noise);
                    for (const Ball& ball : balls)
                        value += ball.value / (1 + std::exp(40 * (glm::length(p - ball.centre) - ball.radius)));
                    if (std::fabs(p.x - wall) < thickness) value += 15000;
                    voxels[i++] = std::uint16_t(std::clamp(value, 0.0, 65535.0));
                }
    });
}

inline Scene random_scene(Random& random, glm::ivec2 size = {96, 72}, double finer = 1) {
    const ViewMode modes[] = {ViewMode::ea, ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::mean};
    const Volume volume = random_volume(random, finer);
    Scene scene = small_scene(volume, modes[random() % 5], size);
    scene.iso = between(random, 4000, 30000);
    TransferFunction function{"random", between(random, 0.5, 3), {}, {}};
    const double start = between(random, 0, 8000);
    for (int i = 0; i < 5; ++i)
        function.points.push_back({start + 9000.0 * i,
                                   {between(random, 0, 1), between(random, 0, 1), between(random, 0, 1)},
                                   i == 0 ? 0 : between(random, 0, 0.8)});
    scene.classification.tf = function;
    scene.camera.azimuth_deg = between(random, -180, 180);
    scene.camera.elevation_deg = between(random, -90, 90);
    scene.camera.zoom = between(random, 0.9, 3);
    if (random() % 3 == 0) scene.camera.fov_deg = between(random, 10, 60);
    return scene;
}

}  // namespace lacuna::test
