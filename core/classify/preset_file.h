#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/classify/transfer_function.h"

namespace lacuna {

/// The way of drawing a preset was made for, in the command line's words. Empty and 0: not stated.
struct Technique {
    std::string mode;     ///< as --mode
    std::string shading;  ///< as --shading
    double step = 0;      ///< as --step, in units of the smallest voxel spacing
    friend bool operator==(const Technique&, const Technique&) = default;
};

/// A transfer function with the technique it is meant for: the contract's transfer-function file, whole.
struct PresetFile {
    TransferFunction tf;
    std::optional<Technique> technique;
    friend bool operator==(const PresetFile&, const PresetFile&) = default;
};

/// The newest version of the format: 1 is points and gradient opacity, 2 adds shapes and the technique. A file that
/// names none is of version 1 or 2; one of a later version is refused as such.
inline constexpr int k_transfer_file_version = 2;

/// @throws Error(bad_input) naming file and key
PresetFile preset_from_json(const std::string& json, const std::string& where);
/// Names its version only where it holds what version 1 had not.
std::string to_json(const PresetFile& preset);
/// @throws Error(bad_input) naming file and key, Error(io)
PresetFile load_preset(const std::filesystem::path& file);
void save_preset(const PresetFile& preset, const std::filesystem::path& file);

/// What a preset of preset_names() is best seen with.
Technique technique_of_preset(const std::string& name);

}  // namespace lacuna
