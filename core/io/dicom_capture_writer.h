#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>

#include "core/io/dicom_derived.h"

namespace lacuna {

/// Writes an 8-bit RGB picture (3 bytes a pixel, row 0 on top) as a DICOM Secondary Capture (PS3.3 A.8.1) of the
/// source's patient and study. @throws Error(io); Error(bad_input) if the bytes are no picture of that size
void write_dicom_capture(glm::ivec2 size, std::span<const std::uint8_t> rgb, const DicomSource& source,
                         const DicomProvenance& made, const std::filesystem::path& target);

}  // namespace lacuna
