#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <deque>
#include <mutex>
#include <vector>

#include "core/base/log.h"

namespace lacuna::ui {

struct LogLine {
    QDateTime time;
    LogLevel level = LogLevel::info;
    QString text;
};

/// The word for a level, in the language of the window.
QString level_name(LogLevel level);
/// "12:03:44.120 warning: ..." as it is shown and copied.
QString to_text(const LogLine& line);

/// The last lines of the program's log, from any thread; those of level `warning` and up still go to stderr too.
class LogStore final : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t k_lines_kept = 5000;

    /// The program's one. From the first call to the end of the QCoreApplication it takes what is logged.
    static LogStore* instance();
    ~LogStore() override;
    std::vector<LogLine> lines() const;
    void clear();

Q_SIGNALS:
    void added(const lacuna::ui::LogLine& line);  ///< on the store's own thread

private:
    explicit LogStore(QObject* parent);
    void take(LogLevel level, std::string_view text);
    mutable std::mutex mutex_;
    std::deque<LogLine> lines_;
};

}  // namespace lacuna::ui
