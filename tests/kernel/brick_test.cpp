// A volume cast brick by brick gives the picture it gives whole: every mode, structure, cut, range and camera, brick
// borders across surfaces, and bricks that are loaded, pushed out and loaded again.
#include <gtest/gtest.h>

#include "core/render/brick_plan.h"
#include "core/render/engine.h"
#include "core/render/reference_renderer.h"
#include "core/volume/brick_grid.h"
#include "tests/support/device_renderer.h"
#include "tests/support/memory_source.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

constexpr std::uint64_t k_plenty = std::uint64_t(1) << 30;

struct Case {
    std::string name;
    Scene scene;
    Plan plan;
    int edge = 9;
    int lanes = 16;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Plan exact_plan(Structure structure) {
    Plan plan;
    plan.structure = structure;
    plan.ert = 0;
    return plan;
}

constexpr ViewMode k_modes[] = {ViewMode::iso,  ViewMode::ea,    ViewMode::mip,
                                ViewMode::lmip, ViewMode::minip, ViewMode::mean};

Volume named(const std::string& name) {
    for (const test::NamedVolume& v : test::ugly_volumes())
        if (v.name == name) return v.volume;
    return {};
}

void look_from_inside(Scene& scene) {
    scene.camera.fov_deg = 80;
    scene.camera.zoom = 8;
}

/// Every mode on an odd, anisotropic volume: from outside, in perspective, from inside, cut, under ranges, nearest.
void add_views(std::vector<Case>& cases) {
    const Volume volume = named("u16_1_1_5");
    for (const ViewMode mode : k_modes) {
        const Case plain{"u16_1_1_5_" + std::string(name_of(mode)), test::small_scene(volume, mode),
                         exact_plan(Structure::none)};
        cases.push_back(plain);
        for (const double azimuth : {0.0, 123.0, 250.0}) {  // 0: rays along an axis
            Case turned = plain;
            turned.name += "_from_" + std::to_string(int(azimuth));
            turned.scene.camera.azimuth_deg = azimuth;
            turned.scene.camera.elevation_deg = azimuth == 0 ? 0 : -40;
            cases.push_back(turned);
        }
        Case far = plain;
        far.name += "_perspective";
        far.scene.camera.fov_deg = 60;
        far.scene.camera.zoom = 2;
        cases.push_back(far);
        Case inside = plain;
        inside.name += "_inside";
        look_from_inside(inside.scene);
        cases.push_back(inside);
        if (mode == ViewMode::iso || mode == ViewMode::ea || mode == ViewMode::mip) {
            Case one_ray = plain;
            one_ray.name += "_one_ray";
            one_ray.lanes = 1;
            cases.push_back(one_ray);
        }
        const glm::dvec3 centre = volume.geometry().centre_mm(), normal(0.3, 1, -0.2);
        for (const bool cap : {true, false}) {
            Case cut = plain;
            cut.name += cap ? "_cut" : "_open";
            cut.scene.cuts = {{normal, -glm::dot(normal, centre), cap}, {{-1, 0.1, 0}, centre.x + 4, false}};
            cases.push_back(cut);
        }
        Case ranged = plain;
        ranged.name += "_ranges";
        const double lo = plain.scene.window.lo, w = plain.scene.window.width();
        ranged.scene.iso = lo;
        ranged.scene.classification.ranges = {{"a", {lo + 0.3 * w, lo + 0.45 * w}, {}},
                                              {"b", {lo + 0.6 * w, lo + 0.9 * w}, {}}};
        cases.push_back(ranged);
        ranged.name += "_open";
        ranged.scene.cuts = {{normal, -glm::dot(normal, centre), false}};
        cases.push_back(ranged);
        Case nearest = plain;
        nearest.name += "_nearest";
        nearest.plan.sampler = Sampler::nearest;
        cases.push_back(nearest);
    }
}

/// What only an isosurface has: refinement across brick borders, long steps.
void add_surfaces(std::vector<Case>& cases) {
    for (const Refinement refine : {Refinement::none, Refinement::bisect, Refinement::regula_falsi, Refinement::newton})
        for (const double step : {0.5, 3.0}) {
            Case c{"surface_" + std::string(name_of(refine)) + (step > 1 ? "_long_steps" : ""),
                   test::small_scene(named("u16_1_1_5"), ViewMode::iso), exact_plan(Structure::none)};
            c.plan.refine = refine;
            c.plan.step = step;
            c.edge = 8;
            cases.push_back(c);
        }
    Case mixed{"surface_terminated", test::small_scene(named("u16_1_1_5"), ViewMode::ea), exact_plan(Structure::none)};
    mixed.plan.ert = 0.002;
    cases.push_back(mixed);
    Case sparse{"surface_sparse", test::small_scene(named("u16_1_1_5"), ViewMode::iso), exact_plan(Structure::none)};
    sparse.plan.sparse = 3;
    cases.push_back(sparse);
}

void add_volumes(std::vector<Case>& cases) {
    for (const char* name :
         {"odd_u8", "signed_i8", "i16_oblique", "nan_f32", "flat_u8", "one_voxel", "one_by_one", "one_slice"})
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip}) {
            if (mode == ViewMode::mip && std::string(name) != "nan_f32") continue;
            cases.push_back({std::string(name) + "_" + std::string(name_of(mode)), test::small_scene(named(name), mode),
                             exact_plan(Structure::none)});
        }
    for (const bool cap : {true, false}) {
        Case cut{cap ? "nan_f32_cut" : "nan_f32_open", test::small_scene(named("nan_f32"), ViewMode::iso),
                 exact_plan(Structure::none)};
        const glm::dvec3 centre = cut.scene.volume.geometry().centre_mm();
        cut.scene.cuts = {{{0.3, 1, -0.2}, -glm::dot(glm::dvec3(0.3, 1, -0.2), centre), cap}};
        cases.push_back(cut);
    }
}

void add_structures(std::vector<Case>& cases) {
    const Volume volume = named("u16_1_1_5");
    for (const Structure structure :
         {Structure::macrocells, Structure::octree, Structure::pyramid, Structure::pc, Structure::acd, Structure::eacd})
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::lmip}) {
            const bool other_field = structure == Structure::pc || structure == Structure::eacd;
            if (other_field && mode == ViewMode::lmip) continue;  // acd stands for all three
            Case c{std::string(name_of(structure)) + "_" + std::string(name_of(mode)), test::small_scene(volume, mode),
                   exact_plan(structure), 16};
            cases.push_back(c);
            if (mode != ViewMode::iso) continue;
            c.name += "_open";
            c.scene.cuts = {{{0, 1, 0}, -volume.geometry().centre_mm().y, false}};
            cases.push_back(c);
            if (structure < Structure::pc || structure > Structure::eacd) continue;
            c.name += "_a_voxel";
            c.plan.cells = 1;
            cases.push_back(c);
        }
}

/// Air and two values, one of them a core that bricks of 16 voxels cut through.
template <class T>
Volume plateaus() {
    GridGeometry grid;
    grid.size = {44, 41, 37};
    grid.spacing = {1, 1, 1.5};
    return make_volume<T>(grid, [&](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) {
            const int x = int(i % 44), y = int(i / 44 % 41), z = int(i / (44 * 41));
            const bool box = x > 3 && x < 40 && y > 2 && y < 38 && z > 2 && z < 34, core = box && x > 12 && z > 11;
            voxels[i] = T(core ? 200 : box ? 120 : 3);
        }
    });
}

/// Leaps through equal voxels, region by region of each brick; f32 by its quantisation.
void add_leaps(std::vector<Case>& cases) {
    const auto add = [&](const Volume& volume, ViewMode mode, const char* name) {
        Case c{std::string("leap_") + name + "_" + std::string(name_of(mode)), test::small_scene(volume, mode),
               exact_plan(Structure::leap), 16};
        c.plan.leap.min_voxels = 8;
        if (volume.type() == VoxelType::f32) c.plan.leap.quantisation = ValueRange{0, 32767};
        c.scene.classification.tf = {"glass", 1.0, {{50, {1, 0.5, 0}, 0}, {255, {0, 1, 1}, 0.06}}, {}};
        cases.push_back(c);
    };
    for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::lmip}) add(plateaus<std::uint8_t>(), mode, "u8");
    add(plateaus<float>(), ViewMode::ea, "f32");
}

std::vector<Case> make_cases() {
    std::vector<Case> cases;
    add_views(cases);
    add_leaps(cases);
    add_surfaces(cases);
    add_volumes(cases);
    add_structures(cases);
    return cases;
}

class Bricks : public testing::TestWithParam<Case> {
protected:
    void SetUp() override { LACUNA_NEEDS_DEVICE(); }
};

Plan in_bricks(Plan plan, int edge, std::uint64_t bytes = k_plenty) {
    plan.brick = edge;
    plan.brick_bytes = bytes;
    return plan;
}

/// Largest difference of depths where both have one; infinity where only one has.
double depth_difference(const Frame& a, const Frame& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        if (std::isinf(a.depth_mm[i]) && std::isinf(b.depth_mm[i])) continue;
        most = std::max(most, std::abs(double(a.depth_mm[i]) - double(b.depth_mm[i])));
    }
    return most;
}

TEST_P(Bricks, ChangeNothing) {
    const Case& c = GetParam();
    OpenClRenderer& renderer = test::renderer(c.lanes);
    const Frame whole = renderer.render(c.scene, c.plan, {}, false).frame;
    const RenderResult bricked = renderer.render(c.scene, in_bricks(c.plan, c.edge), {}, false);
    ASSERT_TRUE(bricked.bricks.has_value());
    EXPECT_EQ(bricked.bricks->total, BrickGrid(c.scene.volume.geometry().size, c.edge, {2, 2, 2}).bricks());
    EXPECT_LE(test::share_over(bricked.frame, whole, 0.01), 0);
    EXPECT_LE(depth_difference(bricked.frame, whole), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Bricks, testing::ValuesIn(make_cases()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& ch : name)
        if (!std::isalnum(static_cast<unsigned char>(ch))) ch = '_';
    return name;
});

TEST(BrickStreaming, EmptyBricksAreNeverLoadedAndHiddenOnesNotEither) {
    LACUNA_NEEDS_DEVICE();
    const Volume balls = make_sample("spheres", {.size = 128}).volume;
    Scene scene = test::small_scene(balls, ViewMode::iso, {128, 128});
    OpenClRenderer renderer(test::device());
    const RenderResult once = renderer.render(scene, in_bricks(exact_plan(Structure::none), 16), {}, false);
    EXPECT_EQ(once.bricks->total, 512);
    EXPECT_GT(once.bricks->empty, 30);
    EXPECT_EQ(once.bricks->loaded + once.bricks->empty + once.bricks->hidden + once.bricks->uniform, 512);
    EXPECT_EQ(once.bricks->cast, once.bricks->loaded + once.bricks->uniform);
    const RenderResult again = renderer.render(scene, in_bricks(exact_plan(Structure::none), 16), {}, false);
    EXPECT_EQ(again.bricks->loaded, 0);  // all still there
    EXPECT_EQ(test::share_over(once.frame, again.frame, 0), 0);

    // A cut through the middle, closed: behind the face nothing is seen, and nothing is loaded.
    scene.mode = ViewMode::ea;
    scene.iso = 0;
    scene.classification.tf = {"solid", 1.0, {{-1, {1, 1, 1}, 1}, {1, {1, 1, 1}, 1}}, {}};
    scene.camera.azimuth_deg = scene.camera.elevation_deg = 0;
    const RenderResult solid = renderer.render(scene, in_bricks(exact_plan(Structure::none), 15), {}, false);
    EXPECT_EQ(solid.bricks->empty, 0);
    EXPECT_GT(solid.bricks->hidden, 100);
    const Frame whole = test::renderer(16).render(scene, exact_plan(Structure::none), {}, false).frame;
    EXPECT_EQ(test::share_over(solid.frame, whole, 0.01), 0);
}

TEST(BrickStreaming, AVolumeThatIsNotInMemoryGivesTheSamePicture) {
    LACUNA_NEEDS_DEVICE();
    for (const char* name : {"u16_1_1_5", "nan_f32", "one_slice"}) {
        Scene scene = test::small_scene(named(name), ViewMode::ea);
        const Frame whole = test::renderer(16).render(scene, exact_plan(Structure::acd), {}, false).frame;
        scene.volume = test::elsewhere(scene.volume);
        Engine engine(test::device());
        const RenderResult result = engine.render(scene, exact_plan(Structure::acd));
        ASSERT_TRUE(result.bricks.has_value());  // nothing asked for them: they are the only way
        EXPECT_LE(test::share_over(result.frame, whole, 0.01), 0) << name;
        EXPECT_THROW(Engine(nullptr).render(scene, exact_plan(Structure::acd)), Error);
    }
}

TEST(BrickStreaming, LongAxesWork) {
    LACUNA_NEEDS_DEVICE();
    GridGeometry grid;
    grid.size = {20000, 5, 4};
    const Volume rod = make_volume<std::uint8_t>(grid, [](auto voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i)
            voxels[i] = std::uint8_t(127.5 + 120 * std::sin(0.004 * double(i % 20000)));
    });
    for (const ViewMode mode : {ViewMode::iso, ViewMode::mip}) {
        Scene scene = test::small_scene(rod, mode, {96, 64});
        scene.camera.azimuth_deg = 12;
        scene.camera.zoom = 500;
        scene.camera.center_mm = glm::dvec3(19900, 2, 1.5);
        const Frame truth = render_reference(scene, exact_plan(Structure::none));
        for (const Structure structure : {Structure::none, Structure::octree, Structure::acd}) {
            const Frame whole = test::renderer(16).render(scene, exact_plan(structure), {}, false).frame;
            const Frame bricks =
                test::renderer(16).render(scene, in_bricks(exact_plan(structure), 256), {}, false).frame;
            EXPECT_LE(test::share_over(whole, truth, 1.0), 0.02) << int(mode) << " " << name_of(structure);
            EXPECT_LE(test::share_over(bricks, whole, 0.01), 0) << int(mode) << " " << name_of(structure);
        }
    }
}

TEST(BrickStreaming, StaysWithinWhatBricksMayTake) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({70, 66, 61}, {1, 1, 1}, 60000);
    Scene scene = test::small_scene(ball, ViewMode::ea);
    scene.classification = {};
    scene.classification.tf = {"fog", 1.0, {{0, {1, 1, 1}, 0.01}, {60000, {0.2, 0.6, 0.9}, 0.05}}, {}};
    const Frame whole = test::renderer(16).render(scene, exact_plan(Structure::none), {}, false).frame;
    OpenClRenderer renderer(test::device());
    const std::uint64_t brick = 23 * 23 * 23 * 2;
    for (const Structure structure : {Structure::none, Structure::octree}) {
        const std::uint64_t bytes = structure == Structure::none ? 3 * brick : 6 * brick;
        for (int turn = 0; turn < 2; ++turn) {
            const RenderResult result = renderer.render(scene, in_bricks(exact_plan(structure), 16, bytes), {}, false);
            EXPECT_LE(result.bricks->bytes_peak, bytes);
            EXPECT_GT(result.bricks->loaded, 60);  // they push each other out
            EXPECT_LE(test::share_over(result.frame, whole, 0.5), 0);
        }
    }
}

TEST(BrickStreaming, EditsAreSeen) {
    LACUNA_NEEDS_DEVICE();
    const Volume balls = make_sample("spheres", {.size = 64}).volume;
    Scene scene = test::small_scene(balls, ViewMode::iso);
    OpenClRenderer renderer(test::device());
    for (const double iso : {scene.iso, scene.window.hi + 1, scene.iso * 1.2, scene.window.lo}) {
        scene.iso = iso;
        for (const Structure structure : {Structure::macrocells, Structure::none}) {
            const Frame whole = test::renderer(16).render(scene, exact_plan(structure), {}, false).frame;
            const Frame frame = renderer.render(scene, in_bricks(exact_plan(structure), 16), {}, false).frame;
            EXPECT_LE(test::share_over(frame, whole, 0.01), 0) << iso;
        }
    }
}

TEST(BrickStreaming, CountsTheSameSamples) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({40, 37, 33}, {1, 1, 1}, 60000);
    Scene scene = test::small_scene(ball, ViewMode::mean);
    const Counters whole = test::renderer(16).render(scene, exact_plan(Structure::none), {}, true).frame.counters;
    const Counters bricks =
        test::renderer(16).render(scene, in_bricks(exact_plan(Structure::none), 12), {}, true).frame.counters;
    EXPECT_EQ(bricks.samples, whole.samples);  // each sample belongs to one brick
    EXPECT_NEAR(double(bricks.rays), double(whole.rays), 2);
}

TEST(BrickStreaming, AStoppedPictureLeavesAWorkingRenderer) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({64, 64, 64}, {1, 1, 1}, 60000);
    const Scene scene = test::small_scene(ball, ViewMode::iso);
    const Plan plan = in_bricks(exact_plan(Structure::octree), 16);
    const Frame truth = test::renderer(16).render(scene, exact_plan(Structure::none), {}, false).frame;
    OpenClRenderer renderer(test::device());
    for (const double stop_at : {0.05, 0.5, 0.9}) {
        std::stop_source source;
        const JobContext job{source.get_token(), [&](double f) {
                                 if (f > stop_at) source.request_stop();
                             }};
        EXPECT_THROW(renderer.render(scene, plan, job, false), Error);
    }
    EXPECT_LE(test::share_over(renderer.render(scene, plan, {}, false).frame, truth, 0.01), 0);
}

TEST(BrickStreaming, LeapsWithinEachBrickAndRefusesRegionsOfTheWhole) {
    LACUNA_NEEDS_DEVICE();
    Scene scene = test::small_scene(plateaus<std::uint8_t>(), ViewMode::ea, {96, 96});
    scene.classification.tf = {"glass", 1.0, {{50, {1, 0.5, 0}, 0}, {255, {0, 1, 1}, 0.06}}, {}};
    scene.shading = Shading::none;
    Plan plan = exact_plan(Structure::leap);
    plan.leap.min_voxels = 8;
    OpenClRenderer renderer(test::device());
    const RenderResult leaping = renderer.render(scene, in_bricks(plan, 20), {}, true);
    const Frame plain = renderer.render(scene, in_bricks(exact_plan(Structure::none), 20), {}, true).frame;
    EXPECT_GT(leaping.frame.counters.structure_reads, 0u);
    EXPECT_LT(double(leaping.frame.counters.samples), 0.95 * double(plain.counters.samples));
    EXPECT_GT(leaping.build.at("leap").bytes, 0u);
    plan.homogeneity = 0.1;
    EXPECT_THROW(check(in_bricks(plan, 20), scene), Error);
    MemoryBudget small;
    small.device_allocation = 20000;
    EXPECT_THROW(with_bricks(plan, scene, small), Error);
    plan.homogeneity = 0;
    small.total = std::uint64_t(1) << 30;
    EXPECT_EQ(with_bricks(plan, scene, small).brick, 32);
}

TEST(BrickStreaming, TheEngineCutsWhatDoesNotFit) {
    LACUNA_NEEDS_DEVICE();
    const Volume ball = test::bumpy_ball<std::uint16_t>({64, 64, 64}, {1, 1, 1}, 60000);
    const Scene scene = test::small_scene(ball, ViewMode::iso);
    MemoryBudget small;
    small.total = 64 << 20;
    small.device_allocation = 200000;  // below the volume's 524288 bytes
    const Plan fitted = with_bricks(exact_plan(Structure::none), scene, small);
    EXPECT_EQ(fitted.brick, 32);
    ASSERT_FALSE(fitted.why.empty());
    EXPECT_NE(fitted.why.back().find("Bricks of 32"), std::string::npos);
    small.device_allocation = 0;
    EXPECT_EQ(with_bricks(exact_plan(Structure::none), scene, small).brick, 0);
    small.device_allocation = 200000;
    small.total = 1 << 20;
    EXPECT_THROW(with_bricks(exact_plan(Structure::none), scene, small), Error);

    Engine engine(test::device());
    Plan asked = exact_plan(Structure::none);
    asked.brick = 24;  // without saying what they may take
    const RenderResult result = engine.render(scene, asked);
    ASSERT_TRUE(result.bricks.has_value());
    EXPECT_EQ(result.bricks->total, 27);
}

/// Zeros but for a bright box; what nobody touches of it takes no memory.
Volume vast(glm::ivec3 size, glm::ivec3 box_first, glm::ivec3 box_last) {
    GridGeometry grid;
    grid.size = size;
    VoxelBuffer voxels(std::size_t(grid.voxel_count()));
    for (int z = box_first.z; z <= box_last.z; ++z)
        for (int y = box_first.y; y <= box_last.y; ++y)
            std::fill_n(voxels.data() + grid.linear_index(box_first.x, y, z), box_last.x - box_first.x + 1,
                        std::byte(200));
    return Volume(grid, VoxelType::u8, std::move(voxels));
}

Scene vast_scene(const Volume& volume) {
    Scene scene;
    scene.volume = volume;
    scene.mode = ViewMode::iso;
    scene.iso = 100;
    scene.window = {0, 255};
    scene.size = {33, 33};
    return scene;
}

// Kernels number voxels with 32 bits, of which all count: nothing is read from the wrong end beyond 2^31.
TEST(BrickStreaming, VoxelsBeyondTwoToThe31AreFoundByTheirNumbers) {
    LACUNA_NEEDS_DEVICE();
    const glm::ivec3 size(1024, 1024, 2100), first(300, 200, 2060), last(700, 900, 2090);
    if (test::device()->info().max_allocation_bytes < std::uint64_t(size.x) * size.y * size.z + 64)
        GTEST_SKIP() << "skipped: the device takes no buffer of 2.2 GB";
    const Volume volume = vast(size, first, last);
    ASSERT_GT(volume.geometry().linear_index(first.x, first.y, first.z), std::int64_t(1) << 31);
    Scene scene = vast_scene(volume);
    scene.camera.elevation_deg = 90;  // from above, onto the box
    scene.camera.center_mm = 0.5 * glm::dvec3(first + last);
    scene.camera.zoom = 3;
    const double pixel_mm = volume.geometry().diameter_mm() / scene.camera.zoom / scene.size.x;
    for (const int lanes : {16, 1}) {
        const Frame frame = test::renderer(lanes).render(scene, exact_plan(Structure::none), {}, false).frame;
        test::renderer(lanes).drop_caches();
        for (int y = 0; y < scene.size.y; ++y)
            for (int x = 0; x < scene.size.x; ++x) {
                const glm::dvec2 off = (glm::abs(glm::dvec2(x, y) - 16.0)) * pixel_mm - 0.5 * glm::dvec2(last - first);
                if (std::abs(off.x) < 2 || std::abs(off.y) < 2) continue;  // on the edge
                EXPECT_EQ(frame.color[std::size_t(y * scene.size.x + x)].a > 0.5f, off.x < 0 && off.y < 0)
                    << x << ", " << y << ", " << lanes << " lanes";
            }
    }
}

TEST(BrickStreaming, MoreThanTwoToThe32VoxelsAreNeverDrawnWhole) {
    MemoryBudget ample;
    ample.total = std::uint64_t(64) << 30;
    const Scene most = vast_scene(vast({65536, 65536, 1}, {0, 0, 0}, {1, 1, 0}));
    EXPECT_TRUE(fits_whole(most, ample));
    const Scene over = vast_scene(vast({65536, 65537, 1}, {0, 0, 0}, {1, 1, 0}));
    EXPECT_FALSE(fits_whole(over, ample));
    const Plan plan = with_bricks(exact_plan(Structure::none), over, ample);
    EXPECT_EQ(plan.brick, 256);
    ASSERT_FALSE(plan.why.empty());
    EXPECT_NE(plan.why.back().find("4294967296"), std::string::npos) << plan.why.back();
    Plan regions = exact_plan(Structure::leap);
    EXPECT_EQ(with_bricks(regions, over, ample).brick, 256);
    regions.homogeneity = 0.1;
    try {
        with_bricks(regions, over, ample);
        FAIL() << "regions of the whole need it whole";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find("memory-limit"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace lacuna
