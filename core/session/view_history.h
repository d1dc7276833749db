#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "core/render/camera.h"
#include "core/session/step_history.h"

namespace lacuna {

/// How near one looks at a slice: its size against the one that fits the view, and how far its middle lies from the
/// view's, in pixels.
struct SliceZoom {
    double zoom = 1;
    glm::dvec2 pan{0};
    friend bool operator==(const SliceZoom&, const SliceZoom&) = default;
};

/// Where one looks from, where the slices are, and how near they are looked at.
struct Viewpoint {
    Camera camera;
    glm::dvec3 cursor_mm{0};
    std::array<SliceZoom, 3> slices{};  ///< axial, coronal, sagittal
    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

/// The viewpoints there were, to go back and forward through as through the pages of a browser. Moves of one gesture
/// (a drag) are one step. Apart from EditHistory: looking around changes nothing of the work, and undoing an edit has
/// to leave the view where its effect is being looked at.
class ViewHistory {
public:
    explicit ViewHistory(std::size_t limit = 100) : steps_(limit) {}

    /// Forgets all steps; `now` is where one is.
    void reset(const Viewpoint& now) {
        steps_.reset();
        now_ = now;
    }
    /// Notes a move to `now`, as StepHistory::note.
    /// @param name  what moved, as it stands in the menu
    void note(std::string_view name, const Viewpoint& now, bool joins = false) {
        if (steps_.note(name, now_, now, joins)) now_ = now;
    }
    /// Ends the gesture: the next move is a step of its own.
    void seal() { steps_.seal(); }

    bool can_go_back() const { return steps_.can_undo(); }
    bool can_go_forward() const { return steps_.can_redo(); }
    /// What going back or forward would move; empty where there is nothing.
    std::string back_name() const { return steps_.undo_name(); }
    std::string forward_name() const { return steps_.redo_name(); }
    /// Where that leads. @pre can_go_back() or can_go_forward()
    const Viewpoint& back() { return now_ = steps_.undo(); }
    const Viewpoint& forward() { return now_ = steps_.redo(); }
    const Viewpoint& now() const { return now_; }

private:
    StepHistory<Viewpoint> steps_;
    Viewpoint now_;
};

}  // namespace lacuna
