#pragma once

#include <cstdint>

#include "core/render/brick_plan.h"
#include "ui/preferences.h"

namespace lacuna::ui {

/// Bytes that may be used by the preferences; without a word there, what a volume may take by default.
inline std::uint64_t memory_limit_bytes() {
    const int mib = preferences::memory_limit_mib();
    return mib > 0 ? std::uint64_t(mib) << 20 : default_memory_limit();
}

}  // namespace lacuna::ui
