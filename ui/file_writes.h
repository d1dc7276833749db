#pragma once

#include <QObject>
#include <functional>

#include "ui/tasks.h"
#include "ui/workbench.h"

namespace lacuna::ui {

/// A feature's jobs that write a file or a folder, as many side by side as are asked for: each stands in the task list
/// while it runs; then the message bar says where it was written, or why not.
class FileWrites final : public QObject {
    Q_OBJECT
public:
    using Work = std::function<void(const JobContext&)>;

    /// @param bench  outlives this
    explicit FileWrites(Workbench& bench) : bench_(bench), jobs_(this, bench.tasks()) {}

    /// @param name  what the task list calls it
    /// @param work  writes `file`; runs off the window's thread
    /// @param done  what is said when it stands, with %1 for where; "Written to %1." by default
    /// @param answers  what can be done with it then
    void start(const QString& name, const QString& file, Work work, const QString& done = {},
               const MessageBar::Answers& answers = {});

Q_SIGNALS:
    void written(const QString& file);

private:
    Workbench& bench_;
    Tasks<QString> jobs_;
};

}  // namespace lacuna::ui
