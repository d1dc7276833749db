#include "ui/task_list.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lacuna::ui {

std::optional<double> TaskList::Row::secondsLeft() const {
    const double seconds = double(since.elapsed() - paused_ms) * 1e-3;
    if (paused() || !(share >= 0.02) || seconds < 1) return std::nullopt;
    return seconds * (1 - share) / share;
}

TaskList::Id TaskList::begin(const QString& name, std::function<void()> cancel, AtStake at_stake) {
    Row row;
    row.id = ++last_;
    row.name = name;
    row.at_stake = at_stake;
    row.since.start();
    row.cancel = std::move(cancel);
    rows_.push_back(std::move(row));
    Q_EMIT changed();
    return last_;
}

std::vector<TaskList::Row> TaskList::workAtStake() const {
    std::vector<Row> work;
    std::copy_if(rows_.begin(), rows_.end(), std::back_inserter(work),
                 [](const Row& row) { return row.at_stake == AtStake::work; });
    return work;
}

TaskList::Row* TaskList::find(Id id) {
    const auto at = std::find_if(rows_.begin(), rows_.end(), [id](const Row& row) { return row.id == id; });
    return at == rows_.end() ? nullptr : &*at;
}

void TaskList::progress(Id id, double share) {
    Row* row = find(id);
    if (!row) return;
    row->share = share;
    Q_EMIT changed();
}

void TaskList::end(Id id) {
    if (std::erase_if(rows_, [id](const Row& row) { return row.id == id; }) > 0) Q_EMIT changed();
}

void TaskList::pause(Id id, std::function<void()> go_on) {
    Row* row = find(id);
    if (!row || row->paused() == (go_on != nullptr)) return;
    if (go_on)
        row->paused_at_ms = row->since.elapsed();
    else
        row->paused_ms += row->since.elapsed() - row->paused_at_ms;
    row->go_on = std::move(go_on);
    Q_EMIT changed();
}

void TaskList::goOn(Id id) {
    const Row* row = find(id);
    if (!row || !row->paused()) return;
    const std::function<void()> go_on = row->go_on;  // the row's goes while it is called
    go_on();
}

void TaskList::cancel(Id id) {
    const Row* row = find(id);
    if (!row || !row->cancel) return;
    const std::function<void()> stop = row->cancel;  // the row goes while it is called
    stop();
}

void TaskList::cancelAll() {
    const std::vector<Row> rows = rows_;
    for (const Row& row : rows) cancel(row.id);
}

QString task_text(const TaskList::Row& row) {
    if (row.paused()) return TaskList::tr("%1 · paused").arg(row.name);
    const std::optional<double> left = row.secondsLeft();
    return left ? QStringLiteral("%1 · %2").arg(row.name, time_left_text(*left)) : row.name;
}

QString time_left_text(double seconds) {
    if (seconds < 10) return TaskList::tr("a few seconds left");
    if (seconds < 55) return TaskList::tr("about %1 s left").arg(5 * int(std::lround(seconds / 5)));
    const int minutes = std::max(1, int(std::lround(seconds / 60)));
    return TaskList::tr("about %n min left", nullptr, minutes);
}

}  // namespace lacuna::ui
