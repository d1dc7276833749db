// Exact ray/cell intersection: against the reference's independent solution, behind every structure, and on walls too
// thin for samples.
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "core/render/reference_renderer.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

const Structure k_structures[] = {Structure::macrocells, Structure::octree, Structure::pyramid,
                                  Structure::pc,         Structure::acd,    Structure::eacd};

Plan cubic(double step = 0.5) {
    Plan plan;
    plan.structure = Structure::none;
    plan.step = step;
    plan.refine = Refinement::cubic;
    return plan;
}

Frame render(const Scene& scene, const Plan& plan, int lanes = 16, bool count = false) {
    check(plan, scene);
    return test::renderer(lanes).render(scene, plan, {}, count).frame;
}

/// Scenes on a volume: plain, perspective, through a capped and an open cut, under ranges.
std::vector<Scene> scenes_on(const test::NamedVolume& v) {
    Scene plain = test::small_scene(v.volume, ViewMode::iso);
    std::vector<Scene> scenes{plain};
    if (v.name != "u16_1_1_5" && v.name != "nan_f32") return scenes;
    Scene far = plain;
    far.camera.fov_deg = 50;
    far.camera.zoom = 1.7;
    scenes.push_back(far);
    for (bool capped : {true, false}) {
        Scene cut = plain;
        const glm::dvec3 normal(0.3, 1, -0.2);
        cut.cuts = {{normal, -glm::dot(normal, v.volume.geometry().centre_mm()), capped}};
        scenes.push_back(cut);
        Scene ranged = cut;
        const double lo = plain.window.lo, w = plain.window.width();
        ranged.iso = lo;
        ranged.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}},
                                        {"b", {lo + 0.45 * w, lo + 0.5 * w}, {}},
                                        {"c", {lo + 0.6 * w, lo + 0.9 * w}, {}}};
        scenes.push_back(ranged);
    }
    return scenes;
}

/// Largest depth difference where both hit, in mm, and the share of pixels that only one hits.
struct DepthDifference {
    double worst = 0, one_sided = 0;
};
DepthDifference depth_difference(const Frame& a, const Frame& b, double share = 0) {
    std::vector<double> all;
    DepthDifference d;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const bool hit_a = std::isfinite(a.depth_mm[i]), hit_b = std::isfinite(b.depth_mm[i]);
        if (hit_a != hit_b) d.one_sided += 1.0 / double(a.pixels());
        if (hit_a && hit_b) all.push_back(std::fabs(double(a.depth_mm[i]) - double(b.depth_mm[i])));
    }
    std::sort(all.begin(), all.end());
    if (!all.empty()) d.worst = all[std::size_t(double(all.size() - 1) * (1 - share))];
    return d;
}

TEST(Cubic, EqualsTheReferencesOwnSolution) {
    LACUNA_NEEDS_DEVICE();
    for (const test::NamedVolume& v : test::ugly_volumes()) {
        int number = 0;
        for (const Scene& scene : scenes_on(v)) {
            SCOPED_TRACE(v.name + " scene " + std::to_string(number++));
            const Frame truth = render_reference(scene, cubic());
            const Frame frame = render(scene, cubic());
            EXPECT_LE(test::share_over(frame, truth, 2.0), 0.004) << compare(frame, truth, {0, 0, 0}).max;
            const DepthDifference d = depth_difference(frame, truth, 0.004);
            EXPECT_LE(d.one_sided, 0.002);
            EXPECT_LE(d.worst, 1e-3 * v.volume.geometry().smallest_spacing_mm());
        }
    }
}

TEST(Cubic, OneRayAWorkItemIsTheSame) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = test::small_scene(test::ugly_volumes()[4].volume, ViewMode::iso);
    EXPECT_LE(test::share_over(render(scene, cubic(), 1), render(scene, cubic(), 16), 0.5), 0.001);
}

TEST(Cubic, TheStepDecidesNothing) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = test::small_scene(test::ugly_volumes()[2].volume, ViewMode::iso);
    const Frame fine = render(scene, cubic(0.3));
    for (double step : {1.0, 3.7, 20.0})
        EXPECT_LE(test::share_over(render(scene, cubic(step)), fine, 1.0), 0.001) << step;
}

TEST(Cubic, EveryStructureChangesNothing) {
    LACUNA_NEEDS_DEVICE();
    const auto volumes = test::ugly_volumes();
    for (const std::size_t which : {std::size_t(2), std::size_t(4)}) {  // u16 1:1:5, NaN
        std::vector<Scene> scenes = scenes_on(volumes[which]);
        for (Structure structure : k_structures) {
            if (which == 4 && structure != Structure::pyramid && structure != Structure::acd) continue;
            for (std::size_t i = 0; i < scenes.size(); ++i) {
                for (double step : {0.5, 2.3}) {
                    SCOPED_TRACE(volumes[which].name + " " + std::string(name_of(structure)) + " scene " +
                                 std::to_string(i) + " step " + std::to_string(step));
                    Plan plan = cubic(step);
                    const Frame plain = render(scenes[i], plan);
                    plan.structure = structure;
                    const Frame frame = render(scenes[i], plan);
                    EXPECT_LE(test::share_over(frame, plain, 1.0), 4e-4);
                    EXPECT_LE(depth_difference(frame, plain, 4e-4).worst, 1e-3);
                }
            }
        }
    }
}

TEST(Cubic, StructuresSaveCells) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = test::small_scene(make_sample("vessels", {.size = 96}).volume, ViewMode::iso, {192, 192});
    const std::uint64_t all = render(scene, cubic(), 16, true).counters.samples;
    Plan plan = cubic();
    plan.structure = Structure::acd;
    const Frame frame = render(scene, plan, 16, true);
    EXPECT_LT(double(frame.counters.samples), 0.6 * double(all));
    EXPECT_GT(frame.counters.structure_reads, 0u);
}

/// One layer of voxels of value 1000 in a volume of 0: under the isovalue 1000 (1 - w/2) a wall w voxels thick.
Scene wall_scene(double thickness) {
    GridGeometry grid;
    grid.size = {40, 33, 40};
    const Volume wall = make_volume<std::uint16_t>(grid, [&](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = (i / 40) % 33 == 16 ? 1000 : 0;
    });
    Scene scene = test::small_scene(wall, ViewMode::iso, {120, 120});
    scene.iso = 1000 * (1 - 0.5 * thickness);
    scene.camera.azimuth_deg = 17;
    scene.camera.elevation_deg = 11;
    scene.camera.fov_deg = 70;  // samples meet the wall at every phase
    return scene;
}

// A wall of thickness w is missed between samples a step s apart with probability 1 - w/s; an exact one never.
TEST(Cubic, FindsWallsThatSamplesMiss) {
    LACUNA_NEEDS_DEVICE();
    for (double w : {0.1, 0.25, 0.5, 0.8, 1.0}) {
        const Scene scene = wall_scene(w);
        const GridGeometry& grid = scene.volume.geometry();
        const ViewRays rays = resolve(scene.camera, grid, scene.size);
        std::vector<std::pair<std::size_t, double>> sees;  // pixels well inside the wall, and the way's share across it
        for (int y = 0; y < scene.size.y; ++y)
            for (int x = 0; x < scene.size.x; ++x) {
                const glm::dvec3 o = grid.mm_to_voxel(rays.origin(x, y)), d = rays.direction(x, y);
                const glm::dvec3 at = o + (16 - o.y) / d.y * d;
                if (at.x > 2 && at.x < 37 && at.z > 2 && at.z < 37)
                    sees.push_back({std::size_t(y) * std::size_t(scene.size.x) + std::size_t(x), d.y});
            }
        ASSERT_GT(sees.size(), 1000u);
        const auto missed = [&](const Frame& frame) {
            std::size_t count = 0;
            for (const auto& [pixel, across] : sees) count += std::isinf(frame.depth_mm[pixel]);
            return double(count) / double(sees.size());
        };
        for (double step : {1.0, 2.0}) {
            Plan plan = cubic(step);
            EXPECT_EQ(missed(render(scene, plan)), 0) << w;
            for (Structure structure : {Structure::pyramid, Structure::acd}) {
                plan.structure = structure;
                EXPECT_EQ(missed(render(scene, plan)), 0) << w << " " << name_of(structure);
            }
            plan.structure = Structure::none;
            EXPECT_EQ(missed(render_reference(scene, plan)), 0) << w;
            plan.refine = Refinement::regula_falsi;
            double expected = 0;
            for (const auto& [pixel, across] : sees) expected += std::max(0.0, 1 - w / (across * step));
            EXPECT_NEAR(missed(render(scene, plan)), expected / double(sees.size()), 0.06 + 0.06 * step)
                << w << " step " << step;
        }
    }
}

TEST(Cubic, DepthIsExactToRounding) {
    LACUNA_NEEDS_DEVICE();
    for (const char* name : {"marschner-lobb", "spheres"}) {
        const Scene scene = test::small_scene(make_sample(name, {.size = 41}).volume, ViewMode::iso, {96, 96});
        const double voxel = scene.volume.geometry().smallest_spacing_mm();
        const Frame truth = render_reference(scene, cubic());
        const Frame frame = render(scene, cubic());
        const DepthDifference exact = depth_difference(frame, truth, 0.005);
        EXPECT_LT(exact.worst, 2e-4 * voxel) << name;
        EXPECT_LT(exact.one_sided, 0.002) << name;
        Plan sampled = cubic();
        sampled.refine = Refinement::none;
        EXPECT_GT(depth_difference(render(scene, sampled), truth, 0.005).worst, 100 * exact.worst) << name;
    }
}

TEST(Cubic, GoesWithTheLinearSamplerAlone) {
    const Scene scene = test::small_scene(test::ugly_volumes()[0].volume, ViewMode::iso);
    Plan plan = cubic();
    for (Sampler sampler : {Sampler::nearest, Sampler::adaptive}) {
        plan.sampler = sampler;
        EXPECT_THROW(check(plan, scene), Error);
    }
}

}  // namespace
}  // namespace lacuna
