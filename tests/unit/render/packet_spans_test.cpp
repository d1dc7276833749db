// Where packets of rays can meet cells and which octants they run into, held against rays walked in small steps.
#include "core/render/packet_spans.h"

#include <gtest/gtest.h>

#include <random>

#include "core/render/ray_params.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

struct View {
    const char* name;
    double azimuth, elevation;
    std::optional<double> fov = {};
    double zoom = 1;
};

const View k_views[] = {{"front", 0, 0},
                        {"turned", 33, 21},
                        {"behind", 190, -60},
                        {"above", 0, 90},
                        {"perspective", 120, 30, 50.0},
                        {"near", 7, 20, 30.0, 3},
                        {"inside", 33, 21, 80.0, 8}};

struct Row {
    glm::ivec3 size;
    glm::dvec3 spacing;
    double share;  ///< of cells that may show something
};

const Row k_rows[] = {{{40, 41, 13}, {1, 1, 5}, 0.02},
                      {{33, 7, 65}, {0.5, 2, 1}, 0.5},
                      {{9, 9, 9}, {1, 1, 1}, 1.0},
                      {{30, 30, 30}, {1, 1, 1}, 0.0}};

Scene scene_of(const Row& row, const View& view) {
    Scene scene =
        test::small_scene(test::bumpy_ball<std::uint16_t>(row.size, row.spacing, 60000), ViewMode::ea, {70, 50});
    scene.camera.azimuth_deg = view.azimuth;
    scene.camera.elevation_deg = view.elevation;
    scene.camera.fov_deg = view.fov;
    scene.camera.zoom = view.zoom;
    return scene;
}

RegionGrid random_cells(glm::ivec3 voxels, int shift, double share) {
    RegionGrid grid{((voxels - 1) >> shift) + 1, {}};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    grid.region.resize(std::size_t(grid.size.x) * std::size_t(grid.size.y) * std::size_t(grid.size.z));
    for (std::uint8_t& region : grid.region) region = uniform(random) < share ? (uniform(random) < 0.5 ? 0 : 2) : 1;
    return grid;
}

TEST(PacketSpans, HoldEveryPlaceWhereARayIsInACell) {
    constexpr int k_shift = 2;
    for (const Row& row : k_rows) {
        const RegionGrid grid = random_cells(row.size, k_shift, row.share);
        PacketSpans spans;
        spans.hold(grid, k_shift);
        for (const View& view : k_views) {
            const Scene scene = scene_of(row, view);
            const GridGeometry& geometry = scene.volume.geometry();
            const RayParams params = make_ray_params(scene, Plan{}, geometry.size, nullptr);
            const glm::ivec2 packets = (scene.size + 3) / 4;
            std::vector<glm::vec2> found(std::size_t(packets.x) * std::size_t(packets.y));
            spans.project(params, packets, found.data());
            const ViewRays rays = resolve(scene.camera, geometry, scene.size);
            const double bias = double(params.depth_bias_mm), furthest = rays.distance_mm + geometry.diameter_mm();
            for (int y = 0; y < scene.size.y; y += 3)
                for (int x = 0; x < scene.size.x; x += 3) {
                    const glm::vec2 span = found[std::size_t(y / 4) * std::size_t(packets.x) + std::size_t(x / 4)];
                    for (double t = 0; t < furthest; t += 0.2) {
                        const glm::dvec3 p = geometry.mm_to_voxel(rays.origin(x, y) + rays.direction(x, y) * t);
                        if (glm::any(glm::lessThan(p, glm::dvec3(-0.5))) ||
                            glm::any(glm::greaterThan(p, glm::dvec3(row.size) - 0.5)))
                            continue;
                        const glm::ivec3 c =
                            glm::ivec3(glm::clamp(p, glm::dvec3(0), glm::dvec3(row.size - 1))) >> k_shift;
                        if (grid.region[std::size_t((c.z * grid.size.y + c.y) * grid.size.x + c.x)] == 1) continue;
                        // Rays of parallel projection are given from the plane through the target.
                        ASSERT_LE(double(span.x), t - bias + 1e-3) << view.name << " " << x << " " << y;
                        ASSERT_GE(double(span.y), t - bias - 1e-3) << view.name << " " << x << " " << y;
                    }
                }
        }
    }
}

TEST(PacketSpans, LeaveEmptyPacketsOut) {
    const Row row{{64, 64, 64}, {1, 1, 1}, 0};
    RegionGrid grid = random_cells(row.size, 2, 0);
    grid.region[std::size_t((8 * 16 + 8) * 16 + 8)] = 0;  // one cell in the middle
    PacketSpans spans;
    spans.hold(grid, 2);
    EXPECT_EQ(spans.cells(), 1u);
    for (const View& view : {k_views[1], k_views[4]}) {
        const Scene scene = scene_of(row, view);
        const RayParams params = make_ray_params(scene, Plan{}, row.size, nullptr);
        const glm::ivec2 packets = (scene.size + 3) / 4;
        std::vector<glm::vec2> found(std::size_t(packets.x) * std::size_t(packets.y));
        spans.project(params, packets, found.data());
        std::size_t met = 0;
        for (const glm::vec2& span : found) {
            met += span.x <= span.y;
            if (span.x <= span.y) {
                EXPECT_LT(span.y - span.x, 10);
            }
        }
        EXPECT_GT(met, 0u);
        EXPECT_LT(met, 13u) << view.name;
    }
}

TEST(PacketSpans, ManyCellsAreTakenTogether) {
    const RegionGrid grid = random_cells({400, 400, 200}, 2, 0.3);  // 500 000 cells, a third of them on their own
    PacketSpans spans;
    spans.hold(grid, 2);
    EXPECT_LT(spans.cells(), 24001u);
}

TEST(OctantsOfRays, HoldEveryRaysOwn) {
    for (const View& view : k_views) {
        const Row& row = k_rows[0];
        const Scene scene = scene_of(row, view);
        const GridGeometry& geometry = scene.volume.geometry();
        const OctantSet octants = octants_of_rays(make_ray_params(scene, Plan{}, row.size, nullptr), 3);
        const ViewRays rays = resolve(scene.camera, geometry, scene.size);
        for (int y = -3; y < scene.size.y + 3; ++y)
            for (int x = -3; x < scene.size.x + 3; ++x) {
                const glm::dvec3 d = geometry.vector_to_voxel(rays.direction(x, y));
                const int octant = (d.x < 0) + 2 * (d.y < 0) + 4 * (d.z < 0);
                ASSERT_TRUE(octants >> octant & 1) << view.name << " " << x << " " << y;
            }
    }
    // A parallel view off the axes runs into one octant.
    const Scene turned = scene_of(k_rows[0], k_views[1]);
    EXPECT_EQ(octants_of(octants_of_rays(make_ray_params(turned, Plan{}, k_rows[0].size, nullptr), 16)).size(), 1u);
}

}  // namespace
}  // namespace lacuna
