#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>

#include "ui/frame_scheduler.h"
#include "ui/task_list.h"
#include "ui/widgets/elided_label.h"

class QToolButton;

namespace lacuna::ui {

/// The line at the foot: what is under the mouse, the oldest running job with its progress and cancel button (and the
/// others behind a button), and what drew the last frame.
class StatusLine final : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(TaskList* tasks, QWidget* parent = nullptr);
    void showReadout(const QString& text);
    void showFrame(const FrameFacts& facts, std::size_t volume_bytes);
    void showDevice(const QString& name);
    QPushButton* cancelButton() const { return cancel_; }
    QString readout() const { return readout_->text(); }
    QString frameText() const { return frame_->text(); }
    ElidedLabel* frameLabel() const { return frame_; }
    ElidedLabel* readoutLabel() const { return readout_; }

private:
    void showTasks();
    void listTasks();

    TaskList* tasks_;
    ElidedLabel *readout_, *what_, *frame_, *device_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QToolButton* more_;
};

}  // namespace lacuna::ui
