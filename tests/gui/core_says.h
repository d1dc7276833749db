#pragma once

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QStringList>
#include <vector>

// What the core's sources can say, read from the sources themselves.
namespace lacuna::ui::test {

inline const QChar k_hole(1);  ///< where the core fills something in

struct Token {
    bool literal = false;
    QString text;
};

/// C++ in words: literals without quotes (those side by side as one), names, signs; no comments.
inline std::vector<Token> tokens_of(const QString& source) {
    static const QRegularExpression word(
        QStringLiteral(
            R"re(//[^\n]*|/\*.*?\*/|R"(?:\w*)\(.*?\)\w*"|"(?<text>(?:[^"\\\n]|\\.)*)"|'(?:[^'\\\n]|\\.)+'|\s+|[A-Za-z_]\w*|\d[\w.']*|::|->|.)re"),
        QRegularExpression::DotMatchesEverythingOption);
    std::vector<Token> all;
    for (auto at = word.globalMatch(source); at.hasNext();) {
        const QRegularExpressionMatch match = at.next();
        const QString whole = match.captured();
        if (whole.startsWith(QLatin1String("//")) || whole.startsWith(QLatin1String("/*")) || whole[0].isSpace())
            continue;
        if (!whole.startsWith(QLatin1Char('"'))) {
            all.push_back({false, whole});
            continue;
        }
        QString text = match.captured(QStringLiteral("text"));
        text.replace(QStringLiteral("\\\""), QStringLiteral("\"")).replace(QStringLiteral("\\n"), QStringLiteral("\n"));
        if (!all.empty() && all.back().literal)
            all.back().text += text;
        else
            all.push_back({true, text});
    }
    return all;
}

/// What an expression of literals, `+`, `?:` and fmt::format can come to, with k_hole for all else.
class Expression {
public:
    using Range = std::pair<std::size_t, std::size_t>;  ///< from, behind the last

    explicit Expression(const std::vector<Token>& tokens) : tokens_(tokens) {}

    QStringList values(Range range) const {
        while (is(range.first, "(") && behind(range.first) == range.second) ++range.first, --range.second;
        if (const auto question = find(range, "?"); question < range.second) {
            const auto colon = find({question + 1, range.second}, ":");
            return values({question + 1, colon}) + values({colon + 1, range.second});
        }
        QStringList all{QString()};
        for (const Range& summand : split(range, "+")) {
            QStringList longer;
            for (const QString& end : summand_values(summand))
                for (const QString& begin : all) longer << begin + end;
            all = longer;
        }
        return all;
    }

    /// The arguments of a call whose opening bracket is at `at`.
    std::vector<Range> arguments(std::size_t at) const { return split({at + 1, behind(at) - 1}, ","); }

    bool is(std::size_t at, const char* sign) const {
        return at < tokens_.size() && !tokens_[at].literal && tokens_[at].text == QLatin1String(sign);
    }

private:
    QStringList summand_values(const Range& range) const {
        if (range.second == range.first + 1 && tokens_[range.first].literal) return {tokens_[range.first].text};
        if (is(range.first, "(") && behind(range.first) == range.second) return values(range);
        const bool of_std = is(range.first, "std") && is(range.first + 2, "string");
        const bool formatted = is(range.first, "fmt") && is(range.first + 2, "format");
        if ((of_std || formatted) && is(range.first + 3, "(") && behind(range.first + 3) == range.second) {
            QStringList made = values(arguments(range.first + 3).front());
            static const QRegularExpression place(QStringLiteral("\\{[^{}]*\\}"));
            if (formatted) made.replaceInStrings(place, QString(k_hole));
            return made;
        }
        return {QString(k_hole)};
    }

    static bool opens(const QString& sign) { return sign.size() == 1 && QStringLiteral("([{").contains(sign); }
    static bool closes(const QString& sign) { return sign.size() == 1 && QStringLiteral(")]}").contains(sign); }

    /// Behind the bracket that closes the one at `at`.
    std::size_t behind(std::size_t at) const {
        int depth = 0;
        for (; at < tokens_.size(); ++at) {
            if (tokens_[at].literal) continue;
            depth += opens(tokens_[at].text) - closes(tokens_[at].text);
            if (depth == 0) return at + 1;
        }
        return at;
    }

    /// The first `sign` outside of all brackets, or the end.
    std::size_t find(Range range, const char* sign) const {
        for (std::size_t at = range.first; at < range.second; ++at) {
            if (is(at, sign)) return at;
            if (!tokens_[at].literal && opens(tokens_[at].text)) at = behind(at) - 1;
        }
        return range.second;
    }

    std::vector<Range> split(Range range, const char* sign) const {
        std::vector<Range> parts;
        for (std::size_t from = range.first; from < range.second;) {
            const std::size_t to = find({from, range.second}, sign);
            parts.emplace_back(from, to);
            from = to + 1;
        }
        return parts;
    }

    const std::vector<Token>& tokens_;
};

struct SourceFile {
    QString name;  ///< within core/
    std::vector<Token> tokens;
};

inline std::vector<SourceFile> core_sources() {
    std::vector<SourceFile> all;
    const QString root = QStringLiteral(LACUNA_SOURCE_DIR "/core/");
    for (QDirIterator at(root, {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                         QDirIterator::Subdirectories);
         at.hasNext();) {
        QFile file(at.next());
        if (file.open(QIODevice::ReadOnly))
            all.push_back({file.fileName().mid(root.size()), tokens_of(QString::fromUtf8(file.readAll()))});
    }
    return all;
}

/// Every sentence that an Error is made with where it is thrown.
inline QStringList error_sentences(const SourceFile& source) {
    const Expression expression(source.tokens);
    QStringList all;
    for (std::size_t i = 0; i + 1 < source.tokens.size(); ++i) {
        if (!expression.is(i, "Error") || !expression.is(i + 1, "(")) continue;
        const auto arguments = expression.arguments(i + 1);
        if (arguments.size() >= 2) all << expression.values(arguments[1]);
    }
    return all;
}

}  // namespace lacuna::ui::test
