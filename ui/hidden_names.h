#pragma once

#include <string>

#include "core/volume/volume.h"

namespace lacuna::ui {

/// A sentence about an input (an error's) without the names it has on the disk, which may be those of patients: the
/// input's own path and name, those of the files in it or beside it, and every other path become "...". Where more
/// files lie there than can be looked through, all that stays is that it cannot be opened. Cost: the listing of a
/// folder.
std::string without_names(const std::string& sentence, const std::string& input);

/// Takes the names of files out of what a volume tells of its input: its warnings and the duplicates of a series, of
/// which only their number stays. Cost: as without_names() for each warning.
void hide_names(Volume& volume, const std::string& input);

}  // namespace lacuna::ui
