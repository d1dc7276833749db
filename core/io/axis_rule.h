#pragma once

#include <string_view>

#include "core/io/plain_file.h"

namespace lacuna {

/// What an input says about the space its positions are in.
struct SpaceStatement {
    FileFormat format = FileFormat::raw;
    /// NRRD: the value of its field `space`; MetaImage: of `AnatomicalOrientation`; empty where there is none.
    std::string_view space = {};
    bool oriented =
        true;  ///< DICOM: an orientation to the patient is stated; NIfTI: a code of one of its two ways is set
    bool component = false;  ///< DICOM: the patient module tells of a part (DICONDE, ASTM E2339)
    bool told_xyz = false;   ///< NRRD: the field k_axes_key says that the axes are a part's
};

/// The one rule of what a volume's axes are called. A patient's letters where the input states positions in a patient's
/// body: DICOM and NIfTI that state an orientation, unless of a part; NRRD in one of the spaces made of left or right,
/// anterior or posterior, superior (with time or not); MetaImage with an AnatomicalOrientation that is not "???". X, Y,
/// Z everywhere else: raw with and without sidecar, TIFF, NRRD of a scanner's or of no space.
AxisNames axis_names_of(const SpaceStatement& statement);

/// The key and value Lacuna writes into an NRRD file of a part, beside the space every reader takes its positions by.
inline constexpr std::string_view k_axes_key = "axes", k_axes_xyz = "xyz";

}  // namespace lacuna
