// Lacuna against VTK 9.1 on the same scenes: the same voxels, camera, transfer function, opacity correction, step,
// picture size and number of threads, frame by frame in turn. Both pictures are held against the reference renderer.
//   xvfb-run -a -s "-screen 0 1024x768x24 -noreset" build/bin/bench_peers --size 256 --views 12 --errors
// Times are from the call to the pixels on the host. Medians over the orbit; ratios are of medians.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/accuracy/image_error.h"
#include "core/base/order_statistics.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"
#include "core/render/engine.h"
#include "core/render/opencl_renderer.h"
#include "core/render/reference_renderer.h"
#include "core/render/turn.h"
#include "tests/bench/peers/peer_scenes.h"
#include "tests/bench/peers/vtk_peer.h"
#include "tests/bench/peers/vtk_threads.h"

namespace lacuna::peers {
namespace {

struct Options {
    int size = 256, views = 12, rounds = 1;
    std::vector<std::string> only{"ea", "mip", "iso", "lanes"};
    std::string scene;  // a part of a scene's name
    bool errors = false;
    std::string json;
    bool wants(const std::string& what) const { return std::find(only.begin(), only.end(), what) != only.end(); }
};

/// Ratios of one kind and their geometric mean.
struct Ratios {
    std::string what;
    std::vector<double> values;
    void print() const {
        if (values.empty()) return;
        double logs = 0;
        for (double v : values) logs += std::log(v);
        fmt::print("{}: geometric mean {:.1f}, least {:.1f}\n\n", what, std::exp(logs / double(values.size())),
                   *std::min_element(values.begin(), values.end()));
    }
};

class Bench {
public:
    Bench(Options options, std::shared_ptr<ComputeDevice> device)
        : options_(std::move(options)), device_(device), engine_(device), threads_(thread_count()) {
        report_["device"] = engine_.device_name();
        report_["size"] = options_.size;
        fmt::print("{}: {}^3 u16 voxels, 512x512 pixels, {} views, {} threads each\n", engine_.device_name(),
                   options_.size, options_.views, threads_);
    }

    void volumes(ViewMode mode, double step) {
        Ratios ratios{fmt::format("VTK's ray caster : Lacuna, {} {}^3", name_of(mode), options_.size), {}};
        fmt::print(
            "\n| scene | VTK ms | its caster alone | Lacuna ms | structure | none ms | VTK : Lacuna | VTK max, "
            "mean error | Lacuna max, mean error |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
        const bool ea = mode == ViewMode::ea;
        for (PeerScene& next : ea ? make_ea_scenes(options_.size) : make_plain_scenes(options_.size, mode))
            for (Shading shading : ea ? std::vector{Shading::none, Shading::phong} : std::vector{Shading::phong}) {
                next.scene.shading = shading;
                const std::string name = next.name + (!ea ? "" : shading == Shading::none ? " unshaded" : " shaded");
                if (name.find(options_.scene) == std::string::npos) continue;
                ratios.values.push_back(one_volume(name, next.scene, step));
            }
        ratios.print();
    }

    void surfaces() {
        Ratios first{"new isovalue, first picture, FlyingEdges + render : Lacuna", {}};
        Ratios orbit{"orbit, VTK's triangles : Lacuna", {}};
        fmt::print(
            "\nVTK's filters run on {}.\n| isosurface | VTK first ms | Lacuna first ms | ratio | VTK orbit ms | "
            "Lacuna orbit ms | ratio |\n| --- | --- | --- | --- | --- | --- | --- |\n",
            set_vtk_threads(threads_));
        for (PeerScene& next : make_plain_scenes(options_.size, ViewMode::iso)) {
            if (next.name.find(options_.scene) == std::string::npos) continue;
            const auto [a, b] = one_surface(next.name, next.scene);
            first.values.push_back(a);
            orbit.values.push_back(b);
        }
        first.print();
        orbit.print();
    }

    /// Packets of 16 rays against one ray a work-item: the same kernels, brute force, on the same device; and packets
    /// that sample from blocks, where there are such kernels.
    void lanes() {
        OpenClRenderer packets(device_, 16, false), blocks(device_, 16), single(device_, 1);
        Ratios ratios{"one ray a work-item : packets, brute force", {}}, by_blocks{"packets : with blocks", {}};
        fmt::print(
            "\n| brute force | one ray a work-item ms | packets ms | ratio | with blocks ms | packets : with blocks |\n"
            "| --- | --- | --- | --- | --- | --- |\n");
        std::vector<PeerScene> scenes = make_ea_scenes(options_.size);
        for (ViewMode mode : {ViewMode::mip, ViewMode::iso})
            for (PeerScene& s : make_plain_scenes(options_.size, mode)) scenes.push_back(std::move(s));
        for (PeerScene& next : scenes) {
            const std::string name = fmt::format("{} {}", next.name, name_of(next.scene.mode));
            if (name.find(options_.scene) == std::string::npos) continue;
            Plan plan = default_plan(next.scene);
            plan.structure = Structure::none;
            std::vector<double> a, b, c;
            const std::vector<Camera> turn = full_turn(next.scene.camera, options_.views);
            for (int view = -1; view < options_.views; ++view) {
                next.scene.camera = turn[std::size_t(std::max(view, 0))];
                const double slow = single.render(next.scene, plan, {}, false).frame.ms;
                const double fast = packets.render(next.scene, plan, {}, false).frame.ms;
                const double faster = blocks.render(next.scene, plan, {}, false).frame.ms;
                if (view < 0) continue;  // compiles
                a.push_back(slow);
                b.push_back(fast);
                c.push_back(faster);
            }
            ratios.values.push_back(median(a) / median(b));
            fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} |", name, median(a), median(b), ratios.values.back());
            if (next.scene.mode == ViewMode::iso) {  // few of its rays take many samples: no such kernel
                fmt::print(" - | - |\n");
                continue;
            }
            by_blocks.values.push_back(median(b) / median(c));
            fmt::print(" {:.1f} | {:.1f} |\n", median(c), by_blocks.values.back());
        }
        ratios.print();
        by_blocks.print();
    }

    const nlohmann::json& report() const { return report_; }

private:
    double lacuna_ms(const Scene& scene, const Plan& plan) {
        const Stopwatch watch;
        last_ = engine_.render(scene, plan).frame;
        return watch.ms();
    }

    double one_volume(const std::string& name, Scene scene, double step) {
        const std::vector<Camera> turn = full_turn(scene.camera, options_.views);
        VtkPeer vtk(scene, step, threads_);
        Plan best = default_plan(scene);
        best.step = step;
        Plan brute = best;
        brute.structure = Structure::none;
        std::map<std::string, std::vector<double>> ms;
        Frame theirs, ours;
        for (int view = -1; view < options_.views * options_.rounds; ++view) {
            scene.camera = turn[std::size_t(std::max(view, 0)) % turn.size()];
            const double a = vtk.draw(scene), alone = vtk.caster_ms(), b = lacuna_ms(scene, best);
            if (view < 0) {  // first pictures: build, compile, touch memory
                theirs = vtk.picture();
                ours = last_;
                lacuna_ms(scene, brute);
                vtk.draw(scene);
                continue;
            }
            ms["vtk"].push_back(a);
            ms["vtk caster"].push_back(alone);
            ms["lacuna"].push_back(b);
            ms["none"].push_back(lacuna_ms(scene, brute));
        }
        const double ratio = median(ms["vtk"]) / median(ms["lacuna"]);
        std::string errors = "- | -";
        if (options_.errors) {
            scene.camera = turn.front();
            Plan truth_plan = reference_plan(scene, best);
            const Frame truth = render_reference(scene, truth_plan);
            const ImageError e = compare(theirs, truth, {0, 0, 0}), f = compare(ours, truth, {0, 0, 0});
            errors = fmt::format("{:.1f}, {:.3f} | {:.1f}, {:.3f}", e.max, e.mean, f.max, f.mean);
            report_["errors"][name] = {{"vtk", {e.max, e.mean, e.psnr, e.ssim}},
                                       {"lacuna", {f.max, f.mean, f.psnr, f.ssim}}};
        }
        fmt::print("| {} | {:.1f} | {:.1f} | {:.2f} | {} | {:.1f} | {:.1f} | {} |\n", name, median(ms["vtk"]),
                   median(ms["vtk caster"]), median(ms["lacuna"]), name_of(best.structure), median(ms["none"]), ratio,
                   errors);
        std::fflush(stdout);
        report_["volumes"].push_back({{"name", name}, {"mode", name_of(scene.mode)}, {"ms", ms}, {"ratio", ratio}});
        return ratio;
    }

    std::pair<double, double> one_surface(const std::string& name, Scene scene) {
        const std::vector<Camera> turn = full_turn(scene.camera, options_.views);
        VtkPeer vtk(scene, 1, threads_);
        Plan plan = default_plan(scene);
        std::vector<double> first_a, first_b, a, b;
        const double iso = scene.iso;
        for (int view = -1; view < options_.views * options_.rounds; ++view) {
            scene.camera = turn[std::size_t(std::max(view, 0)) % turn.size()];
            scene.iso = iso * (1 + 0.002 * ((view + 1) % 5 + 1));  // never the one drawn last
            const double x = vtk.draw(scene), y = lacuna_ms(scene, plan);
            scene.camera = turn[(std::size_t(std::max(view, 0)) + 1) % turn.size()];
            const double u = vtk.draw(scene), v = lacuna_ms(scene, plan);
            if (view < 0) continue;
            first_a.push_back(x);
            first_b.push_back(y);
            a.push_back(u);
            b.push_back(v);
        }
        const double first = median(first_a) / median(first_b), orbit = median(a) / median(b);
        fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} | {:.1f} | {:.2f} | {:.1f} |\n", name, median(first_a),
                   median(first_b), first, median(a), median(b), orbit);
        std::fflush(stdout);
        report_["surfaces"].push_back({{"name", name}, {"first", first}, {"orbit", orbit}});
        return {first, orbit};
    }

    Options options_;
    std::shared_ptr<ComputeDevice> device_;
    Engine engine_;
    int threads_;
    Frame last_;
    nlohmann::json report_;
};

}  // namespace
}  // namespace lacuna::peers

int main(int argc, char** argv) {
    using namespace lacuna;
    peers::Options options;
    CLI::App app{"Lacuna against VTK on the same scenes, frame by frame in turn."};
    app.add_option("--size", options.size, "voxels an axis")->check(CLI::Range(32, 1024));
    app.add_option("--views", options.views, "views of the orbit")->check(CLI::Range(1, 360));
    app.add_option("--rounds", options.rounds, "times round")->check(CLI::Range(1, 100));
    app.add_option("--only", options.only, "of ea, mip, iso, lanes")->delimiter(',');
    app.add_option("--scene", options.scene, "scenes whose name holds this text");
    app.add_flag("--errors", options.errors, "compare both pictures with the reference renderer (slow)");
    app.add_option("--json", options.json, "write every time and error here");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto device = open_device();
        if (!device) throw Error(Errc::device, "There is no usable OpenCL device.");
        peers::Bench bench(options, device);
        if (options.wants("ea")) bench.volumes(ViewMode::ea, 0.5);
        if (options.wants("mip")) bench.volumes(ViewMode::mip, 1);
        if (options.wants("iso")) bench.surfaces();
        if (options.wants("lanes")) bench.lanes();
        if (!options.json.empty()) std::ofstream(options.json) << bench.report().dump(1) << '\n';
        return 0;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "bench_peers: {}\n", failure.what());
        return 1;
    }
}
