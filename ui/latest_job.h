#pragma once

#include <QMetaObject>
#include <QObject>
#include <QThreadPool>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <stop_token>
#include <utility>
#include <variant>

#include "core/base/error.h"
#include "core/base/job.h"

namespace lacuna::ui {

/// What a job ends with: its value, or the error that stopped it.
template <class T>
using Outcome = std::variant<T, Error>;

/// Runs work and turns whatever leaves it into an Outcome.
template <class T>
Outcome<T> capture(const std::function<T(const JobContext&)>& work, const JobContext& job) {
    try {
        job.check();
        return work(job);
    } catch (const Error& error) {
        return error;
    } catch (const std::bad_alloc&) {
        return Error(Errc::out_of_memory, "There is not enough memory for this.");
    } catch (const std::exception& error) {
        return Error(Errc::unsupported, std::string("Something unexpected went wrong: ") + error.what());
    }
}

/// One kind of background work of which only the newest matters: starting another cancels the one before. Values go
/// in with the work (captured by copy), the outcome and the progress come back on the owner's thread; neither comes
/// after cancel(), a newer start() or destruction. Destruction waits for the work to notice its stop.
template <class T>
class LatestJob {
public:
    using Work = std::function<T(const JobContext&)>;
    using Done = std::function<void(Outcome<T>)>;
    using Progress = std::function<void(double)>;

    /// @param owner  lives on the thread that gets the outcomes; must outlive this
    explicit LatestJob(QObject* owner) : owner_(owner) { pool_.setMaxThreadCount(1); }
    ~LatestJob() {
        cancel();
        pool_.waitForDone();
    }
    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    void start(Work work, Done done, Progress progress = nullptr) {
        stop_.request_stop();
        stop_ = std::stop_source();
        running_ = true;
        JobContext job{stop_.get_token(), nullptr};
        if (progress)
            job.progress = [this, progress, stop = job.stop](double share) {
                QMetaObject::invokeMethod(
                    owner_,
                    [progress, stop, share] {
                        if (!stop.stop_requested()) progress(share);
                    },
                    Qt::QueuedConnection);
            };
        pool_.start([this, work = std::move(work), done = std::move(done), job] {
            auto outcome = std::make_shared<Outcome<T>>(capture<T>(work, job));
            QMetaObject::invokeMethod(
                owner_,
                [this, done, outcome, stop = job.stop] {
                    if (stop.stop_requested()) return;  // also when this is gone: its end requests the stop
                    running_ = false;
                    done(std::move(*outcome));
                },
                Qt::QueuedConnection);
        });
    }

    /// Stops the running work; its outcome will not be told.
    void cancel() {
        stop_.request_stop();
        running_ = false;
    }
    /// True from start() until the outcome was told or the work cancelled.
    bool running() const { return running_; }

private:
    QObject* owner_;
    QThreadPool pool_;
    std::stop_source stop_;
    bool running_ = false;
};

}  // namespace lacuna::ui
