#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/dicom_source.h"

class DcmDataset;

// What every object derived from a series has in common; used by the writers of core/io and by who calls them.
namespace lacuna {

/// What a derived object says about its making.
struct DicomProvenance {
    std::string seed;      ///< digest of input and options: all UIDs follow from it and from what each stands for
    std::string software;  ///< "Lacuna"
    std::string version;   ///< "0.1.0"
    std::string title;     ///< of the part, for series descriptions; printable ASCII is kept
};

namespace dicom {

/// A decimal string of at most 16 characters, as exact as they allow (PS3.5, VR DS).
std::string decimal(double value);

/// What a description may show: printable ASCII without DICOM's separators, at most 64 characters.
std::string printable(const std::string& text);

/// The UID of one of the objects made from a seed: "seg", "sr", "key", "seg-series", ...
std::string uid_for(const DicomProvenance& made, const std::string& what);

/// The source's patient, study and frame of reference, as DICOM demands of a derived object; elements of type 2 that
/// the source lacks are there and empty; padding is taken off, and a value its VR does not allow is left out. Kept in
/// memory and in the file written, nowhere else.
/// @throws Error(io) naming the file if the source can no longer be read
void copy_context(const DicomSource& source, const DicomProvenance& made, DcmDataset& into);

/// Sets what would make two runs differ: content and creation date and time come from the source (its content, series
/// or study date; 19000101 where it names none), UIDs from the seed.
void fix_identity(const DicomProvenance& made, const std::string& what, const DcmDataset& context, DcmDataset& set);

/// Names the source's series and images as those a derived image refers to (common instance reference module).
void refer_to_source(const DicomSource& source, DcmDataset& set);

/// Writes a data set as Explicit VR little endian, whole or not at all. @throws Error(io)
void save_dataset(DcmDataset& set, const std::filesystem::path& target);

}  // namespace dicom
}  // namespace lacuna
