// lacuna render: pictures of a volume.

#include <fmt/format.h>

#include "app/command.h"
#include "app/read_guard.h"
#include "app/render_options.h"
#include "app/render_stats.h"
#include "core/accel/brick_index.h"
#include "core/accuracy/difference_map.h"
#include "core/base/atomic_file.h"
#include "core/compute/device_list.h"
#include "core/io/image_writer.h"
#include "core/render/turn.h"

namespace lacuna::cli {

namespace {

/// The frame as floats.
std::uint64_t frame_bytes(glm::ivec2 size) {
    constexpr std::uint64_t k_bytes_per_pixel = sizeof(glm::vec4) + sizeof(float);
    return std::uint64_t(size.x) * std::uint64_t(size.y) * k_bytes_per_pixel;
}

/// Volume, its copy on the device, and the frame.
std::uint64_t bytes_needed(const Volume& volume, glm::ivec2 size) {
    return 2 * std::uint64_t(volume.bytes()) + frame_bytes(size);
}

/// The largest volume drawn in one piece: what has more is left on disk if it can be.
std::uint64_t most_at_once(std::uint64_t limit, glm::ivec2 size) {
    const std::uint64_t frame = frame_bytes(size);
    return limit > frame ? (limit - frame) / 2 : 0;
}

void merge_build(std::map<std::string, BuildRecord>& all, const std::map<std::string, BuildRecord>& frame) {
    for (const auto& [name, made] : frame) {
        BuildRecord& record = all[name];
        record.ms += made.ms;  // later frames find it cached: 0 ms; or make the part of it that their view adds
        record.bytes = std::max(record.bytes, made.bytes);
    }
}

/// Renders one view; with statistics once to warm, once for the time, once for the counters.
Frame render_frame(Engine& engine, const Scene& scene, const Plan& plan, bool measure, const JobContext& job,
                   RenderRecord& record) {
    RenderResult result = engine.render(scene, plan, job.part(0, measure ? 0.4 : 1));
    merge_build(record.build, result.build);
    FrameRecord frame{scene.camera.azimuth_deg, result.frame.ms, {}};
    if (result.bricks) record.bricks = result.bricks;
    if (measure) {
        result = engine.render(scene, plan, job.part(0.4, 0.7));
        frame.ms = result.frame.ms;
        frame.counters = engine.render(scene, plan, job.part(0.7, 1), true).frame.counters;
    }
    record.frames.push_back(frame);
    return std::move(result.frame);
}

/// The error against the true picture; of several frames the worst is kept, and its difference map.
void verify_frame(const RenderOptions& options, const Scene& scene, const Plan& plan, const Frame& frame,
                  const JobContext& job, RenderRecord& record, DifferenceMap& map) {
    std::optional<AnalyticSample> sample;
    if (options.verify_against == Truth::closed_form) sample = open_sample(options.input.input, job);
    const TrueFrame truth = render_truth(options.verify_against, scene, plan, sample ? &*sample : nullptr, job);
    if (!truth.has_colors)
        throw Error(Errc::unsupported,
                    "The closed form of this sample has surfaces but no normals to shade with; add --shading none.");
    ImageError error = compare(frame, truth.frame, scene.background, options.error_allowed());
    error.reference = truth.reference;
    if (record.error && error.max <= record.error->max) return;
    record.error = error;
    map = difference_map(frame, truth.frame, scene.background);
    if (scene.mode == ViewMode::iso)
        record.surface = compare_surfaces(frame, truth.frame, scene.volume.geometry().smallest_spacing_mm());
    if (!scene.color_by_tf && scene.effects.empty() &&
        (scene.mode == ViewMode::mip || scene.mode == ViewMode::lmip || scene.mode == ViewMode::minip))
        record.projection = compare_projections(frame, truth.frame, scene.window, scene.mode == ViewMode::minip);
}

std::string summary(const RenderOptions& options, const Scene& scene, const Plan& plan, const RenderRecord& record) {
    double ms = 0;
    for (const FrameRecord& frame : record.frames) ms += frame.ms;
    const std::string frames = record.frames.size() > 1 ? fmt::format("{} frames of ", record.frames.size()) : "";
    std::string text =
        fmt::format("{}: {}{}x{}, {}, {}, step {:g}, {:.4g} ms{} on {}\n", options.frame_path(0).string(), frames,
                    scene.size.x, scene.size.y, name_of(scene.mode), name_of(plan.structure), plan.step,
                    ms / double(record.frames.size()), record.frames.size() > 1 ? " each" : "", record.device);
    if (record.error) text += "verified: " + error_text(record) + "\n";
    return text;
}

int run_render(RenderOptions& options, Console& console) {
    if (options.device == "list") {
        const std::vector<DeviceInfo> devices = list_devices(true, console.job("Testing"));
        console.print(describe_devices(devices, fastest_index(devices)));
        return 0;
    }
    options.parse();
    for (int i = 0; i < options.turntable(); ++i) check_target(options.frame_path(i));
    if (!options.stats.empty()) check_target(options.stats);
    if (!options.verify_map.empty()) check_target(options.verify_map);
    std::vector<std::filesystem::path> targets{options.stats, options.verify_map};
    for (int i = 0; i < options.turntable(); ++i) targets.push_back(options.frame_path(i));
    check_apart(targets);
    check_not_read(options.input.input, targets);

    const Volume volume =
        options.input.load_or_leave(most_at_once(options.input.memory_limit_bytes(), options.picture_size()), console);
    if (options.verify && !volume.in_memory())
        throw Error(Errc::unsupported,
                    "--verify needs the whole volume in memory; raise --memory-limit or leave it out.");
    std::shared_ptr<const BrickIndex> index;
    VolumeStatistics statistics;
    if (volume.in_memory()) {
        statistics = compute_statistics(volume, console.job("Measuring"));
    } else {
        index = std::make_shared<const BrickIndex>(build_brick_index(volume, console.job("Measuring")));
        statistics = index->statistics;
    }
    Scene scene = options.scene(volume, statistics);
    if (options.regions.any()) {
        if (!volume.in_memory())
            throw Error(Errc::unsupported,
                        "--regions needs the whole volume in memory; raise --memory-limit or leave it out.");
        scene.regions = options.regions.classes(volume, statistics, console.job("Finding regions"));
    }
    if (volume.in_memory()) options.input.require_memory(bytes_needed(volume, scene.size), "Rendering this volume");

    Engine engine(open_device(options.device, console.job("Testing devices")));
    engine.set_memory_limit(options.input.memory_limit_bytes());
    engine.adopt(index);
    check(scene);
    Plan plan = options.plan(scene);
    check(plan, scene);
    if (const std::vector<std::string> idle = options.without_effect(plan); !idle.empty())
        console.note_at_end(fmt::format("without effect in mode {} by structure {}: {}", name_of(scene.mode),
                                        name_of(plan.structure), fmt::join(idle, ", ")));
    if (auto budget = options.budget()) {
        budget->costs = costs_of(engine, console.job("Measuring the device"));
        const PlannedPlan planned = choose_plan(engine, scene, *budget, console.job("Planning"));
        plan = planned.plan;
        if (!planned.meets_budget)
            console.warn_at_end(
                fmt::format("the time budget cannot be kept: the fastest plan found takes {:.3g} ms", planned.ms));
    }
    plan = engine.fitted(plan, scene);
    RenderRecord record;
    record.device = engine.device_name();
    record.error_allowed = options.error_allowed();
    DifferenceMap map;
    const Camera first = scene.camera;
    const int frames = options.turntable();
    const std::vector<Camera> views = full_turn(first, frames);
    for (int i = 0; i < frames; ++i) {
        const JobContext job = console.job(frames > 1 ? fmt::format("Rendering {}/{}", i + 1, frames) : "Rendering");
        scene.camera = views[std::size_t(i)];
        const Frame frame = render_frame(engine, scene, plan, !options.stats.empty(), job, record);
        if (options.verify) verify_frame(options, scene, plan, frame, console.job("Verifying"), record, map);
        write_png(options.frame_path(i), scene.size, to_rgb8(frame, scene.background));
    }
    scene.camera = first;
    if (!options.verify_map.empty()) {
        write_png(options.verify_map, map.size, map.rgb);
        console.note_at_end(
            fmt::format("{}: black where equal, brightest where {:.3g}/255 off", options.verify_map, map.full_scale));
    }
    if (!options.stats.empty()) write_file(options.stats, stats_json(scene, plan, record));
    if (!console.quiet || options.verify) console.print(summary(options, scene, plan, record));
    return 0;
}

}  // namespace

void add_render_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("render", "draw a picture of a volume");
    command->footer("Example: lacuna render sample:head --mode iso --azimuth 30 --elevation 20 -o head.png");
    auto options = std::make_shared<RenderOptions>();
    options->add_to(*command);
    command->callback(
        [&chosen, options] { chosen = [options](Console& console) { return run_render(*options, console); }; });
}

}  // namespace lacuna::cli
