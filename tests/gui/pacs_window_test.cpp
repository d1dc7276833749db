// DICOM servers in the window, with a real one on the loopback.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/io/dicom_writer.h"
#include "core/io/volume_reader.h"
#include "core/volume/samples.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/orthanc.h"
#include "ui/features/pacs_feature.h"
#include "ui/pacs_server_dialog.h"

namespace lacuna::ui::test {
namespace {

using lacuna::test::free_port;
using lacuna::test::Orthanc;

TEST(PacsServers, AllThatIsConfiguredIsKept) {
    PacsServer server{"Ward", "10.0.0.7", 11112, "ARCHIVE", "HERE", 45, {true, "ca.pem", "own.pem", "own.key"}, {}};
    server.receiver = {true, "192.168.3.4", 4242};
    const auto before = kept_pacs_servers();
    keep_pacs_servers({server, PacsServer{}});
    const auto kept = kept_pacs_servers();
    keep_pacs_servers(before);
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0], server);
    EXPECT_FALSE(kept[1].receiver.on) << "C-MOVE only where it is asked for";
    EXPECT_EQ(kept[1].receiver.address, "127.0.0.1");
    PacsServerDialog dialog(server);
    EXPECT_EQ(dialog.server(), server);
    PacsServerDialog fresh(PacsServer{});
    EXPECT_FALSE(fresh.server().receiver.on);
}

class PacsWindowTest : public WindowTest {
protected:
    /// One task of the dialog, to its end.
    template <class Start>
    void finish(PacsDialog& dialog, Start&& start) {
        QSignalSpy finished(&dialog, &PacsDialog::finished);
        start();
        ASSERT_TRUE(finished.count() > 0 || finished.wait(k_patience_ms));
    }
};

TEST_F(PacsWindowTest, WhatOneServerStillHasToAnswerIsNotShownForAnother) {
    const lacuna::test::Listener silent;  // takes the connection and says nothing
    window->findChild<PacsFeature*>()->showDialog();
    auto* dialog = window->findChild<PacsDialog*>();
    ASSERT_NE(dialog, nullptr);
    PacsServer first = lacuna::test::server_at(silent.port(), "ONE"), second = first;
    second.called_aet = "TWO";
    dialog->setServers({first, second});
    dialog->search();
    ASSERT_EQ(window->bench()->tasks()->rows().size(), 1u);
    QComboBox* choice = nullptr;
    for (QComboBox* box : dialog->findChildren<QComboBox*>())
        if (box->count() == 2) choice = box;
    ASSERT_NE(choice, nullptr);
    choice->setCurrentIndex(1);
    EXPECT_TRUE(window->bench()->tasks()->rows().empty());
    dialog->search();
    ASSERT_EQ(window->bench()->tasks()->rows().size(), 1u);
    dialog->setServers({second});
    EXPECT_TRUE(window->bench()->tasks()->rows().empty());
}

TEST_F(PacsWindowTest, ASecondSendingDoesNotEndTheFirstWithoutAWord) {
    const lacuna::test::Listener silent;
    QTemporaryDir folder;
    const std::filesystem::path root = folder.path().toStdString();
    SampleOptions options;
    options.dims = {8, 8, 8};
    write_dicom_series(make_sample("spheres", options).volume, root / "in");
    window->findChild<PacsFeature*>()->showDialog();
    auto* dialog = window->findChild<PacsDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->setServers({lacuna::test::server_at(silent.port(), "ONE")});
    dialog->send({folder.filePath(QStringLiteral("in/slice00001.dcm"))});
    ASSERT_EQ(window->bench()->tasks()->rows().size(), 1u);
    const TaskList::Id first = window->bench()->tasks()->rows()[0].id;
    dialog->send({folder.filePath(QStringLiteral("in/slice00002.dcm"))});
    ASSERT_EQ(window->bench()->tasks()->rows().size(), 1u);
    EXPECT_EQ(window->bench()->tasks()->rows()[0].id, first);
    const auto sender = [&]() -> QPushButton* {
        for (QPushButton* button : dialog->findChildren<QPushButton*>())
            if (button->text().contains(QStringLiteral("iles…"))) return button;
        return nullptr;
    }();
    ASSERT_NE(sender, nullptr);
    EXPECT_FALSE(sender->isEnabled());
    window->bench()->tasks()->cancelAll();
    EXPECT_TRUE(sender->isEnabled());
}

TEST_F(PacsWindowTest, TheSeriesOfTwoStudiesOpenedInARowAllCome) {
    if (!lacuna::test::orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    QTemporaryDir folder;
    const std::filesystem::path root = folder.path().toStdString();
    Orthanc orthanc(root, "");
    const PacsServer server = lacuna::test::server_at(orthanc.port(), "ORTHANC");
    ASSERT_TRUE(orthanc.wait(server));
    SampleOptions options;
    options.dims = {8, 8, 8};
    for (const char* name : {"a", "b"}) {
        write_dicom_series(make_sample("spheres", options).volume, root / name);
        send_to_pacs(server, {root / name / "slice00001.dcm", root / name / "slice00002.dcm"});
    }
    window->findChild<PacsFeature*>()->showDialog();
    auto* dialog = window->findChild<PacsDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->setServers({server});
    finish(*dialog, [&] { dialog->search(); });
    ASSERT_EQ(dialog->results()->topLevelItemCount(), 2);
    for (int i = 0; i < 2; ++i) dialog->results()->topLevelItem(i)->setExpanded(true);
    for (int i = 0; i < 2; ++i)
        EXPECT_TRUE(QTest::qWaitFor([&] { return dialog->results()->topLevelItem(i)->childCount() == 1; }, 10000)) << i;
}

TEST_F(PacsWindowTest, FindsRetrievesBothWaysAndSends) {
    if (!lacuna::test::orthanc_is_there()) GTEST_SKIP() << "skipped: Orthanc is not installed";
    QTemporaryDir folder;
    const std::filesystem::path root = folder.path().toStdString();
    const int port = free_port();
    Orthanc orthanc(root, ",\"DicomModalities\":{\"l\":{\"AET\":\"LACUNA\",\"Host\":\"127.0.0.1\",\"Port\":" +
                              std::to_string(port) + "}}");
    PacsServer server = lacuna::test::server_at(orthanc.port(), "ORTHANC");
    server.name = "Orthanc";
    ASSERT_TRUE(orthanc.wait(server));
    SampleOptions options;
    options.dims = {40, 36, 12};
    Volume volume = make_sample("spheres", options).volume;
    volume.name = "spheres";
    write_dicom_series(volume, root / "in");
    QStringList files;
    for (const QFileInfo& file : QDir(folder.filePath(QStringLiteral("in"))).entryInfoList(QDir::Files))
        files << file.filePath();

    window->findChild<PacsFeature*>()->showDialog();
    auto* dialog = window->findChild<PacsDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->setServers({server});
    finish(*dialog, [&] { dialog->test(); });
    EXPECT_TRUE(dialog->statusText()->text().contains(QStringLiteral("is there")));
    finish(*dialog, [&] { dialog->send(files); });
    EXPECT_TRUE(dialog->statusText()->text().contains(QStringLiteral("12")))
        << dialog->statusText()->text().toStdString();
    finish(*dialog, [&] { dialog->search(); });
    ASSERT_EQ(dialog->results()->topLevelItemCount(), 1);
    QTreeWidgetItem* study = dialog->results()->topLevelItem(0);
    finish(*dialog, [&] { study->setExpanded(true); });
    ASSERT_EQ(study->childCount(), 1);
    dialog->results()->setCurrentItem(study->child(0));

    for (const char* way : {"get", "move"}) {
        const QString target = folder.filePath(QLatin1String(way));
        QSignalSpy opened(window->loader(), &LoadController::finished);
        finish(*dialog, [&] { dialog->retrieve(target); });
        EXPECT_EQ(dialog->statusText()->text(), QStringLiteral("12 files retrieved."));
        ASSERT_TRUE(opened.count() > 0 || opened.wait(k_patience_ms));
        ASSERT_TRUE(window->documents()->hasDocument());
        EXPECT_EQ(QString::fromStdString(document().input), target);
        EXPECT_EQ(document().volume.geometry().size, glm::ivec3(40, 36, 12));
        server.receiver = {true, "127.0.0.1", port};
        dialog->setServers({server});
        finish(*dialog, [&] { dialog->search(); });
        dialog->results()->setCurrentItem(dialog->results()->topLevelItem(0));
    }
    // A port that somebody else has: one sentence, and the window goes on.
    const lacuna::test::Listener taken;
    server.receiver.port = taken.port();
    dialog->setServers({server});
    finish(*dialog, [&] { dialog->search(); });
    dialog->results()->setCurrentItem(dialog->results()->topLevelItem(0));
    finish(*dialog, [&] { dialog->retrieve(folder.filePath(QStringLiteral("none"))); });
    EXPECT_TRUE(dialog->statusText()->text().contains(QStringLiteral("Cannot receive")));
    EXPECT_FALSE(QDir(folder.filePath(QStringLiteral("none"))).exists());
}

}  // namespace
}  // namespace lacuna::ui::test
