// Shear-warp of visible voxels against isosurface ray casting with distances (acd): the same scenes and views, measured
// in turn in one run, so that the ratios hold even where the machine's speed wanders. Prints rates of extraction, frame
// rates, cuts, what a new isovalue costs, what all regions cost, and how far the picture pops where the principal axis
// switches.
//   bench_shear_warp [SIZE [VIEWS [ROUNDS]]]      default 256 36 3
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/order_statistics.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"
#include "core/render/engine.h"
#include "core/render/shear_warp.h"
#include "core/render/turn.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"

namespace lacuna {
namespace {

/// The middle slices of a cube along z, as the paper's volumes are flatter than cubes.
Volume flattened(const Volume& cube, int slices) {
    GridGeometry geometry = cube.geometry();
    const int skip = (geometry.size.z - slices) / 2;
    geometry.size.z = slices;
    return visit_type(cube.type(), [&](auto tag) {
        using T = decltype(tag);
        return make_volume<T>(geometry, [&](std::span<T> voxels) {
            const T* from = cube.view<T>().row(0, skip);
            std::copy(from, from + voxels.size(), voxels.begin());
        });
    });
}

/// A skull: the head's bone.
Scene skull(const Volume& volume) {
    Scene scene = default_scene(volume, compute_statistics(volume));
    scene.mode = ViewMode::shear_warp;
    scene.iso = 400;
    scene.camera.zoom = 1.5;
    return scene;
}

struct Way {
    std::string name;
    Scene scene;
    Plan plan;
    std::vector<double> ms;
};

Way way(std::string name, Scene scene, Sampler sampler, Shading shading) {
    scene.shading = shading;
    Plan plan = default_plan(scene);
    plan.sampler = sampler;
    return {std::move(name), scene, plan, {}};
}

std::vector<Way> ways(const Scene& scene) {
    std::vector<Way> all;
    Scene iso = scene;
    iso.mode = ViewMode::iso;
    all.push_back(way("isosurface ray casting, acd, Phong", iso, Sampler::linear, Shading::phong));
    all.push_back(way("nearest, Lambert", scene, Sampler::nearest, Shading::lambert));
    all.push_back(way("nearest, Phong", scene, Sampler::nearest, Shading::phong));
    const glm::dvec3 middle = scene.volume.geometry().centre_mm();
    for (const bool aligned : {false, true}) {
        Scene cut = scene;
        const glm::dvec3 normal = aligned ? scene.volume.geometry().direction[0] : glm::dvec3(0.6, 0.64, -0.48);
        cut.cuts = {{normal, -glm::dot(normal, middle), true}};
        all.push_back(way(aligned ? "nearest, Phong, axis-aligned cut" : "nearest, Phong, oblique cut", cut,
                          Sampler::nearest, Shading::phong));
    }
    all.push_back(way("bilinear, Phong", scene, Sampler::linear, Shading::phong));
    return all;
}

void frame_rates(const Scene& scene, Engine& engine, int views, int rounds) {
    std::vector<Way> all = ways(scene);
    Camera first = scene.camera;
    first.azimuth_deg = 360.0 * 0.37 / views;  // along none of the volume's axes
    first.elevation_deg = 20;
    const std::vector<Camera> turn = full_turn(first, views);
    for (int round = -1; round < rounds; ++round)  // round -1 builds and compiles
        for (const Camera& view : turn)
            for (Way& w : all) {
                w.scene.camera = view;
                const double ms = engine.render(w.scene, w.plan).frame.ms;
                if (round >= 0) w.ms.push_back(ms);
            }
    fmt::print("\n| orbit of {} views, 512x512 | ms | frames/s | against ray casting |\n| --- | --- | --- | --- |\n",
               views);
    for (const Way& w : all)
        fmt::print("| {} | {:.2f} | {:.0f} | {:.2f} |\n", w.name, median(w.ms), 1000 / median(w.ms),
                   median(all[0].ms) / median(w.ms));
}

/// A cut that moves a little every frame: each picture is a new extraction.
void moving_cuts(const Scene& scene, int frames) {
    fmt::print("\n| a cut moving, extraction included | ms | frames/s |\n| --- | --- | --- |\n");
    const glm::dvec3 middle = scene.volume.geometry().centre_mm();
    for (const bool aligned : {false, true})
        for (const bool cap : {true, false}) {
            ShearWarpRenderer renderer;
            std::vector<double> ms;
            for (int frame = -1; frame < frames; ++frame) {
                Scene cut = scene;
                const glm::dvec3 normal = aligned ? scene.volume.geometry().direction[0] : glm::dvec3(0.6, 0.64, -0.48);
                cut.cuts = {{normal, 0.4 * frame - 5 - glm::dot(normal, middle), cap}};
                cut.camera.azimuth_deg = 30;
                cut.camera.elevation_deg = 20;
                Plan plan = default_plan(cut);
                plan.sampler = Sampler::nearest;
                BuildRecord built;
                const Stopwatch watch;
                renderer.render(cut, plan, {}, built);
                if (frame >= 0) ms.push_back(watch.ms());
            }
            fmt::print("| {} plane, {} | {:.2f} | {:.0f} |\n", aligned ? "axis-aligned" : "oblique",
                       cap ? "capped" : "open", median(ms), 1000 / median(ms));
        }
}

void extraction(const Scene& scene, int rounds) {
    const Solid solid{scene.iso, {}, {}};
    std::vector<double> all_ms[2], first_ms[2];
    double share[2] = {0, 0};
    std::size_t bytes = 0;
    for (int round = 0; round < rounds; ++round)
        for (const int regions : {24, 6}) {
            VisibleVoxelCache cache;
            const std::size_t which = regions == 6;
            const Stopwatch watch;
            std::size_t listed = 0;
            for (const SliceDirection& direction : slice_directions(regions))
                listed += cache.get(scene.volume, solid, direction)->column.size();
            all_ms[which].push_back(watch.ms());
            share[which] = 100.0 * double(listed) / regions / double(scene.volume.geometry().voxel_count());
            if (regions == 24) bytes = cache.bytes_held();
        }
    // A new isovalue: the same renderer, another surface every time, up to the picture.
    ShearWarpRenderer renderer;
    Camera first = scene.camera;
    first.azimuth_deg = 7;
    int n = 0;
    for (const Camera& view : full_turn(first, 12)) {
        for (const Sampler sampler : {Sampler::nearest, Sampler::linear}) {
            Scene moved = scene;
            moved.iso += 5 * n;
            moved.camera = view;
            Plan plan = default_plan(moved);
            plan.sampler = sampler;
            BuildRecord built;
            const Stopwatch watch;
            renderer.render(moved, plan, {}, built);
            first_ms[sampler == Sampler::linear].push_back(watch.ms());
        }
        ++n;
    }
    fmt::print("\n| extraction | 24 regions | 6 regions |\n| --- | --- | --- |\n");
    fmt::print("| visible voxels, % of all, mean of the regions | {:.2f} | {:.2f} |\n", share[0], share[1]);
    fmt::print("| all regions prepared, ms | {:.0f} | {:.0f} |\n", median(all_ms[0]), median(all_ms[1]));
    fmt::print(
        "\nlists of all 24 regions and the object's bits: {:.1f} MiB. First picture of a new isovalue: nearest "
        "{:.1f} ms, worst {:.1f}; bilinear (one list more) {:.1f} ms, worst {:.1f}\n",
        double(bytes) / (1 << 20), median(first_ms[0]), *std::max_element(first_ms[0].begin(), first_ms[0].end()),
        median(first_ms[1]), *std::max_element(first_ms[1].begin(), first_ms[1].end()));
}

/// Mean difference of two pictures in grey levels, and the share of pixels that differ by over 16 of them.
std::pair<double, double> difference(const Frame& a, const Frame& b) {
    double sum = 0, large = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
        const double apart = 255 * std::fabs(double(a.color[i].r) - double(b.color[i].r));
        sum += apart;
        large += apart > 16;
    }
    return {sum / double(a.pixels()), 100 * large / double(a.pixels())};
}

/// A turn of 0.02 degrees about where the principal axis switches from x to y (azimuth 45, whatever the elevation) and
/// from y to z (tan elevation = cos azimuth), and the same turn 0.05 degrees beside it.
void popping(const Scene& scene) {
    fmt::print(
        "\n| a turn by 0.02 degrees | mean change /255 | pixels that change by over 16, % |\n| --- | --- | --- |\n");
    ShearWarpRenderer renderer;
    const double to_z = glm::degrees(std::atan(std::cos(glm::radians(20.0))));
    for (const Sampler sampler : {Sampler::nearest, Sampler::linear})
        for (const bool rising : {false, true})
            for (const double beside : {0.05, 0.0}) {
                Scene a = scene;
                Plan plan = default_plan(a);
                plan.sampler = sampler;
                BuildRecord built;
                a.camera.azimuth_deg = rising ? 20 : 44.99 - beside;
                a.camera.elevation_deg = rising ? to_z - 0.01 - beside : 20;
                const Frame before = renderer.render(a, plan, {}, built);
                (rising ? a.camera.elevation_deg : a.camera.azimuth_deg) += 0.02;
                const auto [mean, share] = difference(before, renderer.render(a, plan, {}, built));
                fmt::print("| {}, {}{} | {:.2f} | {:.2f} |\n", sampler == Sampler::linear ? "bilinear" : "nearest",
                           beside == 0 ? "over the switch " : "beside the switch ", rising ? "y to z" : "x to y", mean,
                           share);
            }
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
    using namespace lacuna;
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise; };
    const int size = argument(1, 256), views = argument(2, 36), rounds = argument(3, 3);
    Engine engine(open_device());
    for (const int edge : {size / 2, size}) {
        const Volume cube = make_sample("head", {.size = edge}).volume;
        const std::vector<int> heights =
            edge == size ? std::vector<int>{edge, edge * 225 / 256} : std::vector<int>{edge * 113 / 128};
        for (const int height : heights) {
            const Scene scene = skull(height == edge ? cube : flattened(cube, height));
            fmt::print("\n## head, {0}x{0}x{1}, {2}, isovalue {3}, {4} threads, {5}\n", edge, height,
                       name_of(cube.type()), scene.iso, thread_count(), engine.device_name());
            extraction(scene, rounds);
            frame_rates(scene, engine, views, rounds);
            moving_cuts(scene, 40);
            popping(scene);
        }
    }
}
