#include "core/base/log.h"

#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace lacuna {

namespace {
std::mutex g_mutex;
std::function<void(LogLevel, std::string_view)> g_sink;
}  // namespace

void log(LogLevel level, std::string_view line) {
    std::lock_guard lock(g_mutex);
    if (g_sink) return g_sink(level, line);
    static const LogLevel least = std::getenv("LACUNA_DEBUG") ? LogLevel::debug : LogLevel::warning;
    if (level >= least) std::fprintf(stderr, "lacuna: %.*s\n", int(line.size()), line.data());
}

void set_log_sink(std::function<void(LogLevel, std::string_view)> sink) {
    std::lock_guard lock(g_mutex);
    g_sink = std::move(sink);
}

}  // namespace lacuna
