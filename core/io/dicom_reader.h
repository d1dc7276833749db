#pragma once

#include "core/io/volume_reader.h"

namespace lacuna {

/// True if the file starts like DICOM (preamble and DICM) or parses as a data set without one.
bool looks_like_dicom(const std::filesystem::path& file);

/// Scans a folder (recursively) or one file by content. Files that are no images are ignored.
std::vector<SeriesEntry> find_dicom_series(const std::filesystem::path& input, const JobContext& job = {});

/// Reads one series found by find_dicom_series.
Volume read_dicom_series(const SeriesEntry& series, const OpenOptions& options = {}, const JobContext& job = {});

}  // namespace lacuna
