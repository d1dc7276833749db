// The distance structures pc, acd and eacd against brute force on the same device.
#include <gtest/gtest.h>

#include "core/render/structure_family.h"
#include "core/volume/samples.h"
#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

Plan plan_for(Structure structure, int cells) {
    Plan plan;
    plan.structure = structure;
    plan.cells = cells;
    plan.ert = 0;
    return plan;
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
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

TEST_P(Distances, OverMacrocellsChangeNothing) {
    const Case& c = GetParam();
    const Frame plain = test::renderer(16).render(c.scene, plan_for(Structure::none, 8), {}, false).frame;
    for (const Structure structure : c.structures)
        for (const int lanes : c.lanes)
            for (const int cells : {4, 8}) {
                const Frame frame = test::renderer(lanes).render(c.scene, plan_for(structure, cells), {}, false).frame;
                EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4)
                    << name_of(structure) << " lanes " << lanes << " cells " << cells;
                EXPECT_LE(test::share_over(frame, plain, 1.0), 0)
                    << name_of(structure) << " lanes " << lanes << " cells " << cells;
            }
}

INSTANTIATE_TEST_SUITE_P(Kernels, Distances, testing::ValuesIn(make_cases()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& ch : name)
        if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
    return name;
});

TEST(VoxelDistances, ChangeNothingAtThresholdZero) {
    LACUNA_NEEDS_DEVICE();
    for (const Case& c : make_cases()) {
        const bool pc_only = !c.name.starts_with("odd_u8_");
        if (c.scene.mode == ViewMode::mip || (pc_only && c.scene.mode != ViewMode::ea)) continue;
        if (c.scene.mode != ViewMode::ea && c.scene.mode != ViewMode::iso) continue;
        const Frame plain = test::renderer(16).render(c.scene, plan_for(Structure::none, 1), {}, false).frame;
        for (const Structure structure : {Structure::pc, Structure::acd, Structure::eacd}) {
            if (pc_only && structure != Structure::pc) continue;
            const Frame frame = test::renderer(16).render(c.scene, plan_for(structure, 1), {}, false).frame;
            EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4) << c.name << ' ' << name_of(structure);
            EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << c.name << ' ' << name_of(structure);
        }
    }
}

TEST(MacrocellDistances, TurningMakesTheOctantsRaysRunInto) {
    LACUNA_NEEDS_DEVICE();
    OpenClRenderer one(test::device(), 16);  // keeps what earlier views made
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea})
        for (const Structure structure : {Structure::acd, Structure::eacd}) {
            Scene scene = test::small_scene(make_sample("spheres", {.size = 64}).volume, mode, {96, 96});
            bool built = true;
            for (int view = 0; view < 8; ++view) {
                scene.camera.azimuth_deg = 90.0 * view + 40;
                scene.camera.elevation_deg = view < 4 ? 25 : -25;
                const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none, 8), {}, false).frame;
                const RenderResult made = one.render(scene, plan_for(structure, 8), {}, false);
                EXPECT_LE(test::share_over(made.frame, plain, 1.0), 0) << name_of(structure) << view;
                built &= made.build.at(std::string(name_of(structure))).ms > 0;
            }
            EXPECT_TRUE(built);  // eight octants, eight views
            EXPECT_EQ(one.render(scene, plan_for(structure, 8), {}, false).build.begin()->second.ms, 0);
        }
}

/// A part of two plateaus that both show.
Scene plateaus() {
    GridGeometry grid;
    grid.size = {48, 48, 48};
    const Volume steps = make_volume<std::uint8_t>(grid, [](std::span<std::uint8_t> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            const int x = int(i % 48), y = int(i / 48 % 48), z = int(i / 2304);
            const bool part = x > 6 && x < 40 && y > 8 && y < 41 && z > 5 && z < 44;
            voxels[i] = std::uint8_t(!part ? 0 : x < 24 ? 100 : 160 + (x + y + z) % 3);
        }
    });
    Scene scene = test::small_scene(steps, ViewMode::ea, {96, 96});
    scene.classification.tf = {"t", 1.0, {{50, {1, 0.5, 0}, 0}, {90, {1, 1, 0}, 0.02}, {255, {0, 1, 1}, 0.06}}, {}};
    return scene;
}

TEST(VoxelDistances, RunsOfEqualSamplesAreTakenAtOnce) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = plateaus();
    for (const Shading shading : {Shading::none, Shading::phong}) {
        scene.shading = shading;
        const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none, 1), {}, true).frame;
        const Frame pc = test::renderer(16).render(scene, plan_for(Structure::pc, 1), {}, true).frame;
        const Frame eacd = test::renderer(16).render(scene, plan_for(Structure::eacd, 1), {}, true).frame;
        EXPECT_LE(test::share_over(pc, plain, 1.0), 0);
        EXPECT_LE(test::share_over(eacd, plain, 1.0), 0);
        EXPECT_LT(double(pc.counters.samples), 0.75 * double(plain.counters.samples));
        EXPECT_LT(eacd.counters.structure_reads, pc.counters.structure_reads);
    }
}

TEST(VoxelDistances, TheErrorGrowsWithTheThreshold) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = plateaus();
    scene.shading = Shading::none;
    const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none, 1), {}, true).frame;
    double before = 0;
    std::uint64_t samples = plain.counters.samples;
    for (const double threshold : {0.0, 0.005, 0.02, 0.08, 0.32}) {
        Plan plan = plan_for(Structure::pc, 1);
        plan.homogeneity = threshold;
        const Frame frame = test::renderer(16).render(scene, plan, {}, true).frame;
        const double error = mean_difference(frame, plain);
        EXPECT_GE(error, before - 0.02) << threshold;
        EXPECT_LE(frame.counters.samples, samples) << threshold;
        EXPECT_LE(error, 255 * std::max(threshold, 1e-4) * 2);
        before = error;
        samples = frame.counters.samples;
    }
    EXPECT_GT(before, 0);
}

TEST(VoxelDistances, GradientsMayTurnByTheAngle) {
    LACUNA_NEEDS_DEVICE();
    Scene scene =
        test::small_scene(test::bumpy_ball<std::uint8_t>({48, 48, 48}, {1, 1, 1}, 240), ViewMode::ea, {96, 96});
    scene.classification.tf = {"t", 1.0, {{20, {1, 0.5, 0}, 0}, {240, {1, 0.6, 0}, 0.05}}, {}};
    const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none, 1), {}, true).frame;
    std::uint64_t samples = plain.counters.samples;
    double before = 0;
    for (const double angle : {0.0, 15.0, 45.0, 180.0}) {
        Plan plan = plan_for(Structure::pc, 1);
        plan.homogeneity = 0.02;
        plan.homogeneity_angle_deg = angle;
        const Frame frame = test::renderer(16).render(scene, plan, {}, true).frame;
        const double error = mean_difference(frame, plain);
        EXPECT_LE(frame.counters.samples, samples) << angle;
        EXPECT_GE(error, before - 0.05) << angle;
        EXPECT_LE(error, 4.0) << angle;  // of 255
        samples = frame.counters.samples;
        before = error;
    }
    EXPECT_LT(samples, plain.counters.samples);
}

TEST(VoxelDistances, TooLargeIsRefusedInOneSentence) {
    LACUNA_NEEDS_DEVICE();
    const double limit = std::min({double(test::device()->info().max_allocation_bytes),
                                   0.5 * double(test::device()->info().memory_bytes), 2147483647.0});
    if (limit > 16.0 * 1300 * 1300 * 80) GTEST_SKIP() << "skipped: the device offers more than this test may take";
    GridGeometry grid;
    grid.size = {1300, 1300, 80};
    const Volume flat = make_volume<std::uint8_t>(grid, [](std::span<std::uint8_t>) {});
    OpenClRenderer own(test::device());
    try {
        own.render(test::small_scene(flat, ViewMode::ea), plan_for(Structure::eacd, 1), {}, false);
        FAIL() << "held all the same";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::out_of_memory);
        EXPECT_NE(std::string(error.what()).find("eacd"), std::string::npos);
    }
}

/// A few balls in a large empty volume.
const Volume& sparse_volume() {
    static const Volume balls = make_sample("spheres", {.size = 96}).volume;
    return balls;
}

TEST(DistanceStructures, AskLessTheMoreTheyKnow) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = test::small_scene(sparse_volume(), ViewMode::ea, {128, 128});
    const auto count = [&](Structure s) {
        return test::renderer(16).render(scene, plan_for(s, 4), {}, true).frame.counters;
    };
    Plan eight = plan_for(Structure::macrocells, 8);
    const Counters plain = count(Structure::none),
                   cells = test::renderer(16).render(scene, eight, {}, true).frame.counters;
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
    LACUNA_NEEDS_DEVICE();
    Scene fog = test::small_scene(sparse_volume(), ViewMode::ea, {128, 128});
    fog.classification.tf = {"fog", 1.0, {{0, {1, 1, 1}, 0.001}, {1, {1, 1, 1}, 0.001}}, {}};
    const Counters made = test::renderer(16).render(fog, plan_for(Structure::pc, 8), {}, true).frame.counters;
    EXPECT_EQ(made.skipped, 0u);
    EXPECT_LT(made.structure_reads, 2 * made.rays);
}

TEST(DistanceStructures, FollowEveryEdit) {
    LACUNA_NEEDS_DEVICE();
    OpenClRenderer own(test::device());
    Scene scene = test::small_scene(sparse_volume(), ViewMode::iso);
    const Plan plan = plan_for(Structure::pc, 8);
    EXPECT_GT(own.render(scene, plan, {}, false).build.at("pc").bytes, 0u);
    EXPECT_EQ(own.render(scene, plan, {}, false).build.at("pc").ms, 0) << "the cached one serves";
    scene.iso *= 0.5;
    const RenderResult edited = own.render(scene, plan, {}, false);
    EXPECT_GT(edited.build.at("pc").ms, 0);
    const Frame fresh = test::renderer(16).render(scene, plan_for(Structure::none, 8), {}, false).frame;
    EXPECT_LE(test::share_over(edited.frame, fresh, 1.0), 0);
    EXPECT_GT(own.render(scene, plan_for(Structure::pc, 4), {}, false).build.at("pc").ms, 0) << "other cells";
}

TEST(DistanceStructures, MinMaxCellsCountWithEachStructureMadeOfThemOnce) {
    const Volume volume = sparse_volume();
    SharedCells cells;
    unsigned first = 0, second = 0;
    cells.grid(volume, 3, {});
    EXPECT_EQ(cells.take_found_ms(first), 0) << "the caller's own clock ran while they were made";
    cells.grid(volume, 3, {});
    EXPECT_EQ(cells.take_found_ms(first), 0) << "known of";
    cells.grid(volume, 3, {});
    const double found = cells.take_found_ms(second);
    EXPECT_GT(found, 0) << "another structure needs them as much";
    cells.grid(volume, 3, {});
    cells.grid(volume, 2, {});
    cells.grid(volume, 2, {});
    EXPECT_EQ(cells.take_found_ms(second), 0);
    unsigned third = 0;
    cells.grid(volume, 3, {});
    cells.grid(volume, 2, {});
    EXPECT_GT(cells.take_found_ms(third), found) << "both sizes";
    EXPECT_EQ(cells.take_found_ms(third), 0) << "none asked for since";
}

TEST(DistanceStructures, AStoppedBuildLeavesNothing) {
    LACUNA_NEEDS_DEVICE();
    OpenClRenderer own(test::device());
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
    const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none, 8), {}, false).frame;
    EXPECT_LE(test::share_over(after.frame, plain, 1.0), 0);
}

}  // namespace
}  // namespace lacuna
