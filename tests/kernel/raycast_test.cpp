// Every kernel against the double-precision reference renderer, and every structure against none.
#include <gtest/gtest.h>

#include "core/accuracy/image_error.h"
#include "core/render/reference_renderer.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

Plan brute_force() {
    Plan plan;
    plan.structure = Structure::none;
    plan.ert = 0;
    return plan;
}

const ViewMode k_modes[] = {ViewMode::iso,  ViewMode::ea,    ViewMode::mip,
                            ViewMode::lmip, ViewMode::minip, ViewMode::mean};

struct Case {
    std::string name;
    Scene scene;
    Plan plan = brute_force();
};

std::vector<Case> make_cases() {
    std::vector<Case> cases;
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (ViewMode mode : k_modes) {
            Case c{v.name + "_" + std::string(name_of(mode)), test::small_scene(v.volume, mode)};
            cases.push_back(c);
            if (v.name == "odd_u8" || v.name == "i16_oblique" || v.name == "u16_1_1_5") {
                Case near_one = c;
                near_one.name += "_nearest";
                near_one.plan.sampler = Sampler::nearest;
                cases.push_back(near_one);
                Case far = c;
                far.name += "_perspective";
                far.scene.camera.fov_deg = 50;
                far.scene.camera.zoom = 1.7;
                cases.push_back(far);
                const glm::dvec3 centre = v.volume.geometry().centre_mm();
                Case cut = c;
                cut.name += "_cut";
                const glm::dvec3 normal(0.3, 1, -0.2);
                cut.scene.cuts = {{normal, -glm::dot(normal, centre), true}, {{-1, 0.1, 0}, centre.x + 4, false}};
                cases.push_back(cut);
                Case open = cut;
                open.name += "_open";
                open.scene.cuts[0].cap = false;
                cases.push_back(open);
                Case ranged = c;
                ranged.name += "_ranges";
                const double lo = c.scene.window.lo, w = c.scene.window.width();
                ranged.scene.iso = lo;
                ranged.scene.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}},
                                                      {"b", {lo + 0.6 * w, lo + 0.9 * w}, {}}};
                TransferFunction own{"own", 1.0, {{lo, {1, 0, 0}, 0.3}, {lo + w, {0, 1, 0}, 0.6}}, {}};
                ranged.scene.classification.ranges[1].tf = own;
                cases.push_back(ranged);
            }
            if (mode == ViewMode::ea && v.name == "u16_1_1_5") {
                Case faded = c;
                faded.name += "_gradient_opacity";
                faded.scene.classification.tf.gradient_opacity = {{0, 0.1}, {4000, 1.0}};
                cases.push_back(faded);
            }
        }
    return cases;
}

/// One ray a work-item is the same source with another width: it is held against the truth on two voxel types.
std::vector<int> lanes_for(const Case& c) {
    return c.name.starts_with("odd_u8") || c.name.starts_with("nan") ? std::vector<int>{16, 1} : std::vector<int>{16};
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Raycast : public testing::TestWithParam<Case> {
protected:
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

TEST_P(Raycast, EqualsTheReferenceRenderer) {
    const Case& c = GetParam();
    const Frame truth = render_reference(c.scene, c.plan);
    for (int lanes : lanes_for(c)) {
        const Frame frame = test::renderer(lanes).render(c.scene, c.plan, {}, false).frame;
        ASSERT_EQ(frame.size, truth.size);
        const ImageError error = compare(frame, truth, {0, 0, 0});
        // Single precision moves samples by about 1e-5 voxels: a handful of edge pixels may turn, the rest may not.
        // Nearest sampling turns whole voxels at once.
        const double allowed = c.plan.sampler == Sampler::nearest ? 0.01 : 0.004;
        EXPECT_LE(test::share_over(frame, truth, 2.0), allowed) << "lanes " << lanes << " max " << error.max;
        EXPECT_LE(error.mean, 0.15) << "lanes " << lanes << " max " << error.max;
    }
}

TEST_P(Raycast, MacrocellsChangeNothing) {
    const Case& c = GetParam();
    // Counting kernels are kernels of their own to compile: one voxel type shows that the counters are right.
    const bool count = c.name.starts_with("u16");
    const Frame plain = test::renderer(16).render(c.scene, c.plan, {}, count).frame;
    Plan skipping = c.plan;
    skipping.structure = Structure::macrocells;
    for (int lanes : lanes_for(c)) {
        const Frame frame = test::renderer(lanes).render(c.scene, skipping, {}, count).frame;
        EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4) << "lanes " << lanes;
        EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << "lanes " << lanes;
        if (!count) continue;
        EXPECT_EQ(frame.counters.rays, plain.counters.rays);
        EXPECT_LE(frame.counters.samples, plain.counters.samples);
        EXPECT_GT(frame.counters.structure_reads, 0u);
        if (c.scene.mode != ViewMode::mean && frame.counters.samples < plain.counters.samples) {
            EXPECT_GT(frame.counters.skipped, 0u);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, Raycast, testing::ValuesIn(make_cases()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& ch : name)
        if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
    return name;
});

TEST(Macrocells, SkipMostOfAnEmptyScene) {
    LACUNA_NEEDS_DEVICE();
    const Volume balls = make_sample("spheres", {.size = 96}).volume;
    const Scene scene = test::small_scene(balls, ViewMode::ea, {128, 128});
    Plan plan = brute_force();
    const Frame plain = test::renderer(16).render(scene, plan, {}, true).frame;
    plan.structure = Structure::macrocells;
    const Frame skipping = test::renderer(16).render(scene, plan, {}, true).frame;
    EXPECT_LT(double(skipping.counters.samples), 0.7 * double(plain.counters.samples));
    EXPECT_GT(double(skipping.counters.skipped), 0.3 * double(plain.counters.samples));
}

TEST(Cancel, AStoppedFrameThrowsAndLeavesTheRendererUsable) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({64, 64, 64}, {1, 1, 1}, 60000);
    const Scene scene = test::small_scene(ball, ViewMode::mean, {512, 512});
    std::stop_source source;
    JobContext job{source.get_token(), [&](double f) {
                       if (f > 0.2) source.request_stop();
                   }};
    Plan plan = brute_force();
    plan.step = 0.05;
    OpenClRenderer own(test::device());
    try {
        own.render(scene, plan, job, false);
        FAIL() << "a stopped frame was returned";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::cancelled);
    }
    plan.step = 0.5;
    EXPECT_EQ(own.render(scene, plan, {}, false).frame.size, glm::ivec2(512, 512));
}

TEST(Determinism, SameBytesTwice) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::int16_t>({50, 51, 52}, {1, 1, 1}, 3000, -1000);
    for (ViewMode mode : k_modes) {
        const Scene scene = test::small_scene(ball, mode);
        const Plan plan = default_plan(scene);
        const Frame a = test::renderer(16).render(scene, plan, {}, false).frame;
        const Frame b = test::renderer(16).render(scene, plan, {}, false).frame;
        EXPECT_TRUE(a.color == b.color && a.depth_mm == b.depth_mm) << name_of(mode);
    }
}

}  // namespace
}  // namespace lacuna
