#include "ui/widgets/message_bar.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>

#include "ui/core_sentences.h"
#include "ui/theme.h"
#include "ui/widgets/short_words.h"

namespace lacuna::ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), row_(new QHBoxLayout(this)), label_(new QLabel(this)) {
    row_->setContentsMargins(10, 5, 6, 5);
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::PlainText);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label_->setAccessibleName(tr("Message"));
    auto* close = new QPushButton(tr("Dismiss"), this);
    close->setAccessibleName(tr("Dismiss the message"));
    close->setShortcut(QKeySequence(Qt::Key_Escape));
    connect(close, &QPushButton::clicked, this, &MessageBar::dismiss);
    row_->addWidget(label_, 1);
    row_->addWidget(close);
    hide();
}

void MessageBar::showError(const QString& sentence) { showText(core_sentence(sentence), true); }
void MessageBar::showNotice(const QString& sentence, const QString& details) {
    showText(sentence, false);
    setToolTip(details);
}

void MessageBar::dismiss() {
    said_.clear();
    setToolTip({});
    takeBackQuestion();
}

void MessageBar::takeBackQuestion() {
    for (QPushButton* button : answers_) {
        button->hide();
        button->deleteLater();
    }
    answers_.clear();
    question_.clear();
    showWords();
}

void MessageBar::ask(const QString& sentence, const Answers& answers) {
    takeBackQuestion();
    if (said_.isEmpty()) error_ = false;
    question_ = sentence;
    showWords();
    for (const auto& [text, act] : answers) {
        auto* button = new QPushButton(text, this);
        connect(button, &QPushButton::clicked, this, [this, act = act] {
            takeBackQuestion();
            act();
        });
        row_->insertWidget(row_->count() - 1, button);  // before the one that dismisses
        answers_ << button;
    }
}

void MessageBar::showText(const QString& sentence, bool error) {
    error_ = error;
    setToolTip({});  // of the message before
    said_ = sentence;
    showWords();
}

void MessageBar::showWords() {
    QStringList words;
    for (const QString& part : {said_, question_})
        if (!part.isEmpty()) words << part;
    if (!words.isEmpty()) {
        const QString whole = words.join(QLatin1Char('\n')), shown = with_short_words(whole);
        label_->setText(shown);
        label_->setToolTip(shown == whole ? QString() : whole);
    }
    setVisible(!words.isEmpty());
    update();
}

void MessageBar::paintEvent(QPaintEvent*) {
    const ThemeColors& c = theme::colors();
    QPainter painter(this);
    painter.fillRect(rect(), c.title);
    painter.fillRect(QRect(0, 0, 4, height()), error_ ? c.error : c.warning);
    painter.fillRect(QRect(0, height() - 1, width(), 1), c.border);
}

}  // namespace lacuna::ui
