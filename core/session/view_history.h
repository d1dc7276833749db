#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/render/camera.h"

namespace lacuna {

/// Where one looks from and where the slices are.
struct Viewpoint {
    Camera camera;
    glm::dvec3 cursor_mm{0};
    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

/// The viewpoints there were, to go back and forward through as through the pages of a browser. Moves of one gesture
/// (a drag) are one step. Apart from EditHistory: looking around changes nothing of the work, and undoing an edit has
/// to leave the view where its effect is being looked at.
class ViewHistory {
public:
    explicit ViewHistory(std::size_t limit = 100) : limit_(limit) {}

    /// Forgets all steps; `now` is where one is.
    void reset(const Viewpoint& now);
    /// Notes a move to `now`. One of the same name joins the last until seal() is called. What was gone back from is
    /// forgotten. A move to where one is is none.
    /// @param name  what moved, as it stands in the menu
    /// @param joins  it belongs to the last step, whatever that was called; unless that was sealed or came to nothing
    void note(std::string_view name, const Viewpoint& now, bool joins = false);
    /// Ends the gesture: the next move is a step of its own.
    void seal() { open_ = false; }

    bool can_go_back() const { return at_ > 0; }
    bool can_go_forward() const { return at_ < steps_.size(); }
    /// What going back or forward would move; empty where there is nothing.
    std::string back_name() const { return can_go_back() ? steps_[at_ - 1].name : std::string(); }
    std::string forward_name() const { return can_go_forward() ? steps_[at_].name : std::string(); }
    /// Where that leads. @pre can_go_back() or can_go_forward()
    const Viewpoint& back();
    const Viewpoint& forward();
    const Viewpoint& now() const { return now_; }

private:
    struct Step {
        std::string name;
        Viewpoint before, after;
    };
    std::vector<Step> steps_;
    std::size_t at_ = 0;  ///< steps in effect; the others were gone back from
    std::size_t limit_;
    Viewpoint now_;
    bool open_ = false;  ///< the last step may still be joined
};

}  // namespace lacuna
