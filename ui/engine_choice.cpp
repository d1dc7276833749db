#include "ui/engine_choice.h"

#include "core/compute/device.h"

namespace lacuna::ui {

EngineFactory engine_on(std::string device, int memory_limit_mib) {
    return [device = std::move(device), memory_limit_mib](const JobContext& job) {
        auto engine = std::make_shared<Engine>(device == "none" ? nullptr : open_device(device, job));
        engine->set_memory_limit(std::uint64_t(memory_limit_mib) << 20);
        return engine;
    };
}

}  // namespace lacuna::ui
