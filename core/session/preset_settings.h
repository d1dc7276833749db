#pragma once

#include <string>

#include "core/classify/preset_file.h"
#include "core/session/document.h"

namespace lacuna {

/// The settings with the preset's transfer function and, where it states one, its technique: mode, shading, step.
/// @throws Error(bad_input) for a mode or a shading that does not exist, or a step that cannot be taken
ViewSettings with_preset(const ViewSettings& settings, const PresetFile& preset);

/// What the settings show, as a preset of that name.
PresetFile preset_of(const ViewSettings& settings, const std::string& name);

}  // namespace lacuna
