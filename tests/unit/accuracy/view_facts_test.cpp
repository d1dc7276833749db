#include "core/accuracy/view_facts.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/base/parallel.h"
#include "core/render/reference_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

using namespace test;

/// A slab of value 100 from z = 12 to 19 in air of value 0.
Scene slab(ViewMode mode) {
    GridGeometry grid;
    grid.size = {33, 31, 32};
    const Volume volume = make_volume<std::uint8_t>(grid, [](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            const std::size_t z = i / (33 * 31);
            voxels[i] = z >= 12 && z < 20 ? 100 : 0;
        }
    });
    Scene scene = small_scene(volume, mode, {64, 64});
    scene.camera = {};
    scene.camera.elevation_deg = 90;  // along z
    scene.classification.tf = {"slab", 1.0, {{0, {1, 1, 1}, 0}, {50, {1, 1, 1}, 0}, {100, {1, 1, 1}, 0.1}}, {}};
    scene.iso = 50;
    return scene;
}

TEST(ViewFacts, CountsAreThoseOfTheReferenceRenderer) {
    const Scene scene = small_scene(bumpy_ball<std::uint16_t>({21, 22, 23}, {1, 1, 2}, 900), ViewMode::mean, {40, 30});
    Plan plan = default_plan(scene);
    const Frame frame = render_reference(scene, plan);
    const ViewFacts facts = measure_view_facts(scene, plan.step, 40 * 30);
    EXPECT_EQ(facts.pixels, 1200);
    EXPECT_EQ(facts.rays, double(frame.counters.rays));
    EXPECT_EQ(facts.whole.samples, double(frame.counters.samples));
    EXPECT_EQ(facts.occupancy(), 1) << "every sample counts in the mean";
    const ViewFacts few = measure_view_facts(scene, plan.step, 300);
    EXPECT_NEAR(few.whole.samples, facts.whole.samples, 0.1 * facts.whole.samples);
}

TEST(ViewFacts, OccupancyRunsAndEndsOfASlab) {
    const ViewFacts facts = measure_view_facts(slab(ViewMode::ea), 0.5);
    const double per_ray = facts.whole.samples / facts.rays;
    EXPECT_NEAR(per_ray, 64, 0.5);
    EXPECT_NEAR(facts.occupancy(), 8.0 / 32, 0.03);
    EXPECT_NEAR(facts.whole.stretches / facts.rays, 2, 1e-9) << "before it and behind it";
    EXPECT_NEAR(facts.whole.empty_run(), 24, 2);
    EXPECT_EQ(facts.seen.samples, facts.whole.samples) << "nothing is opaque";
    EXPECT_GT(facts.value_change, 0);
    Scene opaque = slab(ViewMode::ea);
    opaque.classification.tf.points.back().opacity = 1;
    const ViewFacts ended = measure_view_facts(opaque, 0.5);
    EXPECT_LT(ended.seen.samples, 0.5 * ended.whole.samples);
    EXPECT_EQ(ended.whole.samples, facts.whole.samples);
}

TEST(ViewFacts, AnIsosurfaceEndsAtItsHit) {
    const ViewFacts facts = measure_view_facts(slab(ViewMode::iso), 0.5);
    EXPECT_NEAR(facts.seen.samples / facts.rays, 24, 1.5);  // 12 voxels of air
    EXPECT_NEAR(facts.seen.shown / facts.rays, 1, 1e-9);
}

TEST(ViewFacts, FlatNanAndMissedVolumes) {
    for (const NamedVolume& v : ugly_volumes())
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip}) {
            const ViewFacts facts = measure_view_facts(small_scene(v.volume, mode), 0.5);
            EXPECT_GE(facts.occupancy(), 0) << v.name;
            EXPECT_LE(facts.occupancy(), 1) << v.name;
            EXPECT_LE(facts.seen.samples, facts.whole.samples) << v.name;
            EXPECT_TRUE(std::isfinite(facts.value_change)) << v.name;
        }
    Scene away = slab(ViewMode::ea);
    away.camera.center_mm = glm::dvec3(1e5);
    EXPECT_EQ(measure_view_facts(away, 0.5).rays, 0);
    EXPECT_EQ(measure_view_facts(away, 0.5).whole.empty_run(), 0);
}

TEST(ViewFacts, TheNumberOfThreadsChangesNothing) {
    const Scene scene = slab(ViewMode::ea);
    set_thread_count(1);
    const ViewFacts one = measure_view_facts(scene, 0.3);
    set_thread_count(3);
    const ViewFacts three = measure_view_facts(scene, 0.3);
    set_thread_count(0);
    EXPECT_EQ(one.whole.samples, three.whole.samples);
    EXPECT_EQ(one.value_change, three.value_change);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(measure_view_facts(scene, 0.5, 100, {stop.get_token()}), Error);
}

}  // namespace
}  // namespace lacuna
