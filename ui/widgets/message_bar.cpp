#include "ui/widgets/message_bar.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>

#include "ui/core_sentences.h"
#include "ui/theme.h"

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
    hide();
    for (QPushButton* button : answers_) button->deleteLater();
    answers_.clear();
    question_.clear();
}

void MessageBar::ask(const QString& sentence, const Answers& answers) {
    dismiss();
    showText(sentence, false);
    question_ = sentence;
    for (const auto& [text, act] : answers) {
        auto* button = new QPushButton(text, this);
        connect(button, &QPushButton::clicked, this, [this, act = act] {
            dismiss();
            act();
        });
        row_->insertWidget(row_->count() - 1, button);  // before the one that dismisses
        answers_ << button;
    }
}

void MessageBar::showText(const QString& sentence, bool error) {
    error_ = error;
    setToolTip({});  // of the message before
    label_->setText(question_.isEmpty() ? sentence : sentence + QLatin1Char('\n') + question_);
    show();
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
