#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "core/base/job.h"
#include "core/io/volume_reader.h"

namespace lacuna {

// Volumes that are no DICOM: of which format a file is, where its voxels lie, and reading them.

enum class FileFormat { dicom, meta_image, nrrd, nifti, tiff, raw, dat, vgi };

/// By the ending; `dicom` for one that is none of the others'.
FileFormat format_by_name(const std::filesystem::path& file);

/// As open_volume() takes it: by --raw, by the ending, and where that says little by the first bytes.
FileFormat format_of(const std::filesystem::path& file, const OpenOptions& options);

/// True for .raw, .img and .vol files that are no DICOM and whose size neither a sidecar nor their name tells:
/// open_volume needs --raw for them. @throws Error for a sidecar that is wrong, or an empty file
bool needs_raw_layout(const std::filesystem::path& file);

/// @throws Error(bad_input) for a file of no bytes
void require_bytes(const std::filesystem::path& file);

[[noreturn]] void refuse_folder(const std::string& input);

/// From the header alone. Errors as read_plain().
glm::ivec3 plain_size(const std::filesystem::path& file, FileFormat format);

/// @param path  a file, or a folder of TIFF slices
/// @param room  called with the bytes of the voxels before they are read, where it is given; may throw
/// @throws Error(bad_input), Error(unsupported), Error(io), Error(cancelled)
Volume read_plain(const std::filesystem::path& path, FileFormat format, const OpenOptions& options,
                  const std::function<void(std::uint64_t)>& room, const JobContext& job);

/// The volume with its voxels left in the file, or nothing where they cannot be read in parts.
std::optional<Volume> open_plain_in_parts(const std::filesystem::path& path, FileFormat format,
                                          const OpenOptions& options);

}  // namespace lacuna
