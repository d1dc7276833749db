#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/render/engine.h"

namespace lacuna::ui {

/// Makes the engine; called on a worker thread, because looking for a device takes its time.
using EngineFactory = std::function<std::shared_ptr<Engine>(const JobContext&)>;

/// An engine on a device. @param device  as open_device() takes it, or "none" for the built-in renderer
/// @param memory_limit_mib  host and device memory to stay within; 0: 75 % of the machine's
EngineFactory engine_on(std::string device, int memory_limit_mib);

}  // namespace lacuna::ui
