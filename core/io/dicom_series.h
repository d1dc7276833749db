#pragma once

#include <string>
#include <vector>

#include "core/io/dicom_header.h"

namespace lacuna::dicom {

/// The slices that together make one volume, before they are put in order.
struct SeriesScan {
    std::vector<File> files;              ///< of this series only; their `frames` are moved to `slices`
    std::vector<Frame> slices;            ///< Frame::file indexes `files`
    std::vector<std::string> set_aside;   ///< localizers and odd images that came with the series, by file name
    std::vector<std::string> unreadable;  ///< files of the folder that are DICOM but could not be parsed, by name
    std::vector<std::string> locked;      ///< files and sub-folders that may not be opened, by name
    std::string uid;                      ///< unique in the list: SeriesInstanceUID, "#2", "#3" ... where it was split

    const File& file_of(const Frame& slice) const { return files[std::size_t(slice.file)]; }
    /// "name.dcm", or "name.dcm frame 3" of a file with several.
    std::string name_of(const Frame& slice) const;
};

/// Groups images into volumes: by SeriesInstanceUID, storage, size, spacing and orientation; by acquisition where the
/// slices together form no regular stack. Localizers, colour images and stray slices are set aside when something
/// better is there. Pure: looks at no file. Order: series number, UID, first file.
std::vector<SeriesScan> group_series(std::vector<File> files);

}  // namespace lacuna::dicom
