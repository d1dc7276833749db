#include "core/session/edit_history.h"

namespace lacuna {

void EditHistory::reset() {
    steps_.clear();
    done_ = 0;
    open_ = false;
}

bool EditHistory::note(std::string_view name, const ViewSettings& before, const ViewSettings& after) {
    if (before == after) return false;
    steps_.resize(done_);
    if (open_ && !steps_.empty() && steps_.back().name == name) {
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

const ViewSettings& EditHistory::undo() {
    open_ = false;
    return steps_[--done_].before;
}

const ViewSettings& EditHistory::redo() {
    open_ = false;
    return steps_[done_++].after;
}

}  // namespace lacuna
