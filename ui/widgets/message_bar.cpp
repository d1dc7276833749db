#include "ui/widgets/message_bar.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "ui/theme.h"

namespace lacuna::ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), label_(new QLabel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 6, 5);
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::PlainText);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label_->setAccessibleName(tr("Message"));
    auto* close = new QPushButton(tr("Dismiss"), this);
    close->setAccessibleName(tr("Dismiss the message"));
    close->setShortcut(QKeySequence(Qt::Key_Escape));
    connect(close, &QPushButton::clicked, this, &QWidget::hide);
    row->addWidget(label_, 1);
    row->addWidget(close);
    hide();
}

void MessageBar::showError(const QString& sentence) { showText(sentence, theme::k_error); }
void MessageBar::showNotice(const QString& sentence) { showText(sentence, theme::k_warning); }

void MessageBar::showText(const QString& sentence, const QColor& color) {
    setStyleSheet(
        QStringLiteral("lacuna--ui--MessageBar { background: #2d3036; border: none; border-left: 4px solid %1; }")
            .arg(color.name()));
    label_->setText(sentence);
    show();
}

}  // namespace lacuna::ui
