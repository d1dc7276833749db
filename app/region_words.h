#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "core/render/region_view.h"

namespace lacuna::cli {

/// The words of `lacuna render` about regions: which are found (as `lacuna regions` finds them) and how they are drawn.
class RegionWords {
public:
    void add_to(CLI::App& command);
    /// Reads every word and the transfer functions named; a preset is fitted once the volume is known.
    /// @throws Error(bad_usage), and those of transfer-function files
    void parse();
    bool any() const { return view_ != RegionView::show || !functions_.empty(); }
    bool functions() const { return !functions_.empty(); }
    /// Finds the regions of a volume. @pre parse() was called
    RegionClasses classes(const Volume& volume, const VolumeStatistics& statistics, const JobContext& job) const;

private:
    struct Function {
        std::uint32_t id = 0;
        std::string preset;
        std::optional<TransferFunction> loaded;
    };
    std::optional<std::string> view_word_, range_width_word_, min_voxels_word_, connectivity_word_;
    std::vector<std::string> function_words_;
    RegionView view_ = RegionView::show;
    RegionOptions options_;
    std::vector<Function> functions_;
};

}  // namespace lacuna::cli
