#include "core/session/view_history.h"

namespace lacuna {

void ViewHistory::reset(const Viewpoint& now) {
    steps_.clear();
    at_ = 0;
    now_ = now;
    open_ = false;
}

void ViewHistory::note(std::string_view name, const Viewpoint& now, bool joins) {
    if (now == now_) return;
    steps_.resize(at_);
    if (open_ && !steps_.empty() && (joins || steps_.back().name == name)) {
        steps_.back().name = name;
        steps_.back().after = now;
        if (steps_.back().before == now) {  // the gesture came back to where it began
            steps_.pop_back();
            open_ = false;
        }
    } else {
        steps_.push_back({std::string(name), now_, now});
        if (steps_.size() > limit_) steps_.erase(steps_.begin());
        open_ = true;
    }
    at_ = steps_.size();
    now_ = now;
}

const Viewpoint& ViewHistory::back() {
    open_ = false;
    now_ = steps_[--at_].before;
    return now_;
}

const Viewpoint& ViewHistory::forward() {
    open_ = false;
    now_ = steps_[at_++].after;
    return now_;
}

}  // namespace lacuna
