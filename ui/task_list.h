#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

namespace lacuna::ui {

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
        QElapsedTimer since;
        std::function<void()> cancel;

        /// Seconds left at the pace so far; none before a second and 2 % of the work have passed.
        std::optional<double> secondsLeft() const;
    };

    explicit TaskList(QObject* parent = nullptr) : QObject(parent) {}

    /// @param cancel  stops the work and ends the row
    Id begin(const QString& name, std::function<void()> cancel);
    void progress(Id id, double share);
    void end(Id id);
    /// Asks a job to stop; does nothing for one that has ended.
    void cancel(Id id);
    void cancelAll();

    /// Oldest first.
    const std::vector<Row>& rows() const { return rows_; }

Q_SIGNALS:
    void changed();  ///< rows came, went or went on

private:
    Row* find(Id id);
    std::vector<Row> rows_;
    Id last_ = 0;
};

/// "2 min 5 s left" in words a person would use; rounded, because it is a guess.
QString time_left_text(double seconds);

}  // namespace lacuna::ui
