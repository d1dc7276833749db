// lacuna devices: OpenCL platforms and devices, with what was chosen and why.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "core/accuracy/device_costs.h"
#include "core/compute/device_list.h"

namespace lacuna::cli {

namespace {

/// What the planner knows of each device's costs, after the list.
std::string with_costs(std::string text, const std::vector<DeviceInfo>& devices) {
    for (const DeviceInfo& device : devices)
        if (const auto costs = kept_costs(device.name, device.driver))
            text += fmt::format("Costs of {}: {}.\n", device.index, describe(*costs));
    return text;
}

std::string with_costs_json(const std::string& text, const std::vector<DeviceInfo>& devices) {
    auto json = nlohmann::ordered_json::parse(text);
    for (auto& entry : json["devices"]) {
        entry["costs"] = nullptr;
        for (const DeviceInfo& device : devices)
            if (device.index == entry["index"].get<int>())
                if (const auto costs = kept_costs(device.name, device.driver))
                    entry["costs"] = nlohmann::ordered_json::parse(to_json(*costs));
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

void add_devices_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("devices", "list OpenCL devices, tested and timed");
    command->footer("Example: lacuna devices --json");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "print JSON");
    auto calibrate = std::make_shared<bool>(false);
    command->add_flag("--calibrate", *calibrate,
                      "measure what drawing costs on the chosen device, for the planner of budgets, and keep it");
    command->callback([&chosen, as_json, calibrate] {
        chosen = [as_json, calibrate](Console& console) {
            const std::vector<DeviceInfo> devices = list_devices(true, console.job("Testing"));
            const int best = fastest_index(devices);
            if (*calibrate) {
                Engine engine(open_device("", console.job("Testing")));
                costs_of(engine, console.job("Measuring"), true);
            }
            console.print(*as_json ? with_costs_json(describe_devices_json(devices, best), devices)
                                   : with_costs(describe_devices(devices, best), devices));
            return 0;
        };
    });
}

}  // namespace lacuna::cli
