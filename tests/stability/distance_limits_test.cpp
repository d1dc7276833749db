// EACD's five bits an axis: distances saturate at 31 voxels, so that large empty space is crossed in many small jumps.
#include <gtest/gtest.h>

#include "core/accel/distance_field.h"
#include "tests/stability/failure_scenes.h"

namespace lacuna {
namespace {

using namespace test;

/// Empty but for a plate at the far end.
Scene long_way() {
    const Volume volume =
        sampled<std::uint8_t>(centred({24, 300, 24}), [](const glm::dvec3& mm) { return mm.y > 140 ? 200 : 0; });
    Scene scene = scene_of(volume, ViewMode::ea, 33);
    scene.camera.zoom = 20;
    scene.classification.tf.points = {{90, {1, 1, 1}, 0}, {200, {1, 0.5, 0}, 0.5}};
    return scene;
}

Counters counted(const Scene& scene, Structure structure, int cells) {
    Plan plan = with_structure(structure);
    plan.cells = cells;
    return on_device(scene, plan, true).counters;
}

TEST(DistanceLimits, ThirtyOneVoxelsSaturateAndNeverWrap) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = long_way();
    const Frame plain = on_device(scene, brute_force());
    // The published field, a box a voxel, has to ask anew after every 31 voxels; the cubes' seven bits reach farther.
    const Counters eacd = counted(scene, Structure::eacd, 1), acd = counted(scene, Structure::acd, 1);
    const double needed = 280.0 / k_box_limit;
    EXPECT_GE(double(eacd.structure_reads) / double(eacd.rays), needed) << "the published failure";
    EXPECT_LE(double(eacd.structure_reads) / double(eacd.rays), 3 * needed + 12);
    // Cells of 8^3 voxels reach eight times as far, and none of them changes the picture.
    const Counters cells = counted(scene, Structure::eacd, 8);
    EXPECT_LT(2 * cells.structure_reads, eacd.structure_reads);
    for (const Structure structure : {Structure::pc, Structure::acd, Structure::eacd})
        for (const int edge : {1, 4, 8, 16}) {
            Plan plan = with_structure(structure);
            plan.cells = edge;
            EXPECT_LE(worst_levels(on_device(scene, plan), plain), 0.5) << name_of(structure) << " " << edge;
        }
    EXPECT_EQ(acd.rays, eacd.rays);
}

TEST(DistanceLimits, BoxesOfALongEmptyGridHoldTheLimit) {
    RegionGrid grid{{5, 200, 5}, std::vector<std::uint8_t>(5 * 200 * 5, 1)};
    grid.region[std::size_t((2 * 200 + 199) * 5 + 2)] = 0;
    const VoxelBuffer boxes = box_field(grid);
    const auto* entries = reinterpret_cast<const std::uint16_t*>(boxes.data());
    int at_limit = 0;
    for (std::size_t i = 0; i < boxes.size() / 2; ++i) {
        const int y = (entries[i] >> 5) & 31;
        at_limit += y == k_box_limit;
    }
    EXPECT_GT(at_limit, 5 * 100 * 5);
    // A cell 100 before the border cell, looking towards it: 31, not 100 modulo 32.
    const std::size_t before = std::size_t((2 * 200 + 99) * 5 + 2);
    EXPECT_EQ((entries[before] >> 5) & 31, k_box_limit);
}

/// A half-space seen through a keyhole a third of a voxel wide, just before its surface.
Scene half_space(double azimuth_deg) {
    const Volume volume =
        sampled<std::uint8_t>(centred({64, 64, 64}), [](const glm::dvec3& mm) { return mm.y > 0 ? 200 : 0; });
    Scene scene = scene_of(volume, ViewMode::iso, 33);
    scene.iso = 100;
    scene.camera.azimuth_deg = azimuth_deg;
    scene.camera.center_mm = glm::dvec3(0, -0.25, 0);
    scene.camera.zoom = volume.geometry().diameter_mm() / 0.3;
    return scene;
}

TEST(GrazingRays, LookUpMoreAndSkipNothing) {
    LACUNA_NEEDS_DEVICE();
    const Scene square_on = half_space(0), along = half_space(90);
    const Frame plain = on_device(along, brute_force(), true);
    const auto a_ray = [](std::uint64_t count, const Counters& counters) {
        return double(count) / double(counters.rays);
    };
    for (const Structure structure : {Structure::octree, Structure::pyramid}) {
        const Counters few = counted(square_on, structure, 8), many = counted(along, structure, 8);
        EXPECT_GT(a_ray(many.structure_reads, many), 1.8 * a_ray(few.structure_reads, few)) << name_of(structure);
        EXPECT_LE(a_ray(many.structure_reads, many), 64 / 4) << name_of(structure) << ": one in four voxels";
        EXPECT_GT(many.samples, 0.9 * double(plain.counters.samples)) << name_of(structure) << " skips nothing";
        EXPECT_LE(worst_levels(on_device(along, with_structure(structure)), plain), 0.5) << name_of(structure);
    }
}

}  // namespace
}  // namespace lacuna
