#include "ui/core_sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <vector>

#include "ui/core_sentence_list.h"

namespace lacuna::ui {

namespace {

constexpr const char* k_context = "CoreSentence";
constexpr int k_first_phrase = 8;

QString translated(const char* known) { return QCoreApplication::translate(k_context, known); }

/// A sentence as an expression that finds what was filled in. All of it has to fit.
QRegularExpression expression_of(const QString& sentence) {
    QString expression = QRegularExpression::escape(sentence);
    QStringList phrases;
    for (const char* phrase : k_core_phrases) phrases << QRegularExpression::escape(QString::fromUtf8(phrase));
    for (int i = 1; i <= 9; ++i)
        expression.replace(QStringLiteral("\\%%1").arg(i),
                           i < k_first_phrase
                               ? QStringLiteral("(?<a%1>.+?)").arg(i)
                               : QStringLiteral("(?<a%1>%2)").arg(i).arg(phrases.join(QLatin1Char('|'))));
    return QRegularExpression(QRegularExpression::anchoredPattern(expression),
                              QRegularExpression::DotMatchesEverythingOption);
}

QString with_phrase(const QString& english) {
    for (const char* phrase : k_core_phrases)
        if (english == QLatin1String(phrase)) return translated(phrase);
    return english;
}

/// `sentence` with what `match` found in the places of the English one. At once: what is filled in may hold a %1 of its
/// own.
QString filled(const QString& sentence, const QRegularExpressionMatch& match) {
    QString whole;
    for (qsizetype i = 0; i < sentence.size(); ++i) {
        const int place = sentence[i] == QLatin1Char('%') && i + 1 < sentence.size() ? sentence[i + 1].digitValue() : 0;
        if (place < 1) {
            whole += sentence[i];
            continue;
        }
        const QString found = match.captured(QStringLiteral("a%1").arg(place));
        whole += place >= k_first_phrase ? with_phrase(found) : core_sentence(found);  // the reason may be a sentence
        ++i;
    }
    return whole;
}

struct Known {
    const char* english;
    QRegularExpression expression;
};

std::vector<Known> known_sentences() {
    std::vector<Known> all;
    for (const char* sentence : k_core_sentences) all.push_back({sentence, expression_of(QString::fromUtf8(sentence))});
    for (const char* sentence : k_job_sentences) all.push_back({sentence, expression_of(QString::fromUtf8(sentence))});
    return all;
}

}  // namespace

QStringList core_sentences() {
    QStringList all;
    for (const char* sentence : k_core_sentences) all << QString::fromUtf8(sentence);
    return all;
}

QString core_sentence(const QString& english) {
    static const std::vector<Known> all = known_sentences();
    if (!english.contains(QLatin1Char(' '))) return english;
    for (const Known& known : all) {
        const QRegularExpressionMatch match = known.expression.match(english);
        if (!match.hasMatch()) continue;
        const QString other = translated(known.english);
        return other == QString::fromUtf8(known.english) ? english : filled(other, match);
    }
    return english;
}

QString core_sentence(const std::string& english) { return core_sentence(QString::fromStdString(english)); }
QString core_sentence(const char* english) { return core_sentence(QString::fromUtf8(english)); }

}  // namespace lacuna::ui
