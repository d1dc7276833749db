// lacuna inspect: finds defects in a part, measures them, judges it, writes the report folder.

#include <fmt/format.h>

#include <filesystem>

#include "app/command.h"
#include "app/input_options.h"
#include "app/parse.h"
#include "core/base/shell_word.h"
#include "core/compute/device.h"
#include "core/inspect/batch.h"
#include "core/inspect/report.h"
#include "core/io/dicom_source.h"
#include "core/render/engine.h"

namespace lacuna::cli {

namespace {

struct InspectWords {
    InputOptions input;
    std::string criteria, report, device;
    std::vector<std::string> accept, reject;
    std::optional<std::string> worst;
};

/// The command that makes the report again, without folder names: a report must not differ by where it was made.
std::string replay_command(const InspectWords& words) {
    std::string text = "lacuna inspect " + shell_word(last_name(words.input.input)) + " --criteria " +
                       shell_word(last_name(words.criteria)) + " --report REPORT" + open_flags(words.input.open);
    const auto add = [&text](const char* flag, const std::string& value) {
        if (!value.empty()) text += fmt::format(" {} {}", flag, shell_word(value));
    };
    for (const std::string& word : words.accept) add("--accept", word);
    for (const std::string& word : words.reject) add("--reject", word);
    if (words.worst) add("--worst", *words.worst);
    return text;
}

void add_decisions(const std::string& flag, const std::vector<std::string>& words, bool accepted,
                   std::vector<HandDecision>& decisions) {
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos || equals + 1 == word.size()) refuse(flag, word, "ID=REASON");
        const auto id = std::uint32_t(parse_integer(flag, word.substr(0, equals), 1, UINT32_MAX));
        for (const HandDecision& other : decisions)
            if (other.defect == id) refuse(flag, word, "the only decision on that defect");
        decisions.push_back({id, accepted, word.substr(equals + 1)});
    }
}

std::string summary(const InspectionReport& report, const std::string& folder) {
    std::string text = fmt::format("{}: {}, {} defects\n", report.scan.name, name_of(report.judgement.verdict),
                                   report.analysis.defects.size());
    for (const std::string& reason : report.judgement.reasons) text += "  " + reason + "\n";
    return text + "report: " + folder + "\n";
}

int run_inspect(InspectWords& words, Console& console) {
    words.input.check();
    InspectOptions options;
    options.worst = int(words.worst ? parse_integer("--worst", *words.worst, 0, 1000) : options.worst);
    add_decisions("--accept", words.accept, true, options.by_hand);
    add_decisions("--reject", words.reject, false, options.by_hand);
    const Criteria criteria = read_criteria(words.criteria);
    check_report_folder(words.report);

    const Volume volume = words.input.load(console);
    const auto voxels = std::uint64_t(volume.geometry().voxel_count());
    words.input.require_memory(inspection_bytes(voxels, int(volume.bytes() / voxels)), "Inspecting this volume");
    const std::vector<ZoneMask> masks = lay_zones(criteria, volume.geometry(), console.job("Reading zones"));
    Engine engine(open_device(words.device, console.job("Testing devices")));
    options.input = words.input.input;
    if (volume.dicom) options.source = find_dicom_source(words.input.input, words.input.open, console.job("Looking"));
    options.software = std::string("Lacuna ") + LACUNA_VERSION;
    options.replay = replay_command(words);
    const InspectionReport report = inspect_part(volume, criteria, masks, engine, options, console.job("Inspecting"));
    write_report(report, volume, words.report, console.job("Writing the report"));
    console.print(summary(report, words.report));
    constexpr int k_not_passed = 3;
    return report.judgement.verdict == Verdict::pass ? 0 : k_not_passed;
}

}  // namespace

void add_inspect_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("inspect", "find, measure and judge the defects of a part");
    command->footer(
        "Example: lacuna inspect sample:casting --criteria limits.json --report casting-report\n"
        "Criteria: {\"limits\": {\"porosity_percent\": 0.5, \"defect_diameter_mm\": 2}}; docs/inspection.md says all.\n"
        "Exit status: 0 the part passed; 3 it did not, or cannot be told.");
    auto words = std::make_shared<InspectWords>();
    words->input.add_to(*command);
    command->add_option("--criteria", words->criteria, "JSON file: material, defects, limits, zones")->required();
    command->add_option("--report", words->report, "folder to write; a report that stands there is replaced")
        ->required();
    command->add_option("--accept", words->accept, "ID=REASON: a defect that counts no longer (repeat)");
    command->add_option("--reject", words->reject, "ID=REASON: a defect that fails the part (repeat)");
    command->add_option("--worst", words->worst, "defects that get pictures (default 10)");
    command->add_option("--device", words->device, "OpenCL device that draws: number or name");
    command->callback(
        [&chosen, words] { chosen = [words](Console& console) { return run_inspect(*words, console); }; });
}

}  // namespace lacuna::cli
