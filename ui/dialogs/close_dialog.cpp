#include "ui/dialogs/close_dialog.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

namespace lacuna::ui {

CloseDialog::CloseDialog(TaskList* tasks, QWidget* parent)
    : QDialog(parent),
      tasks_(tasks),
      question_(new QLabel(this)),
      jobs_(new QLabel(this)),
      wait_(new QPushButton(tr("Close when they have &ended"), this)),
      stop_(new QPushButton(tr("&Stop them and close"), this)),
      stay_(new QPushButton(tr("&Keep the window open"), this)) {
    setWindowTitle(tr("Close the window"));
    setWindowModality(Qt::WindowModal);
    auto* column = new QVBoxLayout(this);
    column->addWidget(question_);
    column->addWidget(jobs_);
    column->addStretch(1);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (QPushButton* button : {wait_, stop_, stay_}) buttons->addWidget(button);
    column->addSpacing(8);
    column->addLayout(buttons);
    question_->setWordWrap(true);
    jobs_->setTextFormat(Qt::PlainText);
    jobs_->setWordWrap(true);
    jobs_->setAccessibleName(tr("Running jobs"));
    jobs_->setContentsMargins(12, 0, 0, 0);
    wait_->setDefault(true);  // what costs nobody anything
    wait_->setFocus();
    connect(wait_, &QPushButton::clicked, this, &CloseDialog::waitForJobs);
    connect(stop_, &QPushButton::clicked, this, [this] {
        accept();
        Q_EMIT closeAgreed();
    });
    connect(stay_, &QPushButton::clicked, this, &QDialog::reject);
    ended_.setSingleShot(true);
    ended_.setInterval(0);  // what a job ends with is said first, and may be the beginning of another
    connect(&ended_, &QTimer::timeout, this, [this] {
        if (!isVisible() || !tasks_->workAtStake().empty()) return;
        accept();
        Q_EMIT closeAgreed();
    });
    connect(tasks_, &TaskList::changed, this, &CloseDialog::showJobs);
    // Why it failed stands in the window: that would close over it.
    connect(tasks_, &TaskList::failed, this, &QDialog::reject);
    showJobs();
}

void CloseDialog::waitForJobs() {
    waiting_ = true;
    stay_->setFocus();
    for (const TaskList::Row& row : tasks_->workAtStake())
        if (row.paused()) tasks_->goOn(row.id);
    showJobs();
}

void CloseDialog::showJobs() {
    const std::vector<TaskList::Row> rows = tasks_->workAtStake();
    if (rows.empty()) {
        if (isVisible()) ended_.start();
        return;
    }
    const bool paused = std::any_of(rows.begin(), rows.end(), [](const TaskList::Row& row) { return row.paused(); });
    wait_->setEnabled(!waiting_ || paused);
    question_->setText(
        waiting_ ? tr("The window closes as soon as these jobs have ended:")
        : paused ? tr("These jobs have not ended; paused ones go on if the window waits for them. What they have not "
                      "finished is lost if they are stopped now.")
                 : tr("These jobs still run. What they have not finished is lost if they are stopped now."));
    QStringList lines;
    for (const TaskList::Row& row : rows)
        lines << (row.share < 0 ? task_text(row)
                                : tr("%1 · %2 % done").arg(task_text(row)).arg(int(100 * std::min(row.share, 1.0))));
    const QString words = lines.join(QLatin1Char('\n'));
    if (words != jobs_->text()) jobs_->setText(words);
}

CloseGuard::CloseGuard(TaskList* tasks, QWidget* window) : QObject(window), tasks_(tasks), window_(window) {}

bool CloseGuard::mayClose() {
    if (agreed_ || tasks_->workAtStake().empty()) return true;
    if (dialog_) {
        dialog_->raise();
        dialog_->activateWindow();
        return false;
    }
    dialog_ = new CloseDialog(tasks_, window_);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &CloseDialog::closeAgreed, this, [this] {
        agreed_ = true;
        window_->close();
        agreed_ = false;
    });
    dialog_->open();
    return false;
}

}  // namespace lacuna::ui
