#pragma once

#include <QFrame>
#include <QLabel>

namespace lacuna::ui {

/// A line above the views that says what went wrong or what to know, without stopping anyone. Escape or its button
/// closes it.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);
    QString text() const { return label_->text(); }
    bool isError() const { return error_; }

public Q_SLOTS:
    void showError(const QString& sentence);
    void showNotice(const QString& sentence);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void showText(const QString& sentence, bool error);
    QLabel* label_;
    bool error_ = false;
};

}  // namespace lacuna::ui
