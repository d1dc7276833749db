#pragma once

#include <filesystem>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

/// Writes a CT series, one CT Image Storage file a slice (Explicit VR little endian, fresh UIDs, no patient's data)
/// into a folder that must not exist yet or be empty. The folder appears whole or not at all. Whole-number f32 volumes
/// that fit 16 bits with an offset are stored as such.
/// @throws Error(unsupported) for values that 16 bit integers cannot hold exactly, or an axis over 65535;
/// Error(io) for a folder with files in it; Error(cancelled)
void write_dicom_series(const Volume& volume, const std::filesystem::path& folder, const JobContext& job = {});

}  // namespace lacuna
