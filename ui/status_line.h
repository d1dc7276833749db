#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>

#include "ui/frame_scheduler.h"

namespace lacuna::ui {

/// The line at the foot: what is under the mouse, progress with its cancel button, and what drew the last frame.
class StatusLine final : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusLine(QWidget* parent = nullptr);
    void showReadout(const QString& text);
    void showFrame(const FrameFacts& facts, std::size_t volume_bytes);
    void showDevice(const QString& name);
    /// Shows a job's name with a bar; share below 0: unknown.
    void showProgress(const QString& what, double share);
    void hideProgress();
    QPushButton* cancelButton() const { return cancel_; }
    QString readout() const { return readout_->text(); }
    QString frameText() const { return frame_->text(); }

Q_SIGNALS:
    void cancelRequested();

private:
    QLabel *readout_, *what_, *frame_, *device_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

}  // namespace lacuna::ui
