#pragma once

#include <QString>

#include "core/session/preset_library.h"

namespace lacuna::ui {

/// The name of a built-in preset (preset_names()) in the language of the window; any other name as it is.
QString preset_title(const std::string& name);
/// A user's own preset keeps the name it was given.
QString preset_title(const PresetEntry& entry);

}  // namespace lacuna::ui
