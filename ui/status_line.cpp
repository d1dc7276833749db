#include "ui/status_line.h"

#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "ui/core_sentences.h"
#include "ui/number_text.h"

namespace lacuna::ui {

StatusLine::StatusLine(TaskList* tasks, QWidget* parent)
    : QStatusBar(parent),
      tasks_(tasks),
      readout_(new ElidedLabel(24, this)),
      what_(new ElidedLabel(10, this)),
      frame_(new ElidedLabel(10, this)),
      device_(new ElidedLabel(6, this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      more_(new QToolButton(this)) {
    setSizeGripEnabled(false);
    setContentsMargins(8, 0, 8, 0);
    readout_->setAccessibleName(tr("Value under the cursor"));
    frame_->setAccessibleName(tr("Last frame"));
    device_->setAccessibleName(tr("Device"));
    device_->setMaximumWidth(260);
    bar_->setAccessibleName(tr("Progress"));
    bar_->setFixedWidth(160);
    bar_->setMaximumHeight(16);
    cancel_->setAccessibleName(tr("Cancel the running job"));
    cancel_->setToolTip(tr("Stops what is running (Ctrl+.)"));
    cancel_->setShortcut(QKeySequence(QStringLiteral("Ctrl+.")));
    addWidget(readout_, 1);
    addWidget(what_);
    addWidget(bar_);
    addWidget(cancel_);
    addWidget(more_);
    more_->setToolTip(tr("All running jobs: choose one to cancel it"));
    more_->setAccessibleName(tr("All running jobs"));
    connect(more_, &QToolButton::clicked, this, &StatusLine::listTasks);
    addPermanentWidget(frame_);
    addPermanentWidget(device_);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        if (!tasks_->rows().empty()) tasks_->cancel(tasks_->rows().front().id);
    });
    connect(tasks_, &TaskList::changed, this, &StatusLine::showTasks);
    showTasks();
}

void StatusLine::showReadout(const QString& text) { readout_->setText(text); }

void StatusLine::showDevice(const QString& name) { device_->setText(core_sentence(name)); }

void StatusLine::showFrame(const FrameFacts& facts, std::size_t volume_bytes) {
    const double mib = double(facts.bytes_held + volume_bytes) / (1024.0 * 1024.0);
    frame_->setText(tr("%1 · %2 ms%3 · %4 MiB")
                        .arg(facts.plan)
                        .arg(number_text(facts.ms, 'f', facts.ms < 9.95 ? 1 : 0))
                        .arg(facts.coarse ? tr(" (coarse)") : QString())
                        .arg(number_text(mib, 'f', mib < 9.95 ? 1 : 0)));
    showDevice(facts.device);
}

void StatusLine::showTasks() {
    const std::vector<TaskList::Row>& rows = tasks_->rows();
    for (QWidget* widget : {static_cast<QWidget*>(what_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_)})
        widget->setVisible(!rows.empty());
    more_->setVisible(rows.size() > 1);
    if (rows.empty()) return;
    what_->setText(task_text(rows.front()));
    const double share = rows.front().share;
    bar_->setRange(0, share < 0 ? 0 : 1000);
    if (share >= 0) bar_->setValue(int(1000 * std::clamp(share, 0.0, 1.0)));
    more_->setText(tr("+%1").arg(rows.size() - 1));
}

void StatusLine::listTasks() {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const TaskList::Row& row : tasks_->rows())
        menu->addAction(tr("Cancel: %1").arg(task_text(row)), tasks_, [this, id = row.id] { tasks_->cancel(id); });
    menu->popup(more_->mapToGlobal(QPoint(0, -menu->sizeHint().height())));
}

}  // namespace lacuna::ui
