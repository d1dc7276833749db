#pragma once

#include "core/session/document.h"
#include "core/session/step_history.h"

namespace lacuna {

/// Undo and redo of named edits of the view settings, without the voxels, which are not among them.
using EditHistory = StepHistory<ViewSettings>;

}  // namespace lacuna
