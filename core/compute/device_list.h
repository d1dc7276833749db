#pragma once

#include <string>
#include <vector>

#include "core/compute/device.h"

namespace lacuna {

/// The device that open_device("") takes of a measured list: the usable one with the least rank_ms; -1 when none is.
int fastest_index(const std::vector<DeviceInfo>& devices);

/// One short clause on why the device of that index was chosen over the others, e.g. "the only one that can be used".
std::string why_chosen(const std::vector<DeviceInfo>& devices, int chosen_index);

/// The devices as text, a block each, the chosen one marked with "*", and a last line saying why.
/// @param chosen_index DeviceInfo::index, or -1 for none
std::string describe_devices(const std::vector<DeviceInfo>& devices, int chosen_index);

/// The same as JSON: {"chosen": index or null, "why", "devices": [{"index","name","platform","vendor","driver",
/// "opencl_version","type","compute_units","memory_bytes","max_allocation_bytes","usable","fault","rank_ms","chosen"}]},
/// fault and rank_ms null when there is none.
std::string describe_devices_json(const std::vector<DeviceInfo>& devices, int chosen_index);

}  // namespace lacuna
