#include "ui/action_catalog.h"

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>
#include <vector>

namespace lacuna::ui {

namespace {

void walk(const QList<QAction*>& actions, const QStringList& path, QList<CatalogEntry>& entries) {
    for (QAction* action : actions) {
        if (action->isSeparator() || !action->isVisible()) continue;
        if (QMenu* menu = action->menu()) {
            Q_EMIT menu->aboutToShow();
            walk(menu->actions(), path + QStringList{plain_text(menu->title())}, entries);
        } else {
            entries.push_back(
                {path, plain_text(action->text()), action, action->shortcut().toString(QKeySequence::NativeText)});
        }
    }
}

/// Letters without case and accents.
QString folded(const QString& text) {
    QString plain;
    for (const QChar letter : text.normalized(QString::NormalizationForm_D))
        if (letter.category() != QChar::Mark_NonSpacing) plain += letter.toCaseFolded();
    return plain;
}

}  // namespace

QString plain_text(const QString& text) {
    QString plain;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] == QLatin1Char('&') && (i + 1 == text.size() || text[++i] == QLatin1Char(' ')))
            plain += QLatin1Char('&');
        if (i < text.size()) plain += text[i];
    }
    while (plain.endsWith(QChar(0x2026)) || plain.endsWith(QLatin1Char('.'))) plain.chop(1);
    return plain;
}

QList<CatalogEntry> catalog_of(QMenuBar* bar) {
    QList<CatalogEntry> entries;
    walk(bar->actions(), {}, entries);
    return entries;
}

int fuzzy_score(const QString& pattern, const QString& text) {
    QString wanted = folded(pattern);
    wanted.remove(QLatin1Char(' '));
    const QString in = folded(text);
    const int m = int(wanted.size()), n = int(in.size());
    if (m == 0) return 0;
    if (m > n) return -1;
    // best[j]: the highest score of the letters so far with the last of them at j (dynamic programme over the letters).
    constexpr int k_letter = 1, k_row = 5, k_word = 8;
    std::vector<int> best(std::size_t(n), -1), next(std::size_t(n), -1);
    for (int i = 0; i < m; ++i) {
        int before = -1;  // the best of any earlier place that leaves a gap
        for (int j = 0; j < n; ++j) {
            if (j >= 2) before = std::max(before, best[std::size_t(j - 2)]);
            next[std::size_t(j)] = -1;
            if (in[j] != wanted[i]) continue;
            const bool starts_word = j == 0 || !in[j - 1].isLetterOrNumber();
            const int own = k_letter + (starts_word ? k_word : 0);
            int score = -1;
            if (i == 0) {
                score = own;
            } else {
                if (j >= 1 && best[std::size_t(j - 1)] >= 0) score = best[std::size_t(j - 1)] + own + k_row;
                if (before >= 0) score = std::max(score, before + own);
            }
            next[std::size_t(j)] = score;
        }
        std::swap(best, next);
    }
    return *std::max_element(best.begin(), best.end());
}

}  // namespace lacuna::ui
