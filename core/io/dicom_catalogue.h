#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

/// What a folder or a DICOMDIR holds, as a radiologist looks for it. Holds patients' data: to be shown to the person
/// who asked, never logged. Texts are UTF-8; dates are YYYYMMDD as stored.
struct CatalogueSeries {
    std::string uid, modality, description;
    int number = 0;
    int columns = 0, rows = 0;                 ///< 0: not known (of a DICOMDIR)
    int images = 0;                            ///< frames of all files
    std::vector<std::filesystem::path> files;  ///< by instance number
};
struct CatalogueStudy {
    std::string uid, date, description, accession;
    std::vector<CatalogueSeries> series;  ///< by number
};
struct CataloguePatient {
    std::string id, name, birth_date, sex;
    std::vector<CatalogueStudy> studies;  ///< newest first
};
struct Catalogue {
    std::vector<CataloguePatient> patients;  ///< by name, then id
    int files = 0;                           ///< looked at
    int unreadable = 0;                      ///< DICOM files that are broken or may not be opened
    int missing = 0;                         ///< files a DICOMDIR names that are not there

    int series_count() const;
};

/// Looks through a folder, with all below it, or reads a DICOMDIR; files without pixels are left out. Only headers are
/// read, in parallel. `found` is told, from any thread and never more than once in 200 ms, what is there so far.
/// Cost: about a millisecond a file where the disk is fast.
/// @throws Error(io) if the folder cannot be read; Error(bad_input) for a DICOMDIR that is none; Error(cancelled)
Catalogue scan_catalogue(const std::filesystem::path& input, const JobContext& job = {},
                         const std::function<void(const Catalogue&)>& found = nullptr);

/// A name as people write it: "Family, Given" of "Family^Given"; only the first group of several spellings.
std::string person_name(const std::string& stored);

/// The folder that holds all files of a series, or the deepest that does: what open_volume is given with its UID.
std::filesystem::path folder_of(const CatalogueSeries& series);

/// A small grey picture, rows top to bottom.
struct CatalogueThumbnail {
    int width = 0, height = 0;  ///< 0: there is none
    std::vector<std::uint8_t> grey;
};

/// The middle image of a series, at most `edge` pixels wide and high, its grey window fitted to its values. Images that
/// cannot be shown (colour, broken) have none. @throws Error(cancelled)
CatalogueThumbnail catalogue_thumbnail(const CatalogueSeries& series, int edge, const JobContext& job = {});

}  // namespace lacuna
