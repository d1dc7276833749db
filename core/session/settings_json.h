#pragma once

#include <string>

#include "core/session/document.h"

namespace lacuna {

/// The view settings as JSON, every field of them; reading it back gives equal settings.
std::string to_json(const ViewSettings& settings);

/// Fields that are left out take the default of ViewSettings, unknown ones are refused. What is out of range for any
/// volume (an unknown word, a transfer function that is none, too many cuts or ranges) is refused too.
/// @param where  names the text in complaints, e.g. a file
/// @throws Error(bad_input) naming `where` and the entry
ViewSettings view_settings_from_json(const std::string& json, const std::string& where);

/// Refuses what no window can show. @throws Error(bad_input) naming `where` and the fault
void check(const ViewSettings& settings, const std::string& where);

}  // namespace lacuna
