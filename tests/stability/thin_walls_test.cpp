// Walls thinner than a step, from square on to grazing: samples miss them by a known share, solved cells never do.
#include <gtest/gtest.h>

#include "core/render/reference_renderer.h"
#include "tests/stability/failure_scenes.h"

namespace lacuna {
namespace {

using namespace test;

/// One layer of voxels: between it and its neighbours the signal is a roof, and the isovalue cuts a wall `thickness`
/// voxels thick out of it. @param turn_deg between the line of sight and the wall's normal
Scene wall(double thickness, double turn_deg) {
    const Volume volume =
        sampled<std::uint16_t>(centred({41, 33, 41}), [](const glm::dvec3& mm) { return mm.y == 0 ? 10000 : 0; });
    Scene scene = scene_of(volume, ViewMode::iso, 96);
    scene.iso = 10000 * (1 - 0.5 * thickness);
    scene.camera.azimuth_deg = turn_deg;
    scene.camera.elevation_deg = 7;
    scene.camera.fov_deg = 30;  // samples meet the wall at every phase
    return scene;
}

/// A ray that crosses the wall well within the volume.
struct Crossing {
    std::size_t pixel = 0;
    double slant = 1;     ///< cosine between the ray and the wall's normal
    double front_mm = 0;  ///< the wall's front, from the ray's origin
    double expected(double thickness, double step) const { return std::max(0.0, 1 - thickness / (slant * step)); }
};

std::vector<Crossing> crossings(const Scene& scene, double thickness) {
    const ViewRays rays = resolve(scene.camera, scene.volume.geometry(), scene.size);
    std::vector<Crossing> all;
    for (int y = 0; y < scene.size.y; ++y)
        for (int x = 0; x < scene.size.x; ++x) {
            const glm::dvec3 o = rays.origin(x, y), d = rays.direction(x, y);
            const double slant = std::fabs(d.y), t = -o.y / d.y;
            if (!(slant > 0.03)) continue;
            const glm::dvec3 at = o + t * d;
            const double reach = 18 - 0.5 * thickness / slant;  // half the way within the wall
            if (std::fabs(at.x) < reach && std::fabs(at.z) < reach)
                all.push_back(
                    {std::size_t(y) * std::size_t(scene.size.x) + std::size_t(x), slant, t - 0.5 * thickness / slant});
        }
    return all;
}

double missed(const Frame& frame, const std::vector<Crossing>& rays) {
    double count = 0;
    for (const Crossing& ray : rays) count += std::isinf(frame.depth_mm[ray.pixel]);
    return count / double(rays.size());
}

/// Largest depth error among the rays that hit, in voxels (of 1 mm).
double depth_error(const Frame& frame, const std::vector<Crossing>& rays) {
    double worst = 0;
    for (const Crossing& ray : rays)
        if (std::isfinite(frame.depth_mm[ray.pixel]))
            worst = std::max(worst, std::fabs(double(frame.depth_mm[ray.pixel]) - ray.front_mm));
    return worst;
}

constexpr double k_turns[] = {0, 45, 70, 85};

TEST(ThinWalls, SamplesMissOneMinusThicknessOverStepAtEveryAngle) {
    LACUNA_NEEDS_DEVICE();
    for (const double thickness : {0.1, 0.25, 0.5, 1.0})
        for (const double turn : k_turns)
            for (const double step : {0.5, 1.0}) {
                SCOPED_TRACE(testing::Message() << thickness << " thick, turned " << turn << ", step " << step);
                const Scene scene = wall(thickness, turn);
                const auto rays = crossings(scene, thickness);
                ASSERT_GT(rays.size(), 100u);
                double expected = 0;
                for (const Crossing& ray : rays) expected += ray.expected(thickness, step) / double(rays.size());
                const double share = missed(on_device(scene, brute_force(step)), rays);
                EXPECT_NEAR(share, expected, 0.12) << "rays do not meet the wall at phases spread quite evenly";
                if (expected == 0) {
                    EXPECT_EQ(share, 0) << "nothing as thick as a step is missed";
                }
            }
}

TEST(ThinWalls, SolvedCellsMissNoneByAnyStructure) {
    LACUNA_NEEDS_DEVICE();
    for (const double thickness : {0.1, 0.5, 1.0})
        for (const double turn : k_turns) {
            const Scene scene = wall(thickness, turn);
            const auto rays = crossings(scene, thickness);
            for (const Structure structure : casting_structures()) {
                SCOPED_TRACE(testing::Message()
                             << thickness << " thick, turned " << turn << ", " << name_of(structure));
                Plan plan = with_structure(structure, 1);
                plan.refine = Refinement::cubic;
                const Frame frame = on_device(scene, plan);
                EXPECT_EQ(missed(frame, rays), 0);
                EXPECT_LT(depth_error(frame, rays), 2e-3);
            }
        }
}

TEST(ThinWalls, NoStructureAddsToWhatSamplesMissByAnyRefinement) {
    LACUNA_NEEDS_DEVICE();
    constexpr double k_thickness = 0.25, k_step = 0.5;
    for (const double turn : {45.0, 85.0}) {
        const Scene scene = wall(k_thickness, turn);
        const auto rays = crossings(scene, k_thickness);
        for (const auto& [refinement, name] : refinement_names()) {
            if (refinement == Refinement::cubic) continue;
            Plan plan = brute_force(k_step);
            plan.refine = refinement;
            const Frame plain = on_device(scene, plan);
            EXPECT_LE(depth_error(plain, rays), k_step + 1e-3) << name << ", turned " << turn;
            if (refinement == Refinement::bisect) {
                EXPECT_LE(depth_error(plain, rays), k_step / 64 + 1e-3) << "turned " << turn;
            }
            for (const Structure structure : casting_structures()) {
                plan = with_structure(structure, k_step);
                plan.refine = refinement;
                const Frame frame = on_device(scene, plan);
                std::size_t other = 0;
                for (const Crossing& ray : rays)
                    other += std::isinf(frame.depth_mm[ray.pixel]) != std::isinf(plain.depth_mm[ray.pixel]);
                EXPECT_EQ(other, 0u) << name << ", " << name_of(structure) << ", turned " << turn;
                EXPECT_LE(share_over(frame, plain, 1.0), 0) << name << ", " << name_of(structure);
            }
        }
    }
}

}  // namespace
}  // namespace lacuna
