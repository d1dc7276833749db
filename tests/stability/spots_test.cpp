// One-voxel spots in the projections: how much of them the samples miss, along axes and across, on cubic and flat
// voxels.
#include <gtest/gtest.h>

#include "tests/stability/failure_scenes.h"

namespace lacuna {
namespace {

using namespace test;

constexpr double k_height = 200;

struct View {
    const char* name;
    double azimuth_deg, elevation_deg;
};
constexpr View k_views[] = {{"along y", 0, 0},
                            {"along x", 90, 0},
                            {"along z", 0, 90},
                            {"edge diagonal", 45, 0},
                            {"body diagonal", 45, 35.264389682754654},
                            {"oblique", 33, 21}};

/// A voxel of 220 among 20, or of 20 among 220 where `dark`, seen close up.
Scene spot(ViewMode mode, glm::dvec3 spacing, const View& view, bool dark) {
    const Volume volume = sampled<std::uint8_t>(centred({15, 15, 7}, spacing), [&](const glm::dvec3& mm) {
        return (glm::length(mm) < 0.1) != dark ? 220 : 20;
    });
    Scene scene = scene_of(volume, mode, 33);
    scene.window = {0, 255};
    scene.lmip_threshold = 1000;  // none is so bright: the largest sample
    scene.camera.azimuth_deg = view.azimuth_deg;
    scene.camera.elevation_deg = view.elevation_deg;
    scene.camera.zoom = volume.geometry().diameter_mm() / 3;
    return scene;
}

/// What a sample lattice of `step` loses of the spot at most, as a share of its height: a ray's nearest sample lies
/// half a step off, and the trilinear spot falls by its distance along each axis.
double bound(const Scene& scene, double step) {
    const GridGeometry& grid = scene.volume.geometry();
    const glm::dvec3 d = resolve(scene.camera, grid, scene.size).forward;
    double left = 1;
    for (int axis = 0; axis < 3; ++axis)
        left *= std::max(0.0, 1 - 0.5 * step * grid.smallest_spacing_mm() * std::fabs(d[axis]) / grid.spacing[axis]);
    return 1 - left;
}

/// The largest loss over all rays, as a share of the spot's height, against 64 samples a voxel.
double loss(const Scene& scene, const Frame& frame) {
    static Scene last;
    static Frame fine;
    if (last.volume.identity() != scene.volume.identity() || last.mode != scene.mode || !(last.camera == scene.camera))
        fine = render_reference(last = scene, brute_force(1.0 / 64));
    double worst = 0;
    for (std::size_t i = 0; i < frame.pixels(); ++i)
        worst = std::max(worst, std::fabs(double(frame.color[i].r) - double(fine.color[i].r)) * 255 / k_height);
    return worst;
}

/// The spot itself as shown, 1: whole.
double shown(const Frame& frame, bool dark) {
    double best = 0;
    for (const glm::vec4& c : frame.color) {
        const double value = c.a > 0 ? 255.0 * double(c.r) : (dark ? 220.0 : 20.0);
        best = std::max(best, (dark ? 220 - value : value - 20) / k_height);
    }
    return best;
}

TEST(Spots, SamplesLoseNoMoreThanTheBoundAndAlmostThatMuch) {
    LACUNA_NEEDS_DEVICE();
    for (const ViewMode mode : {ViewMode::mip, ViewMode::lmip, ViewMode::minip})
        for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 5)}) {
            const bool dark = mode == ViewMode::minip;
            double worst_at[3] = {0, 0, 0};
            for (const View& view : k_views) {
                const Scene scene = spot(mode, spacing, view, dark);
                const double steps[] = {0.25, 0.5, 1};
                for (int i = 0; i < 3; ++i) {
                    SCOPED_TRACE(testing::Message()
                                 << name_of(mode) << " " << view.name << ", z " << spacing.z << ", step " << steps[i]);
                    const double lost = loss(scene, on_device(scene, brute_force(steps[i])));
                    EXPECT_LE(lost, bound(scene, steps[i]) + 0.01);
                    worst_at[i] = std::max(worst_at[i], lost);
                }
            }
            EXPECT_GT(worst_at[0], 0.10) << "a quarter of a voxel loses an eighth of a spot";
            EXPECT_GT(worst_at[1], 0.22) << "half a voxel a quarter";
            EXPECT_GT(worst_at[2], 0.35) << "a voxel more than a third";
        }
}

TEST(Spots, NearestSamplesShowThemWhole) {
    LACUNA_NEEDS_DEVICE();
    for (const ViewMode mode : {ViewMode::mip, ViewMode::lmip, ViewMode::minip})
        for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 5)})
            for (const View& view : k_views) {
                const bool dark = mode == ViewMode::minip;
                const Scene scene = spot(mode, spacing, view, dark);
                for (const double step : {0.25, 0.5, 1.0}) {
                    Plan plan = brute_force(step);
                    plan.sampler = Sampler::nearest;
                    EXPECT_NEAR(shown(on_device(scene, plan), dark), 1, 0.005)
                        << name_of(mode) << " " << view.name << ", z " << spacing.z << ", step " << step;
                }
            }
}

TEST(Spots, LocalMaximaBelowTheThresholdAreLost) {
    LACUNA_NEEDS_DEVICE();
    // Nine tenths of the spot are asked for: half a voxel's samples see three quarters along an axis.
    Scene scene = spot(ViewMode::lmip, glm::dvec3(1), k_views[0], false);
    auto* voxels = reinterpret_cast<std::uint8_t*>(scene.volume.buffer().data());
    voxels[scene.volume.geometry().linear_index(7, 11, 3)] = 240;  // brighter, behind the spot
    scene.lmip_threshold = 200;
    const auto middle_depth = [&](const Plan& plan) {
        return double(on_device(scene, plan).depth_mm[std::size_t(16 * 33 + 16)]);
    };
    const double spot_mm = 0.5 * scene.volume.geometry().diameter_mm();
    EXPECT_GT(middle_depth(brute_force(0.5)), spot_mm + 3) << "the spot is passed over";
    Plan nearest = brute_force(0.5);
    nearest.sampler = Sampler::nearest;
    EXPECT_NEAR(middle_depth(nearest), spot_mm, 1);
}

TEST(Spots, NoStructureLosesMore) {
    LACUNA_NEEDS_DEVICE();
    for (const ViewMode mode : {ViewMode::mip, ViewMode::lmip, ViewMode::minip})
        for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 5)}) {
            const Scene scene = spot(mode, spacing, k_views[5], mode == ViewMode::minip);
            const Frame plain = on_device(scene, brute_force(0.5));
            for (const Structure structure : casting_structures())
                EXPECT_LE(worst_levels(on_device(scene, with_structure(structure)), plain), 0.5)
                    << name_of(mode) << " " << name_of(structure) << " z " << spacing.z;
        }
}

}  // namespace
}  // namespace lacuna
