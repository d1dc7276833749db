// lacuna convert: an input in another format.

#include <algorithm>

#include "app/command.h"
#include "app/input_options.h"
#include "core/io/volume_writer.h"

namespace lacuna::cli {

namespace {

/// Bytes up to which a volume is converted in one piece: what goes into a file as it is need not be gathered first.
std::uint64_t most_at_once(const InputOptions& input, const std::string& target) {
    constexpr std::uint64_t k_worth_parts = std::uint64_t(256) << 20;
    const bool plain = target.ends_with(".raw") || target.ends_with(".mhd");
    return plain ? std::min(k_worth_parts, input.memory_limit_bytes()) : input.memory_limit_bytes();
}

}  // namespace

void add_convert_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("convert", "write an input in another format");
    command->footer(
        "Example: lacuna convert scans/head head.nrrd\n"
        "OUT ends in .nrrd, .mhd, .nii, .nii.gz or .raw (with a .dat beside it); a folder name takes a DICOM\n"
        "series. A large raw volume, a large sample or anything not packed goes into .raw and .mhd in parts:\n"
        "lacuna convert sample:casting@2048x2048x1024 large.mhd");
    auto input = std::make_shared<InputOptions>();
    auto target = std::make_shared<std::string>();
    input->add_to(*command);
    input->add_smooth(*command);
    command->add_option("OUT", *target, "file or folder to write")->required();
    command->callback([&chosen, input, target] {
        chosen = [input, target](Console& console) {
            input->check();
            const Volume volume = input->load_or_leave(most_at_once(*input, *target), console);
            write_volume(volume, *target, console.job("Writing"));
            return 0;
        };
    });
}

}  // namespace lacuna::cli
