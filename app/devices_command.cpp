// lacuna devices: OpenCL platforms and devices, with what was chosen and why.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/device_list.h"

namespace lacuna::cli {

namespace {

const DeviceInfo* fastest(const std::vector<DeviceInfo>& devices) {
    const DeviceInfo* best = nullptr;
    for (const DeviceInfo& device : devices)
        if (device.usable && (!best || device.rank_ms < best->rank_ms)) best = &device;
    return best;
}

std::string why(const DeviceInfo* best) {
    if (!best) return "no usable OpenCL device: pictures come from the reference renderer on the processor";
    return fmt::format("fastest usable device by a measured kernel ({:.3g} ms)", best->rank_ms);
}

}  // namespace

std::string device_table(const std::vector<DeviceInfo>& devices) {
    const DeviceInfo* best = fastest(devices);
    std::string text;
    for (const DeviceInfo& d : devices) {
        text += fmt::format("{}{}  {}\n      {}, {}, driver {}, {} units, {} MB\n", &d == best ? "* " : "  ", d.index,
                            d.name, d.platform, d.opencl_version, d.driver, d.compute_units, d.memory_bytes >> 20);
        text += d.usable ? fmt::format("      self-test passed, ranking kernel {:.3g} ms\n", d.rank_ms)
                         : fmt::format("      not used: {}\n", d.fault);
    }
    return text + (best ? "* chosen: " : "") + why(best) + "\n";
}

std::string device_json(const std::vector<DeviceInfo>& devices) {
    using nlohmann::ordered_json;
    const DeviceInfo* best = fastest(devices);
    ordered_json list = ordered_json::array();
    for (const DeviceInfo& d : devices)
        list.push_back({{"index", d.index},
                        {"name", d.name},
                        {"platform", d.platform},
                        {"vendor", d.vendor},
                        {"driver", d.driver},
                        {"opencl_version", d.opencl_version},
                        {"type", d.is_gpu   ? "gpu"
                                 : d.is_cpu ? "cpu"
                                            : "other"},
                        {"compute_units", d.compute_units},
                        {"memory_bytes", d.memory_bytes},
                        {"usable", d.usable},
                        {"fault", d.fault},
                        {"rank_ms", d.rank_ms}});
    ordered_json json{{"devices", list}};
    json["chosen"] = best ? ordered_json(best->index) : ordered_json();
    json["why"] = why(best);
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void add_devices_command(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("devices", "list OpenCL devices, tested and timed");
    command->footer("Example: lacuna devices --json");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "print JSON");
    command->callback([&chosen, as_json] {
        chosen = [as_json](Console& console) {
            const std::vector<DeviceInfo> devices = list_devices(true, console.job("Testing"));
            console.print(*as_json ? device_json(devices) : device_table(devices));
            return 0;
        };
    });
}

}  // namespace lacuna::cli
