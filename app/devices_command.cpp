// lacuna devices: OpenCL platforms and devices, with what was chosen and why.

#include "app/command.h"
#include "core/compute/device_list.h"

namespace lacuna::cli {

void add_devices_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("devices", "list OpenCL devices, tested and timed");
    command->footer("Example: lacuna devices --json");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "print JSON");
    command->callback([&chosen, as_json] {
        chosen = [as_json](Console& console) {
            const std::vector<DeviceInfo> devices = list_devices(true, console.job("Testing"));
            const int best = fastest_index(devices);
            console.print(*as_json ? describe_devices_json(devices, best) : describe_devices(devices, best));
            return 0;
        };
    });
}

}  // namespace lacuna::cli
