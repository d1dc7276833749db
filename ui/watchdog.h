#pragma once

#include <QApplication>
#include <QObject>
#include <QString>
#include <chrono>
#include <vector>

namespace lacuna::ui {

/// A turn of the event loop that took long: from taking up its first event to waiting for the next. The thread's own
/// time is what it computed itself; wall time holds also what it waited for, and on a busy machine what others had.
struct SlowTurn {
    double wall_ms = 0, cpu_ms = 0;
    /// The event that took most of it, with its receiver's class: "Paint to lacuna::ui::SliceView". Names of classes
    /// and kinds of events alone, nothing of what is shown.
    QString what;
    double what_ms = 0;  ///< wall time of that event without those it brought about itself
};

/// Measures the turns of the window's event loop and says which took longer than a person notices. Debug builds have it
/// on from the start, others by LACUNA_WATCHDOG=1 (or a limit in ms), all are silenced by LACUNA_WATCHDOG=0. While it
/// is off an event costs two comparisons; while it is on, two readings of two clocks.
class Watchdog final : public QObject {
    Q_OBJECT
public:
    static constexpr double k_limit_ms = 50;

    explicit Watchdog(QObject* parent = nullptr);
    bool isOn() const { return on_; }
    void setOn(bool on);
    /// Wall time a turn may take before it is told.
    void setLimit(double ms) { limit_ms_ = ms; }
    double limit() const { return limit_ms_; }
    /// Of all turns since the last forget(), by the thread's own time and by wall time; zeros where there was none.
    const SlowTurn& worstOwn() const { return worst_own_; }
    const SlowTurn& worstWall() const { return worst_wall_; }
    std::int64_t turns() const { return turns_; }
    void forget();

    /// Around the delivery of each event, on the window's thread.
    void enter(const QObject* receiver, const QEvent* event);
    void leave();
    /// The loop is about to wait, or has just waited: a turn is over.
    void turnOver();

Q_SIGNALS:
    void slow(const lacuna::ui::SlowTurn& turn);

private:
    struct Frame {
        const char* receiver;
        int type;
        std::chrono::steady_clock::time_point begin;
        double inner_ms;  ///< of the events delivered within it
    };
    void watchLoop();

    bool on_ = false, measuring_ = false, watches_loop_ = false;
    double limit_ms_ = k_limit_ms;
    std::vector<Frame> stack_;
    std::size_t base_ = 0;  ///< depth of the event being measured: deeper than 0 within a dialog's own loop
    std::chrono::steady_clock::time_point begin_;
    double begin_cpu_ms_ = 0, wall_ms_ = 0, cpu_ms_ = 0, most_ms_ = 0;
    const char* most_receiver_ = "";
    int most_type_ = 0;
    std::int64_t turns_ = 0;
    SlowTurn worst_own_, worst_wall_;
};

/// The program's application: delivers every event under the eyes of a watchdog, which logs the slow turns.
class Application final : public QApplication {
    Q_OBJECT
public:
    Application(int& argc, char** argv);
    static Application* instance() { return qobject_cast<Application*>(QCoreApplication::instance()); }
    Watchdog* watchdog() const { return watchdog_; }
    bool notify(QObject* receiver, QEvent* event) override;

private:
    Watchdog* watchdog_ = nullptr;
};

}  // namespace lacuna::ui
