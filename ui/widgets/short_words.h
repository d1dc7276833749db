#pragma once

#include <QRegularExpression>
#include <QString>

namespace lacuna::ui {

/// The text with the middle of very long words left out, such as file names of 200 characters: a label cannot break
/// them over lines, and would make its window wider than the screen.
inline QString with_short_words(const QString& text) {
    constexpr int k_longest = 60;
    static const QRegularExpression unbroken(QStringLiteral("[^\\s/\\\\]{%1,}").arg(k_longest + 1));
    QString made;
    qsizetype from = 0;
    for (auto found = unbroken.globalMatch(text); found.hasNext();) {
        const QRegularExpressionMatch word = found.next();
        made += text.mid(from, word.capturedStart() - from);
        made += word.captured().left(k_longest / 2) + QChar(0x2026) + word.captured().right(k_longest / 2 - 1);
        from = word.capturedEnd();
    }
    return made + text.mid(from);
}

}  // namespace lacuna::ui
