#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

/// What lies under an input.
struct FolderListing {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> locked = {};  ///< names of sub-folders that may not be opened
    int empty = 0;                         ///< files of no bytes, which are left out
};

/// The file named, or all files under a folder that are not empty, in the order of their names. Links to folders are
/// not followed. @throws Error(bad_input) where there is nothing of that name, Error(io), Error(cancelled)
FolderListing files_under(const std::filesystem::path& input, const JobContext& job = {});

}  // namespace lacuna
