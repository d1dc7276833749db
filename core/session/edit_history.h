#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/session/document.h"

namespace lacuna {

/// Undo and redo of named edits of the view settings. Each step keeps the settings whole: they are small, because the
/// voxels are not among them. Edits of one gesture (a slider being dragged) merge into one step.
class EditHistory {
public:
    explicit EditHistory(std::size_t limit = 200) : limit_(limit) {}

    /// Forgets all steps.
    void reset();
    /// Notes that `before` became `after` by the edit `name`. Equal settings are no edit. An edit of the same name as
    /// the last one joins it until seal() is called. Anything undone before is forgotten.
    /// @return false when nothing was noted
    bool note(std::string_view name, const ViewSettings& before, const ViewSettings& after);
    /// Ends the gesture: the next edit is a step of its own.
    void seal() { open_ = false; }

    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < steps_.size(); }
    /// Name of the step undo or redo would take; empty when there is none.
    std::string undo_name() const { return can_undo() ? steps_[done_ - 1].name : std::string(); }
    std::string redo_name() const { return can_redo() ? steps_[done_].name : std::string(); }
    /// The settings to go back or forward to. @pre can_undo() or can_redo()
    const ViewSettings& undo();
    const ViewSettings& redo();

private:
    struct Step {
        std::string name;
        ViewSettings before, after;
    };
    std::vector<Step> steps_;
    std::size_t done_ = 0;  ///< steps in effect; the others were undone
    std::size_t limit_;
    bool open_ = false;  ///< the last step may still be joined
};

}  // namespace lacuna
