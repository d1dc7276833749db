#include "core/render/region_view.h"

#include "core/base/names.h"
#include "core/base/parallel.h"

namespace lacuna {

namespace {
constexpr NameTable<RegionView, 3> k_view_names{
    {{RegionView::show, "show"}, {RegionView::hide, "hide"}, {RegionView::only, "only"}}};
}

std::string_view name_of(RegionView view) { return name_in(k_view_names, view); }
RegionView parse_region_view(std::string_view text) { return parse_name(k_view_names, text, "view of regions"); }

RegionClasses make_region_classes(const Volume& volume, const RegionViewOptions& options, const JobContext& job) {
    RegionClasses made;
    if (options.view == RegionView::show && options.functions.empty()) return made;
    if (options.functions.size() > RegionClasses::k_max_functions)
        throw Error(Errc::bad_usage, "At most " + std::to_string(RegionClasses::k_max_functions) +
                                         " regions can have transfer functions of their own.");
    const HomogeneousRegions regions = grow_homogeneous_regions(volume, options.regions, job.part(0, 0.95));
    const std::size_t count = regions.mean.size() - 1;
    std::vector<std::uint8_t> class_of(count + 1, options.view == RegionView::hide ? RegionClasses::k_hidden : 0);
    class_of[0] = options.view == RegionView::only ? RegionClasses::k_hidden : 0;
    for (const auto& [id, tf] : options.functions) {
        if (id < 1 || id > count)
            throw Error(Errc::bad_usage, "There is no region " + std::to_string(id) + "; the volume has regions 1 to " +
                                             std::to_string(count) + " (lacuna regions lists them).");
        made.functions.push_back(tf);
        if (options.view != RegionView::hide) class_of[id] = std::uint8_t(made.functions.size());
    }
    const std::vector<std::uint32_t>& labels = *regions.labels.labels;
    auto classes = std::make_shared<std::vector<std::uint8_t>>(labels.size());
    parallel_bands(
        0, std::int64_t(labels.size()), 64,
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t i = first; i < last; ++i) (*classes)[std::size_t(i)] = class_of[labels[std::size_t(i)]];
        },
        job.part(0.95, 1));
    made.of_voxel = std::move(classes);
    return made;
}

}  // namespace lacuna
