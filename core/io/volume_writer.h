#pragma once

#include <filesystem>

#include "core/base/job.h"
#include "core/regions/label_volume.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Writes a volume in the format its name asks for: .nrrd (gzip), .mhd (+ .raw), .nii.gz/.nii (LPS turned to RAS),
/// .raw (+ .dat sidecar), or a folder name ending in "/" or naming an existing or extension-less folder: a DICOM CT
/// series. A volume that does not lie in memory is written slab by slab: .raw, .mhd, and .nrrd (not packed then).
/// All or nothing: files are written beside their targets and renamed.
/// @throws Error(bad_usage) for an unknown ending, listing the known; Error(unsupported) where the format cannot hold
/// the type; Error(io), Error(cancelled)
void write_volume(const Volume& volume, const std::filesystem::path& target, const JobContext& job = {});

/// Writes region labels as .nrrd (gzip) in the smallest of u8, u16, u32 that holds every id.
/// @throws Error(bad_usage) for another ending; Error(bad_input) if labels and grid disagree; Error(io),
/// Error(cancelled)
void write_labels(const LabelVolume& labels, const std::filesystem::path& target, const JobContext& job = {});

}  // namespace lacuna
