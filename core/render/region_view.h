#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/regions/regions.h"
#include "core/render/scene.h"

namespace lacuna {

/// Whether voxels of homogeneous regions are drawn, hidden, or drawn alone (Frey & Ertl 2009, section 5).
enum class RegionView { show, hide, only };

std::string_view name_of(RegionView view);
/// @throws Error(bad_usage) listing the known names
RegionView parse_region_view(std::string_view text);

struct RegionViewOptions {
    RegionView view = RegionView::show;
    RegionOptions regions;  ///< range_width must be set
    /// By region id, as find_regions numbers them: its own transfer function. At most RegionClasses::k_max_functions.
    std::vector<std::pair<std::uint32_t, TransferFunction>> functions;
};

/// Finds the regions and says what the view makes of each voxel; nothing (null) where it makes nothing special.
/// Memory meanwhile: 4 bytes a voxel for the labels. @throws as find_regions; Error(bad_usage) for a region that is not
/// there
RegionClasses make_region_classes(const Volume& volume, const RegionViewOptions& options, const JobContext& job = {});

}  // namespace lacuna
