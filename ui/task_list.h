#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

namespace lacuna::ui {

/// What is lost when a job is ended before its time: work somebody asked for (a file, a transfer, a result), or nothing
/// that would not be there again.
enum class AtStake { nothing, work };

/// The long jobs of a window in one place: what runs, how far it is, how long it will still take, how to stop it.
/// Lives on the window's thread; Task (task.h) enters its jobs here.
class TaskList final : public QObject {
    Q_OBJECT
public:
    using Id = int;

    struct Row {
        Id id = 0;
        QString name;
        double share = -1;  ///< 0..1; below 0: not known yet
        AtStake at_stake = AtStake::nothing;
        QElapsedTimer since;
        std::function<void()> cancel;
        std::function<void()> go_on;  ///< set while the job is paused: lets it go on
        qint64 paused_at_ms = 0;      ///< of `since`, while it is paused
        qint64 paused_ms = 0;         ///< in all, of the pauses that are over

        bool paused() const { return go_on != nullptr; }
        /// Seconds left at the pace so far; none before a second and 2 % of the work have passed.
        std::optional<double> secondsLeft() const;
    };

    explicit TaskList(QObject* parent = nullptr) : QObject(parent) {}

    /// @param cancel  stops the work and ends the row
    Id begin(const QString& name, std::function<void()> cancel, AtStake at_stake = AtStake::nothing);
    void progress(Id id, double share);
    void end(Id id);
    /// The job waits until somebody lets it go on, here by `go_on`; null: it goes on.
    void pause(Id id, std::function<void()> go_on);
    /// Lets a paused job go on; does nothing for others.
    void goOn(Id id);
    /// Asks a job to stop; does nothing for one that has ended.
    void cancel(Id id);
    void cancelAll();

    /// Oldest first.
    const std::vector<Row>& rows() const { return rows_; }
    /// Those whose end would lose work.
    std::vector<Row> workAtStake() const;

Q_SIGNALS:
    void changed();  ///< rows came, went or went on
    void failed();   ///< a job's work did not become what was asked for; not of one that was cancelled

private:
    Row* find(Id id);
    std::vector<Row> rows_;
    Id last_ = 0;
};

/// "Saving the volume", and how long it will still take where that is known, or that it is paused.
QString task_text(const TaskList::Row& row);

/// "2 min 5 s left" in words a person would use; rounded, because it is a guess.
QString time_left_text(double seconds);

}  // namespace lacuna::ui
