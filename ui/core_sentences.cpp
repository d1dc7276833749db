#include "ui/core_sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <vector>

namespace lacuna::ui {

namespace {

constexpr const char* k_context = "CoreSentence";

constexpr const char* k_sentences[] = {
    // Opening.
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot open '%1': there is no such file or folder."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot open %1: there is no such file or folder."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it is empty (0 bytes); copy it again."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: of packed files only .nii.gz is read; unpack it first."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: the folder holds no DICOM images and no TIFF slices."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: this DICOM file holds no image."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot read %1: it is no DICOMDIR, or a damaged one; open its folder."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot read %1: it is neither DICOM nor named .mhd .mha .nrrd .nhdr .nii .nii.gz .tif .tiff .raw "
        ".img .vol .dat or .vgi; give --raw if it is a raw volume."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "Cannot read %1: the DICOM header of %2 is cut short or damaged; copy or export the files again."),
    QT_TRANSLATE_NOOP("CoreSentence", "The folder %1 is empty; name one that holds DICOM images."),
    QT_TRANSLATE_NOOP("CoreSentence", "The folder %1 holds no DICOM images; name one that does."),
    QT_TRANSLATE_NOOP("CoreSentence", "The folder %1 holds no DICOM images but %2; name the file."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "No DICOM image could be opened under %1: permission denied for %2; ask for the right to read it."),
    QT_TRANSLATE_NOOP("CoreSentence", "The volume takes %1 MB of memory, but only %2 MB may be used."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot allocate %1 bytes for the voxels; close other programs or use a smaller volume."),
    // Writing.
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot write %1: the folder %2 does not exist; create it first."),
    QT_TRANSLATE_NOOP("CoreSentence", "Cannot write %1: it is no folder; name another one."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "Cannot write %1: the folder is not empty; name a new one, so that nothing is mixed."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is no DICOM image to anonymise; name a DICOM folder or file."),
    // Sessions.
    QT_TRANSLATE_NOOP("CoreSentence", "%1 is no session of Lacuna."),
    // DICOM servers.
    QT_TRANSLATE_NOOP("CoreSentence",
                      "%1 refuses the connection; check that the server runs and that the port is right."),
    QT_TRANSLATE_NOOP("CoreSentence", "%1 does not answer; check address, port and firewall."),
    QT_TRANSLATE_NOOP("CoreSentence", "There is no host named %1; check the server's address."),
    QT_TRANSLATE_NOOP("CoreSentence",
                      "The server %1 refuses the association; check that its AE title is %2 and that it knows this "
                      "program as %3."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server %1 fell silent for %2 s; try again, or allow it more time."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The server %1 ended the connection; check that it is a DICOM server and takes connections of this "
        "program."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server %1 does not offer %2."),
    QT_TRANSLATE_NOOP("CoreSentence", "What answers at %1 is no DICOM server, or does not speak as one (%2)."),
    QT_TRANSLATE_NOOP(
        "CoreSentence",
        "The secure connection to %1 failed (%2); check that it speaks TLS there and that its certificate "
        "is trusted."),
    QT_TRANSLATE_NOOP("CoreSentence", "A secure connection needs the certificates to trust; name their PEM file."),
    QT_TRANSLATE_NOOP("CoreSentence", "The AE title '%1' is none: 1 to 16 characters without spaces and backslashes."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server has no address; enter its host name or IP address."),
    QT_TRANSLATE_NOOP("CoreSentence", "The server sent nothing for this; it may have been removed there."),
};

/// A sentence as an expression that finds what was filled in. All of it has to fit.
QRegularExpression expression_of(const QString& sentence) {
    QString expression = QRegularExpression::escape(sentence);
    for (int i = 1; i <= 9; ++i) {
        const QString escaped = QStringLiteral("\\%%1").arg(i);
        expression.replace(escaped, QStringLiteral("(?<a%1>.+?)").arg(i));
    }
    return QRegularExpression(QRegularExpression::anchoredPattern(expression));
}

}  // namespace

QStringList core_sentences() {
    QStringList all;
    for (const char* sentence : k_sentences) all << QString::fromLatin1(sentence);
    return all;
}

QString core_sentence(const QString& english) {
    static const std::vector<QRegularExpression> expressions = [] {
        std::vector<QRegularExpression> made;
        for (const QString& sentence : core_sentences()) made.push_back(expression_of(sentence));
        return made;
    }();
    for (std::size_t i = 0; i < expressions.size(); ++i) {
        const QRegularExpressionMatch match = expressions[i].match(english);
        if (!match.hasMatch()) continue;
        const QString known = QString::fromLatin1(k_sentences[i]);
        QString translated = QCoreApplication::translate(k_context, k_sentences[i]);
        if (translated == known) return english;
        QStringList filled;  // at once: what is filled in may hold a %1 of its own
        for (int a = 1; a <= match.lastCapturedIndex(); ++a) filled << match.captured(QStringLiteral("a%1").arg(a));
        if (filled.isEmpty()) return translated;
        if (filled.size() == 1) return translated.arg(filled[0]);
        if (filled.size() == 2) return translated.arg(filled[0], filled[1]);
        return translated.arg(filled[0], filled[1], filled[2]);
    }
    return english;
}

QString core_sentence(const std::string& english) { return core_sentence(QString::fromStdString(english)); }
QString core_sentence(const char* english) { return core_sentence(QString::fromUtf8(english)); }

}  // namespace lacuna::ui
