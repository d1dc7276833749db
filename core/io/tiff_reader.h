#pragma once

#include <filesystem>
#include <vector>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// The .tif and .tiff files directly inside a folder, in natural order (slice9 before slice10).
std::vector<std::filesystem::path> tiff_stack(const std::filesystem::path& folder);

/// Size of the volume a stack (one page each) or one multi-page file holds, without reading pixels.
glm::ivec3 tiff_size(const std::vector<std::filesystem::path>& files);

/// Reads a stack or a multi-page file of grey pages (8, 16, 32 bit integers, 32 or 64 bit floats, or a palette that is
/// a grey ramp). The spacing is 1 mm with a warning unless ImageJ's description states it.
/// @throws Error(bad_input) naming the page that is damaged or differs from the first; Error(unsupported) for colours
Volume read_tiff(const std::vector<std::filesystem::path>& files, const JobContext& job = {});

}  // namespace lacuna
