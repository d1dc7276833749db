// lacuna bench: plans over scenes, time against error.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "app/bench_scenes.h"
#include "app/command.h"
#include "app/parse.h"
#include "app/read_guard.h"
#include "core/accuracy/sweep_report.h"
#include "core/base/atomic_file.h"
#include "core/base/stopwatch.h"
#include "core/compute/device.h"

namespace lacuna::cli {

namespace {

constexpr double k_quick_limit_s = 48;  // of --quick, for its scenes; the rest of a minute is for reading and drawing

struct BenchOptions {
    InputOptions input;
    std::string chart, json, data, device, views_text, rounds_text, front = "max", time_limit_text, only;
    std::optional<std::string> modes, size;
    bool quick = false, list = false;
    int views = 0, rounds = 0;
    double time_limit_s = 0;

    void add_to(CLI::App& command);
    void parse();
    std::vector<SceneWords> scenes() const;

private:
    bool from_file() const { return std::filesystem::path(input.input).extension() == ".json"; }
    void check_words() const;
    std::vector<SceneWords> scenes_of_input() const;
};

void BenchOptions::add_to(CLI::App& command) {
    input.add_to(command);
    command.add_option("--chart", chart, "draw time against error: OUT.svg, OUT.png or OUT.pdf");
    command.add_option("--json", json, "write every point as JSON (docs/schemas/bench.schema.json)");
    command.add_flag("--quick", quick, "fewer plans, under a minute");
    command.add_option("--views", views_text, "views around the volume (default 4; quick 1)");
    command.add_option("--rounds", rounds_text, "times each plan is measured, all in turn (default 5; quick 3)");
    command.add_option("--modes", modes, "modes of an INPUT that is no scene file (default iso,ea,mip)");
    command.add_option("--size", size, "WxH in pixels, likewise (default 512x512)");
    command.add_option("--scene", only, "only the scenes of a file whose names contain this");
    command.add_flag("--list", list, "show the scenes, each as the command that renders it, and measure nothing");
    command.add_option("--error", front, "error the front and the chart weigh: max (default), mean or flip");
    command.add_option("--time-limit", time_limit_text,
                       "seconds a scene may take; what is not measured by then says so");
    command.add_option("--data", data,
                       "folder a scene file's inputs lie in (default: LACUNA_DATA, else the file's own folder)");
    command.add_option("--device", device, "OpenCL device: number or part of its name");
}

/// A word that only the other kind of INPUT has a use for is no word to pass over.
void BenchOptions::check_words() const {
    const auto refuse_if_given = [](const std::string& flag, bool given, const char* why) {
        if (given) throw Error(Errc::bad_usage, fmt::format("{} {}.", flag, why));
    };
    if (from_file()) {
        const char* const why = "does not go with a scene file, whose scenes say it";
        refuse_if_given("--modes", modes.has_value(), why);
        refuse_if_given("--size", size.has_value(), why);
        refuse_if_given("--raw", !input.open.raw.empty(), why);
        refuse_if_given("--series", !input.open.series.empty(), why);
        refuse_if_given("--spacing", !input.spacing_text.empty(), why);
    } else {
        refuse_if_given("--scene", !only.empty(), "goes with a scene file (.json)");
        refuse_if_given("--data", !data.empty(), "goes with a scene file (.json)");
    }
    refuse_if_given("--json", list && !json.empty(), "does not go with --list, which measures nothing");
    refuse_if_given("--chart", list && !chart.empty(), "does not go with --list, which measures nothing");
}

void BenchOptions::parse() {
    input.check();
    check_words();
    views = views_text.empty() ? (quick ? 1 : 4) : int(parse_integer("--views", views_text, 1, 360));
    rounds = rounds_text.empty() ? (quick ? 3 : 5) : int(parse_integer("--rounds", rounds_text, 1, 1000));
    parse_front_error(front);
    if (size) parse_size("--size", *size);
    if (!time_limit_text.empty()) {
        time_limit_s = parse_number("--time-limit", time_limit_text);
        if (!(time_limit_s > 0)) refuse("--time-limit", time_limit_text, "above 0");
    }
    if (!chart.empty()) {
        check_chart_name(chart);
        check_target(chart);
    }
    if (!json.empty()) check_target(json);
    check_apart({chart, json});
    check_not_read(input.input, {chart, json});
}

/// INPUT itself in each of the modes.
std::vector<SceneWords> BenchOptions::scenes_of_input() const {
    std::vector<std::string> shared{input.input, "--size=" + size.value_or("512x512"), "--elevation=20", "--zoom=1.5"};
    if (!input.open.raw.empty()) shared.push_back("--raw=" + input.open.raw);
    if (!input.open.series.empty()) shared.push_back("--series=" + input.open.series);
    if (!input.spacing_text.empty()) shared.push_back("--spacing=" + input.spacing_text);
    std::vector<SceneWords> made;
    const bool sample = input.input.starts_with("sample:");
    const std::string name = sample ? input.input.substr(7) : std::filesystem::path(input.input).filename().string();
    std::string rest = modes.value_or("iso,ea,mip");
    while (!rest.empty()) {
        const std::size_t comma = rest.find(',');
        const std::string mode = rest.substr(0, comma);
        rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
        for_flag("--modes", [&] { return parse_view_mode(mode); });
        if (std::any_of(made.begin(), made.end(),
                        [&](const SceneWords& s) { return s.words.back() == "--mode=" + mode; }))
            refuse("--modes", *modes, "a list of view modes, each once");
        made.push_back({fmt::format("{}, {}", name, mode), shared});
        made.back().words.push_back("--mode=" + mode);
    }
    if (made.empty()) refuse("--modes", "", "a list of view modes");
    return made;
}

/// INPUT itself in each of the modes, or what the scene file says.
std::vector<SceneWords> BenchOptions::scenes() const {
    std::vector<SceneWords> found;
    if (from_file()) {
        const char* environment = std::getenv("LACUNA_DATA");
        found = load_scenes(input.input, !data.empty() ? data : environment ? environment : "");
        std::erase_if(found, [&](const SceneWords& s) { return s.name.find(only) == std::string::npos; });
        if (found.empty()) refuse("--scene", only, "part of any scene's name in " + input.input);
    } else {
        found = scenes_of_input();
    }
    for (SceneWords& scene : found) {
        if (input.open.keep_gaps) scene.words.push_back("--keep-gaps");
        if (!input.memory_limit_text.empty()) scene.words.push_back("--memory-limit=" + input.memory_limit_text);
    }
    return found;
}

int run_bench(BenchOptions& options, Console& console) {
    const Stopwatch watch;
    options.parse();
    std::vector<BenchScene> scenes;
    for (const SceneWords& words : options.scenes()) {
        scenes.emplace_back(words);
        if (options.list) console.print(fmt::format("{}: {}\n", words.name, scenes.back().command()));
    }
    if (options.list) return 0;

    Engine engine(open_device(options.device, console.job("Testing devices")));
    engine.set_memory_limit(options.input.memory_limit_bytes());
    SweepOptions sweeping;
    sweeping.extent = options.quick ? SweepExtent::quick : SweepExtent::full;
    sweeping.closed_form = !options.quick;
    sweeping.rounds = options.rounds;
    sweeping.front = parse_front_error(options.front);
    std::vector<SceneResult> results;
    for (BenchScene& scene : scenes) {
        const std::size_t left = scenes.size() - results.size();
        const SweepScene opened = scene.open(console, options.views);
        if (options.quick) sweeping.time_limit_s = std::max(1.0, (k_quick_limit_s - watch.ms() * 1e-3) / double(left));
        if (options.time_limit_s > 0) sweeping.time_limit_s = options.time_limit_s;
        results.push_back(
            sweep(engine, opened, sweeping,
                  console.job(fmt::format("{} ({}/{})", opened.name, results.size() + 1, scenes.size()))));
        if (!console.quiet || (options.json.empty() && options.chart.empty()))
            console.print(sweep_table(results.back()) + "\n");
    }
    const auto measured = [](const SceneResult& result) {
        return std::any_of(result.points.begin(), result.points.end(),
                           [](const SweepPoint& point) { return point.refused.empty(); });
    };
    if (std::none_of(results.begin(), results.end(), measured))
        throw Error(Errc::unsupported, options.quick || options.time_limit_s > 0
                                           ? "No plan was measured in the time set; raise --time-limit."
                                           : "No plan was measured: " + results.front().points.front().refused);
    if (!options.json.empty()) write_file(options.json, sweep_json(engine.device_name(), results, sweeping.front));
    if (!options.chart.empty()) save(sweep_chart(engine.device_name(), results, sweeping.front), options.chart);
    return 0;
}

}  // namespace

void add_bench_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("bench", "measure ways of drawing: time against error");
    command->footer(
        "Example: lacuna bench sample:casting --quick --chart casting.svg --json casting.json\n"
        "INPUT may be a scene file (docs/schemas/scenes.schema.json); resources/scenes/ holds some. A point's plan is\n"
        "drawn again by lacuna render --plan.");
    auto options = std::make_shared<BenchOptions>();
    options->add_to(*command);
    command->callback(
        [&chosen, options] { chosen = [options](Console& console) { return run_bench(*options, console); }; });
}

}  // namespace lacuna::cli
