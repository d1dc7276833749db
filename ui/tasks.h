#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "ui/task.h"

namespace lacuna::ui {

/// Jobs of one kind of which every one matters, as those that write files: each is a Task of its own, so that starting
/// another cancels none. They run side by side.
template <class T>
class Tasks {
public:
    /// @param owner  lives on the window's thread and outlives this
    Tasks(QObject* owner, TaskList* list) : owner_(owner), list_(list) {}

    void start(const QString& name, typename Task<T>::Work work, typename Task<T>::Done done) {
        auto free = std::find_if(tasks_.begin(), tasks_.end(), [](const auto& task) { return !task->running(); });
        if (free == tasks_.end()) free = tasks_.insert(free, std::make_unique<Task<T>>(owner_, list_));
        (*free)->start(name, std::move(work), std::move(done));
    }

private:
    QObject* owner_;
    TaskList* list_;
    std::vector<std::unique_ptr<Task<T>>> tasks_;
};

}  // namespace lacuna::ui
