#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/io/stored_voxels.h"
#include "core/volume/volume.h"

namespace lacuna {

// What the image libraries do not check themselves, or check only after allocating: that the header names data that
// exist and are as long as it claims. Each throws Error(bad_input) or Error(unsupported) with one clear sentence.

/// The data file an .mhd names, or an empty path if the data are inside, in a list or in a pattern of files.
std::filesystem::path meta_image_data_file(const std::filesystem::path& header);

/// The header of a NIfTI pair whose voxels are in this `.img`, or an empty path where none lies beside it.
std::filesystem::path nifti_pair_header(const std::filesystem::path& image);

/// What a header says that ITK does not tell, or not right.
struct HeaderFacts {
    std::optional<StoredVoxels> voxels;  ///< where they lie, if in one file and in binary
    std::vector<StoredVoxels> pieces;    ///< MetaImage: where they lie, one behind the other, if in several files
    std::optional<StoredType> type;      ///< NIfTI: of the voxels in the file
    double slope = 1, intercept = 0;     ///< NIfTI: value = stored * slope + intercept
    glm::dvec3 mm_per_spacing{1};        ///< the header's lengths are in this unit along each axis
    glm::dvec3 mm_per_origin{1};         ///< and its position
    std::optional<glm::dvec3> spacing, origin;  ///< stated in a way that ITK does not take
    AxisNames axis_names = AxisNames::xyz;      ///< as axis_names_of() finds
    std::vector<Warning> warnings;
};

HeaderFacts check_meta_image(const std::filesystem::path& header);
HeaderFacts check_nrrd(const std::filesystem::path& header);
/// @param file  `.nii`, `.nii.gz`, or the `.hdr` of a pair
HeaderFacts check_nifti(const std::filesystem::path& file);

}  // namespace lacuna
