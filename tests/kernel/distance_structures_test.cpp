// The distance structures pc, acd and eacd against brute force on the same device.
#include <gtest/gtest.h>

#include "core/compute/device.h"
#include "core/render/opencl_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

std::shared_ptr<ComputeDevice> device() {
    static const std::shared_ptr<ComputeDevice> opened = open_device();
    return opened;
}

OpenClRenderer& renderer(int lanes) {
    static OpenClRenderer packets(device(), 16), single(device(), 1);
    return lanes == 16 ? packets : single;
}

Plan plan_for(Structure structure, int cells) {
    Plan plan;
    plan.structure = structure;
    plan.cells = cells;
    plan.ert = 0;
    return plan;
}

/// Share of pixels in which any channel differs by more than `levels`/255.
double share_over(const Frame& a, const Frame& b, double levels) {
    std::size_t over = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const glm::vec4 d = glm::abs(a.color[i] - b.color[i]) * 255.0f;
        over += !(std::max({d.r, d.g, d.b, d.a}) <= float(levels));
    }
    return double(over) / double(a.pixels());
}

double mean_difference(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const glm::vec4 d = glm::abs(a.color[i] - b.color[i]);
        sum += double(std::max({d.r, d.g, d.b, d.a}));
    }
    return 255 * sum / double(a.pixels());
}

const ViewMode k_modes[] = {ViewMode::iso,  ViewMode::ea,    ViewMode::mip,
                            ViewMode::lmip, ViewMode::minip, ViewMode::mean};

struct Case {
    std::string name;
    Scene scene;
    std::vector<int> lanes{16};
    std::vector<Structure> structures{Structure::pc};
};

/// The scene from beside, in perspective, cut with and without caps.
void add_views(const Case& c, std::vector<Case>& cases) {
    const auto add = [&](const char* name) -> Scene& {
        cases.push_back(c);
        cases.back().lanes = {16};
        cases.back().name += name;
        return cases.back().scene;
    };
    Scene& far = add("_perspective");
    far.camera.fov_deg = 60;
    far.camera.zoom = 1.7;
    far.camera.azimuth_deg = 0;  // rays of one packet run into different octants
    far.camera.elevation_deg = 0;
    const glm::dvec3 centre = c.scene.volume.geometry().centre_mm(), normal(0.3, 1, -0.2);
    for (const bool cap : {true, false})
        add(cap ? "_cut" : "_open").cuts = {{normal, -glm::dot(normal, centre), cap},
                                            {{-1, 0.1, 0}, centre.x + 4, false}};
    if (c.name.starts_with("u16")) return;
    const double lo = c.scene.window.lo, w = c.scene.window.width();
    Scene& ranged = add("_ranges");
    cases.back().structures = {Structure::pc};
    ranged.iso = lo;
    ranged.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}}, {"b", {lo + 0.6 * w, lo + 0.9 * w}, {}}};
}

/// Every voxel type in three modes, one in all; every variant of a kernel takes a second to compile.
std::vector<Case> make_cases() {
    std::vector<Case> cases;
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (const ViewMode mode : k_modes) {
            const bool principal = mode == ViewMode::iso || mode == ViewMode::ea, all = v.name == "odd_u8";
            if (!all && !principal && mode != ViewMode::mip) continue;
            Case c{v.name + "_" + std::string(name_of(mode)), test::small_scene(v.volume, mode)};
            if (principal && (all || v.name == "nan_f32")) c.lanes = {16, 1};
            if ((all && (principal || mode == ViewMode::mip)) || (v.name == "u16_1_1_5" && principal))
                c.structures = {Structure::pc, Structure::acd, Structure::eacd};
            cases.push_back(c);
            if (c.structures.size() > 1) add_views(c, cases);
        }
    return cases;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Distances : public testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        if (!device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    }
};

TEST_P(Distances, OverMacrocellsChangeNothing) {
    const Case& c = GetParam();
    const Frame plain = renderer(16).render(c.scene, plan_for(Structure::none, 8), {}, false).frame;
    for (const Structure structure : c.structures)
        for (const int lanes : c.lanes)
            for (const int cells : {4, 8}) {
                const Frame frame = renderer(lanes).render(c.scene, plan_for(structure, cells), {}, false).frame;
                EXPECT_LE(share_over(frame, plain, 0.5), 1e-4)
                    << name_of(structure) << " lanes " << lanes << " cells " << cells;
                EXPECT_LE(share_over(frame, plain, 1.0), 0)
                    << name_of(structure) << " lanes " << lanes << " cells " << cells;
            }
}

INSTANTIATE_TEST_SUITE_P(Kernels, Distances, testing::ValuesIn(make_cases()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& ch : name)
        if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
    return name;
});

/// A few balls in a large empty volume.
const Volume& sparse_volume() {
    static const Volume balls = make_sample("spheres", {.size = 96}).volume;
    return balls;
}

TEST(DistanceStructures, AskLessTheMoreTheyKnow) {
    if (!device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    const Scene scene = test::small_scene(sparse_volume(), ViewMode::ea, {128, 128});
    const auto count = [&](Structure s) { return renderer(16).render(scene, plan_for(s, 4), {}, true).frame.counters; };
    Plan eight = plan_for(Structure::macrocells, 8);
    const Counters plain = count(Structure::none), cells = renderer(16).render(scene, eight, {}, true).frame.counters;
    const Counters pc = count(Structure::pc), acd = count(Structure::acd), eacd = count(Structure::eacd);
    EXPECT_LT(double(pc.samples), 0.6 * double(plain.samples));
    EXPECT_LT(pc.samples, cells.samples);  // smaller cells, fewer samples, and still fewer questions
    EXPECT_LT(pc.structure_reads, cells.structure_reads);
    EXPECT_LT(acd.structure_reads, pc.structure_reads);
    EXPECT_LT(eacd.structure_reads, acd.structure_reads);
    EXPECT_EQ(pc.rays, plain.rays);
    EXPECT_GT(pc.skipped, 0u);
}

TEST(DistanceStructures, AskOnceWhereNothingCanBeSkipped) {
    if (!device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    Scene fog = test::small_scene(sparse_volume(), ViewMode::ea, {128, 128});
    fog.classification.tf = {"fog", 1.0, {{0, {1, 1, 1}, 0.001}, {1, {1, 1, 1}, 0.001}}, {}};
    const Counters made = renderer(16).render(fog, plan_for(Structure::pc, 8), {}, true).frame.counters;
    EXPECT_EQ(made.skipped, 0u);
    EXPECT_LT(made.structure_reads, 2 * made.rays);
}

TEST(DistanceStructures, FollowEveryEdit) {
    if (!device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    OpenClRenderer own(device());
    Scene scene = test::small_scene(sparse_volume(), ViewMode::iso);
    const Plan plan = plan_for(Structure::pc, 8);
    EXPECT_GT(own.render(scene, plan, {}, false).build.at("pc").bytes, 0u);
    EXPECT_EQ(own.render(scene, plan, {}, false).build.at("pc").ms, 0) << "the cached one serves";
    scene.iso *= 0.5;
    const RenderResult edited = own.render(scene, plan, {}, false);
    EXPECT_GT(edited.build.at("pc").ms, 0);
    const Frame fresh = renderer(16).render(scene, plan_for(Structure::none, 8), {}, false).frame;
    EXPECT_LE(share_over(edited.frame, fresh, 1.0), 0);
    EXPECT_GT(own.render(scene, plan_for(Structure::pc, 4), {}, false).build.at("pc").ms, 0) << "other cells";
}

TEST(DistanceStructures, AStoppedBuildLeavesNothing) {
    if (!device()) GTEST_SKIP() << "skipped: no usable OpenCL device";
    OpenClRenderer own(device());
    const Scene scene = test::small_scene(sparse_volume(), ViewMode::ea);
    std::stop_source source;
    const JobContext job{source.get_token(), [&](double) { source.request_stop(); }};
    try {
        own.render(scene, plan_for(Structure::eacd, 4), job, false);
        FAIL() << "a stopped frame was returned";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::cancelled);
    }
    const RenderResult after = own.render(scene, plan_for(Structure::eacd, 4), {}, false);
    EXPECT_GT(after.build.at("eacd").ms, 0);
    const Frame plain = renderer(16).render(scene, plan_for(Structure::none, 8), {}, false).frame;
    EXPECT_LE(share_over(after.frame, plain, 1.0), 0);
}

}  // namespace
}  // namespace lacuna
