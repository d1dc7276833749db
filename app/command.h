#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/console.h"

namespace lacuna::cli {

/// A subcommand's work, run after the whole command line was read. Returns the exit status.
using Action = std::function<int(Console&)>;

/// Each adds its subcommand with its flags; when the user chose it, `chosen` becomes its work.
void add_info_command(CLI::App& app, Action& chosen);
void add_render_command(CLI::App& app, Action& chosen);
void add_regions_command(CLI::App& app, Action& chosen);
void add_convert_command(CLI::App& app, Action& chosen);
void add_devices_command(CLI::App& app, Action& chosen);
void add_inspect_command(CLI::App& app, Action& chosen);
void add_batch_command(CLI::App& app, Action& chosen);
void add_tf_command(CLI::App& app, Action& chosen);

}  // namespace lacuna::cli
