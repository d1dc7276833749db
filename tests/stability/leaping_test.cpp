// The leaping kernel of Frey & Ertl 2009 against brute force, and its known failure: two equal samples are taken for a
// region wherever they occur.
#include <gtest/gtest.h>

#include "core/io/volume_reader.h"
#include "core/regions/regions.h"
#include "core/volume/samples.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"
#include "tests/support/test_data.h"

namespace lacuna {
namespace {

Plan plan_for(Structure structure, Leaping kernel = Leaping::lossless, double homogeneity = 0) {
    Plan plan;
    plan.structure = structure;
    plan.ert = 0;
    plan.homogeneity = homogeneity;
    plan.leap.kernel = kernel;
    plan.leap.min_voxels = 500;
    return plan;
}

/// A block of one value, and stripes along x: rays along x take equal samples there too, in no region large enough.
Scene stripes(glm::ivec3 size = {64, 48, 48}) {
    GridGeometry grid;
    grid.size = size;
    const Volume volume = make_volume<std::uint8_t>(grid, [&](std::span<std::uint8_t> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    voxels[i++] = std::uint8_t(x < 28 ? 100 : 30 + (y * 37 + z * 61) % 7 * 30);
    });
    Scene scene = test::small_scene(volume, ViewMode::ea, {80, 80});
    scene.shading = Shading::none;
    scene.classification.tf = {"t", 1.0, {{30, {1, 0.2, 0}, 0.0}, {120, {0, 1, 0}, 0.02}, {210, {0, 0, 1}, 0.1}}, {}};
    return scene;
}

double worst(const Frame& a, const Frame& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const glm::vec4 d = glm::abs(a.color[i] - b.color[i]);
        most = std::max(most, 255.0 * double(std::max({d.r, d.g, d.b, d.a})));
    }
    return most;
}

TEST(Leaping, EqualSamplesOutsideRegionsFoolThePublishedKernelButNotTheConfirmedOne) {
    LACUNA_NEEDS_DEVICE();
    // Balls without noise: their insides are of one value, but too small to be regions.
    const Volume volume = make_sample("spheres", {.size = 64}).volume;
    Scene scene = default_scene(volume, compute_statistics(volume));
    scene.mode = ViewMode::ea;
    scene.shading = Shading::none;
    scene.size = {160, 160};
    const auto picture = [&](const Plan& plan) { return test::renderer(16).render(scene, plan, {}, true).frame; };
    const Frame truth = picture(plan_for(Structure::none));
    const Frame confirmed = picture(plan_for(Structure::leap, Leaping::confirmed));
    const Frame published = picture(plan_for(Structure::leap, Leaping::published));
    EXPECT_LE(worst(confirmed, truth), 1.0);
    EXPECT_GT(worst(published, truth), 10.0) << "nearest where the edges should be interpolated";
    EXPECT_GT(confirmed.counters.skipped, 0u);
    EXPECT_GT(published.counters.skipped, 0u);
}

TEST(Leaping, ConfirmedEqualsBruteForceFromAllSides) {
    LACUNA_NEEDS_DEVICE();
    std::vector<Scene> scenes = {stripes(), stripes({64, 31, 33})};
    scenes.push_back(
        test::small_scene(test::bumpy_ball<std::int16_t>({50, 51, 52}, {1, 1, 1}, 3000, -1000), ViewMode::ea));
    scenes.push_back(test::small_scene(test::bumpy_ball<std::uint8_t>({40, 41, 25}, {1, 1, 2}, 240), ViewMode::ea));
    scenes.push_back(test::small_scene(test::bumpy_ball<std::uint8_t>({30, 1, 30}, {1, 1, 1}, 240), ViewMode::ea));
    scenes.push_back(test::small_scene(test::bumpy_ball<std::uint8_t>({9, 9, 9}, {1, 1, 1}, 0, 100), ViewMode::ea));
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        Scene& scene = scenes[i];
        scene.shading = Shading::none;
        const glm::dvec3 centre = scene.volume.geometry().centre_mm(), normal(0.3, 1, -0.2);
        for (int view = 0; view < 4; ++view) {
            scene.camera.azimuth_deg = 40.0 * view + 10;
            scene.camera.fov_deg = view == 1 ? std::optional(50.0) : std::nullopt;
            scene.cuts.clear();
            if (view >= 2) scene.cuts = {{normal, -glm::dot(normal, centre), view == 2}};  // rays begin inside regions
            const Frame truth = test::renderer(16).render(scene, plan_for(Structure::none), {}, false).frame;
            for (const int lanes : i == 0 ? std::vector{16, 1} : std::vector{16}) {
                Plan plan = plan_for(Structure::leap, Leaping::confirmed);
                plan.leap.min_voxels = 20;
                const Frame frame = test::renderer(lanes).render(scene, plan, {}, false).frame;
                EXPECT_LE(test::share_over(frame, truth, 0.5), 1e-4) << i << " view " << view << " lanes " << lanes;
                EXPECT_LE(test::share_over(frame, truth, 1.0), 0) << i << " view " << view << " lanes " << lanes;
            }
        }
    }
}

TEST(Leaping, NanStaysNan) {
    LACUNA_NEEDS_DEVICE();
    Volume volume = test::bumpy_ball<float>({33, 34, 35}, {1, 1, 1}, 1);
    auto* voxels = reinterpret_cast<float*>(volume.buffer().data());
    for (int i = 0; i < 300; ++i) voxels[(i * 7919) % (33 * 34 * 35)] = std::nanf("");
    Scene scene = test::small_scene(volume, ViewMode::ea);
    scene.shading = Shading::none;
    Plan plan = plan_for(Structure::leap, Leaping::confirmed);
    plan.leap.quantisation = ValueRange{0, 1};
    const Frame truth = test::renderer(16).render(scene, plan_for(Structure::none), {}, false).frame;
    const Frame frame = test::renderer(16).render(scene, plan, {}, false).frame;
    EXPECT_LE(test::share_over(frame, truth, 1.0), 0) << "15 bits are fine enough for a smooth function";
}

/// Their Table 1, engine, range 0.1: s^3/v^2 = 49554 with the boundary layer's voxels for the surface, 407 holes.
TEST(Leaping, TheEngineHasTheRegionOfThePaper) {
    LACUNA_NEEDS_DATA(file, "industrial/engine/engine.mhd");
    const Volume engine = open_volume(file.string());
    RegionOptions options;
    options.range_width = 0.1;
    options.min_voxels = 8389;  // 0.1 % of the voxels
    const RegionTable table = find_regions(engine, options);
    EXPECT_EQ(table.rows.size(), 8u) << "regions";
    const RegionCharacteristics& metal = table.rows.at(1);
    EXPECT_EQ(metal.holes, 407);
    const LabelGrid grid{engine.geometry().size, engine.geometry().spacing, table.labels.labels->data()};
    const BoundaryList boundary = boundary_list(grid, std::uint32_t(table.rows.size()));
    const double s = double(boundary.first[metal.id + 1] - boundary.first[metal.id]), v = double(metal.voxels);
    EXPECT_NEAR(s * s * s / (v * v), 49554, 0.5);
}

TEST(Leaping, TakesOneLookUpAStepAndLeaps) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = stripes();
    const Counters plain = test::renderer(16).render(scene, plan_for(Structure::none), {}, true).frame.counters;
    for (const Leaping kernel : {Leaping::confirmed, Leaping::published}) {
        const Counters leap =
            test::renderer(16).render(scene, plan_for(Structure::leap, kernel), {}, true).frame.counters;
        EXPECT_EQ(leap.structure_reads, leap.samples) << "one look-up a step";
        EXPECT_EQ(leap.samples + leap.skipped, plain.samples) << "the lattice is not shifted";
        EXPECT_GT(double(leap.skipped), 0.2 * double(plain.samples));
    }
}

}  // namespace
}  // namespace lacuna
