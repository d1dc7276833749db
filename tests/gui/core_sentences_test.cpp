// The core's own words in the language of the window.
#include "ui/core_sentences.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

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
    for (QDirIterator at(QStringLiteral(LACUNA_SOURCE_DIR "/core"), {QStringLiteral("*.cpp")}, QDir::Files,
                         QDirIterator::Subdirectories);
         at.hasNext();) {
        QFile file(at.next());
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        all += QString::fromUtf8(file.readAll());
    }
    return all.remove(QRegularExpression(QStringLiteral("\"\\s*\"")));
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
