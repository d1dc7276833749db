#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/io/dicom_derived.h"
#include "core/regions/label_volume.h"

namespace lacuna {

/// One segment: the voxels of one or more labels.
struct DicomSegment {
    std::string label;               ///< "Defect 3"
    std::string type;                ///< code and meaning of what it is: "void", "inclusion", "part"
    std::string description;         ///< may be empty
    std::vector<std::uint32_t> ids;  ///< labels it is made of
    glm::ivec3 first{0}, last{0};    ///< box of voxels that holds them, both ends included
    std::string tracking_uid;        ///< ties it to the report's measurements; empty: none
};

/// Label volumes as a DICOM Segmentation (PS3.3 A.51), binary, a frame a segment and plane where it has voxels, on the
/// volume's own grid and in the source's frame of reference, each frame referring to the source image nearest to it.
/// The first segment is taken from `part` (1 inside), the others from `labels`.
/// Cost: rows x columns / 8 bytes a frame. @throws Error(io); Error(unsupported), with nothing written, for what DICOM
/// refuses: no segment or more than 65535, planes of more than 65535 rows or columns, frames of 4 GiB or more;
/// Error(cancelled)
void write_dicom_segmentation(const MaskVolume& part, const LabelVolume& labels,
                              const std::vector<DicomSegment>& segments, const DicomSource& source,
                              const DicomProvenance& made, const std::filesystem::path& target,
                              const JobContext& job = {});

}  // namespace lacuna
