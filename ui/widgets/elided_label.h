#pragma once

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <algorithm>

namespace lacuna::ui {

/// One line that ends in "…" where there is no room for all of it, which its tool tip then holds.
class ElidedLabel final : public QLabel {
public:
    /// @param least  characters' worth of room it does not give up
    explicit ElidedLabel(int least, QWidget* parent = nullptr) : QLabel(parent), least_(least) {
        setTextFormat(Qt::PlainText);
    }
    QSize minimumSizeHint() const override {
        const QSize whole = QLabel::sizeHint();
        return {std::min(whole.width(), least_ * fontMetrics().averageCharWidth()), whole.height()};
    }
    QString shownText() const { return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const QString shown = shownText();
        style()->drawItemText(&painter, contentsRect(), int(alignment()), palette(), isEnabled(), shown,
                              foregroundRole());
    }
    bool event(QEvent* event) override {
        if (event->type() == QEvent::ToolTip) setToolTip(shownText() == text() ? QString() : text());
        return QLabel::event(event);
    }

private:
    int least_;
};

}  // namespace lacuna::ui
