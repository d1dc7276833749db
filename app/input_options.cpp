#include "app/input_options.h"

#include <fmt/format.h>
#include <unistd.h>

#include "app/parse.h"
#include "core/volume/smooth.h"

namespace lacuna::cli {

namespace {
constexpr std::uint64_t k_mb = std::uint64_t(1) << 20;

std::uint64_t machine_memory_bytes() {
    return std::uint64_t(::sysconf(_SC_PHYS_PAGES)) * std::uint64_t(::sysconf(_SC_PAGE_SIZE));
}
}  // namespace

void InputOptions::add_to(CLI::App& command, bool required) {
    command.add_option("INPUT", input, "folder, volume file, or sample:NAME[@N|@WxHxD]")->required(required);
    add_flags_to(command);
}

void InputOptions::add_flags_to(CLI::App& command) {
    command.add_option("--raw", open.raw, "layout of a raw file: WxHxD:TYPE[:SX,SY,SZ][:be][:+OFFSET]");
    command.add_option("--series", open.series, "which series of a folder: its number or UID");
    command.add_option("--spacing", spacing_text,
                       "SX,SY,SZ: mm between voxels, where the file's own are wrong or missing");
    command.add_flag("--keep-gaps", open.keep_gaps, "refuse a series with missing slices instead of interpolating");
    command.add_option("--memory-limit", memory_limit_text, "MB it may use (default: 75 % of the machine's memory)");
}

void InputOptions::add_smooth(CLI::App& command) {
    command.add_option("--smooth", smooth_text, "MM: smooth by a Gaussian of this standard deviation, in mm, first");
}

void InputOptions::check() {
    if (!smooth_text.empty()) {
        smooth_mm = parse_number("--smooth", smooth_text);
        if (!(smooth_mm > 0)) refuse("--smooth", smooth_text, "a length in mm above 0");
    }
    if (!memory_limit_text.empty()) parse_integer("--memory-limit", memory_limit_text, 1, std::int64_t(1) << 30);
    if (spacing_text.empty()) return;
    const std::vector<double> s = parse_numbers("--spacing", spacing_text, 3);
    if (!(s[0] > 0 && s[1] > 0 && s[2] > 0)) refuse("--spacing", spacing_text, "three lengths above 0");
    open.spacing_mm = glm::dvec3(s[0], s[1], s[2]);
}

std::uint64_t InputOptions::memory_limit_bytes() const {
    if (memory_limit_text.empty()) return machine_memory_bytes() / 4 * 3;
    return std::uint64_t(parse_integer("--memory-limit", memory_limit_text, 1, std::int64_t(1) << 30)) * k_mb;
}

void InputOptions::require_memory(std::uint64_t bytes, const std::string& what) const {
    const std::uint64_t limit = memory_limit_bytes();
    if (bytes <= limit) return;
    throw Error(Errc::out_of_memory,
                fmt::format("{} takes {} MB and the limit is {} MB; raise --memory-limit or use a smaller volume.",
                            what, (bytes + k_mb - 1) / k_mb, limit / k_mb));
}

Volume InputOptions::load_or_leave(std::uint64_t most_bytes, const Console& console) const {
    if (smooth_mm > 0) return load(console);  // smoothing takes the whole volume
    std::optional<Volume> parts;
    if (open.series.empty() || open.series == "1") parts = open_volume_in_parts(input, open);
    if (!parts) {
        try {
            return load(console);
        } catch (const Error& error) {
            if (error.code() != Errc::out_of_memory) throw;
            throw Error(Errc::out_of_memory, std::string(error.what()) +
                                                 " Volumes in .raw, .mhd and .nrrd that are not packed are read in "
                                                 "parts; lacuna convert makes them.");
        }
    }
    if (parts->total_bytes() <= most_bytes) return load(console);
    if (say_warnings)
        for (const Warning& warning : parts->warnings) console.note_at_end("warning: " + warning.text);
    return *parts;
}

Volume InputOptions::load(const Console& console) const {
    if (!memory_limit_text.empty() && open.series.empty() && open.raw.empty()) {
        // Before reading: a voxel has a byte at least.
        const std::vector<SeriesEntry> found = list_series(input, console.job("Looking"));
        if (found.size() == 1) {
            const glm::ivec3 size = glm::max(found[0].size, 0);
            require_memory(std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z), "The volume");
        }
    }
    Volume volume = open_volume(input, open, console.job("Reading"));
    require_memory(volume.bytes(), "The volume");
    if (smooth_mm > 0) {
        require_memory(volume.bytes() + gaussian_smooth_bytes(volume), "Smoothing the volume");
        volume = gaussian_smooth(volume, smooth_mm, console.job("Smoothing"));
    }
    if (say_warnings)
        for (const Warning& warning : volume.warnings) console.note_at_end("warning: " + warning.text);
    return volume;
}

}  // namespace lacuna::cli
