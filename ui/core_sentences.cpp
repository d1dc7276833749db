#include "ui/core_sentences.h"

#include <QCache>
#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringMatcher>
#include <optional>
#include <span>
#include <vector>

#include "ui/core_sentence_list.h"
#include "ui/core_sentences_of_files.h"
#include "ui/core_sentences_of_pictures.h"
#include "ui/core_sentences_of_work.h"
#include "ui/number_text.h"
#include "ui/plan_words.h"

namespace lacuna::ui {

namespace {

using Words = std::span<const char* const>;

constexpr const char* k_context = "CoreSentence";
constexpr int k_first_phrase = 8;
constexpr int k_kept = 4096;

const Words k_all_sentences[] = {k_core_sentences,    k_file_sentences,   k_work_sentences,
                                 k_picture_sentences, k_reason_sentences, k_failure_sentences};
const Words k_all_phrases[] = {k_core_phrases, k_file_phrases, k_work_phrases, k_picture_phrases};

QString translated(const char* known) { return QCoreApplication::translate(k_context, known); }

/// @param phrases  what %8 and %9 may stand for; empty within a phrase, whose places keep no name
QString expression_text(const QString& words, const QString& phrases, bool named) {
    QString expression = QRegularExpression::escape(words);
    for (int i = 1; i <= 9; ++i)
        expression.replace(QStringLiteral("\\%%1").arg(i),
                           (named ? QStringLiteral("(?<a%1>%2)").arg(i) : QStringLiteral("(?:%2)"))
                               .arg(i < k_first_phrase ? QStringLiteral(".+?") : phrases));
    return expression;
}

/// A sentence or phrase, and how to know it again: all of it has to fit.
class Known {
public:
    Known(const char* english, const QString& phrases) : english_(english) {
        const QString words = QString::fromUtf8(english);
        static const QRegularExpression place(QStringLiteral("%\\d"));
        QString longest;
        for (const QString& piece : words.split(place))
            if (piece.size() > longest.size()) longest = piece;
        piece_.setPattern(longest);
        expression_.setPattern(QRegularExpression::anchoredPattern(expression_text(words, phrases, true)));
        expression_.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
    }
    const char* english() const { return english_; }
    QRegularExpressionMatch match(const QString& words) const {
        return piece_.indexIn(words) < 0 ? QRegularExpressionMatch() : expression_.match(words);
    }

private:
    const char* english_;
    QStringMatcher piece_;  ///< looked for first: most sentences are told apart by it alone
    QRegularExpression expression_;
};

struct AllKnown {
    AllKnown() {
        QStringList alternatives;
        for (const Words words : k_all_phrases)
            for (const char* phrase : words) {
                phrases.emplace_back(phrase, QString());
                alternatives << expression_text(QString::fromUtf8(phrase), {}, false);
            }
        const QString any = alternatives.join(QLatin1Char('|'));
        for (const Words words : k_all_sentences)
            for (const char* sentence : words) sentences.emplace_back(sentence, any);
        for (const char* sentence : k_job_sentences) sentences.emplace_back(sentence, any);
    }
    std::vector<Known> sentences, phrases;
};

std::optional<QString> in_own_words(const QString& english);

/// What was filled in: a reason that is a sentence or a phrase itself, the name of a known failure, a
/// plan, or a number.
QString filled_in(const QString& found) {
    if (const auto plan = plan_in_own_words(found)) return *plan;
    if (const auto own = in_own_words(found)) return *own;
    const QByteArray text = found.toUtf8();
    if (const QString limit = QCoreApplication::translate("Limits", text.constData()); limit != found) return limit;
    static const QRegularExpression plan(QStringLiteral("\\b(step|ert|homogeneity|gradient) \\d[^/]*$"));
    if (plan.match(found).hasMatch()) return with_decimal_marks(found);
    static const QRegularExpression numbers(QStringLiteral("^[\\d.,eE+\\-<\\[\\]() ]+(/255)?( ?[^\\s/\\d]{1,6})?$"));
    if (!numbers.match(found).hasMatch()) return found;
    QString number = with_decimal_marks(found);
    if (number != found) number.replace(QStringLiteral(", "), QStringLiteral("; "));  // a comma is the decimal mark now
    return number;
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
        whole += filled_in(match.captured(QStringLiteral("a%1").arg(place)));
        ++i;
    }
    return whole;
}

/// What is said behind the first colon about what stands before it; nullopt where that is not known.
std::optional<QString> about_something(const QString& english) {
    const QString colon = QStringLiteral(": ");
    const qsizetype at = english.indexOf(colon);
    if (at < 0) return std::nullopt;
    const auto rest = in_own_words(english.mid(at + colon.size()));
    if (!rest) return std::nullopt;
    const QString about = english.left(at);
    return in_own_words(about).value_or(about.contains(QLatin1Char('/')) ? about : with_decimal_marks(about)) + colon +
           *rest;
}

/// nullopt for what is not known.
std::optional<QString> in_own_words(const QString& english) {
    static const AllKnown all;
    // A limit ("count: ", "Zone rim, count: ") or a file before the sentence is not what a sentence fills in.
    static const QRegularExpression heading(QStringLiteral("^(\\S+|Zone [^:]+, \\S+): "));
    if (heading.match(english).hasMatch())
        if (auto said = about_something(english)) return said;
    for (const auto* list : {&all.sentences, &all.phrases})
        for (const Known& known : *list)
            if (const QRegularExpressionMatch match = known.match(english); match.hasMatch())
                return filled(translated(known.english()), match);
    return about_something(english);
}

}  // namespace

QStringList core_sentences() {
    QStringList all;
    for (const Words words : k_all_sentences)
        for (const char* sentence : words) all << QString::fromUtf8(sentence);
    return all;
}

QStringList core_phrases() {
    QStringList all;
    for (const Words words : k_all_phrases)
        for (const char* phrase : words) all << QString::fromUtf8(phrase);
    return all;
}

QString core_sentence(const QString& english) {
    const QString sign = translated(k_core_sentences[0]);
    if (english.isEmpty() || sign == QString::fromUtf8(k_core_sentences[0])) return english;
    static thread_local QCache<QString, QString> kept(k_kept);
    static thread_local QString kept_sign;
    if (std::exchange(kept_sign, sign) != sign) kept.clear();
    if (const QString* known = kept.object(english)) return *known;
    const QString own = in_own_words(english).value_or(english);
    kept.insert(english, new QString(own));
    return own;
}

QString core_sentence(const std::string& english) { return core_sentence(QString::fromStdString(english)); }
QString core_sentence(const char* english) { return core_sentence(QString::fromUtf8(english)); }

}  // namespace lacuna::ui
