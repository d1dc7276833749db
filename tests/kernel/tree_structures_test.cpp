// The trees (octree, pyramid) change no picture: every mode against brute force on ugly volumes, and what their
// counters, their homogeneity and their builds promise.
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

Plan with(Structure structure) {
    Plan plan;
    plan.structure = structure;
    plan.ert = 0;
    return plan;
}

struct Case {
    std::string name;
    Scene scene;
    Structure structure;
    Sampler sampler = Sampler::linear;
};

/// Plateaus that homogeneous nodes can be found in, seen through each other.
Volume plateaus() {
    GridGeometry grid;
    grid.size = {70, 61, 53};
    return make_volume<std::uint16_t>(grid, [&](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            const int x = int(i % 70), y = int(i / 70 % 61), z = int(i / (70 * 61));
            const bool box = x > 9 && x < 60 && y > 5 && y < 56 && z > 3 && z < 48, core = box && x > 30 && z > 20;
            voxels[i] = std::uint16_t(core ? 50000 : box ? 30000 : 900);
        }
    });
}

Scene see_through(const Volume& volume, Shading shading) {
    Scene scene = test::small_scene(volume, ViewMode::ea);
    scene.classification = {};
    scene.classification.tf = {
        "glass", 1.0, {{5000, {0, 0, 0}, 0}, {20000, {0.9, 0.5, 0.2}, 0.03}, {60000, {0.2, 0.6, 0.9}, 0.1}}, {}};
    scene.shading = shading;
    return scene;
}

/// A kernel takes about a second to compile, and traversal does not know the voxel type: the MIP family, ranges and
/// nearest sampling are held on one type of whole numbers and one of floats.
std::vector<Case> make_cases() {
    std::vector<Case> cases;
    for (const Structure structure : {Structure::octree, Structure::pyramid}) {
        const std::string tree = "_" + std::string(name_of(structure));
        for (const test::NamedVolume& v : test::ugly_volumes()) {
            const VoxelType type = v.volume.type();
            for (const ViewMode mode :
                 {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::lmip, ViewMode::minip, ViewMode::mean}) {
                const bool solid = mode == ViewMode::iso || mode == ViewMode::ea;
                // Bits hold no ranges: without segmentation ranges the pyramid is one for the whole MIP family.
                const bool projection =
                    type == VoxelType::u16 && (structure == Structure::octree || mode == ViewMode::mip);
                if (!solid && !projection) continue;
                const Case c{v.name + "_" + std::string(name_of(mode)) + tree, test::small_scene(v.volume, mode),
                             structure};
                cases.push_back(c);
                if (solid) {
                    const glm::dvec3 centre = v.volume.geometry().centre_mm(), normal(0.3, 1, -0.2);
                    for (const bool cap : {true, false}) {
                        Case cut = c;
                        cut.name += cap ? "_cut" : "_open";
                        cut.scene.cuts = {{normal, -glm::dot(normal, centre), cap},
                                          {{-1, 0.1, 0}, centre.x + 4, false}};
                        cases.push_back(cut);
                    }
                    Case far = c;
                    far.name += "_perspective";
                    far.scene.camera.fov_deg = 60;
                    far.scene.camera.zoom = 3;
                    cases.push_back(far);
                }
                if (v.name != "u16_1_1_5" && (v.name != "nan_f32" || mode != ViewMode::iso)) continue;
                if (solid && v.name == "u16_1_1_5") {
                    Case nearest = c;
                    nearest.name += "_nearest";
                    nearest.sampler = Sampler::nearest;
                    cases.push_back(nearest);
                }
                Case ranged = c;
                ranged.name += "_ranges";
                const double lo = c.scene.window.lo, w = c.scene.window.width();
                ranged.scene.iso = lo;
                ranged.scene.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}},
                                                      {"b", {lo + 0.6 * w, lo + 0.9 * w}, {}}};
                cases.push_back(ranged);
            }
        }
        for (const Shading shading : {Shading::none, Shading::phong})
            cases.push_back({std::string("plateaus_") + (shading == Shading::none ? "plain" : "shaded") + tree,
                             see_through(plateaus(), shading), structure});
        Case faded = cases.back();
        faded.name = "plateaus_gradient_opacity" + tree;
        faded.scene.classification.tf.gradient_opacity = {{0, 0.1}, {4000, 1.0}};
        cases.push_back(faded);
    }
    return cases;
}

std::vector<int> lanes_for(const Case& c) {
    return c.name.starts_with("odd_u8") || c.name.starts_with("plateaus_plain") ? std::vector<int>{16, 1}
                                                                                : std::vector<int>{16};
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Trees : public testing::TestWithParam<Case> {
protected:
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

TEST_P(Trees, ChangeNothing) {
    const Case& c = GetParam();
    Plan plan = with(Structure::none);
    plan.sampler = c.sampler;
    const Frame plain = test::renderer(16).render(c.scene, plan, {}, false).frame;
    plan.structure = c.structure;
    for (const int lanes : lanes_for(c)) {
        const Frame frame = test::renderer(lanes).render(c.scene, plan, {}, false).frame;
        EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4) << "lanes " << lanes;
        EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << "lanes " << lanes;
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, Trees, testing::ValuesIn(make_cases()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& ch : name)
        if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
    return name;
});

TEST(TreeStructures, CountersShowTheirOwnWork) {
    LACUNA_NEEDS_DEVICE();
    const Volume balls = make_sample("spheres", {.size = 96}).volume;
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea}) {
        const Scene scene = test::small_scene(balls, mode, {128, 128});
        const Counters plain = test::renderer(16).render(scene, with(Structure::none), {}, true).frame.counters;
        const Counters cells = test::renderer(16).render(scene, with(Structure::macrocells), {}, true).frame.counters;
        const Counters octree = test::renderer(16).render(scene, with(Structure::octree), {}, true).frame.counters;
        const Counters pyramid = test::renderer(16).render(scene, with(Structure::pyramid), {}, true).frame.counters;
        EXPECT_EQ(octree.rays, plain.rays);
        EXPECT_GT(octree.structure_reads, 0u);
        EXPECT_GT(pyramid.structure_reads, 0u);
        EXPECT_LT(octree.structure_reads, cells.structure_reads);  // large nodes, read once a packet
        EXPECT_LT(double(octree.samples), 0.7 * double(plain.samples));
        EXPECT_LT(pyramid.samples, octree.samples);  // cells of single voxels
        EXPECT_GT(octree.skipped, 0u);
        EXPECT_GT(pyramid.skipped, octree.skipped);
    }
}

TEST(TreeStructures, RunsReplaceTheSamplesOfAPlateau) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = see_through(plateaus(), Shading::none);
    scene.size = {192, 192};
    const Counters plain = test::renderer(16).render(scene, with(Structure::none), {}, true).frame.counters;
    const Counters octree = test::renderer(16).render(scene, with(Structure::octree), {}, true).frame.counters;
    EXPECT_LT(double(octree.samples), 0.6 * double(plain.samples));
    EXPECT_NEAR(double(octree.samples + octree.skipped), double(plain.samples), 0.02 * double(plain.samples));
}

TEST(TreeStructures, ErrorGrowsWithTheHomogeneityAskedFor) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({72, 72, 72}, {1, 1, 1}, 60000);
    Scene scene = test::small_scene(ball, ViewMode::ea, {96, 96});
    scene.classification = {};
    scene.classification.tf = {"glass", 1.0, {{500, {0, 0, 0}, 0}, {60000, {1, 0.8, 0.6}, 0.08}}, {}};
    scene.shading = Shading::none;
    const Frame plain = test::renderer(16).render(scene, with(Structure::none), {}, false).frame;
    double last = -1;
    std::uint64_t samples = ~std::uint64_t(0);
    for (const double threshold : {0.0, 600.0, 3000.0, 12000.0, 30000.0}) {
        Plan plan = with(Structure::octree);
        plan.homogeneity = threshold;
        const Frame frame = test::renderer(16).render(scene, plan, {}, true).frame;
        const double mean = compare(frame, plain, {0, 0, 0}).mean;
        RecordProperty("mean_error_at_" + std::to_string(int(threshold)), std::to_string(mean));
        if (threshold == 0) {
            EXPECT_LE(test::share_over(frame, plain, 0.5), 0);
        }
        EXPECT_GE(mean, last) << threshold;
        EXPECT_LE(frame.counters.samples, samples) << threshold;
        last = mean;
        samples = frame.counters.samples;
    }
    EXPECT_GT(last, 0.05);
    EXPECT_LT(last, 20);
}

TEST(TreeStructures, AStoppedBuildLeavesNothingAndTheNextOneWorks) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({64, 64, 64}, {1, 1, 1}, 60000);
    Scene scene = test::small_scene(ball, ViewMode::iso);
    const Frame truth = test::renderer(16).render(scene, with(Structure::none), {}, false).frame;
    for (const Structure structure : {Structure::octree, Structure::pyramid}) {
        OpenClRenderer own(test::device());
        for (const double stop_at : {0.01, 0.5, 0.95}) {
            std::stop_source source;
            const JobContext job{source.get_token(), [&](double f) {
                                     if (f > stop_at) source.request_stop();
                                 }};
            try {
                own.render(scene, with(structure), job, false);
                FAIL() << "a stopped build gave a frame";
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), Errc::cancelled);
            }
        }
        EXPECT_LE(test::share_over(own.render(scene, with(structure), {}, false).frame, truth, 0.5), 1e-4);
        // An edit that is stopped must not pass for the classification before it either.
        Scene edited = scene;
        edited.iso = scene.iso * 0.5;
        std::stop_source source;
        source.request_stop();
        EXPECT_THROW(own.render(edited, with(structure), {source.get_token(), nullptr}, false), Error);
        EXPECT_LE(test::share_over(own.render(scene, with(structure), {}, false).frame, truth, 0.5), 1e-4);
        const Frame after = test::renderer(16).render(edited, with(Structure::none), {}, false).frame;
        EXPECT_LE(test::share_over(own.render(edited, with(structure), {}, false).frame, after, 0.5), 1e-4);
    }
}

}  // namespace
}  // namespace lacuna
