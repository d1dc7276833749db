#pragma once

#include <filesystem>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Writes .nii, or .nii.gz compressed, NIfTI-1 with the grid turned from LPS to RAS as both sform and qform.
/// @throws Error(unsupported) for an axis over 32767 voxels; Error(io), Error(cancelled)
void write_nifti(const Volume& volume, const std::filesystem::path& target, const JobContext& job = {});

}  // namespace lacuna
