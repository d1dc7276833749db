#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "app/console.h"
#include "core/io/volume_reader.h"

namespace lacuna::cli {

/// INPUT and the flags that say how to open it, the same for every subcommand.
struct InputOptions {
    std::string input;
    OpenOptions open;
    std::string memory_limit_text, spacing_text, smooth_text;
    double smooth_mm = 0;      ///< Gaussian pre-smoothing, standard deviation; 0: none
    bool say_warnings = true;  ///< a note on standard error for each of the volume's warnings

    /// Adds the positional INPUT (required unless told) and --raw, --series, --spacing, --keep-gaps, --memory-limit.
    void add_to(CLI::App& command, bool required = true);
    /// Adds --smooth, for subcommands that work on the smoothed volume.
    void add_smooth(CLI::App& command);
    /// Reads the flags' words without touching a file; call it before load. @throws Error(bad_usage)
    void check();
    /// Bytes this run may use: --memory-limit, else 75 % of the machine's memory.
    std::uint64_t memory_limit_bytes() const;
    /// Opens the input, and smooths it where asked to. @throws what open_volume throws; Error(out_of_memory) naming
    /// need and limit
    Volume load(const Console& console) const;
    /// The same, with the voxels left where they are when the input can be read in parts and holds more than
    /// `most_bytes`. @throws as load()
    Volume load_or_leave(std::uint64_t most_bytes, const Console& console) const;
    /// @throws Error(out_of_memory) naming both numbers when `bytes` for `what` is over the limit
    void require_memory(std::uint64_t bytes, const std::string& what) const;
};

}  // namespace lacuna::cli
