// The figures the published methods' authors report, measured here on the same kind of scene (docs/seeds.md): gains
// over plain casting on the same device, frames in turn, medians over an orbit. Times are processor time of all
// threads, which other programs on the machine disturb least. Without blocks (kernels/include/block.clh), which no
// author had: methods by themselves; with them where the last word says so.
//   bench_seeds [levoy|es|lesar|memory|rebuild] [SIZE [VIEWS [blocks]]]      all of them, 256, 6
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "core/accuracy/image_error.h"
#include "core/base/order_statistics.h"
#include "core/compute/device.h"
#include "core/render/engine.h"
#include "core/render/turn.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"

namespace lacuna {
namespace {

double processor_ms() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

/// One way to draw a scene, and what it cost.
struct Way {
    std::string name;
    Plan plan;
    std::vector<Effect> effects = {};
    std::vector<double> ms = {};
    BuildRecord build = {};
    Counters counters = {};
    ImageError error = {};

    double steps() const { return double(counters.samples + counters.structure_reads) * 1e-6; }
};

class SeedsBench {
public:
    SeedsBench(std::shared_ptr<ComputeDevice> device, int size, int views, bool blocks)
        : engine_(std::move(device), blocks), size_(size), views_(views) {
        fmt::print("{}: {} views, medians, with{} blocks\n", engine_.device_name(), views_, blocks ? "" : "out");
    }

    /// Levoy 1988: opaque surfaces in mostly empty space; the picture grows with the data, as his did.
    void levoy() {
        for (const char* sample : {"head", "casting"}) {
            Scene scene = scene_of(sample, size_);
            scene.mode = ViewMode::ea;
            Plan plain = plan_of(Structure::none, 0), stops = plan_of(Structure::none, 0.05);
            Plan pyramid = plan_of(Structure::pyramid, 0), both = plan_of(Structure::pyramid, 0.05);
            std::vector<Way> ways{{"plain", plain},
                                  {"pyramid", pyramid},
                                  {"termination 0.05", stops},
                                  {"pyramid, termination 0.05", both}};
            run(scene, ways);
            table(fmt::format("Levoy: {} {}^3, 512x512, step 1", sample, size_), ways);
        }
        for (const bool grows : {true, false}) {
            fmt::print("\nGrowth with the data's width ({}): head, two surfaces: time, samples and look-ups\n",
                       grows ? "the picture grows with it" : "picture 512x512");
            fmt::print("| width | plain | pyramid, termination 0.05 | default |\n| --- | --- | --- | --- |\n");
            std::vector<double> before, before_steps;
            for (int size = size_ / 2; size <= 2 * size_; size *= 2) {
                Scene scene = scene_of("head", size);
                scene.mode = ViewMode::ea;
                show_two_surfaces(scene);
                if (grows) scene.size = glm::ivec2(2 * size);
                Plan standard = default_plan(scene);
                standard.step = 1;
                std::vector<Way> ways{
                    {"", plan_of(Structure::none, 0)}, {"", plan_of(Structure::pyramid, 0.05)}, {"", standard}};
                run(scene, ways);
                std::string line = fmt::format("| {} ", size);
                for (std::size_t i = 0; i < ways.size(); ++i) {
                    const double now = median(ways[i].ms), steps = ways[i].steps();
                    line += before.empty() ? fmt::format("| {:.1f} ms, {:.2f} M ", now, steps)
                                           : fmt::format("| {:.1f} ms ({:.2f} times), {:.2f} M ({:.2f}) ", now,
                                                         now / before[i], steps, steps / before_steps[i]);
                    ways[i].ms = {now};
                }
                before.clear();
                before_steps.clear();
                for (const Way& way : ways) {
                    before.push_back(way.ms[0]);
                    before_steps.push_back(way.steps());
                }
                fmt::print("{}|\n", line);
            }
        }
    }

    /// Es, Keles & Isler 2006: an opaque part, nearest sampling, a field a voxel as published; then over macro-cells.
    void es() {
        for (const int cells : {1, 8}) {
            Scene scene = scene_of("casting", size_);
            scene.mode = ViewMode::ea;
            scene.shading = Shading::none;
            std::vector<Way> ways;
            for (Structure s : {Structure::none, Structure::pc, Structure::acd, Structure::eacd}) {
                Plan plan = plan_of(s, 0.002);
                plan.cells = cells;
                plan.sampler = Sampler::nearest;
                ways.push_back({std::string(s == Structure::none ? "plain" : name_of(s)), plan});
            }
            run(scene, ways);
            table(fmt::format("Es: casting {}^3, nearest, step 1, {}", size_,
                              cells == 1 ? "a field a voxel, as published" : "macro-cells of 8^3"),
                  ways);
            fmt::print("Steps (samples and look-ups) eacd : acd {:.2f}\n", ways[3].steps() / ways[2].steps());
        }
    }

    /// Lesar 2015: isosurface and opaque rendering with and without octree and sparse casting; what effects add.
    void lesar() {
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea}) {
            Scene scene = scene_of("head", size_);
            scene.mode = mode;
            std::vector<Way> ways{{"plain", plan_of(Structure::none, 0.002)},
                                  {"octree", plan_of(Structure::octree, 0.002)},
                                  {"sparse 2", plan_of(Structure::none, 0.002)},
                                  {"octree, sparse 2", plan_of(Structure::octree, 0.002)},
                                  {"octree, ssao", plan_of(Structure::octree, 0.002), parse_effects("ssao")},
                                  {"octree, dof", plan_of(Structure::octree, 0.002), parse_effects("dof")}};
            ways[2].plan.sparse = ways[3].plan.sparse = 2;
            run(scene, ways);
            table(fmt::format("Lesar: head {}^3, {}, 512x512, step 1", size_, name_of(mode)), ways);
        }
    }

    /// Bytes of every structure against the voxels'.
    void memory() {
        fmt::print("\n| structure | MiB | of the voxels' bytes |\n| --- | --- | --- |\n");
        Scene scene = scene_of("casting", size_);
        scene.mode = ViewMode::ea;
        for (Structure s : {Structure::macrocells, Structure::octree, Structure::pyramid, Structure::pc, Structure::acd,
                            Structure::eacd}) {
            engine_.drop_caches();
            const RenderResult result = engine_.render(scene, plan_of(s, 0.002));
            const double bytes = double(result.build.begin()->second.bytes);
            fmt::print("| {} | {:.2f} | {:.2f} % |\n", name_of(s), bytes / (1 << 20),
                       100 * bytes / double(scene.volume.bytes()));
        }
    }

    /// Distances over macro-cells made anew after an edit of the classification: the cells' ranges stay.
    void rebuild() {
        fmt::print("\n| rebuilt after an edit, ms | pc | acd | eacd |\n| --- | --- | --- | --- |\n");
        for (int size : {size_, 2 * size_}) {
            std::string line = fmt::format("| casting {}^3 ", size);
            Scene scene = scene_of("casting", size);
            scene.mode = ViewMode::ea;
            for (Structure s : {Structure::pc, Structure::acd, Structure::eacd}) {
                std::vector<double> ms;
                for (int i = 0; i < 7; ++i) {
                    for (TransferPoint& p : scene.classification.tf.points) p.value += 1;
                    const double took = engine_.render(scene, plan_of(s, 0.002)).build.begin()->second.ms;
                    if (i > 0) ms.push_back(took);
                }
                line += fmt::format("| {:.1f} ", median(ms));
            }
            fmt::print("{}|\n", line);
        }
    }

private:
    static Plan plan_of(Structure structure, double ert) {
        Plan plan;
        plan.structure = structure;
        plan.ert = ert;
        plan.step = 1;
        return plan;
    }

    static Scene scene_of(const std::string& sample, int size) {
        const Volume volume = make_sample(sample, {.size = size}).volume;
        Scene scene = default_scene(volume, compute_statistics(volume));
        scene.camera.zoom = 1.3;
        return scene;
    }

    /// Levoy's analysis: a semi-transparent surface before an opaque one.
    static void show_two_surfaces(Scene& scene) {
        TransferFunction& tf = scene.classification.tf;
        tf.points = {{-600, {0.9, 0.7, 0.6}, 0}, {-500, {0.9, 0.7, 0.6}, 0.15}, {-300, {0.9, 0.7, 0.6}, 0.15},
                     {-200, {0.9, 0.7, 0.6}, 0}, {200, {1, 1, 0.9}, 0},         {500, {1, 1, 0.9}, 0.8},
                     {3000, {1, 1, 0.9}, 0.9}};
    }

    void run(Scene& scene, std::vector<Way>& ways) {
        scene.camera.azimuth_deg = 7;
        scene.camera.elevation_deg = 20;
        const std::vector<Camera> turn = full_turn(scene.camera, views_);
        for (int view = -1; view < views_; ++view) {  // view -1 builds, compiles and compares
            scene.camera = turn[std::size_t(std::max(view, 0))];
            Frame truth;
            for (Way& way : ways) {
                scene.effects = way.effects;
                const double before_ms = processor_ms();
                const RenderResult result = engine_.render(scene, way.plan, {}, false);
                if (view >= 0) {
                    way.ms.push_back(processor_ms() - before_ms);
                    continue;
                }
                if (!result.build.empty()) way.build = result.build.begin()->second;
                if (&way == &ways.front()) truth = result.frame;
                way.error = compare(result.frame, truth, {0, 0, 0});
                way.counters = engine_.render(scene, way.plan, {}, true).frame.counters;
            }
        }
        scene.effects.clear();
    }

    static void table(const std::string& title, const std::vector<Way>& ways) {
        fmt::print(
            "\n{}\n| way | processor ms | gain | samples | look-ups | build ms | MiB | max, mean difference /255 |\n",
            title);
        fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
        const double plain = median(ways.front().ms);
        for (const Way& way : ways)
            fmt::print("| {} | {:.1f} | {:.2f} | {:.2f} M | {:.2f} M | {:.1f} | {:.2f} | {:.2f}, {:.4f} |\n", way.name,
                       median(way.ms), plain / median(way.ms), double(way.counters.samples) * 1e-6,
                       double(way.counters.structure_reads) * 1e-6, way.build.ms, double(way.build.bytes) / (1 << 20),
                       way.error.max, way.error.mean);
        std::fflush(stdout);
    }

    Engine engine_;
    int size_, views_;
};

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
    using namespace lacuna;
    const std::string what = argc > 1 ? argv[1] : "all";
    const auto number = [&](int i, int otherwise) { return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise; };
    try {
        const auto device = open_device();
        if (!device) throw Error(Errc::device, "There is no usable OpenCL device.");
        SeedsBench bench(device, number(2, 256), number(3, 6), argc > 4 && std::string(argv[4]) == "blocks");
        bool known = false;
        const auto part = [&](const char* name, void (SeedsBench::*run)()) {
            if (what != name && what != "all") return;
            known = true;
            (bench.*run)();
        };
        part("levoy", &SeedsBench::levoy);
        part("es", &SeedsBench::es);
        part("lesar", &SeedsBench::lesar);
        part("memory", &SeedsBench::memory);
        part("rebuild", &SeedsBench::rebuild);
        if (!known) throw Error(Errc::bad_usage, "Known parts: levoy, es, lesar, memory, rebuild, all.");
        return 0;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "bench_seeds: {}\n", failure.what());
        return 1;
    }
}
