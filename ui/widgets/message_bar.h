#pragma once

#include <QFrame>
#include <QLabel>
#include <QList>
#include <functional>
#include <utility>

class QHBoxLayout;
class QPushButton;

namespace lacuna::ui {

/// A line above the views that says what went wrong or what to know, without stopping anyone. Escape or its button
/// closes it.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);
    QString text() const { return label_->text(); }
    bool isError() const { return error_; }
    /// What can be done about it, each a button; any of them takes the question back.
    using Answers = QList<std::pair<QString, std::function<void()>>>;
    /// Asks without stopping anyone: the question stays until it is answered, dismissed or another one is asked. What
    /// was said before, and what is to be said meanwhile, stands above it and stays when it is answered.
    void ask(const QString& sentence, const Answers& answers);
    const QList<QPushButton*>& answerButtons() const { return answers_; }

public Q_SLOTS:
    void showError(const QString& sentence);
    /// @param sentence  none: forgets what was said; a question stays @param details  more of it, as a tool tip
    void showNotice(const QString& sentence, const QString& details = {});
    /// Hides the bar; a question it asked is taken back.
    void dismiss();

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void showText(const QString& sentence, bool error);
    void takeBackQuestion();
    void showWords();
    QHBoxLayout* row_;
    QLabel* label_;
    QList<QPushButton*> answers_;
    QString said_, question_;
    bool error_ = false;
};

}  // namespace lacuna::ui
