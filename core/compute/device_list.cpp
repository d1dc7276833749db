#include "core/compute/device_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lacuna {

namespace {

const DeviceInfo* find_index(const std::vector<DeviceInfo>& devices, int index) {
    const auto at = std::find_if(devices.begin(), devices.end(), [&](const auto& one) { return one.index == index; });
    return at == devices.end() ? nullptr : &*at;
}

const char* type_of(const DeviceInfo& info) { return info.is_gpu ? "gpu" : info.is_cpu ? "cpu" : "accelerator"; }

std::string state_of(const DeviceInfo& info) {
    if (!info.usable) return info.fault.empty() ? "not tested" : "cannot be used: " + info.fault;
    if (info.rank_ms > 0) return fmt::format("passed its self-test, ranking kernel {:.3g} ms", info.rank_ms);
    return "passed its self-test";
}

}  // namespace

int fastest_index(const std::vector<DeviceInfo>& devices) {
    const DeviceInfo* best = nullptr;
    for (const DeviceInfo& one : devices)
        if (one.usable && (!best || one.rank_ms < best->rank_ms)) best = &one;
    return best ? best->index : -1;
}

std::string why_chosen(const std::vector<DeviceInfo>& devices, int chosen_index) {
    if (devices.empty()) return "no OpenCL platform is installed; pictures come from the slower built-in renderer";
    const DeviceInfo* chosen = find_index(devices, chosen_index);
    if (!chosen) return "no device can be used; pictures come from the slower built-in renderer";
    const auto usable = std::count_if(devices.begin(), devices.end(), [](const auto& one) { return one.usable; });
    if (usable == 1 && chosen->usable) return devices.size() == 1 ? "the only device" : "the only one that can be used";
    if (chosen_index == fastest_index(devices) && chosen->rank_ms > 0)
        return fmt::format("the fastest of {} by the ranking kernel", usable);
    return "asked for";
}

std::string describe_devices(const std::vector<DeviceInfo>& devices, int chosen_index) {
    std::string text;
    for (const DeviceInfo& one : devices) {
        text += fmt::format("{} {}: {}\n", one.index == chosen_index ? '*' : ' ', one.index, one.name);
        text += fmt::format("     {}, {}, driver {}, {}\n", one.platform, one.vendor, one.driver, one.opencl_version);
        text += fmt::format("     {}, {} compute units, {:.1f} GiB memory, {:.1f} GiB at once\n", type_of(one),
                            one.compute_units, double(one.memory_bytes) / (1 << 30),
                            double(one.max_allocation_bytes) / (1 << 30));
        text += "     " + state_of(one) + "\n";
    }
    const DeviceInfo* chosen = find_index(devices, chosen_index);
    const std::string why = why_chosen(devices, chosen_index);
    return text + (chosen ? fmt::format("Chosen: {} ({}), {}.\n", chosen->index, chosen->name, why)
                          : fmt::format("Chosen: none, {}.\n", why));
}

std::string describe_devices_json(const std::vector<DeviceInfo>& devices, int chosen_index) {
    using nlohmann::ordered_json;
    ordered_json rows = ordered_json::array();
    for (const DeviceInfo& one : devices)
        rows.push_back({{"index", one.index},
                        {"name", one.name},
                        {"platform", one.platform},
                        {"vendor", one.vendor},
                        {"driver", one.driver},
                        {"opencl_version", one.opencl_version},
                        {"type", type_of(one)},
                        {"compute_units", one.compute_units},
                        {"memory_bytes", one.memory_bytes},
                        {"max_allocation_bytes", one.max_allocation_bytes},
                        {"usable", one.usable},
                        {"fault", one.fault.empty() ? ordered_json() : ordered_json(one.fault)},
                        {"rank_ms", one.rank_ms > 0 ? ordered_json(one.rank_ms) : ordered_json()},
                        {"chosen", one.index == chosen_index}});
    const bool any = find_index(devices, chosen_index) != nullptr;
    const ordered_json root = {{"chosen", any ? ordered_json(chosen_index) : ordered_json()},
                               {"why", why_chosen(devices, chosen_index)},
                               {"devices", std::move(rows)}};
    // A driver's text need not be UTF-8: what is not becomes a question mark, never an exception.
    return root.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace lacuna
