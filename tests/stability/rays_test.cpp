// Rays and voxels at their extremes: along axes, through corners, from within, from far away; voxels that are no
// numbers, volumes of one value or one voxel across. No structure may change a picture, and the device must keep to the
// reference.
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "tests/stability/failure_scenes.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

constexpr ViewMode k_modes[] = {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::mean};

/// A ray along an axis that runs within the faces of the volume's box: in or out is rounding's to say.
bool runs_within_a_face(const Scene& scene, const ViewRays& rays, int x, int y) {
    const GridGeometry& grid = scene.volume.geometry();
    const glm::dvec3 o = grid.mm_to_voxel(rays.origin(x, y)), d = rays.direction(x, y);
    for (int axis = 0; axis < 3; ++axis)
        if (std::fabs(d[axis]) < 1e-9 &&
            std::min(std::fabs(o[axis] + 0.5), std::fabs(o[axis] - (grid.size[axis] - 0.5))) < 1e-3)
            return true;
    return false;
}

/// Share of pixels off by more than two levels, rays within the box's faces left out.
double turned_pixels(const Scene& scene, const Frame& a, const Frame& b) {
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    std::size_t over = 0;
    for (int y = 0; y < a.size.y; ++y)
        for (int x = 0; x < a.size.x; ++x) {
            const glm::vec4 d = glm::abs(a.color[pixel_index(a, x, y)] - b.color[pixel_index(a, x, y)]) * 255.0f;
            const bool same = std::max({d.r, d.g, d.b, d.a}) <= 2;  // NaN is not
            over += !same && !runs_within_a_face(scene, rays, x, y);
        }
    return double(over) / double(a.pixels());
}

/// Every structure against brute force on the device, and that against the reference renderer.
/// @param turned share of pixels that single precision may turn (rays that graze voxels exactly)
void expect_all_alike(const Scene& scene, double turned, std::optional<ValueRange> leap_values = {}) {
    const Frame truth = render_reference(scene, brute_force());
    const Frame plain = on_device(scene, brute_force());
    EXPECT_LE(turned_pixels(scene, plain, truth), turned) << name_of(scene.mode) << " against the reference";
    for (const Structure structure : casting_structures()) {
        Plan plan = with_structure(structure);
        plan.leap.quantisation = leap_values;
        const Frame frame = on_device(scene, plan);
        // Floats quantised are other floats: where a voxel that is no number lies beside the surface, a pixel may turn.
        const bool quantised = structure == Structure::leap && leap_values;
        EXPECT_LE(share_over(frame, plain, quantised ? 2.0 : 1.0), quantised ? turned : 0)
            << name_of(scene.mode) << " " << name_of(structure);
    }
}

Scene bumpy(ViewMode mode) {
    static const Volume volume = bumpy_ball<std::uint16_t>({24, 25, 26}, {1, 1, 1}, 60000);
    Scene scene = small_scene(volume, mode, {33, 33});
    scene.camera = {};
    return scene;
}

TEST(Rays, ExactlyAlongAxesOnVoxelCentresFacesAndEdges) {
    LACUNA_NEEDS_DEVICE();
    for (const ViewMode mode : k_modes)
        for (const auto& [azimuth, elevation] :
             {std::pair(0.0, 0.0), {90.0, 0.0}, {180.0, 0.0}, {-90.0, 0.0}, {0.0, 90.0}, {0.0, -90.0}})
            for (const double shift : {0.0, 0.5}) {
                SCOPED_TRACE(testing::Message() << azimuth << " " << elevation << " shifted " << shift);
                Scene scene = bumpy(mode);
                const GridGeometry& grid = scene.volume.geometry();
                scene.camera.azimuth_deg = azimuth;
                scene.camera.elevation_deg = elevation;
                scene.camera.center_mm = grid.voxel_to_mm(glm::dvec3(12, 12, 13) + shift);
                scene.camera.zoom = grid.diameter_mm() / scene.size.x;  // a pixel a voxel
                expect_all_alike(scene, 0.01);
            }
}

TEST(Rays, ThroughVoxelCornersAlongDiagonals) {
    LACUNA_NEEDS_DEVICE();
    for (const ViewMode mode : k_modes)
        for (const auto& [azimuth, elevation] :
             {std::pair(45.0, 0.0), {-135.0, 0.0}, {45.0, 35.264389682754654}, {-45.0, -35.264389682754654}}) {
            SCOPED_TRACE(testing::Message() << azimuth << " " << elevation);
            Scene scene = bumpy(mode);
            scene.camera.azimuth_deg = azimuth;
            scene.camera.elevation_deg = elevation;
            scene.camera.center_mm = scene.volume.geometry().voxel_to_mm(glm::dvec3(11.5, 12.5, 12.5));
            expect_all_alike(scene, 0.01);
        }
}

TEST(Rays, FromInsideTheVolume) {
    LACUNA_NEEDS_DEVICE();
    for (const ViewMode mode : k_modes)
        for (const double shift : {0.0, 0.5}) {
            Scene scene = bumpy(mode);
            const GridGeometry& grid = scene.volume.geometry();
            scene.camera.fov_deg = 150;  // the eye stands a quarter of the radius before the centre
            scene.camera.azimuth_deg = 30 * shift;
            scene.camera.center_mm = grid.voxel_to_mm(glm::dvec3(12, 12, 13) + shift);
            const ViewRays rays = resolve(scene.camera, grid, scene.size);
            const glm::dvec3 eye = grid.mm_to_voxel(rays.eye);
            ASSERT_TRUE(glm::all(glm::greaterThan(eye, glm::dvec3(0))) &&
                        glm::all(glm::lessThan(eye, glm::dvec3(grid.size - 1))));
            expect_all_alike(scene, 0.01);
        }
}

/// Largest depth difference in mm among pixels both hit; pixels only one hits are counted.
std::pair<double, int> depth_difference(const Frame& a, const Frame& b) {
    double worst = 0;
    int one_sided = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        if (std::isinf(a.depth_mm[i]) != std::isinf(b.depth_mm[i])) ++one_sided;
        if (std::isfinite(a.depth_mm[i]) && std::isfinite(b.depth_mm[i]))
            worst = std::max(worst, std::fabs(double(a.depth_mm[i]) - double(b.depth_mm[i])));
    }
    return {worst, one_sided};
}

TEST(Precision, AnEyeTenThousandVoxelsAwaySeesTheSameSurface) {
    LACUNA_NEEDS_DEVICE();
    for (const double origin_mm : {0.0, 1e4, 1e6}) {
        GridGeometry grid = centred({24, 24, 24});
        grid.origin += glm::dvec3(origin_mm);
        Scene scene = scene_of(sampled<std::uint16_t>(grid,
                                                      [&](const glm::dvec3& mm) {
                                                          const double r = glm::length(mm - grid.centre_mm());
                                                          return std::clamp(30000 + 3000 * (8 - r), 0.0, 60000.0);
                                                      }),
                               ViewMode::iso, 41);
        scene.iso = 30000;
        scene.camera.azimuth_deg = 31;
        scene.camera.elevation_deg = 17;
        scene.camera.fov_deg = 0.2;
        ASSERT_GT(resolve(scene.camera, grid, scene.size).distance_mm, 1e4);
        const Frame truth = render_reference(scene, brute_force());
        for (const Structure structure : casting_structures()) {
            const auto [worst, one_sided] = depth_difference(on_device(scene, with_structure(structure)), truth);
            EXPECT_LE(worst, 0.01) << name_of(structure) << ", origin at " << origin_mm;
            EXPECT_LE(one_sided, 4) << name_of(structure) << ", origin at " << origin_mm;
        }
    }
}

TEST(Precision, TenThousandVoxelsBehindTheFaceAWallStandsWhereItIs) {
    LACUNA_NEEDS_DEVICE();
    const Volume volume =
        sampled<std::uint8_t>(centred({4, 10000, 4}), [](const glm::dvec3& mm) { return mm.y > 4900.25 ? 200 : 0; });
    Scene scene = scene_of(volume, ViewMode::iso, 9);
    scene.iso = 100;
    scene.camera.zoom = 3000;
    const Frame truth = render_reference(scene, brute_force());
    ASSERT_TRUE(std::isfinite(truth.depth_mm[40]));
    for (const Structure structure : casting_structures()) {
        const auto [worst, one_sided] = depth_difference(on_device(scene, with_structure(structure)), truth);
        EXPECT_LE(worst, 0.02) << name_of(structure);
        EXPECT_EQ(one_sided, 0) << name_of(structure);
    }
}

TEST(Voxels, NanAndInfinityContributeNothingAnywhere) {
    LACUNA_NEEDS_DEVICE();
    Volume volume = bumpy_ball<float>({25, 26, 27}, {1, 1, 1}, 1);
    auto* voxels = reinterpret_cast<float*>(volume.buffer().data());
    for (int i = 0; i < 120; ++i)
        voxels[(i * 7919) % (25 * 26 * 27)] = i % 3 == 0 ? std::nanf("") : i % 3 == 1 ? INFINITY : -INFINITY;
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip}) {
        Scene scene = small_scene(volume, mode, {41, 37});
        EXPECT_TRUE(std::isfinite(scene.iso) && std::isfinite(scene.window.lo) && std::isfinite(scene.window.hi));
        expect_all_alike(scene, 0.01, ValueRange{0, 1});
    }
}

TEST(Voxels, OneValueOrOneVoxelAcrossIsDrawnByEveryStructure) {
    LACUNA_NEEDS_DEVICE();
    std::vector<Volume> volumes = {bumpy_ball<std::uint16_t>({9, 9, 9}, {1, 1, 1}, 0, 100)};
    for (const glm::ivec3 size :
         {glm::ivec3(1, 1, 30), glm::ivec3(30, 1, 1), glm::ivec3(1, 30, 1), glm::ivec3(1, 20, 30), glm::ivec3(1, 1, 1)})
        volumes.push_back(bumpy_ball<std::uint16_t>(size, {1, 1, 1}, size == glm::ivec3(1) ? 0 : 900, 50));
    for (const Volume& volume : volumes)
        for (const ViewMode mode : k_modes) {
            const glm::ivec3 size = volume.geometry().size;
            SCOPED_TRACE(testing::Message() << size.x << "x" << size.y << "x" << size.z);
            Scene scene = small_scene(volume, mode, {33, 33});
            for (const double azimuth : {0.0, 33.0}) {
                scene.camera.azimuth_deg = azimuth;
                expect_all_alike(scene, 0.01);
            }
        }
}

}  // namespace
}  // namespace lacuna
