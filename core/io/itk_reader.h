#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "core/base/job.h"
#include "core/volume/volume.h"

namespace lacuna {

enum class ItkFormat { meta_image, nrrd, nifti };

/// Size of the volume in a MetaImage, NRRD or NIfTI file, from its header alone. Errors as read_itk_volume.
glm::ivec3 itk_volume_size(const std::filesystem::path& file, ItkFormat format);

/// Reads a MetaImage, NRRD or NIfTI file; positions come out in LPS. Types the program has are kept; wider integers
/// become the smallest type that holds every value exactly (f32 with a warning beyond 2^24), double becomes f32.
/// @param room  called with the bytes of the voxels before they are read; may throw
/// @throws Error(bad_input) naming file and fault; Error(unsupported) for vectors, colours and time series
Volume read_itk_volume(const std::filesystem::path& file, ItkFormat format, const JobContext& job = {},
                       const std::function<void(std::uint64_t)>& room = nullptr);

/// The volume with its voxels left in the file (open_raw), or nothing where they cannot be read in parts: packed, in
/// several files, of a type that would be converted, NIfTI. Errors as read_itk_volume.
std::optional<Volume> open_itk_volume(const std::filesystem::path& file, ItkFormat format);

}  // namespace lacuna
