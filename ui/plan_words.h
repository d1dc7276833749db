#pragma once

#include <QString>
#include <optional>

#include "core/render/plan.h"

namespace lacuna::ui {

/// A structure's name in the language of the window: "octree", in German "Octree".
QString structure_word(Structure structure);
/// For a list to choose from: with the core's name behind it where that differs, as messages and files use it.
QString structure_title(Structure structure);
/// A word of a plan (a sampler, a view mode ..) in the language of the window; one that is not known, as it is.
QString plan_value(std::string_view word);

/// The core's words of a plan ("octree, step 0.5, sampler nearest") in the language of the window, numbers with its
/// decimal mark; nullopt for what are no such words.
std::optional<QString> plan_in_own_words(const QString& english);
/// The same for words known to be a plan's: parts that are not known stay as they are.
QString plan_words(const QString& english);

}  // namespace lacuna::ui
