// The order bricks are cast in, and which pixels they can reach, held against rays walked in small steps.
#include "core/render/brick_view.h"

#include <gtest/gtest.h>

#include "core/render/ray_params.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

struct View {
    const char* name;
    double azimuth, elevation;
    std::optional<double> fov = {};
    double zoom = 1;
    std::optional<glm::dvec3> center = {};
};

const View k_views[] = {{"front", 0, 0},
                        {"turned", 33, 21},
                        {"behind", 190, -60},
                        {"above", 0, 90},
                        {"perspective", 120, 30, 50.0},
                        {"inside", 33, 21, 80.0, 8},
                        {"inside_aside", 200, -10, 90.0, 8, glm::dvec3(20, 10, 30)}};

Scene scene_of(const View& view) {
    Scene scene = test::small_scene(test::bumpy_ball<std::uint16_t>({40, 41, 13}, {1, 1, 5}, 60000), ViewMode::ea);
    scene.camera.azimuth_deg = view.azimuth;
    scene.camera.elevation_deg = view.elevation;
    scene.camera.fov_deg = view.fov;
    scene.camera.zoom = view.zoom;
    scene.camera.center_mm = view.center;
    return scene;
}

std::int64_t brick_at(const BrickGrid& grid, const glm::dvec3& p) {
    glm::ivec3 b;
    for (int a = 0; a < 3; ++a) b[a] = std::clamp(int(std::floor(p[a] / grid.edge)), 0, grid.count[a] - 1);
    return grid.index(b);
}

TEST(BrickView, NoRayComesBackAndNoneIsMissed) {
    for (const View& view : k_views) {
        const Scene scene = scene_of(view);
        const GridGeometry& geometry = scene.volume.geometry();
        const BrickGrid grid(geometry.size, 7, {2, 2, 2});
        const RayParams params = make_ray_params(scene, Plan{}, geometry.size, nullptr);
        const BrickView bricks(grid, params, view.fov.has_value());
        const std::vector<std::int64_t> order = bricks.front_to_back();
        std::vector<int> rank(order.size(), -1);
        for (std::size_t i = 0; i < order.size(); ++i) rank[std::size_t(order[i])] = int(i);
        EXPECT_EQ(std::count(rank.begin(), rank.end(), -1), 0) << view.name;
        const ViewRays rays = resolve(scene.camera, geometry, scene.size);
        int met = 0;
        for (int y = 0; y < scene.size.y; y += 3)
            for (int x = 0; x < scene.size.x; x += 3) {
                int last = -1;
                for (double t = 0; t < 400; t += 0.3) {
                    const glm::dvec3 p = geometry.mm_to_voxel(rays.origin(x, y) + t * rays.direction(x, y));
                    if (glm::any(glm::lessThan(p, glm::dvec3(-0.5))) ||
                        glm::any(glm::greaterThan(p, glm::dvec3(geometry.size) - 0.5)))
                        continue;
                    const std::int64_t b = brick_at(grid, p);
                    EXPECT_GE(rank[std::size_t(b)], last) << view.name;
                    if (rank[std::size_t(b)] == last) continue;
                    last = rank[std::size_t(b)];
                    const PixelRect rect = bricks.pixels_of(grid.at(b));
                    EXPECT_TRUE(x >= rect.first.x && x < rect.end.x && y >= rect.first.y && y < rect.end.y)
                        << view.name << " " << x << " " << y;
                    EXPECT_TRUE(bricks.meets(grid.at(b), x, y, 0.01)) << view.name;
                    ++met;
                }
            }
        EXPECT_GT(met, 100) << view.name;
    }
}

TEST(BrickView, BricksBesideThePictureHaveNoPixels) {
    Scene scene = scene_of({"near", 33, 21});
    scene.camera.zoom = 6;
    const glm::ivec3 size = scene.volume.geometry().size;
    const BrickGrid grid(size, 7, {2, 2, 2});
    const BrickView bricks(grid, make_ray_params(scene, Plan{}, size, nullptr), false);
    int outside = 0;
    for (std::int64_t b = 0; b < grid.bricks(); ++b) outside += bricks.pixels_of(grid.at(b)).empty();
    EXPECT_GT(outside, int(grid.bricks()) / 5);
    EXPECT_LT(outside, int(grid.bricks()));
}

}  // namespace
}  // namespace lacuna
