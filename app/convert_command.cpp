// lacuna convert: an input in another format.

#include "app/command.h"
#include "app/input_options.h"
#include "core/io/volume_writer.h"

namespace lacuna::cli {

void add_convert_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("convert", "write an input in another format");
    command->footer(
        "Example: lacuna convert scans/head head.nrrd\n"
        "OUT ends in .nrrd, .mhd, .nii, .nii.gz or .raw (with a .dat beside it); a folder name takes a DICOM\n"
        "series.");
    auto input = std::make_shared<InputOptions>();
    auto target = std::make_shared<std::string>();
    input->add_to(*command);
    input->add_smooth(*command);
    command->add_option("OUT", *target, "file or folder to write")->required();
    command->callback([&chosen, input, target] {
        chosen = [input, target](Console& console) {
            input->check();
            const Volume volume = input->load(console);
            write_volume(volume, *target, console.job("Writing"));
            return 0;
        };
    });
}

}  // namespace lacuna::cli
