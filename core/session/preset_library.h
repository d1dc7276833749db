#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/classify/preset_file.h"

namespace lacuna {

/// A preset that can be chosen: one of preset_names(), or a file of the user's.
struct PresetEntry {
    std::string name;
    std::filesystem::path file = {};        ///< empty: built in
    std::optional<PresetFile> preset = {};  ///< what the file holds; none where it is built in or cannot be read
    std::string fault = {};                 ///< why it cannot be read; the file is left as it is
    bool built_in() const { return file.empty(); }
    friend bool operator==(const PresetEntry&, const PresetEntry&) = default;
};

/// The built-in presets, then the files (*.json) of the folder by name. A folder that does not exist holds none; a file
/// that cannot be read is listed with its fault. @throws Error(io) where the folder itself cannot be read
std::vector<PresetEntry> list_presets(const std::filesystem::path& folder);

/// What an entry shows on this volume; built-in ones are fitted to the data.
/// @throws Error(bad_input) with the fault of an entry that cannot be read
PresetFile preset_for(const PresetEntry& entry, const Volume& volume, const VolumeStatistics& statistics);

/// Whether one of the folder's files holds a preset of that name. @throws Error(io) where it cannot be read
bool owns_preset(const std::filesystem::path& folder, const std::string& name);

/// Writes a preset into the folder, which is made where it does not exist, as a file named after it.
/// @param replace  false: a preset of that name (a file's, or a built-in one's) is refused as Error(bad_usage)
/// @throws Error(bad_usage) for an empty name, Error(io). @return the file
std::filesystem::path store_preset(const std::filesystem::path& folder, const PresetFile& preset, bool replace);

/// Gives a file's preset another name, and the file with it; nothing is lost where that fails.
/// @throws Error(bad_usage) where the name is taken, Error(bad_input) where the file cannot be read, Error(io)
std::filesystem::path rename_preset(const std::filesystem::path& file, const std::string& name);

/// @throws Error(io)
void remove_preset(const std::filesystem::path& file);

}  // namespace lacuna
