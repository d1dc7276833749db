#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/dicom_derived.h"

namespace lacuna {

/// What can be said of a defect in a measurement report, with a unit of UCUM.
enum class DicomQuantity { volume_mm3, diameter_mm, equivalent_diameter_mm, surface_distance_mm, area_mm2, mean_value };

/// A measured value; lo and hi, its interval, follow as measurements of their own.
struct DicomMeasurement {
    DicomQuantity quantity = DicomQuantity::volume_mm3;
    double value = 0;
};

/// One measurement group of TID 1500 (Volumetric ROI Measurements, TID 1411).
struct DicomMeasurementGroup {
    std::string label;                                      ///< "Defect 3"
    std::string tracking_uid;                               ///< as in the segmentation
    std::string type;                                       ///< "void", "inclusion", "part"
    int segment = 0;                                        ///< number of the segment in the segmentation, from 1
    std::vector<DicomMeasurement> measurements;             ///< at least one
    std::vector<std::pair<std::string, std::string>> said;  ///< evaluations in words: name, text
};

/// Writes a measurement report (Comprehensive SR, template TID 1500) that refers to a segmentation written with the
/// same provenance and to the source series.
/// @param unit  of mean values: "HU", or anything else for arbitrary units
/// @param said  evaluations of the whole part in words, UTF-8: name, text
/// @throws Error(io); Error(unsupported) for what DICOM refuses
void write_dicom_report(const std::vector<DicomMeasurementGroup>& groups,
                        const std::vector<std::pair<std::string, std::string>>& said, const std::string& unit,
                        const DicomSource& source, const DicomProvenance& made, const std::filesystem::path& target);

}  // namespace lacuna
