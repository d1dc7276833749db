#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/accuracy/limits.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

/// What a spot on this ray loses where the nearest sample is half a step off.
double loss_along(const GridGeometry& grid, const glm::dvec3& direction, double step) {
    const glm::dvec3 d = glm::abs(glm::transpose(grid.direction) * direction);
    double left = 1;
    for (int axis = 0; axis < 3; ++axis)
        left *= std::max(0.0, 1 - 0.5 * step * grid.smallest_spacing_mm() * d[axis] / grid.spacing[axis]);
    return 1 - left;
}

TEST(SpotLoss, IsThatOfTheRaysWhichAreParallel) {
    Scene scene = small_scene(bumpy_ball<std::uint8_t>({12, 13, 14}, {1, 1, 5}, 200), ViewMode::mip, {16, 12});
    for (const double azimuth : {0.0, 33.0, 45.0}) {
        scene.camera.azimuth_deg = azimuth;
        const GridGeometry& grid = scene.volume.geometry();
        const ViewRays rays = resolve(scene.camera, grid, scene.size);
        EXPECT_NEAR(spot_loss(scene, 0.5), loss_along(grid, rays.forward, 0.5), 1e-12);
    }
}

TEST(SpotLoss, BoundsEveryRayOfAPerspectiveView) {
    for (const glm::dvec3 spacing : {glm::dvec3(1, 1, 1), glm::dvec3(1, 1, 5), glm::dvec3(0.7, 1.3, 0.9)})
        for (const double fov : {0.01, 20.0, 60.0, 120.0})
            for (const double azimuth : {0.0, 20.0, 45.0})
                for (const double step : {0.25, 0.5, 1.0, 3.0}) {
                    Scene scene = small_scene(oblique(bumpy_ball<std::uint8_t>({12, 13, 14}, spacing, 200), 17),
                                              ViewMode::mip, {24, 15});
                    scene.camera.azimuth_deg = azimuth;
                    scene.camera.elevation_deg = azimuth / 2;
                    scene.camera.fov_deg = fov;
                    const GridGeometry& grid = scene.volume.geometry();
                    const ViewRays rays = resolve(scene.camera, grid, scene.size);
                    double largest = 0;
                    for (int y = 0; y < scene.size.y; ++y)
                        for (int x = 0; x < scene.size.x; ++x)
                            largest = std::max(largest, loss_along(grid, rays.direction(x, y), step));
                    const double bound = spot_loss(scene, step);
                    EXPECT_GE(bound, largest - 1e-9) << fov << " degrees, azimuth " << azimuth << ", step " << step;
                    EXPECT_LE(bound, 1.7 * largest);
                    if (fov == 0.01) {
                        EXPECT_LE(bound, 1.01 * largest);
                    }
                }
}

}  // namespace
}  // namespace lacuna
