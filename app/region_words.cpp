#include "app/region_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/parse.h"

namespace lacuna::cli {

namespace {
constexpr double k_range_width = 0.1;
constexpr std::int64_t k_min_voxels = 8;  // as lacuna regions
}  // namespace

void RegionWords::add_to(CLI::App& command) {
    command.add_option("--regions", view_word_, "homogeneous regions: show (default), hide, or show only them");
    command.add_option("--range-width", range_width_word_,
                       "share (0..1) of the volume's range a region's values span, as in lacuna regions (default 0.1)");
    command.add_option("--min-voxels", min_voxels_word_, "smaller regions are none (default 8)");
    command.add_option("--connectivity", connectivity_word_,
                       "neighbours of a voxel in a region: 6 (default), 18 or 26");
    command
        .add_option("--region-tf", function_words_,
                    "ID:FILE or ID:preset:NAME: a transfer function for one region, by its number in lacuna regions "
                    "(ea; repeat)")
        ->allow_extra_args(false)
        ->take_all();
}

void RegionWords::parse() {
    if (view_word_) view_ = for_flag("--regions", [&] { return parse_region_view(*view_word_); });
    options_.range_width = k_range_width;
    options_.min_voxels = k_min_voxels;
    if (range_width_word_) options_.range_width = parse_number("--range-width", *range_width_word_);
    if (!(*options_.range_width >= 0 && *options_.range_width <= 1))
        refuse("--range-width", *range_width_word_, "a share from 0 to 1");
    if (min_voxels_word_) options_.min_voxels = parse_integer("--min-voxels", *min_voxels_word_, 1, INT64_MAX);
    if (connectivity_word_) {
        const std::int64_t n = parse_integer("--connectivity", *connectivity_word_, 0, 99);
        if (n != 6 && n != 18 && n != 26) refuse("--connectivity", *connectivity_word_, "6, 18 or 26");
        options_.connectivity = Connectivity(n);
    }
    for (const std::string& word : function_words_) {
        const std::size_t colon = word.find(':');
        if (colon == std::string::npos) refuse("--region-tf", word, "ID:FILE or ID:preset:NAME");
        Function function;
        function.id = std::uint32_t(parse_integer("--region-tf", word.substr(0, colon), 1, 1 << 22));
        const std::string rest = word.substr(colon + 1);
        constexpr std::string_view k_preset = "preset:";
        if (rest.starts_with(k_preset)) {
            function.preset = rest.substr(k_preset.size());
            const std::vector<std::string> known = preset_names();
            if (std::find(known.begin(), known.end(), function.preset) == known.end())
                refuse("--region-tf", word, fmt::format("a known preset: {}", fmt::join(known, ", ")));
        } else {
            function.loaded = load_transfer_function(rest);
        }
        functions_.push_back(std::move(function));
    }
    if (functions_.size() > RegionClasses::k_max_functions)
        throw Error(Errc::bad_usage,
                    fmt::format("--region-tf can be given {} times at most.", RegionClasses::k_max_functions));
    if (!any() && (range_width_word_ || min_voxels_word_ || connectivity_word_))
        throw Error(Errc::bad_usage,
                    "--range-width, --min-voxels and --connectivity go with --regions hide, --regions only or "
                    "--region-tf.");
}

RegionClasses RegionWords::classes(const Volume& volume, const VolumeStatistics& statistics,
                                   const JobContext& job) const {
    RegionViewOptions options;
    options.view = view_;
    options.regions = options_;
    for (const Function& f : functions_)
        options.functions.push_back({f.id, f.loaded ? *f.loaded : make_preset(f.preset, volume, statistics)});
    return make_region_classes(volume, options, job);
}

}  // namespace lacuna::cli
