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

public Q_SLOTS:
    void showError(const QString& sentence);
    void showNotice(const QString& sentence);

private:
    void showText(const QString& sentence, const QColor& color);
    QLabel* label_;
};

}  // namespace lacuna::ui
