// Leaping through homogeneous regions (Frey & Ertl 2009): how long its volume takes in three ways, and what it gains
// over brute force, measured in turn in one run.
//   bench_leap prepare [SIZE [WAYS]]        default 512 128: the transform at SIZE, all three ways at WAYS
//   bench_leap render [SIZE [VIEWS [ROUNDS]]]   default 256 8 2
//   bench_leap table INPUT...               their Table 1 for range width 0.1: the largest region that does not touch
//   the
//                                           border, its surface the voxels of its boundary layer, as they count
//   bench_leap sweep INPUT [VIEWS [ROUNDS]]  their sweep of the range width: regions, and what leaping gains
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "core/accel/leap_volume.h"
#include "core/accuracy/image_error.h"
#include "core/base/order_statistics.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"
#include "core/io/volume_reader.h"
#include "core/regions/regions.h"
#include "core/render/opencl_renderer.h"
#include "core/render/turn.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"

namespace lacuna {
namespace {

double status_bytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key)) return 1024.0 * std::atof(line.c_str() + key.size() + 1);
    return 0;
}

/// Sum of how far rays can go from the leap voxels, mm.
double reach(const LeapVolume& leap, std::int64_t voxels) {
    double sum = 0;
    for (std::int64_t i = 0; i < voxels; ++i)
        if (leap.data()[i] & k_leap_bit) sum += (leap.data()[i] & 0x7fff) * leap.unit_mm;
    return sum;
}

void prepare(const Volume& volume, double width, LeapWay way, const char* name, CentreGroups groups = {}) {
    LeapOptions options;
    options.range_width = width;
    options.step_mm = 0.5 * volume.geometry().smallest_spacing_mm();
    options.way = way;
    options.groups = groups;
    std::ofstream("/proc/self/clear_refs") << "5";
    const double before = status_bytes("VmRSS:");
    const Stopwatch clock;
    double grown_ms = 0;
    const JobContext job{{}, [&](double done) { grown_ms = done <= 0.6 ? clock.ms() : grown_ms; }};
    const LeapVolume leap = build_leap_volume(volume, options, job);
    const double voxels = double(volume.geometry().voxel_count());
    fmt::print("| {} | {}^3 | {} | {:.2f} | {:.2f} | {:.1f} | {} | {:.1f} | {:.1f} | {:.2f} |\n", name,
               volume.geometry().size.x, width, clock.ms() / 1000, (clock.ms() - grown_ms) / 1000,
               (status_bytes("VmHWM:") - before) / voxels, leap.regions, 100 * double(leap.region_voxels) / voxels,
               100 * double(leap.leap_voxels) / voxels,
               reach(leap, volume.geometry().voxel_count()) / std::max(1.0, double(leap.leap_voxels)) /
                   volume.geometry().smallest_spacing_mm());
    std::fflush(stdout);
}

void prepare_all(int size, int ways) {
    fmt::print("{} threads\n", thread_count());
    fmt::print(
        "| way | casting | range width | s | of it leap values s | peak B a voxel | regions | in regions % | leap "
        "voxels "
        "% | mean leap, voxels |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    const Volume large = make_sample("casting", {.size = size}).volume;
    for (const double width : {0.1, 0.3}) prepare(large, width, LeapWay::transform, "transform");
    const Volume small = make_sample("casting", {.size = ways}).volume;
    for (const double width : {0.1, 0.3}) {
        prepare(small, width, LeapWay::transform, "transform");
        prepare(small, width, LeapWay::kd_tree, "kd-tree");
        prepare(small, width, LeapWay::groups, "groups, p 0.001, r 0.5", {0.001, 0.5, 1});
        prepare(small, width, LeapWay::groups, "groups, p 0.01, r 0.5", {0.01, 0.5, 1});
    }
}

struct BenchScene {
    std::string name;
    Scene scene;
    std::vector<double> widths;
};

BenchScene make_scene(const std::string& name, const Volume& volume, Shading shading, double opacity,
                      std::vector<double> widths) {
    const VolumeStatistics statistics = compute_statistics(volume);
    Scene scene = default_scene(volume, statistics);
    scene.mode = ViewMode::ea;
    scene.shading = shading;
    scene.camera.zoom = 1.5;
    scene.camera.azimuth_deg = 15;
    scene.camera.elevation_deg = 20;
    const double lo = statistics.range.lo, w = statistics.range.width(), unit = volume.geometry().diameter_mm() / 200;
    if (opacity > 0)
        scene.classification.tf = {"glass",
                                   unit,
                                   {{lo + 0.25 * w, {0.2, 0.4, 0.9}, 0},
                                    {lo + 0.5 * w, {0.9, 0.8, 0.3}, opacity},
                                    {lo + w, {1, 0.5, 0.2}, 2 * opacity}},
                                   {}};
    return {name, scene, std::move(widths)};
}

std::vector<BenchScene> make_scenes(int size) {
    std::vector<BenchScene> scenes;
    const auto add = [&](const char* name, const Volume& volume, Shading shading, double opacity,
                         std::vector<double> widths) {
        scenes.push_back(make_scene(name, volume, shading, opacity, std::move(widths)));
    };
    const Volume casting = make_sample("casting", {.size = size}).volume;
    add("casting, glass", casting, Shading::none, 0.02, {0.05, 0.1, 0.2, 0.3});
    add("casting, fitted, Phong", casting, Shading::phong, 0, {0.1, 0.3});
    const Volume balls = make_sample("spheres", {.size = size, .noise = 0}).volume;
    add("balls without noise, glass", balls, Shading::none, 0.02, {0, 0.1});
    add("balls without noise, fitted, Phong", balls, Shading::phong, 0, {0});
    return scenes;
}

void table(const std::string& input) {
    const Volume volume = open_volume(input);
    RegionOptions options;
    options.range_width = 0.1;
    options.min_voxels = 8;
    const RegionTable found = find_regions(volume, options);
    const double voxels = double(volume.geometry().voxel_count());
    std::int64_t background = 0, large = 0;
    for (const RegionCharacteristics& row : found.rows) {
        if (row.touches_border) background = std::max(background, row.voxels);
        large += double(row.voxels) >= 0.001 * voxels;
    }
    const auto row =
        std::find_if(found.rows.begin(), found.rows.end(), [](const auto& r) { return !r.touches_border; });
    if (row == found.rows.end()) return;
    const LabelGrid grid{volume.geometry().size, volume.geometry().spacing, found.labels.labels->data()};
    const BoundaryList boundary = boundary_list(grid, std::uint32_t(found.rows.size()));
    const double layer = double(boundary.first[row->id + 1] - boundary.first[row->id]), v = double(row->voxels);
    fmt::print(
        "{}: {} regions of at least 0.1 % of the voxels ({} of at least 8 voxels); the largest inside has {} voxels, "
        "{:.1f} % of those outside the largest region at the border; boundary layer {} voxels, s^3/v^2 {:.0f} by that "
        "count, {:.0f} by {}; {} holes\n",
        volume.name, large, found.rows.size(), row->voxels, 100 * v / (voxels - double(background)), layer,
        layer * layer * layer / (v * v), row->shape_factor, found.surface_method, row->holes);
}

struct Row {
    std::string name;
    Plan plan;
    std::vector<double> ms = {};
    BuildRecord build = {};
    ImageError error = {};
    Counters counters = {};
};

void render(const BenchScene& bench, const std::shared_ptr<ComputeDevice>& device, int views, int rounds) {
    std::vector<Row> rows;
    const auto add = [&](std::string name, Structure structure, double width, Leaping kernel) {
        Plan plan = default_plan(bench.scene);
        plan.structure = structure;
        plan.homogeneity = width;
        plan.leap.kernel = kernel;
        rows.push_back({std::move(name), plan});
    };
    add("none", Structure::none, 0, Leaping::lossless);
    add("acd", Structure::acd, 0, Leaping::lossless);
    for (const double width : bench.widths) {
        add(fmt::format("leap {}", width), Structure::leap, width, Leaping::lossless);
        if (bench.scene.shading != Shading::none) continue;
        add(fmt::format("leap {} confirmed", width), Structure::leap, width, Leaping::confirmed);
        add(fmt::format("leap {} published", width), Structure::leap, width, Leaping::published);
    }
    // A renderer each: one keeps one leap volume.
    std::vector<std::unique_ptr<OpenClRenderer>> renderers;
    for (std::size_t i = 0; i < rows.size(); ++i)
        renderers.push_back(std::make_unique<OpenClRenderer>(device, 0, false));
    const std::vector<Camera> turn = full_turn(bench.scene.camera, views);
    for (int round = -1; round < rounds; ++round)  // round -1 builds, compiles and compares
        for (const Camera& view : std::span(turn).first(round < 0 ? 1 : turn.size())) {
            Scene scene = bench.scene;
            scene.camera = view;
            Frame truth;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const RenderResult result = renderers[i]->render(scene, rows[i].plan, {}, false);
                if (round >= 0) {
                    rows[i].ms.push_back(result.frame.ms);
                    continue;
                }
                if (i == 0) truth = result.frame;
                rows[i].error = compare(result.frame, truth, {0, 0, 0});
                if (!result.build.empty()) rows[i].build = result.build.begin()->second;
                rows[i].counters = renderers[i]->render(scene, rows[i].plan, {}, true).frame.counters;
            }
        }
    fmt::print("\n{}: brute force {:.1f} ms a frame\n", bench.name, median(rows[0].ms));
    fmt::print(
        "| plan | ms | gain | samples | skipped | reads | build ms | MiB | mean, largest difference /255 |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const Row& row : rows)
        fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} M | {:.1f} M | {:.1f} M | {:.0f} | {:.1f} | {:.2f}, {:.1f} |\n",
                   row.name, median(row.ms), median(rows[0].ms) / median(row.ms), double(row.counters.samples) * 1e-6,
                   double(row.counters.skipped) * 1e-6, double(row.counters.structure_reads) * 1e-6, row.build.ms,
                   double(row.build.bytes) / (1 << 20), row.error.mean, row.error.max);
    std::fflush(stdout);
}

void sweep_widths(const std::string& input, const std::shared_ptr<ComputeDevice>& device, int views, int rounds) {
    const Volume volume = open_volume(input);
    const std::vector<double> widths{0.02, 0.05, 0.1, 0.2, 0.3, 0.5};
    fmt::print(
        "| range width | regions | in regions % | leap voxels % | mean leap, voxels | prepared in s |\n"
        "| --- | --- | --- | --- | --- | --- |\n");
    for (const double width : widths) {
        LeapOptions options;
        options.range_width = width;
        options.step_mm = 0.5 * volume.geometry().smallest_spacing_mm();
        const Stopwatch clock;
        const LeapVolume leap = build_leap_volume(volume, options);
        const std::int64_t voxels = volume.geometry().voxel_count();
        fmt::print(
            "| {} | {} | {:.1f} | {:.1f} | {:.2f} | {:.2f} |\n", width, leap.regions,
            100 * double(leap.region_voxels) / double(voxels), 100 * double(leap.leap_voxels) / double(voxels),
            reach(leap, voxels) / std::max(1.0, double(leap.leap_voxels)) / volume.geometry().smallest_spacing_mm(),
            clock.ms() / 1000);
        std::fflush(stdout);
    }
    render(make_scene(volume.name + ", glass", volume, Shading::none, 0.02, widths), device, views, rounds);
}

}  // namespace
}  // namespace lacuna

int main(int argc, char** argv) {
    using namespace lacuna;
    const std::string what = argc > 1 ? argv[1] : "render";
    const auto argument = [&](int i, int otherwise) { return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise; };
    if (what == "prepare") {
        prepare_all(argument(2, 512), argument(3, 128));
        return 0;
    }
    if (what == "table") {
        for (int i = 2; i < argc; ++i) table(argv[i]);
        return 0;
    }
    const auto device = open_device();
    if (!device) {
        fmt::print(stderr, "bench_leap: no usable OpenCL device.\n");
        return 1;
    }
    if (what == "sweep") {
        if (argc < 3) return fmt::print(stderr, "bench_leap: sweep needs an INPUT.\n"), 2;
        sweep_widths(argv[2], device, argument(3, 4), argument(4, 2));
        return 0;
    }
    const int size = argument(2, 256), views = argument(3, 8), rounds = argument(4, 2);
    fmt::print("{}: {}^3 voxels, 512x512 pixels, step 0.5, {} views, {} rounds\n", device->info().name, size, views,
               rounds);
    for (const BenchScene& scene : make_scenes(size)) render(scene, device, views, rounds);
}
