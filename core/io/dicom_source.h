#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

/// One image of the series a volume was made of.
struct DicomSourceImage {
    std::filesystem::path file;
    std::string sop_class_uid, sop_instance_uid;
    int frame = 0;     ///< from 1, of a file with several; 0: the file has one
    double plane = 0;  ///< where it lies along the volume's third axis, in voxels
};

/// Where a volume came from: what objects derived from it (segmentations, reports) must refer to. Holds no patient's
/// data; writers copy that from the first image's file. Never logged.
struct DicomSource {
    std::string study_uid, series_uid, frame_of_reference_uid;
    std::vector<DicomSourceImage> images;  ///< those used, in stacking order
};

struct OpenOptions;
struct SeriesEntry;

/// What open_volume() of the same words reads its DICOM series from; null where it reads something else. Looks at
/// headers only. @throws as open_volume
std::shared_ptr<const DicomSource> find_dicom_source(const std::string& input, const OpenOptions& options,
                                                     const JobContext& job = {});

/// The same of one series found by find_dicom_series.
std::shared_ptr<const DicomSource> dicom_source_of(const SeriesEntry& series, const JobContext& job = {});

}  // namespace lacuna
