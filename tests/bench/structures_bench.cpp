// Every structure against brute force: the same scenes, the same views, measured in turn (none, a, b, ..., none, a,
// ...) in one run, so that the ratios hold even where the machine's speed wanders. Prints one table a scene.
//   bench_structures [SIZE [VIEWS [ROUNDS]]]      default 256 12 3
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <span>
#include <vector>

#include "core/accuracy/image_error.h"
#include "core/base/order_statistics.h"
#include "core/compute/device.h"
#include "core/render/opencl_renderer.h"
#include "core/render/turn.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"

namespace lacuna {
namespace {

struct BenchScene {
    std::string name;
    Scene scene;
};

/// All values a little visible: what no structure can help.
TransferFunction fog(const VolumeStatistics& statistics, double spacing_mm) {
    const ValueRange range = statistics.range;
    return {"fog", spacing_mm, {{range.lo, {0.3, 0.5, 0.9}, 0.001}, {range.hi, {1, 1, 1}, 0.006}}, {}};
}

std::vector<BenchScene> make_scenes(int size) {
    std::vector<BenchScene> scenes;
    for (const char* name : {"casting", "head", "vessels"}) {
        const Volume volume = make_sample(name, {.size = size}).volume;
        const VolumeStatistics statistics = compute_statistics(volume);
        Scene scene = default_scene(volume, statistics);
        scene.camera.zoom = 1.5;
        scene.camera.elevation_deg = 20;
        for (ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip}) {
            scene.mode = mode;
            scenes.push_back({fmt::format("{} {}", name, name_of(mode)), scene});
        }
        if (std::string(name) == "casting") {
            scene.mode = ViewMode::ea;
            scene.classification.tf = fog(statistics, volume.geometry().smallest_spacing_mm());
            scenes.push_back({"casting fog", scene});
        }
    }
    return scenes;
}

struct Row {
    std::vector<double> ms;
    BuildRecord build;
    double worst = 0;  // difference from brute force, in 1/255
    Counters counters;
};

void run(const BenchScene& bench, OpenClRenderer& renderer, int views, int rounds) {
    const Structure structures[] = {Structure::none, Structure::macrocells, Structure::octree, Structure::pyramid,
                                    Structure::pc,   Structure::acd,        Structure::eacd,   Structure::leap};
    std::map<Structure, Row> rows;
    const std::vector<Camera> turn = full_turn(bench.scene.camera, views);
    for (int round = -1; round < rounds; ++round)  // round -1 builds, compiles and compares
        for (const Camera& view : std::span(turn).first(round < 0 ? 1 : turn.size())) {
            Scene scene = bench.scene;
            scene.camera = view;
            Frame truth;
            for (Structure structure : structures) {
                Plan plan = default_plan(scene);
                plan.structure = structure;
                plan.cells = Plan{}.cells;
                Row& row = rows[structure];
                const RenderResult result = renderer.render(scene, plan, {}, false);
                if (round >= 0) {
                    row.ms.push_back(result.frame.ms);
                    continue;
                }
                if (structure == Structure::none) truth = result.frame;
                row.worst = compare(result.frame, truth, {0, 0, 0}).max;
                if (!result.build.empty()) row.build = result.build.begin()->second;
                row.counters = renderer.render(scene, plan, {}, true).frame.counters;
            }
        }
    const double brute = median(rows[Structure::none].ms);
    fmt::print("\n{}: brute force {:.1f} ms a frame, {:.1f} M samples\n", bench.name, brute,
               double(rows[Structure::none].counters.samples) * 1e-6);
    fmt::print("| structure | ms | gain | samples | reads | build ms | MiB | max difference /255 |\n");
    fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (Structure structure : structures) {
        const Row& row = rows[structure];
        fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} M | {:.1f} M | {:.1f} | {:.1f} | {:.2f} |\n", name_of(structure),
                   median(row.ms), brute / median(row.ms), double(row.counters.samples) * 1e-6,
                   double(row.counters.structure_reads) * 1e-6, row.build.ms, double(row.build.bytes) / (1 << 20),
                   row.worst);
    }
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
    using namespace lacuna;
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise; };
    const int size = argument(1, 256), views = argument(2, 12), rounds = argument(3, 3);
    const auto device = open_device();
    if (!device) {
        fmt::print(stderr, "bench_structures: no usable OpenCL device.\n");
        return 1;
    }
    fmt::print("{}: {}^3 voxels, 512x512 pixels, step 0.5, {} views, {} rounds\n", device->info().name, size, views,
               rounds);
    OpenClRenderer renderer(device, 0, false);  // structures by themselves
    for (const BenchScene& scene : make_scenes(size)) run(scene, renderer, views, rounds);
}
