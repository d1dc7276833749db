#pragma once

#include <string>
#include <vector>

#include "core/compute/device.h"

namespace lacuna::cli {

/// Every device with its test result; the one that is taken unless another is asked for is marked, with the reason.
std::string device_table(const std::vector<DeviceInfo>& devices);
std::string device_json(const std::vector<DeviceInfo>& devices);

}  // namespace lacuna::cli
