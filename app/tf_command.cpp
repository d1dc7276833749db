// lacuna tf: transfer-function presets, shown or fitted to data.

#include <algorithm>
#include <filesystem>

#include "app/command.h"
#include "app/input_options.h"
#include "app/read_guard.h"
#include "core/base/atomic_file.h"
#include "core/classify/preset_file.h"
#include "core/volume/statistics.h"

namespace lacuna::cli {

namespace {

/// What a preset is fitted to when no input is given: the Hounsfield scale.
Volume hounsfield_scale() {
    GridGeometry geometry;
    geometry.size = {16, 16, 16};
    Volume volume = make_volume<std::int16_t>(geometry, [](std::span<std::int16_t> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::int16_t(-1024 + int(i));
    });
    volume.unit = "HU";
    return volume;
}

void print_or_write(Console& console, const PresetFile& preset, const std::string& target) {
    if (target.empty())
        console.print(to_json(preset));
    else
        save_preset(preset, target);
}

bool is_preset(const std::string& name) {
    const std::vector<std::string> names = preset_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

void add_show(CLI::App& tf, Action& chosen) {
    CLI::App* show = tf.add_subcommand(
        "show", "print a preset with its technique, fitted to an input or on the Hounsfield scale; or check a file");
    show->footer("Example: lacuna tf show bone scans/head > bone.json");
    auto input = std::make_shared<InputOptions>();
    auto name = std::make_shared<std::string>();
    show->add_option("NAME", *name, "preset, as listed by lacuna tf list, or a transfer-function file")->required();
    input->add_to(*show, false);
    show->callback([&chosen, input, name] {
        chosen = [input, name](Console& console) {
            if (!is_preset(*name) && std::filesystem::is_regular_file(*name)) {
                print_or_write(console, load_preset(*name), "");
                return 0;
            }
            input->check();
            const Volume volume = input->input.empty() ? hounsfield_scale() : input->load(console);
            const VolumeStatistics statistics = compute_statistics(volume, console.job("Measuring"));
            print_or_write(console, {make_preset(*name, volume, statistics), technique_of_preset(*name)}, "");
            return 0;
        };
    });
}

void add_fit(CLI::App& tf, Action& chosen) {
    CLI::App* fit = tf.add_subcommand("fit", "the transfer function an input gets when none is named");
    fit->footer("Example: lacuna tf fit sample:casting -o casting-tf.json");
    auto input = std::make_shared<InputOptions>();
    auto target = std::make_shared<std::string>();
    input->add_to(*fit);
    fit->add_option("-o,--output", *target, "file to write (default: standard output)");
    fit->callback([&chosen, input, target] {
        chosen = [input, target](Console& console) {
            if (!target->empty()) check_target(*target);
            check_not_read(input->input, {*target});
            input->check();
            const Volume volume = input->load(console);
            const VolumeStatistics statistics = compute_statistics(volume, console.job("Measuring"));
            print_or_write(console, {fit_transfer_function(volume, statistics), {}}, *target);
            return 0;
        };
    });
}

}  // namespace

void add_tf_command(CLI::App& app, Action& chosen) {
    CLI::App* tf = app.add_subcommand("tf", "transfer functions: list, show, fit");
    tf->footer("Example: lacuna tf list");
    tf->require_subcommand(1);
    CLI::App* list = tf->add_subcommand("list", "names of the presets");
    list->footer("Example: lacuna tf list");
    list->callback([&chosen] {
        chosen = [](Console& console) {
            std::string text;
            for (const std::string& name : preset_names()) text += name + "\n";
            console.print(text);
            return 0;
        };
    });
    add_show(*tf, chosen);
    add_fit(*tf, chosen);
}

}  // namespace lacuna::cli
