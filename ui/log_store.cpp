#include "ui/log_store.h"

#include <QCoreApplication>
#include <QPointer>
#include <cstdio>

namespace lacuna::ui {

QString level_name(LogLevel level) {
    switch (level) {
        case LogLevel::debug:
            return LogStore::tr("detail");
        case LogLevel::info:
            return LogStore::tr("note");
        case LogLevel::warning:
            return LogStore::tr("warning");
        case LogLevel::error:
            return LogStore::tr("error");
    }
    return {};
}

QString to_text(const LogLine& line) {
    return QStringLiteral("%1 %2: %3")
        .arg(line.time.toString(QStringLiteral("hh:mm:ss.zzz")), level_name(line.level), line.text);
}

LogStore* LogStore::instance() {
    static QPointer<LogStore> one;
    if (!one) one = new LogStore(QCoreApplication::instance());
    return one;
}

LogStore::LogStore(QObject* parent) : QObject(parent) {
    set_log_sink([this](LogLevel level, std::string_view text) { take(level, text); });
}

LogStore::~LogStore() { set_log_sink(nullptr); }

void LogStore::take(LogLevel level, std::string_view text) {
    if (level >= LogLevel::warning) std::fprintf(stderr, "lacuna: %.*s\n", int(text.size()), text.data());
    const LogLine line{QDateTime::currentDateTime(), level, QString::fromUtf8(text.data(), qsizetype(text.size()))};
    {
        std::lock_guard lock(mutex_);
        lines_.push_back(line);
        if (lines_.size() > k_lines_kept) lines_.pop_front();
    }
    QMetaObject::invokeMethod(
        this, [this, line] { Q_EMIT added(line); }, Qt::QueuedConnection);
}

std::vector<LogLine> LogStore::lines() const {
    std::lock_guard lock(mutex_);
    return {lines_.begin(), lines_.end()};
}

void LogStore::clear() {
    std::lock_guard lock(mutex_);
    lines_.clear();
}

}  // namespace lacuna::ui
