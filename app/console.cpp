#include "app/console.h"

#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

namespace lacuna::cli {

namespace {

/// The line "label 42%", redrawn at most ten times a second.
class ProgressLine {
public:
    void show(const std::string& label, double share) {
        const std::lock_guard lock(mutex_);
        const auto now = std::chrono::steady_clock::now();
        const int percent = std::clamp(int(share * 100), 0, 100);
        if (visible_ && (now - drawn_ < std::chrono::milliseconds(100) || (percent == percent_ && label == label_)))
            return;
        std::fprintf(stderr, "\r%s %3d%%\033[K", label.c_str(), percent);
        std::fflush(stderr);
        visible_ = true;
        percent_ = percent;
        label_ = label;
        drawn_ = now;
    }

    void clear() {
        const std::lock_guard lock(mutex_);
        if (!visible_) return;
        std::fputs("\r\033[K", stderr);
        std::fflush(stderr);
        visible_ = false;
    }

private:
    std::mutex mutex_;
    bool visible_ = false;
    int percent_ = -1;
    std::string label_;
    std::chrono::steady_clock::time_point drawn_{};
};

ProgressLine& progress_line() {
    static ProgressLine line;
    return line;
}

}  // namespace

std::stop_token Console::watch_signals() {
    // A closed pipe and a file over the size limit become write errors, so that half-written files are cleaned up.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    struct sigaction hangup {};
    ::sigaction(SIGHUP, nullptr, &hangup);
    if (hangup.sa_handler != SIG_IGN) sigaddset(&signals, SIGHUP);  // the terminal closes; nohup asks to go on
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // inherited by every later thread, so only the one below sees them
    // Shared with a thread that never ends; the kernel drops it at exit.
    auto source = std::make_shared<std::stop_source>();
    std::thread([signals, source] {
        int signal = 0;
        if (sigwait(&signals, &signal) == 0) source->request_stop();
        if (sigwait(&signals, &signal) == 0) ::_exit(130);
    }).detach();
    return source->get_token();
}

JobContext Console::job(const std::string& label) const {
    JobContext job{stop_, nullptr};
    if (!quiet && ::isatty(STDERR_FILENO) == 1)
        job.progress = [label](double share) { progress_line().show(label, share); };
    return job;
}

void Console::clear_progress() const { progress_line().clear(); }

void Console::print(std::string_view text) const {
    clear_progress();
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw Error(Errc::io, "Cannot write to standard output.");
}

void Console::note(std::string_view line) const {
    clear_progress();
    if (!quiet) std::fprintf(stderr, "lacuna: %.*s\n", int(line.size()), line.data());
}

void Console::say_at_end() const {
    clear_progress();
    for (const auto& [line, wanted] : at_end_)
        if (wanted) std::fprintf(stderr, "lacuna: %s\n", line.c_str());
    at_end_.clear();
}

void check_target(const std::filesystem::path& target) {
    namespace fs = std::filesystem;
    std::error_code ec;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ec))
        throw Error(Errc::io, "Cannot write " + target.string() + ": the folder " + folder.string() +
                                  " does not exist; create it first.");
    if (fs::exists(target, ec) && !fs::is_regular_file(target, ec))
        throw Error(Errc::io, "Cannot write " + target.string() + ": it exists and is no plain file.");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw Error(Errc::io,
                    "Cannot write " + target.string() + ": no permission to write in " + folder.string() + ".");
}

void check_apart(const std::vector<std::filesystem::path>& targets) {
    namespace fs = std::filesystem;
    std::set<fs::path> places;
    for (const fs::path& target : targets) {
        if (target.empty()) continue;
        std::error_code ec;
        const fs::path place = fs::weakly_canonical(target, ec);
        if (!places.insert(ec ? target.lexically_normal() : place).second)
            throw Error(Errc::bad_usage, "Two results would go into " + target.string() + "; name two files.");
    }
}

}  // namespace lacuna::cli
