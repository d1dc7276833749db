// The core's own words in the language of the window.
#include "ui/core_sentences.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "core/base/atomic_file.h"
#include "core/base/atomic_folder.h"
#include "core/base/error.h"
#include "core/io/dicom_catalogue.h"
#include "core/io/pacs.h"
#include "core/io/volume_reader.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/orthanc.h"
#include "ui/language.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

/// The core's sources, every literal that is written in several pieces put together.
QString core_text() {
    QString all;
    for (QDirIterator at(QStringLiteral(LACUNA_SOURCE_DIR "/core"), {QStringLiteral("*.cpp"), QStringLiteral("*.h")},
                         QDir::Files, QDirIterator::Subdirectories);
         at.hasNext();) {
        QFile file(at.next());
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        all += QString::fromUtf8(file.readAll());
    }
    all.replace(QStringLiteral("\\\""), QString(QChar(1)));  // quotes within a literal
    all.remove(QRegularExpression(QStringLiteral("\"\\s*\"")));
    return all.replace(QChar(1), QLatin1Char('"'));
}

TEST(CoreSentences, StandInTheCoreWordByWord) {
    const QString core = core_text();
    ASSERT_GT(core.size(), 100000);
    // What is filled in parts a sentence, and what the core puts in before a semicolon in other cases.
    static const QRegularExpression place(QStringLiteral("%\\d|(?=;)"));
    for (const QString& sentence : core_sentences())
        for (const QString& piece : sentence.split(place, Qt::SkipEmptyParts))
            EXPECT_TRUE(piece.size() < 8 || core.contains(piece)) << piece.toStdString();
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
                    AtomicFolder::check(folder.path().toStdString(), "report.json");
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
