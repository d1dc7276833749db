#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/job.h"

namespace lacuna::cli {

/// What a subcommand talks through: standard output for results, a progress line on standard error when that is a
/// terminal, and the stop token that Ctrl-C triggers.
class Console {
public:
    /// Starts to listen for SIGINT and SIGTERM. Call once, before any other thread starts. The first signal asks the
    /// running job to stop; a second one ends the program at once with status 130.
    static std::stop_token watch_signals();

    explicit Console(std::stop_token stop) : stop_(std::move(stop)) {}

    bool quiet = false;

    /// A job whose progress shows as "label 42%".
    JobContext job(const std::string& label) const;
    /// Removes the progress line, so that other text can follow.
    void clear_progress() const;
    /// Writes text to standard output. @throws Error(io) if it does not get there (closed pipe, full disk)
    void print(std::string_view text) const;
    /// One line on standard error, unless --quiet.
    void note(std::string_view line) const;
    /// A note that follows the result; a failure has the one line that says why, and no other.
    void note_at_end(std::string line) const { at_end_.emplace_back(std::move(line), !quiet); }
    /// Likewise, but said with --quiet, too: what was asked for is not what was done.
    void warn_at_end(std::string line) const { at_end_.emplace_back(std::move(line), true); }
    void say_at_end() const;

private:
    std::stop_token stop_;
    mutable std::vector<std::pair<std::string, bool>> at_end_;  // and whether it is to be said
};

/// Refuses a target that could not be written in the end, before hours of work: its folder must exist and take new
/// files, and what already has its name must be a plain file. @throws Error(io)
void check_target(const std::filesystem::path& target);
/// Refuses two results in one file, of which only the last would be left. @param targets  empty ones are none
/// @throws Error(bad_usage)
void check_apart(const std::vector<std::filesystem::path>& targets);

}  // namespace lacuna::cli
