// Leaping through homogeneous regions against brute force on the same device.
#include <gtest/gtest.h>

#include "tests/support/device_renderer.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

Plan plan_for(Structure structure, const Scene& scene, double homogeneity = 0) {
    Plan plan;
    plan.structure = structure;
    plan.ert = 0;
    plan.homogeneity = homogeneity;
    plan.leap.min_voxels = 8;
    // f32 volumes: as fine as 15 bits go over the values there are.
    if (scene.volume.type() == VoxelType::f32) plan.leap.quantisation = scene.window;
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
};

/// The scene from beside, in perspective, cut with and without caps, through ranges.
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
    const glm::dvec3 centre = c.scene.volume.geometry().centre_mm(), normal(0.3, 1, -0.2);
    for (const bool cap : {true, false})
        add(cap ? "_cut" : "_open").cuts = {{normal, -glm::dot(normal, centre), cap},
                                            {{-1, 0.1, 0}, centre.x + 4, false}};
    if (c.name.starts_with("u16")) return;
    const double lo = c.scene.window.lo, w = c.scene.window.width();
    Scene& ranged = add("_ranges");
    ranged.iso = lo;
    ranged.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}}, {"b", {lo + 0.6 * w, lo + w}, {}}};
}

std::vector<Case> make_cases() {
    std::vector<Case> cases;
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (const ViewMode mode : k_modes) {
            const bool principal = mode == ViewMode::iso || mode == ViewMode::ea, all = v.name == "odd_u8";
            // Every variant of a kernel takes a second to compile: all modes on one voxel type.
            const VoxelType type = v.volume.type();
            if (!all && (!principal || type == VoxelType::i8 || (type == VoxelType::i16 && mode == ViewMode::ea)))
                continue;
            Case c{v.name + "_" + std::string(name_of(mode)), test::small_scene(v.volume, mode)};
            if (principal && all) c.lanes = {16, 1};
            cases.push_back(c);
            if ((all && (principal || mode == ViewMode::mip)) || (v.name == "u16_1_1_5" && principal))
                add_views(c, cases);
        }
    return cases;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Leaps : public testing::TestWithParam<Case> {
protected:
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

/// What a picture by leaping is a picture of: the volume with its regions at their averages.
Scene flattened(const Scene& scene, double width) {
    LeapOptions options;
    options.range_width = width;
    options.min_voxels = 8;
    options.step_mm = 0.5 * scene.volume.geometry().smallest_spacing_mm();
    options.quantisation = plan_for(Structure::leap, scene).leap.quantisation;
    Scene flat = scene;
    flat.volume = build_leap_volume(scene.volume, options).flat;
    return flat;
}

TEST_P(Leaps, AtThresholdZeroChangeNothing) {
    const Case& c = GetParam();
    // f32 volumes change by their quantisation, and by no more.
    const bool quantised = c.scene.volume.type() == VoxelType::f32;
    const Scene same = quantised ? flattened(c.scene, 0) : c.scene;
    const Frame plain = test::renderer(16).render(same, plan_for(Structure::none, c.scene), {}, false).frame;
    for (const int lanes : c.lanes) {
        const Frame frame = test::renderer(lanes).render(c.scene, plan_for(Structure::leap, c.scene), {}, false).frame;
        EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4) << "lanes " << lanes;
        EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << "lanes " << lanes;
    }
}

TEST_P(Leaps, AboveZeroDrawTheFlattenedVolume) {
    const Case& c = GetParam();
    const double width = 0.15;
    const Scene flat = flattened(c.scene, width);
    const Frame plain = test::renderer(16).render(flat, plan_for(Structure::none, flat), {}, false).frame;
    const Frame frame = test::renderer(16).render(c.scene, plan_for(Structure::leap, c.scene, width), {}, false).frame;
    EXPECT_LE(test::share_over(frame, plain, 0.5), 1e-4);
    EXPECT_LE(test::share_over(frame, plain, 1.0), 0);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Leaps, testing::ValuesIn(make_cases()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& ch : name)
        if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
    return name;
});

/// A part of two plateaus that both show, one of them with a little noise.
Scene plateaus(int noise = 3) {
    GridGeometry grid;
    grid.size = {64, 64, 64};
    const Volume steps = make_volume<std::uint8_t>(grid, [&](std::span<std::uint8_t> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            const int x = int(i % 64), y = int(i / 64 % 64), z = int(i / 4096);
            const bool part = x > 6 && x < 56 && y > 8 && y < 57 && z > 5 && z < 60;
            voxels[i] = std::uint8_t(!part ? 0 : x < 32 ? 100 : 160 + (x * 7 + y * 5 + z * 3) % noise);
        }
    });
    Scene scene = test::small_scene(steps, ViewMode::ea, {96, 96});
    scene.classification.tf = {"t", 1.0, {{50, {1, 0.5, 0}, 0}, {90, {1, 1, 0}, 0.01}, {255, {0, 1, 1}, 0.03}}, {}};
    scene.shading = Shading::none;
    return scene;
}

TEST(LeapStructure, LeapsInEveryModeItServes) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = plateaus();
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip, ViewMode::minip, ViewMode::lmip})
        for (const Shading shading : {Shading::none, Shading::phong}) {
            if (shading != Shading::none && mode != ViewMode::ea) continue;
            scene.mode = mode;
            scene.iso = 130;
            scene.lmip_threshold = 155;
            scene.shading = shading;
            const Scene flat = flattened(scene, 0.05);
            const Counters plain =
                test::renderer(16).render(flat, plan_for(Structure::none, scene), {}, true).frame.counters;
            const Counters leap =
                test::renderer(16).render(scene, plan_for(Structure::leap, scene, 0.05), {}, true).frame.counters;
            EXPECT_LT(double(leap.samples), 0.85 * double(plain.samples)) << name_of(mode);
            EXPECT_GT(leap.skipped, 0u);
            EXPECT_LE(leap.samples + leap.skipped, plain.samples) << name_of(mode);
            EXPECT_LT(double(leap.structure_reads), 0.55 * double(plain.samples)) << name_of(mode);
            EXPECT_EQ(leap.rays, plain.rays);
        }
}

TEST(LeapStructure, TheErrorGrowsWithTheThreshold) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = plateaus(40);
    const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none, scene), {}, true).frame;
    double before = 0;
    std::uint64_t samples = plain.counters.samples;
    for (const double threshold : {0.0, 0.02, 0.06, 0.2, 0.5, 1.0}) {
        const Frame frame =
            test::renderer(16).render(scene, plan_for(Structure::leap, scene, threshold), {}, true).frame;
        const double error = mean_difference(frame, plain);
        EXPECT_GE(error, before - 0.05) << threshold;
        EXPECT_LE(frame.counters.samples, samples) << threshold;
        before = error;
        samples = frame.counters.samples;
    }
    EXPECT_GT(before, 0.5) << "everything one region: the picture cannot be right";
}

TEST(LeapStructure, AllThreeWaysDrawTheSame) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = plateaus();
    const Frame plain = test::renderer(16).render(scene, plan_for(Structure::none, scene), {}, false).frame;
    std::uint64_t reads[3] = {};
    for (const LeapWay way : {LeapWay::transform, LeapWay::kd_tree, LeapWay::groups}) {
        Plan plan = plan_for(Structure::leap, scene);
        plan.leap.way = way;
        plan.leap.groups.probability = 0.02;
        const Frame frame = test::renderer(16).render(scene, plan, {}, true).frame;
        EXPECT_LE(test::share_over(frame, plain, 1.0), 0) << name_of(way);
        reads[int(way)] = frame.counters.structure_reads;
    }
    EXPECT_EQ(reads[0], reads[1]);
    EXPECT_GE(reads[2], reads[0]) << "shorter leaps";
}

TEST(LeapStructure, ServesEditsWithoutBuildingAnew) {
    LACUNA_NEEDS_DEVICE();
    OpenClRenderer own(test::device());
    Scene scene = plateaus();
    EXPECT_GT(own.render(scene, plan_for(Structure::leap, scene), {}, false).build.at("leap").ms, 0);
    scene.classification.tf.points[1].opacity = 0.02;
    scene.shading = Shading::phong;
    Plan finer = plan_for(Structure::leap, scene);
    finer.step = 0.4;
    EXPECT_EQ(own.render(scene, finer, {}, false).build.at("leap").ms, 0) << "a shorter step, another function";
    Plan coarser = finer;
    coarser.step = 2;
    EXPECT_GT(own.render(scene, coarser, {}, false).build.at("leap").ms, 0) << "guards too thin for it";
    Plan wider = coarser;
    wider.homogeneity = 0.1;
    EXPECT_GT(own.render(scene, wider, {}, false).build.at("leap").ms, 0);
    const Frame plain = own.render(scene, plan_for(Structure::none, scene), {}, false).frame;
    EXPECT_LE(test::share_over(own.render(scene, plan_for(Structure::leap, scene), {}, false).frame, plain, 1.0), 0);
}

TEST(LeapStructure, AStoppedBuildLeavesNothing) {
    LACUNA_NEEDS_DEVICE();
    const Scene scene = plateaus();
    for (const double at : {0.0, 0.3, 0.7}) {
        OpenClRenderer own(test::device());
        own.render(scene, plan_for(Structure::none, scene), {}, false);
        const std::size_t before = own.bytes_held();
        std::stop_source source;
        const JobContext job{source.get_token(), [&](double done) {
                                 if (done >= at) source.request_stop();
                             }};
        try {
            own.render(scene, plan_for(Structure::leap, scene, 0.1), job, false);
            FAIL() << "a stopped frame was returned";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::cancelled);
        }
        EXPECT_EQ(own.bytes_held(), before);
        EXPECT_GT(own.render(scene, plan_for(Structure::leap, scene, 0.1), {}, false).build.at("leap").ms, 0);
    }
}

TEST(LeapStructure, FogCostsLittleMoreThanNothing) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = plateaus(200);
    scene.classification.tf = {"fog", 1.0, {{0, {1, 1, 1}, 0.001}, {1, {1, 1, 1}, 0.001}}, {}};
    Plan plan = plan_for(Structure::leap, scene);
    plan.leap.min_voxels = 1000000;
    const Frame frame = test::renderer(16).render(scene, plan, {}, true).frame;
    EXPECT_EQ(frame.counters.structure_reads, 0u) << "no leap voxel: not asked at all";
}

TEST(LeapStructure, RefusesWhatItCannotServeNamingWhatCan) {
    const auto message = [](const Plan& plan, const Scene& scene) -> std::string {
        try {
            check(plan, scene);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::bad_usage);
            return error.what();
        }
        return "";
    };
    const Scene floats = test::small_scene(test::bumpy_ball<float>({8, 8, 8}, {1, 1, 1}, 1), ViewMode::ea);
    Plan plan = plan_for(Structure::leap, floats);
    EXPECT_EQ(message(plan, floats), "");
    plan.leap.quantisation.reset();
    EXPECT_NE(message(plan, floats).find("macrocells"), std::string::npos);
    Scene scene = plateaus();
    plan = plan_for(Structure::leap, scene);
    for (const double wrong : {-0.1, 1.5, std::nan("")}) {
        plan.homogeneity = wrong;
        EXPECT_NE(message(plan, scene), "") << wrong;
    }
    plan = plan_for(Structure::leap, scene);
    plan.leap.kernel = Leaping::confirmed;
    EXPECT_EQ(message(plan, scene), "");
    scene.shading = Shading::phong;
    EXPECT_NE(message(plan, scene).find("lossless"), std::string::npos);
    scene.mode = ViewMode::shear_warp;
    EXPECT_NE(message(plan, scene).find("visible"), std::string::npos);
}

}  // namespace
}  // namespace lacuna
