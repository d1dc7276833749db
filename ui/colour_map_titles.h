#pragma once

#include <QString>
#include <string>

namespace lacuna::ui {

/// What the window calls a map of colour_map_names(), in its language.
QString colour_map_title(const std::string& name);

}  // namespace lacuna::ui
