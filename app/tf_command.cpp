// lacuna tf: transfer-function presets, shown or fitted to data.

#include "app/command.h"
#include "app/input_options.h"
#include "core/base/atomic_file.h"
#include "core/classify/transfer_function.h"
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

void print_or_write(Console& console, const TransferFunction& tf, const std::string& target) {
    if (target.empty()) {
        std::string text = to_json(tf);
        if (!text.ends_with('\n')) text += '\n';
        console.print(text);
    } else {
        save_transfer_function(tf, target);
    }
}

void add_show(CLI::App& tf, Action& chosen) {
    CLI::App* show = tf.add_subcommand("show", "print a preset, fitted to an input or on the Hounsfield scale");
    show->footer("Example: lacuna tf show bone scans/head > bone.json");
    auto input = std::make_shared<InputOptions>();
    auto name = std::make_shared<std::string>();
    show->add_option("NAME", *name, "preset, as listed by lacuna tf list")->required();
    input->add_to(*show, false);
    show->callback([&chosen, input, name] {
        chosen = [input, name](Console& console) {
            input->check();
            const Volume volume = input->input.empty() ? hounsfield_scale() : input->load(console);
            print_or_write(console, make_preset(*name, volume, compute_statistics(volume, console.job("Measuring"))),
                           "");
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
            input->check();
            const Volume volume = input->load(console);
            const VolumeStatistics statistics = compute_statistics(volume, console.job("Measuring"));
            print_or_write(console, fit_transfer_function(volume, statistics), *target);
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
