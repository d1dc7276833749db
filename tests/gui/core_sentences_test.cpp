// The core's own words in the language of the window.
#include "ui/core_sentences.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "core/base/atomic_file.h"
#include "core/base/atomic_folder.h"
#include "core/base/error.h"
#include "core/io/dicom_catalogue.h"
#include "core/io/pacs.h"
#include "core/io/volume_reader.h"
#include "tests/gui/core_says.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/orthanc.h"
#include "ui/language.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

/// The literals of the core's sources, one a line.
QString core_text() {
    QString all;
    for (const SourceFile& source : core_sources())
        for (const Token& token : source.tokens)
            if (token.literal) all += token.text + QLatin1Char('\n');
    return all;
}

/// In how many pieces `words` can be found in `text`, each as long as can be.
int pieces_of(const QString& words, const QString& text) {
    int pieces = 0;
    for (qsizetype at = 0; at < words.size(); ++pieces) {
        qsizetype length = 1;
        while (at + length < words.size() && text.contains(QStringView(words).mid(at, length + 1))) ++length;
        at += length;
    }
    return pieces;
}

TEST(CoreSentences, StandInTheCoreWordByWord) {
    const QString core = core_text();
    ASSERT_GT(core.size(), 50000);
    // The core parts a sentence where it fills something in or chooses between words; a sentence it does not say any
    // more falls into many pieces.
    static const QRegularExpression place(QStringLiteral("%\\d|(?=;)"));
    for (const QString& sentence : core_sentences())
        for (const QString& piece : sentence.split(place, Qt::SkipEmptyParts))
            EXPECT_LE(pieces_of(piece, core), 3 + int(piece.size()) / 24) << piece.toStdString();
    EXPECT_GT(pieces_of(QStringLiteral("Cannot read the volume, as someone else has opened it meanwhile."), core), 6);
}

/// Words for a reader: three of them at least.
bool is_prose(const QString& text) {
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{2,}"));
    int words = 0;
    for (auto at = word.globalMatch(text); at.hasNext(); at.next()) ++words;
    return words >= 3 && text.contains(QLatin1Char(' '));
}

/// Files whose prose is translated elsewhere or is not of the window; the sentences of their errors count all the same.
bool speaks_elsewhere(const QString& file) {
    static const QStringList begins = {
        // The known failures: the context "Limits". The command line's tables. What is written into files.
        QStringLiteral("accuracy/limits"),       QStringLiteral("accuracy/sweep"),
        QStringLiteral("accuracy/device_costs"), QStringLiteral("compute/device_list"),
        QStringLiteral("inspect/report_"),       QStringLiteral("inspect/batch_summary"),
        QStringLiteral("inspect/inspect."),      QStringLiteral("io/mesh_writer"),
        QStringLiteral("io/dicom_sr_writer"),    QStringLiteral("io/dicom_seg_writer"),
        QStringLiteral("io/volume_writer")};
    return std::any_of(begins.begin(), begins.end(), [&](const QString& begin) { return file.startsWith(begin); });
}

/// Prose that never comes to a window: log lines, file contents, compiler options, names.
bool is_not_said(const QString& text) {
    static const QStringList begins = {QStringLiteral("closed form of the sample "),
                                       QStringLiteral("reference renderer, structure none"),
                                       QStringLiteral("Inter, DejaVu"),
                                       QStringLiteral("bone over soft tissue"),
                                       QStringLiteral("OpenCL lists no platform"),
                                       QStringLiteral("An OpenCL platform lists"),
                                       QStringLiteral("No OpenCL device can be used"),
                                       QStringLiteral(": no platform is installed"),
                                       QStringLiteral(". Pictures come from the slower"),
                                       QStringLiteral("Portable Computing Language"),
                                       QStringLiteral("-cl-std="),
                                       QStringLiteral(" -DLACUNA_"),
                                       QStringLiteral("Compiled kernels are not kept"),
                                       QStringLiteral("lacuna inspect "),
                                       QStringLiteral("marching cubes"),
                                       QStringLiteral(": PS3.15"),
                                       QStringLiteral("Basic Application Confidentiality"),
                                       QStringLiteral("frame of reference"),
                                       QStringLiteral("AE AS CS"),
                                       QStringLiteral("the DICOM reader assumes"),
                                       QStringLiteral("the digest is defined on"),
                                       QStringLiteral("the chosen plan"),
                                       QStringLiteral("WxHxD:TYPE")};
    return std::any_of(begins.begin(), begins.end(), [&](const QString& begin) { return text.startsWith(begin); });
}

TEST(CoreSentences, HoldAllThatTheCoreCanSay) {
    static const QRegularExpression known_place(QStringLiteral("%\\d")), place(QStringLiteral("\\{[^{}]*\\}|%\\.\\dg"));
    static const QRegularExpression signs_around(QStringLiteral("^[\\s:;,.'\"()]+|[\\s:;,.'\"()]+$"));
    QString known;
    for (const QString& words : core_sentences() + core_phrases())
        known += words.split(known_place).join(QLatin1Char('\n')) + QLatin1Char('\n');
    int found = 0;
    for (const SourceFile& source : core_sources()) {
        if (speaks_elsewhere(source.name)) continue;
        for (const Token& token : source.tokens) {
            if (!token.literal || !is_prose(token.text) || is_not_said(token.text)) continue;
            ++found;
            for (QString piece : token.text.split(place)) {
                piece.remove(signs_around);
                EXPECT_TRUE(piece.size() < 8 || known.contains(piece))
                    << source.name.toStdString()
                    << " says what ui/core_sentences_of_*.h do not have: " << piece.toStdString();
            }
        }
    }
    EXPECT_GT(found, 500);
}

class GermanTest : public testing::Test {
protected:
    void SetUp() override { use("de"); }
    void TearDown() override { use("en"); }
    static void use(const char* code) {
        preferences::set_language(QLatin1String(code));
        Language::instance()->apply();
    }
    /// What the window says of a call's error.
    template <class Call>
    static QString said_of(Call&& call) {
        try {
            call();
        } catch (const Error& error) {
            const QString said = core_sentence(error.what());
            EXPECT_NE(said.toStdString(), error.what()) << "it is said in English";
            return said;
        }
        ADD_FAILURE() << "nothing was thrown";
        return {};
    }
};

TEST_F(GermanTest, TheCommonErrorsAreSaidInGerman) {
    QTemporaryDir folder;
    const std::string root = folder.path().toStdString();
    EXPECT_EQ(said_of([&] { open_volume(root + "/gone.nrrd"); }),
              QStringLiteral("%1/gone.nrrd kann nicht geöffnet werden: Es gibt keine solche Datei und keinen solchen "
                             "Ordner.")
                  .arg(folder.path()));
    EXPECT_TRUE(said_of([&] { open_volume(root); }).contains(folder.path()));
    QFile empty(folder.filePath(QStringLiteral("50%1")));  // what is filled in may look like a place itself
    ASSERT_TRUE(empty.open(QIODevice::WriteOnly));
    empty.close();
    EXPECT_TRUE(said_of([&] { open_volume(root + "/50%1"); }).contains(QStringLiteral("/50%1")));
    EXPECT_TRUE(said_of([&] { scan_catalogue(root + "/gone"); }).contains(QStringLiteral("/gone")));
    PacsServer server = lacuna::test::server_at(lacuna::test::free_port());
    EXPECT_TRUE(said_of([&] { pacs_echo(server); }).startsWith(QStringLiteral("127.0.0.1 port ")));
    server.called_aet = "TWO WORDS";
    EXPECT_TRUE(said_of([&] { pacs_echo(server); }).contains(QStringLiteral("'TWO WORDS'")));
    server.host.clear();
    EXPECT_TRUE(said_of([&] { pacs_echo(server); }).contains(QStringLiteral("Adresse")));
}

TEST_F(GermanTest, EverySentenceKnownIsSaidInGermanWithAllThatWasFilledIn) {
    static const QRegularExpression place(QStringLiteral("%(\\d)"));
    for (const QString& sentence : core_sentences()) {
        QString english = sentence;
        english.replace(QStringLiteral("%8"), QStringLiteral("choose a shorter name"));
        english.replace(QStringLiteral("%9"), QStringLiteral("Permission denied"));
        QStringList given;
        for (auto at = place.globalMatch(sentence); at.hasNext();) {
            const QString digit = at.next().captured(1);
            if (digit > QLatin1String("7")) continue;
            given << QStringLiteral("X%1Y").arg(digit);
            english.replace(QLatin1Char('%') + digit, given.back());
        }
        const QString german = core_sentence(english);
        EXPECT_NE(german, english);
        for (const QString& word : given) EXPECT_TRUE(german.contains(word)) << german.toStdString();
        for (const char* left : {"Permission denied", "choose a shorter name", "%1", "%8", "%9"})
            EXPECT_FALSE(german.contains(QLatin1String(left))) << german.toStdString();
    }
}

/// A sentence with its holes filled, by what numbers and names look like or by a phrase.
QStringList filled_ways(const QString& sentence) {
    const qsizetype holes = sentence.count(k_hole);
    if (holes > 8) return {};
    QStringList ways;
    for (int way = 0; way < 1 << holes; ++way) {
        QString filled = sentence;
        for (int hole = 0; hole < holes; ++hole)
            filled.replace(filled.indexOf(k_hole), 1,
                           way >> hole & 1 ? QStringLiteral("Permission denied") : QStringLiteral("X7"));
        ways << filled;
    }
    return ways;
}

TEST_F(GermanTest, EveryErrorThrownIsSaidInGerman) {
    int checked = 0;
    for (const SourceFile& source : core_sources())
        for (const QString& sentence : error_sentences(source)) {
            QString said = sentence;
            if (!is_prose(said.remove(k_hole))) continue;  // made elsewhere and passed on
            ++checked;
            const QStringList ways = filled_ways(sentence);
            EXPECT_TRUE(
                std::any_of(ways.begin(), ways.end(), [](const QString& way) { return core_sentence(way) != way; }))
                << source.name.toStdString() << ": " << QString(sentence).replace(k_hole, QChar(0x2026)).toStdString();
        }
    EXPECT_GT(checked, 200);
}

TEST_F(GermanTest, NumbersFilledInHaveADecimalComma) {
    EXPECT_EQ(core_sentence("about 3.25 ms a frame; the budget is 2.5 ms."),
              QStringLiteral("etwa 3,25 ms je Bild; das Budget ist 2,5 ms."));
    EXPECT_EQ(core_sentence("Zone rim, count: 3 breaks 2.5, the most allowed.").toStdString(),
              "Zone rim, count: 3 verletzt die Grenze, höchstens 2,5.");
    EXPECT_EQ(
        core_sentence("defect_diameter_mm: defect 3: 1.25 [1.1, 1.4] mm breaks 0.5 mm, the most allowed."),
        QStringLiteral("defect_diameter_mm: Fehlstelle 3: 1,25 [1,1; 1,4] mm verletzt die Grenze, höchstens 0,5 mm."));
    EXPECT_EQ(
        core_sentence("octree, step 0.5: 0.25/255 from brute force over the whole view and 1.5 ms a frame, both "
                      "measured (error budget 0.5/255)."),
        QStringLiteral("Octree, Schritt 0,5: 0,25/255 Abweichung von Brute Force über die ganze Ansicht und 1,5 ms je "
                       "Bild, beides gemessen (Fehlerbudget 0,5/255)."));
    EXPECT_EQ(core_sentence("/a/v1.5/b.json: step has to be a number."),
              QStringLiteral("/a/v1.5/b.json: step muss eine Zahl sein."));
    EXPECT_TRUE(core_sentence("X is compressed in a way that cannot be read (transfer syntax JPIP, "
                              "1.2.840.10008.1.2.4.94); export it uncompressed.")
                    .contains(QStringLiteral("1.2.840.10008.1.2.4.94")));
}

TEST_F(GermanTest, ReasonsAreTranslatedWithTheSentencesTheyStandIn) {
    EXPECT_EQ(core_sentence("Cannot write /a/b.nrrd: No space left on device; nothing was written; free some space or "
                            "write elsewhere."),
              QStringLiteral("/a/b.nrrd kann nicht geschrieben werden: kein Platz auf dem Datenträger; es wurde nichts "
                             "geschrieben; bitte Platz schaffen oder anderswohin schreiben."));
    // What the system says in words not known stays English as a whole: half a sentence of each is neither.
    const QString strange = QStringLiteral("Cannot read /a/b: something else.");
    EXPECT_EQ(core_sentence(strange), strange);
    EXPECT_TRUE(core_sentence("The reference component cannot be inspected: The volume holds no voxels.")
                    .endsWith(QStringLiteral("Das Volumen enthält keine Voxel.")));
    QTemporaryDir folder;
    const std::string sidecar = folder.filePath(QStringLiteral("part.mhd")).toStdString();
    EXPECT_TRUE(said_of([&] {
                    write_file(sidecar,
                               "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\n"
                               "ElementNumberOfChannels = 3\nElementDataFile = LOCAL\n");
                    open_volume(sidecar);
                }).contains(QStringLiteral("3 Werte je Voxel")));
    write_file(folder.filePath(QStringLiteral("full.txt")).toStdString(), "x");
    EXPECT_TRUE(said_of([&] {
                    AtomicFolder::check(folder.path().toStdString(), {"report.json"});
                }).contains(QStringLiteral("report.json")));
}

TEST_F(GermanTest, WhatIsNotKnownStaysAsItIs) {
    EXPECT_EQ(core_sentence("Something else went wrong."), QStringLiteral("Something else went wrong."));
    use("en");
    const QString english = QStringLiteral("Cannot open 'x': there is no such file or folder.");
    EXPECT_EQ(core_sentence(english), english);
}

TEST_F(GermanTest, TheMessageBarSpeaksIt) {
    MessageBar bar;
    bar.showError(QStringLiteral("The folder /a/b is empty; name one that holds DICOM images."));
    EXPECT_EQ(bar.text(), QStringLiteral("Der Ordner /a/b ist leer; bitte einen mit DICOM-Bildern nennen."));
}

}  // namespace
}  // namespace lacuna::ui::test
