#pragma once

#include <QComboBox>
#include <QDialog>
#include <QPlainTextEdit>

#include "ui/log_store.h"

namespace lacuna::ui {

/// The program's log as it goes on, from a chosen level up; can be copied and cleared.
class LogWindow final : public QDialog {
    Q_OBJECT
public:
    explicit LogWindow(QWidget* parent = nullptr);
    QComboBox* levelBox() const { return level_; }
    QString text() const { return lines_->toPlainText(); }

public Q_SLOTS:
    void copy() const;

private:
    void fill();
    void append(const LogLine& line);
    LogLevel least() const;

    QComboBox* level_;
    QPlainTextEdit* lines_;
};

}  // namespace lacuna::ui
