#pragma once

#include <functional>
#include <string_view>

namespace lacuna {

enum class LogLevel { debug, info, warning, error };

/// Sends one line to the current sink (stderr, level `warning` and up, unless changed). Never pass patient data.
void log(LogLevel level, std::string_view line);

/// Replaces the sink (nullptr: back to stderr). Called from any thread, one call at a time.
void set_log_sink(std::function<void(LogLevel, std::string_view)> sink);

}  // namespace lacuna
