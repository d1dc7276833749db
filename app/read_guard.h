#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna::cli {

/// Refuses a result in the place of what is read: a table would take the scan's place for good.
/// @param read     INPUT as given: a file, a folder, or a sample's name
/// @param targets  of results none of which is DICOM; empty ones are none
/// @throws Error(bad_usage)
void check_not_read(const std::string& read, const std::vector<std::filesystem::path>& targets);

}  // namespace lacuna::cli
