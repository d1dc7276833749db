#pragma once

#include <cstdint>
#include <filesystem>

namespace lacuna {

// What the image libraries do not check themselves, or check only after allocating: that the header names data that
// exist and are as long as it claims. Each throws Error(bad_input) or Error(unsupported) with one clear sentence.

/// The data file an .mhd names, or an empty path if the data are inside, in a list or in a pattern of files.
std::filesystem::path meta_image_data_file(const std::filesystem::path& header);
void check_meta_image(const std::filesystem::path& header);

void check_nrrd(const std::filesystem::path& header);

/// What ITK does not tell about a NIfTI file.
struct NiftiFacts {
    bool stored_as_integer = false;
};
NiftiFacts check_nifti(const std::filesystem::path& file);

}  // namespace lacuna
