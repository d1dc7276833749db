// Ray-casting methods against the plain choice: the same scenes and views, measured in turn in one run, so that the
// ratios hold even where the machine's speed wanders. The error is that against the reference renderer's integral.
//   bench_methods [SIZE [VIEWS [ROUNDS]]]      default 256 8 2
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <span>
#include <vector>

#include "core/accuracy/image_error.h"
#include "core/base/order_statistics.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"
#include "core/render/opencl_renderer.h"
#include "core/render/reference_renderer.h"
#include "core/render/turn.h"
#include "core/volume/samples.h"
#include "core/volume/smooth.h"
#include "core/volume/statistics.h"

namespace lacuna {
namespace {

struct Method {
    std::string name;
    Plan plan;
};

struct Bench {
    std::string name;
    Scene scene;
    Plan truth;                   ///< what the reference renders
    std::vector<Method> methods;  ///< the first is the plain choice
};

/// What an edit of a transfer function looks like: a narrow peak, drawn like an isosurface.
TransferFunction peak(const Scene& scene) {
    const double lo = scene.window.lo, w = scene.window.width(), at = scene.iso, half = 0.03 * w;
    const double unit = scene.volume.geometry().smallest_spacing_mm();
    return {"peak",
            unit,
            {{lo, {0.2, 0.3, 0.9}, 0},
             {at - half, {0.2, 0.3, 0.9}, 0},
             {at, {1, 0.7, 0.2}, 0.9},
             {at + half, {0.9, 0.1, 0.1}, 0},
             {lo + w, glm::dvec3(1), 0}},
            {}};
}

Bench samplers(const std::string& name, Scene scene, ViewMode mode) {
    scene.mode = mode;
    Bench bench{name, scene, reference_plan(scene, default_plan(scene)), {}};
    for (Structure structure : {Structure::none, Structure::acd})
        for (Sampler sampler : {Sampler::linear, Sampler::adaptive, Sampler::nearest}) {
            Plan plan = default_plan(scene);
            plan.structure = structure;
            plan.sampler = sampler;
            bench.methods.push_back({fmt::format("{}, {}", name_of(sampler), name_of(structure)), plan});
        }
    return bench;
}

Bench refinements(const std::string& name, Scene scene) {
    scene.mode = ViewMode::iso;
    Plan truth = reference_plan(scene, default_plan(scene));
    truth.refine = Refinement::cubic;
    Bench bench{name, scene, truth, {}};
    for (const auto& [refinement, step] :
         {std::pair(Refinement::regula_falsi, 0.5), std::pair(Refinement::none, 0.5),
          std::pair(Refinement::bisect, 0.5), std::pair(Refinement::newton, 0.5),
          std::pair(Refinement::regula_falsi_plain, 0.5), std::pair(Refinement::cubic, 0.5),
          std::pair(Refinement::cubic, 1.0), std::pair(Refinement::cubic, 2.0),
          std::pair(Refinement::regula_falsi, 0.1)}) {
        Plan plan = default_plan(scene);
        plan.refine = refinement;
        plan.step = step;
        bench.methods.push_back({fmt::format("{}, step {}", name_of(refinement), step), plan});
    }
    return bench;
}

Bench gradients(const std::string& name, Scene scene, ViewMode mode) {
    scene.mode = mode;
    Bench bench{name, scene, reference_plan(scene, default_plan(scene)), {}};
    for (GradientFilter filter : {GradientFilter::central, GradientFilter::sobel})
        for (GradientStore store : {GradientStore::on_the_fly, GradientStore::stored}) {
            Plan plan = default_plan(scene);
            plan.gradient = filter;
            plan.gradient_store = store;
            bench.methods.push_back({fmt::format("{}, {}", name_of(filter), name_of(store)), plan});
        }
    return bench;
}

Bench integrations(const std::string& name, Scene scene, bool narrow) {
    scene.mode = ViewMode::ea;
    if (narrow) scene.classification.tf = peak(scene);
    Plan truth = reference_plan(scene, default_plan(scene));
    truth.integration = Integration::preintegrated;  // 16 samples a step of 0.5
    Bench bench{name, scene, truth, {}};
    for (const auto& [integration, step] :
         {std::pair(Integration::riemann, 0.5), std::pair(Integration::riemann, 1.0),
          std::pair(Integration::riemann, 0.1), std::pair(Integration::preintegrated, 0.5),
          std::pair(Integration::preintegrated, 1.0), std::pair(Integration::preintegrated, 2.0)}) {
        Plan plan = default_plan(scene);
        plan.integration = integration;
        plan.step = step;
        bench.methods.push_back({fmt::format("{}, step {}", name_of(integration), step), plan});
    }
    return bench;
}

void run(const Bench& bench, OpenClRenderer& renderer, int views, int rounds) {
    struct Row {
        std::vector<double> ms;
        double build_ms = 0, mib = 0;
        ImageError error;
        Counters counters;
    };
    std::vector<Row> rows(bench.methods.size());
    const std::vector<Camera> turn = full_turn(bench.scene.camera, views);
    for (int round = -1; round < rounds; ++round)  // round -1 builds, compiles and compares
        for (const Camera& view : std::span(turn).first(round < 0 ? 1 : turn.size())) {
            Scene scene = bench.scene;
            scene.camera = view;
            if (round < 0) scene.size = {256, 256};
            const Frame truth = round < 0 ? render_reference(scene, bench.truth) : Frame{};
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const Plan& plan = bench.methods[i].plan;
                const RenderResult result = renderer.render(scene, plan, {}, false);
                if (round >= 0) {
                    rows[i].ms.push_back(result.frame.ms);
                    continue;
                }
                rows[i].error = compare(result.frame, truth, {0, 0, 0});
                for (const auto& [what, made] : result.build) {
                    if (what == name_of(plan.structure)) continue;
                    rows[i].build_ms += made.ms;
                    rows[i].mib += double(made.bytes) / (1 << 20);
                }
                rows[i].counters = renderer.render(scene, plan, {}, true).frame.counters;
            }
        }
    const double plain = median(rows[0].ms);
    fmt::print("\n{}: plain {:.1f} ms a frame\n", bench.name, plain);
    fmt::print("| method | ms | gain | samples | of eight voxels | build ms | MiB | mean error /255 | PSNR |\n");
    fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        fmt::print("| {} | {:.1f} | {:.2f} | {:.2f} M | {:.2f} M | {:.1f} | {:.1f} | {:.3f} | {:.1f} |\n",
                   bench.methods[i].name, median(row.ms), plain / median(row.ms), double(row.counters.samples) * 1e-6,
                   double(row.counters.trilinear) * 1e-6, row.build_ms, row.mib, row.error.mean, row.error.psnr);
    }
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
    using namespace lacuna;
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise; };
    const int size = argument(1, 256), views = argument(2, 8), rounds = argument(3, 2);
    const auto device = open_device();
    if (!device) {
        fmt::print(stderr, "bench_methods: no usable OpenCL device.\n");
        return 1;
    }
    fmt::print("{}: {}^3 voxels, 512x512 pixels, {} views, {} rounds; errors at 256x256\n", device->info().name, size,
               views, rounds);
    OpenClRenderer renderer(device, 0, false);  // methods by themselves
    for (const char* name : {"casting", "head"}) {
        const Volume volume = make_sample(name, {.size = size}).volume;
        Scene scene = default_scene(volume, compute_statistics(volume));
        scene.camera.zoom = 1.5;
        scene.camera.azimuth_deg = 10;
        scene.camera.elevation_deg = 20;
        const std::string what = name;
        for (ViewMode mode : {ViewMode::iso, ViewMode::ea})
            run(samplers(what + ", samplers, " + std::string(name_of(mode)), scene, mode), renderer, views, rounds);
        run(refinements(what + ", refinements", scene), renderer, views, rounds);
        for (ViewMode mode : {ViewMode::iso, ViewMode::ea})
            run(gradients(what + ", gradients, " + std::string(name_of(mode)), scene, mode), renderer, views, rounds);
        run(integrations(what + ", integration, fitted", scene, false), renderer, views, rounds);
        run(integrations(what + ", integration, peak", scene, true), renderer, views, rounds);
        const Stopwatch watch;
        gaussian_smooth(volume, 1.5 * volume.geometry().smallest_spacing_mm());
        fmt::print("\n{}: smoothed by 1.5 voxels in {:.0f} ms\n", name, watch.ms());
    }
}
