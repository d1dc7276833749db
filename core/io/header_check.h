#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/io/compressed_check.h"

namespace lacuna {

// What the image libraries do not check themselves, or check only after allocating: that the header names data that
// exist and are as long as it claims. Each throws Error(bad_input) or Error(unsupported) with one clear sentence.

/// The data file an .mhd names, or an empty path if the data are inside, in a list or in a pattern of files.
std::filesystem::path meta_image_data_file(const std::filesystem::path& header);

/// Voxels that lie in a file as they are.
struct PlainData {
    std::filesystem::path file;
    std::uint64_t offset = 0;  ///< bytes before the first voxel
    bool big_endian = false;
};

/// What a header says that ITK does not tell.
struct HeaderFacts {
    bool stored_as_integer = false;            ///< NIfTI: the voxels in the file, before any scaling
    std::optional<CompressedData> compressed;  ///< where the packed voxels lie, if they are packed
    std::optional<PlainData> plain;            ///< or the voxels as they are, if they lie in one file (not of NIfTI)
};

HeaderFacts check_meta_image(const std::filesystem::path& header);
HeaderFacts check_nrrd(const std::filesystem::path& header);
HeaderFacts check_nifti(const std::filesystem::path& file);

}  // namespace lacuna
