// What each effect costs, as a share of the frame it is applied to: frame and effects measured in turn in one run.
//   bench_effects [SIZE [ROUNDS]]      default 256 9
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"
#include "core/render/engine.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"

int main(int argc, char** argv) {
    using namespace lacuna;
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise; };
    const int size = argument(1, 256), rounds = argument(2, 9);
    const auto least = [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); };
    const char* effects[] = {"ssao", "dof", "gamma=2.2", "tonemap", "brightness=0.1", "contrast=1.2", "ao=16"};
    Engine engine(open_device());
    fmt::print("{} threads, {}, {}^3 voxels, 512x512 pixels, least of {} runs; in brackets: share of the frame\n",
               thread_count(), engine.device_name(), size, rounds);
    fmt::print("| scene | frame ms |");
    for (const char* effect : effects) fmt::print(" {} |", effect);
    fmt::print("\n| --- | --- |{}\n", " --- | --- | --- | --- | --- | --- | --- |");
    for (const char* name : {"casting", "head"}) {
        const Volume volume = make_sample(name, {.size = size}).volume;
        for (const ViewMode mode : {ViewMode::iso, ViewMode::ea}) {
            Scene scene = default_scene(volume, compute_statistics(volume));
            scene.mode = mode;
            scene.camera.zoom = 1.5;
            scene.camera.azimuth_deg = 30;
            scene.camera.elevation_deg = 20;
            const Plan plan = default_plan(scene);
            const Frame clean = engine.render(scene, plan).frame;
            std::vector<double> frame_ms;
            std::map<std::string, std::vector<double>> effect_ms;
            for (int round = 0; round < rounds; ++round) {
                frame_ms.push_back(engine.render(scene, plan).frame.ms);
                for (const char* effect : effects) {
                    if (round > 1 && std::string(effect).starts_with("ao")) continue;  // seconds a frame
                    Scene with = scene;
                    with.effects = parse_effects(effect);
                    Frame frame = clean;
                    const Stopwatch watch;
                    apply_effects(with, frame);
                    effect_ms[effect].push_back(watch.ms());
                }
            }
            fmt::print("| {}, {} | {:.1f} |", name, name_of(mode), least(frame_ms));
            for (const char* effect : effects) {
                const double ms = least(effect_ms[effect]);
                fmt::print(" {:.1f} ({:.0f} %) |", ms, 100 * ms / least(frame_ms));
            }
            fmt::print("\n");
        }
    }
}
