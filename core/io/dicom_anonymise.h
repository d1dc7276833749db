#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

/// How a DICOM export is anonymised.
struct AnonymiseOptions {
    /// All new UIDs and pseudonyms follow from this and the old ones; whoever has it can tell which belong together.
    /// Empty: made at random and forgotten, so that two exports of one series cannot be joined.
    std::string key;
    bool keep_burned_in = false;      ///< export images that say patient data are drawn into their pixels
    std::string software = "Lacuna";  ///< with its version; stated as the method, (0012,0063)
};

/// What an export did. Names no file and no patient.
struct AnonymiseReport {
    int images = 0, series = 0, studies = 0, patients = 0;
    int not_images = 0;        ///< DICOM files without pixels (reports, plans, DICOMDIR): left out
    int unreadable = 0;        ///< DICOM files that could not be read: left out
    int burned_in = 0;         ///< images that say (0028,0301) YES; left out unless asked to keep them
    int burned_in_unsaid = 0;  ///< images of kinds that often have text in their pixels and do not say: look at them
    int faces = 0;             ///< images that say a face can be recognised, (0028,0302) YES; pixels are not changed

    /// The above as sentences for a person; what was left out or must be looked at.
    std::vector<std::string> notes() const;
};

/// Writes the images among `files` into a new folder, anonymised by the Basic Application Level Confidentiality Profile
/// of PS3.15 Annex E (2024b), without options: every attribute of Table E.1-1 at any depth is removed, emptied,
/// replaced or given another UID as the table says, references between the files staying whole; private attributes,
/// curves, overlays and group lengths are removed. Stricter than the profile: attributes that DCMTK's dictionary does
/// not know are removed, names and dates that the table does not list emptied. Where the table leaves a choice by type,
/// CT, MR, PET, CR and secondary captures take the most private, all other objects the one that keeps them valid.
/// Patients get a pseudonym for name and id. (0012,0062), (0012,0063), (0012,0064) and (0028,0303) say what was done.
/// The pixels and their coding stay as they are: text drawn into them is not found, only what the file says of it.
/// Files are named by number alone: SE001/IM00001.dcm. The folder appears whole or not at all.
/// @throws Error(bad_input) if no image is among the files; Error(io) for the folder; Error(cancelled)
AnonymiseReport anonymise_dicom(const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder,
                                const AnonymiseOptions& options = {}, const JobContext& job = {});

}  // namespace lacuna
