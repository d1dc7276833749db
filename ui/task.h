#pragma once

#include <QPointer>

#include "ui/latest_job.h"
#include "ui/task_list.h"

namespace lacuna::ui {

/// A LatestJob that a person sees: it stands in the window's task list while it runs and can be cancelled there. Unlike
/// LatestJob, `done` is told of a cancel too, at once, as Error(cancelled); not of a newer start or of destruction.
template <class T>
class Task {
public:
    using Work = typename LatestJob<T>::Work;
    using Done = typename LatestJob<T>::Done;

    /// @param owner  lives on the window's thread and outlives this
    Task(QObject* owner, TaskList* list, AtStake at_stake = AtStake::work)
        : list_(list), at_stake_(at_stake), job_(owner) {}
    ~Task() { leave(); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

    void start(const QString& name, Work work, Done done) {
        leave();
        done_ = std::move(done);
        id_ = list_->begin(
            name, [this] { cancel(); }, at_stake_);
        job_.start(
            std::move(work),
            [this](Outcome<T> outcome) {
                leave();
                finish(std::move(outcome));
            },
            [this](double share) {
                if (list_) list_->progress(id_, share);
            });
    }

    void cancel() {
        if (!job_.running()) return;
        job_.cancel();
        leave();
        finish(Error(Errc::cancelled, "Cancelled."));
    }

    bool running() const { return job_.running(); }

    /// Says in the task list that the work waits, and what lets it go on there (null: it goes on). The work itself is
    /// held by whoever calls this.
    void pause(std::function<void()> go_on) {
        if (list_ && id_ != 0) list_->pause(id_, std::move(go_on));
    }

private:
    void leave() {
        if (list_ && id_ != 0) list_->end(id_);
        id_ = 0;
    }
    void finish(Outcome<T> outcome) {
        const Done done = std::exchange(done_, nullptr);  // it may start the next one
        const Error* error = std::get_if<Error>(&outcome);
        const bool failed = error && error->code() != Errc::cancelled;
        const QPointer<TaskList> list = list_;
        if (done) done(std::move(outcome));
        if (failed && list) Q_EMIT list->failed();
    }

    QPointer<TaskList> list_;
    AtStake at_stake_;
    TaskList::Id id_ = 0;
    Done done_;
    LatestJob<T> job_;
};

}  // namespace lacuna::ui
