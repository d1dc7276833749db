#pragma once

#include <QDialog>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTimer>

#include "ui/task_list.h"

namespace lacuna::ui {

/// Asks what is to become of work that still runs when the window is to close: the window waits for it, or stops it, or
/// stays. Shows how far the jobs are while it asks. Waiting lets paused jobs go on: they would never end.
class CloseDialog final : public QDialog {
    Q_OBJECT
public:
    explicit CloseDialog(TaskList* tasks, QWidget* parent = nullptr);

    QPushButton* waitButton() const { return wait_; }
    QPushButton* stopButton() const { return stop_; }
    QString jobsText() const { return jobs_->text(); }

Q_SIGNALS:
    /// Nothing that would be lost runs any more, or it may be lost.
    void closeAgreed();

private:
    void waitForJobs();
    void showJobs();

    TaskList* tasks_;
    QLabel *question_, *jobs_;
    QPushButton *wait_, *stop_, *stay_;
    QTimer ended_;
    bool waiting_ = false;
};

/// Keeps a window from closing over running work without asking (CloseDialog).
class CloseGuard final : public QObject {
    Q_OBJECT
public:
    CloseGuard(TaskList* tasks, QWidget* window);
    /// True when nothing would be lost, or that was agreed to; else asks, and closes the window once it was.
    bool mayClose();
    /// The question that is open, or null.
    CloseDialog* dialog() const { return dialog_; }

private:
    TaskList* tasks_;
    QWidget* window_;
    QPointer<CloseDialog> dialog_;
    bool agreed_ = false;
};

}  // namespace lacuna::ui
