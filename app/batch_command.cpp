// lacuna batch: inspects a series of parts.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/command.h"
#include "app/input_options.h"
#include "app/parse.h"
#include "core/base/parallel.h"
#include "core/compute/device.h"
#include "core/inspect/batch.h"

namespace lacuna::cli {

namespace {

struct BatchWords {
    InputOptions input;
    std::vector<std::string> inputs;
    std::string criteria, report, reference, merge, device;
    std::optional<std::string> jobs, shard, worst;
    bool resume = false;
};

/// I/N
void parse_shard(const std::string& text, BatchOptions& options) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) refuse("--shard", text, "I/N");
    options.shards = int(parse_integer("--shard", text.substr(slash + 1), 1, 1000000));
    options.shard = int(parse_integer("--shard", text.substr(0, slash), 1, options.shards));
}

std::string summary(const BatchResult& result, const std::string& folder) {
    std::size_t passed = 0, failed = 0, open = 0, broken = 0;
    std::string text;
    for (const BatchRow& row : result.rows) {
        ++(!row.verdict                    ? broken
           : *row.verdict == Verdict::pass ? passed
           : *row.verdict == Verdict::fail ? failed
                                           : open);
        if (!row.verdict) text += fmt::format("{}: broken: {}\n", row.name, row.reason);
    }
    text += fmt::format("{} parts: {} pass, {} fail, {} cannot tell, {} broken\n", result.rows.size(), passed, failed,
                        open, broken);
    return text + (result.whole ? "summary: " + folder + "/summary.html\n"
                                : "when all shards are done: lacuna batch --merge " + folder + "\n");
}

int finish(const BatchResult& result, const std::string& folder, const Console& console) {
    console.print(summary(result, folder));
    const bool all_passed = std::all_of(result.rows.begin(), result.rows.end(),
                                        [](const BatchRow& row) { return row.verdict == Verdict::pass; });
    constexpr int k_not_passed = 3;
    return all_passed ? 0 : k_not_passed;
}

int run_merge(const BatchWords& words, const Console& console) {
    if (!words.inputs.empty() || !words.criteria.empty() || !words.report.empty())
        throw Error(Errc::bad_usage, "--merge DIR stands alone: the series' folder says all.");
    return finish(merge_batch(words.merge), words.merge, console);
}

int run_series(BatchWords& words, Console& console) {
    if (!words.merge.empty()) return run_merge(words, console);
    if (words.inputs.empty() || words.criteria.empty() || words.report.empty())
        throw Error(Errc::bad_usage, "give FOLDER or LIST, --criteria FILE and --report DIR; or --merge DIR.");
    words.input.check();
    BatchOptions options;
    options.jobs = int(words.jobs ? parse_integer("--jobs", *words.jobs, 1, 1024) : 1);
    if (words.shard) parse_shard(*words.shard, options);
    if (words.worst) options.worst = int(parse_integer("--worst", *words.worst, 0, 1000));
    options.criteria = read_criteria(words.criteria);
    options.folder = words.report;
    options.open = words.input.open;
    options.reference = words.reference;
    options.resume = words.resume;
    options.memory_bytes = words.input.memory_limit_bytes();
    options.software = std::string("Lacuna ") + LACUNA_VERSION;
    const std::vector<BatchPart> parts = find_parts(words.inputs, words.report);
    options.device = open_device(words.device, console.job("Testing devices"));
    // Parts side by side share the cores.
    if (options.jobs > 1) set_thread_count(std::max(1, thread_count() / options.jobs));
    const BatchResult result = run_batch(parts, options, console.job(fmt::format("Inspecting {} parts", parts.size())));
    return finish(result, words.report, console);
}

}  // namespace

void add_batch_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("batch", "inspect a series of parts");
    command->footer(
        "Example: lacuna batch parts/ --criteria limits.json --report series --jobs 2 --reference golden/part\n"
        "A component is a sub-folder or a volume file of FOLDER, or a line of LIST. Killed at any moment, --resume "
        "goes\n"
        "on with it. Exit status: 0 every part passed; 3 at least one did not, cannot be told or is broken.");
    auto words = std::make_shared<BatchWords>();
    command->add_option("INPUTS", words->inputs, "FOLDER or LIST, or several")->type_name("FOLDER|LIST...");
    words->input.add_flags_to(*command);
    command->add_option("--criteria", words->criteria, "JSON file: material, defects, limits, zones");
    command->add_option("--report", words->report, "folder for the summary and one report folder a part");
    command->add_option("--jobs", words->jobs, "parts at once, at most (default 1); fewer where memory ends");
    command->add_flag("--resume", words->resume, "go on with the series that stands in DIR; done parts are kept");
    command->add_option("--reference", words->reference, "INPUT of a component to tell deviations from");
    command->add_option("--shard", words->shard,
                        "I/N: inspect every N-th part, for job arrays; merge when all are done");
    command->add_option("--merge", words->merge, "DIR: make the summary of a series inspected in shards");
    command->add_option("--worst", words->worst, "defects that get pictures, a part (default 10)");
    command->add_option("--device", words->device, "OpenCL device that draws: number or name");
    command->callback([&chosen, words] { chosen = [words](Console& console) { return run_series(*words, console); }; });
}

}  // namespace lacuna::cli
