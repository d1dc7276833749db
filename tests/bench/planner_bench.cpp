// How good the planner's picks are: the time of the plan it picks against the best measured plan that keeps the same
// error budget, both timed in turn, over the built-in samples.
//   bench_planner [SAMPLE-SIZE [PICTURE-SIDE]]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/accuracy/planner.h"
#include "core/accuracy/sweep.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"
#include "core/volume/samples.h"

using namespace lacuna;

namespace {

constexpr int k_rounds = 7;

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Time of the first plan over that of the second, timed in turn.
double ratio(Engine& engine, const Scene& scene, const Plan& a, const Plan& b) {
    std::vector<double> first, second;
    for (int round = 0; round < k_rounds; ++round) {
        first.push_back(engine.render(scene, a).frame.ms);
        second.push_back(engine.render(scene, b).frame.ms);
    }
    return median(first) / median(second);
}

}  // namespace

int main(int count, char** words) {
    const int sample = count > 1 ? std::atoi(words[1]) : 128, side = count > 2 ? std::atoi(words[2]) : 384;
    const std::shared_ptr<ComputeDevice> device = open_device();
    if (!device) return fmt::print("There is no OpenCL device to measure.\n"), 1;
    Engine engine(device);
    const auto costs = costs_of(engine);
    fmt::print("{}, samples of {}, pictures of {}\n", engine.device_name(), sample, side);
    if (costs) fmt::print("{}\n", describe(*costs));
    fmt::print("{:<16} {:<5} {:>6} {:>9} {:>7} {:>7} {:>8}  picked\n", "sample", "mode", "budget", "planning s",
               "error", "ratio", "over");
    double sum = 0;
    int scenes = 0, over = 0;
    for (const char* name : {"casting", "head", "vessels", "spheres"}) {
        const Volume volume = make_sample(name, {.size = sample}).volume;
        const VolumeStatistics statistics = compute_statistics(volume);
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea, ViewMode::mip}) {
            SweepScene swept;
            swept.name = name;
            swept.scene = default_scene(volume, statistics);
            swept.scene.mode = mode;
            swept.scene.size = {side, side};
            swept.scene.camera.azimuth_deg = 35;
            swept.scene.camera.elevation_deg = 20;
            swept.scene.camera.zoom = 1.5;
            swept.views = {swept.scene.camera};
            SweepOptions options;
            options.extent = SweepExtent::quick;
            options.rounds = 3;
            const SceneResult measured = sweep(engine, swept, options);
            for (const double budget : {0.5, 8.0}) {
                const Stopwatch watch;
                const PlannedPlan planned = choose_plan(engine, swept.scene, {.error = budget, .costs = costs});
                const double planning_s = 1e-3 * watch.ms();
                const SweepPoint* best = nullptr;
                for (const SweepPoint& point : measured.points)
                    if (point.refused.empty() && point.plan.mode == mode && point.error.max <= budget &&
                        (!best || point.ms < best->ms))
                        best = &point;
                if (!best) continue;
                const double slower = ratio(engine, swept.scene, planned.plan, best->plan.plan);
                sum += std::log(slower);
                ++scenes;
                over += !(planned.error <= budget);
                fmt::print("{:<16} {:<5} {:>6g} {:>9.1f} {:>7.3g} {:>7.2f} {:>8}  {} (best: {})\n", name, name_of(mode),
                           budget, planning_s, planned.error, slower, planned.error <= budget ? "no" : "yes",
                           planned.plan.why.front().substr(0, planned.plan.why.front().find(':')),
                           name_of(best->plan.plan.structure));
            }
        }
    }
    fmt::print("{} scenes: picked over best, geometric mean {:.2f}; budget exceeded in {}\n", scenes,
               std::exp(sum / std::max(1, scenes)), over);
    return 0;
}
