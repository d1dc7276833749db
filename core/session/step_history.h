#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// Undo and redo of named steps from one State to the next. Each keeps both states whole: they are small. Steps of one
/// gesture (a slider being dragged) join into one.
/// @tparam State  a value with ==
template <class State>
class StepHistory {
public:
    explicit StepHistory(std::size_t limit = 200) : limit_(limit) {}

    /// Forgets all steps.
    void reset() {
        steps_.clear();
        done_ = 0;
        open_ = false;
    }
    /// Notes that `before` became `after` by the step `name`. Equal states are no step. One of the same name as the
    /// last joins it until seal() is called. Anything undone before is forgotten.
    /// @param joins  it joins the last step, whatever that was called, and names it; unless that was sealed
    /// @return false when nothing was noted
    bool note(std::string_view name, const State& before, const State& after, bool joins = false) {
        if (before == after) return false;
        steps_.resize(done_);
        if (open_ && !steps_.empty() && (joins || steps_.back().name == name)) {
            steps_.back().name = name;
            steps_.back().after = after;
            if (steps_.back().before == after) {  // the gesture came back to where it began
                steps_.pop_back();
                open_ = false;
            }
        } else {
            steps_.push_back({std::string(name), before, after});
            if (steps_.size() > limit_) steps_.erase(steps_.begin());
            open_ = true;
        }
        done_ = steps_.size();
        return true;
    }
    /// Ends the gesture: the next step stands alone.
    void seal() { open_ = false; }

    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < steps_.size(); }
    /// Name of the step undo or redo would take; empty when there is none.
    std::string undo_name() const { return can_undo() ? steps_[done_ - 1].name : std::string(); }
    std::string redo_name() const { return can_redo() ? steps_[done_].name : std::string(); }
    /// The state to go back or forward to. @pre can_undo() or can_redo()
    const State& undo() {
        open_ = false;
        return steps_[--done_].before;
    }
    const State& redo() {
        open_ = false;
        return steps_[done_++].after;
    }

private:
    struct Step {
        std::string name;
        State before, after;
    };
    std::vector<Step> steps_;
    std::size_t done_ = 0;  ///< steps in effect; the others were undone
    std::size_t limit_;
    bool open_ = false;  ///< the last step may still be joined
};

}  // namespace lacuna
