#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/io/dicom_series.h"
#include "core/volume/volume.h"

namespace lacuna::dicom {

/// The slices of a stack as real values, in the smallest type that holds them all exactly.
struct LoadedSlices {
    VoxelType type = VoxelType::u8;
    VoxelBuffer voxels;               ///< planes x rows x columns; planes without a slice are not written
    ValueRange range;                 ///< of the values that are no padding
    std::int64_t padding_voxels = 0;  ///< stored as padding; they hold range.lo now
    bool rounded = false;             ///< values beyond f32's whole numbers (2^24) lost their last digits
};

/// Reads slice order[i] into plane planes[i] of `plane_count`. Uncompressed pixels are read straight into their place
/// by all threads; the value scale is applied there.
///
/// Padding (PixelPaddingValue, PixelPaddingRangeLimit) is no measurement: such voxels get the smallest measured value
/// of the whole stack, which is air in a CT, so that neither histogram nor interpolation meets a value that is none.
/// @throws Error(bad_input) naming a file that is cut short; Error(unsupported); Error(cancelled)
LoadedSlices load_slices(const SeriesScan& scan, std::span<const std::size_t> order, std::span<const int> planes,
                         int plane_count, const JobContext& job);

}  // namespace lacuna::dicom
