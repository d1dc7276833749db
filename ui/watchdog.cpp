#include "ui/watchdog.h"

#include <QAbstractEventDispatcher>
#include <QEvent>
#include <QMetaEnum>
#include <QThread>
#include <ctime>

#include "core/base/log.h"

namespace lacuna::ui {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double thread_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

QString words(int type, const char* receiver) {
    const char* name = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
    return QStringLiteral("%1 to %2")
        .arg(name ? QString::fromLatin1(name) : QStringLiteral("Event %1").arg(type), QString::fromLatin1(receiver));
}

/// What the environment asks for: a limit in ms, 0 for off; without it what this build does by itself.
double limit_asked() {
#ifdef NDEBUG
    constexpr double k_by_itself = 0;
#else
    constexpr double k_by_itself = Watchdog::k_limit_ms;
#endif
    bool is_number = false;
    const double asked = qEnvironmentVariable("LACUNA_WATCHDOG").toDouble(&is_number);
    if (!is_number) return qEnvironmentVariableIsEmpty("LACUNA_WATCHDOG") ? k_by_itself : Watchdog::k_limit_ms;
    return asked == 1 ? Watchdog::k_limit_ms : asked > 0 ? asked : 0;
}

}  // namespace

Watchdog::Watchdog(QObject* parent) : QObject(parent) {
    connect(this, &Watchdog::slow, this, [](const SlowTurn& turn) {
        log(LogLevel::info, QStringLiteral("The window was busy for %1 ms (%2 ms of its own work), most of it with %3 "
                                           "(%4 ms).")
                                .arg(std::lround(turn.wall_ms))
                                .arg(std::lround(turn.cpu_ms))
                                .arg(turn.what)
                                .arg(std::lround(turn.what_ms))
                                .toStdString());
    });
}

void Watchdog::setOn(bool on) {
    on_ = on;
    measuring_ = false;
    stack_.clear();
    wall_ms_ = cpu_ms_ = most_ms_ = 0;
    if (on) watchLoop();
}

/// Which of the two signals a loop gives, and when, depends on the platform's loop; each of them parts turns.
void Watchdog::watchLoop() {
    QAbstractEventDispatcher* loop = QAbstractEventDispatcher::instance();
    if (watches_loop_ || !loop) return;
    watches_loop_ = true;
    connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, &Watchdog::turnOver);
    connect(loop, &QAbstractEventDispatcher::awake, this, &Watchdog::turnOver);
}

void Watchdog::forget() {
    turnOver();
    turns_ = 0;
    worst_own_ = worst_wall_ = {};
}

void Watchdog::enter(const QObject* receiver, const QEvent* event) {
    const auto now = Clock::now();
    if (!measuring_) {
        measuring_ = true;
        base_ = stack_.size();
        begin_ = now;
        begin_cpu_ms_ = thread_ms();
    }
    stack_.push_back({receiver->metaObject()->className(), int(event->type()), now, 0});
}

void Watchdog::leave() {
    if (stack_.empty()) return;  // switched on within this event
    const Frame frame = stack_.back();
    stack_.pop_back();
    if (!measuring_ || stack_.size() < base_) return;  // the turn ended within: the loop of a dialog ran in it
    const double took = ms_since(frame.begin), own = took - frame.inner_ms;
    if (stack_.size() > base_) stack_.back().inner_ms += took;
    if (own > most_ms_) {
        most_ms_ = own;
        most_receiver_ = frame.receiver;
        most_type_ = frame.type;
    }
    if (stack_.size() > base_) return;
    wall_ms_ += ms_since(begin_);
    cpu_ms_ += thread_ms() - begin_cpu_ms_;
    measuring_ = false;
}

void Watchdog::turnOver() {
    if (measuring_) {  // within an event: what follows is the turn of a loop of its own
        wall_ms_ += ms_since(begin_);
        cpu_ms_ += thread_ms() - begin_cpu_ms_;
        measuring_ = false;
        if (!stack_.empty() && most_ms_ == 0) {
            most_ms_ = ms_since(stack_.back().begin);
            most_receiver_ = stack_.back().receiver;
            most_type_ = stack_.back().type;
        }
    }
    if (wall_ms_ > 0) {
        ++turns_;
        const bool worse_own = cpu_ms_ > worst_own_.cpu_ms, worse_wall = wall_ms_ > worst_wall_.wall_ms;
        if (worse_own || worse_wall || wall_ms_ > limit_ms_) {
            const SlowTurn turn{wall_ms_, cpu_ms_, words(most_type_, most_receiver_), most_ms_};
            if (worse_own) worst_own_ = turn;
            if (worse_wall) worst_wall_ = turn;
            if (wall_ms_ > limit_ms_) Q_EMIT slow(turn);
        }
    }
    wall_ms_ = cpu_ms_ = most_ms_ = 0;
}

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    watchdog_ = new Watchdog(this);  // whose coming is an event itself
    if (const double limit = limit_asked(); limit > 0) {
        watchdog_->setLimit(limit);
        watchdog_->setOn(true);
    }
}

bool Application::notify(QObject* receiver, QEvent* event) {
    // Other threads deliver their events through here as well, and a closing program has no watchdog any more.
    // The watchdog is asked only on its own thread: whether it is on may change there at the same moment.
    if (QThread::currentThread() != thread() || !watchdog_ || !watchdog_->isOn())
        return QApplication::notify(receiver, event);
    watchdog_->enter(receiver, event);
    const bool taken = QApplication::notify(receiver, event);
    watchdog_->leave();
    return taken;
}

}  // namespace lacuna::ui
