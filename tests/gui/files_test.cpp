// What comes in by other ways than a dialog: drops, what was open lately; and how a file wants to be shown.
#include <QDir>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QTemporaryDir>

#include "core/io/dicom_writer.h"
#include "core/io/volume_writer.h"
#include "core/volume/samples.h"
#include "tests/gui/window_fixture.h"
#include "ui/dropped_files.h"
#include "ui/features/recent_feature.h"
#include "ui/hidden_names.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

class FilesTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        recent()->forgetAll();
    }
    RecentFeature* recent() const { return window->findChild<RecentFeature*>(); }
    QString path(const QString& name) const { return folder.filePath(name); }
    /// A small volume as a file, or as a folder of DICOM images where the name has no ending.
    QString write(const QString& name, int size = 16) {
        SampleOptions options;
        options.size = size;
        Volume volume = make_sample("spheres", options).volume;
        volume.name = name.toStdString();
        if (QFileInfo(name).suffix().isEmpty())
            write_dicom_series(volume, path(name).toStdString());
        else
            write_volume(volume, path(name).toStdString());
        return path(name);
    }
    /// Drops files on the window and waits until something has been opened or refused.
    void drop(const QStringList& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files) urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QSignalSpy finished(window->loader(), &LoadController::finished);
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &enter);
        ASSERT_TRUE(enter.isAccepted());
        QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &drop);
        ASSERT_TRUE(finished.count() > 0 || finished.wait(k_patience_ms));
    }
    QString input() const { return QString::fromStdString(document().input); }

    QTemporaryDir folder;
};

TEST_F(FilesTest, AFolderAFileAndSeveralFilesAreDropped) {
    const QString dicom = write(QStringLiteral("dicom"));
    drop({dicom});
    EXPECT_EQ(input(), dicom);
    drop({write(QStringLiteral("a.nrrd"))});
    EXPECT_EQ(input(), path(QStringLiteral("a.nrrd")));
    // A header with its voxels is one thing, whichever comes first.
    write(QStringLiteral("b.mhd"));
    const QStringList pair{path(QStringLiteral("b.raw")), path(QStringLiteral("b.mhd"))};
    EXPECT_EQ(dropped_input(pair).left_out, 0);
    drop(pair);
    EXPECT_EQ(input(), path(QStringLiteral("b.mhd")));
    // Slices stand for their folder.
    QStringList slices;
    for (const QFileInfo& slice : QDir(dicom).entryInfoList(QDir::Files)) slices << slice.filePath();
    ASSERT_GT(slices.size(), 3);
    drop(slices.mid(0, 3));
    EXPECT_EQ(input(), dicom);
    EXPECT_EQ(document().volume.geometry().size.z, 16);
    // Of things that do not belong together the first is opened, and it is said.
    drop({path(QStringLiteral("a.nrrd")), path(QStringLiteral("b.mhd")).replace(QStringLiteral(".mhd"), QString()),
          dicom});
    EXPECT_EQ(input(), path(QStringLiteral("a.nrrd")));
    const Dropped mixed = dropped_input({path(QStringLiteral("a.nrrd")), dicom});
    EXPECT_EQ(mixed.input, path(QStringLiteral("a.nrrd")));
    EXPECT_EQ(mixed.left_out, 1);
}

TEST_F(FilesTest, WhatIsNoFileIsNotTaken) {
    QMimeData words;
    words.setText(QStringLiteral("hello"));
    QDragEnterEvent text({10, 10}, Qt::CopyAction, &words, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.get(), &text);
    EXPECT_FALSE(text.isAccepted());
    QMimeData link;
    link.setUrls({QUrl(QStringLiteral("https://example.org/a.nrrd"))});
    QDragEnterEvent web({10, 10}, Qt::CopyAction, &link, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.get(), &web);
    EXPECT_FALSE(web.isAccepted());
}

TEST_F(FilesTest, WhatWasOpenLatelyIsOpenedAgain) {
    open(write(QStringLiteral("a.nrrd")));
    open(write(QStringLiteral("b.nrrd"), 18));
    open(k_casting);  // samples have a menu of their own
    ASSERT_EQ(recent()->entries().size(), 2);
    EXPECT_EQ(recent()->entries().front().input, path(QStringLiteral("b.nrrd")));
    EXPECT_TRUE(recent()->menu()->actions().front()->text().contains(QStringLiteral("b.nrrd")));
    QSignalSpy finished(window->loader(), &LoadController::finished);
    recent()->menu()->actions().at(1)->trigger();
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_EQ(input(), path(QStringLiteral("a.nrrd")));
    EXPECT_EQ(recent()->entries().front().input, path(QStringLiteral("a.nrrd"))) << "the newest comes first";
    EXPECT_EQ(recent()->entries().size(), 2) << "and stands once";
    // Another window knows them too.
    window.reset();
    WindowTest::SetUp();
    ASSERT_EQ(recent()->entries().size(), 2);
    EXPECT_EQ(recent()->entries().front().input, path(QStringLiteral("a.nrrd")));
}

TEST_F(FilesTest, AnInputThatIsGoneIsSaidAndLeavesTheList) {
    open(write(QStringLiteral("a.nrrd")));
    open(write(QStringLiteral("b.nrrd")));
    QFile::remove(path(QStringLiteral("a.nrrd")));
    QSignalSpy finished(window->loader(), &LoadController::finished);
    recent()->open(1);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("a.nrrd")))
        << window->messageBar()->text().toStdString();
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("left the list")));
    ASSERT_EQ(recent()->entries().size(), 1);
    EXPECT_EQ(input(), path(QStringLiteral("b.nrrd"))) << "what was open stays";
    // One that is there but cannot be read stays in the list.
    QFile broken(path(QStringLiteral("b.nrrd")));
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("no volume");
    broken.close();
    QSignalSpy again(window->loader(), &LoadController::finished);
    recent()->open(0);
    ASSERT_TRUE(again.wait(k_patience_ms));
    EXPECT_EQ(recent()->entries().size(), 1);
    recent()->forgetAll();
    EXPECT_TRUE(recent()->entries().isEmpty());
}

TEST_F(FilesTest, WhatFailsInsteadOfAnEntryDoesNotRemoveIt) {
    open(write(QStringLiteral("a.nrrd")));
    QFile::remove(path(QStringLiteral("a.nrrd")));
    QSignalSpy finished(window->loader(), &LoadController::finished);
    recent()->open(0);
    window->openInput(path(QStringLiteral("other.nrrd")));  // before the first was found to be gone
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("other.nrrd")));
    EXPECT_FALSE(window->messageBar()->text().contains(QStringLiteral("left the list")));
    EXPECT_EQ(recent()->entries().size(), 1);
}

TEST_F(FilesTest, NamesAreHiddenWithThePatients) {
    open(write(QStringLiteral("Doe_Jane.nrrd")));
    preferences::set_hide_patient(true);
    Q_EMIT recent()->menu()->aboutToShow();
    const QString hidden = recent()->menu()->actions().front()->text();
    preferences::set_hide_patient(false);
    EXPECT_FALSE(hidden.contains(QStringLiteral("Doe"))) << hidden.toStdString();
    Q_EMIT recent()->menu()->aboutToShow();
    EXPECT_TRUE(recent()->menu()->actions().front()->text().contains(QStringLiteral("Doe")));
    // Nor are they told when there is nothing left to open.
    QFile::remove(path(QStringLiteral("Doe_Jane.nrrd")));
    preferences::set_hide_patient(true);
    QSignalSpy finished(window->loader(), &LoadController::finished);
    recent()->menu()->actions().front()->trigger();
    EXPECT_TRUE(finished.wait(k_patience_ms));
    preferences::set_hide_patient(false);
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("left the list")));
    EXPECT_FALSE(window->messageBar()->text().contains(QStringLiteral("Doe"))) << "in the message";
}

TEST_F(FilesTest, FaultsAreToldWithoutNamesWhilePatientsAreHidden) {
    const QString sound = write(QStringLiteral("Doe_Jane.nrrd"));
    QFile file(sound);
    ASSERT_TRUE(file.resize(file.size() / 2));
    const auto fault = [&](const QString& input) {
        QSignalSpy finished(window->loader(), &LoadController::finished);
        window->loader()->open(input);
        EXPECT_TRUE(finished.wait(k_patience_ms));
        return window->messageBar()->text();
    };
    EXPECT_TRUE(fault(sound).contains(QStringLiteral("Doe")));
    preferences::set_hide_patient(true);
    const QString hidden = fault(sound), of_folder = fault(QFileInfo(sound).path());
    preferences::set_hide_patient(false);
    EXPECT_TRUE(hidden.contains(QStringLiteral("cut"))) << hidden.toStdString();
    EXPECT_FALSE(hidden.contains(QStringLiteral("Doe"))) << hidden.toStdString();
    EXPECT_TRUE(of_folder.contains(QStringLiteral("no DICOM images"))) << of_folder.toStdString();
    EXPECT_FALSE(of_folder.contains(QStringLiteral("Doe"))) << of_folder.toStdString();
    EXPECT_FALSE(of_folder.contains(QFileInfo(sound).path())) << of_folder.toStdString();
}

TEST_F(FilesTest, NotesOnAnInputNameNoFileOncePatientsAreHidden) {
    Volume volume = make_sample("spheres", {}).volume;
    volume.dicom = DicomFacts{};
    volume.dicom->duplicates = {"Doe_Jane_1", "Doe_Jane_2"};
    volume.warnings = {{"1 DICOM files with a damaged header are left out: Doe_Jane.dcm.", 0}};
    ASSERT_TRUE(QFile(path(QStringLiteral("Doe_Jane.dcm"))).open(QIODevice::WriteOnly));
    hide_names(volume, folder.path().toStdString());
    EXPECT_EQ(volume.warnings[0].text.find("Doe"), std::string::npos) << volume.warnings[0].text;
    EXPECT_NE(volume.warnings[0].text.find("left out"), std::string::npos) << volume.warnings[0].text;
    ASSERT_EQ(volume.dicom->duplicates.size(), 2u) << "how many there are may be known";
    for (const std::string& name : volume.dicom->duplicates) EXPECT_EQ(name.find("Doe"), std::string::npos);
    // What was said before they were hidden is taken back; a question stays, and is no longer about it.
    MessageBar* bar = window->messageBar();
    bar->ask(QStringLiteral("Shall it?"), {{QStringLiteral("Yes"), [] {}}});
    bar->showNotice(QStringLiteral("Written to Doe_Jane.png."), QStringLiteral("Doe"));
    window->patient()->setHidden(true);
    EXPECT_EQ(bar->text(), QStringLiteral("Shall it?"));
    EXPECT_TRUE(bar->toolTip().isEmpty());
    EXPECT_TRUE(bar->isVisible());
    bar->dismiss();
    window->patient()->setHidden(false);
    bar->showNotice(QStringLiteral("Doe_Jane"));
    window->patient()->setHidden(true);
    EXPECT_FALSE(bar->isVisible());
    window->patient()->setHidden(false);
}

TEST_F(FilesTest, NamesLeaveASentenceWhole) {
    const std::string input = path(QStringLiteral("Doe Jane.mhd")).toStdString();
    for (const char* beside : {"1", "42", "a"}) {
        QFile file(path(QString::fromLatin1(beside)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    }
    EXPECT_EQ(without_names("Cannot read " + input + ": its data file Doe Jane.raw is not there.", input),
              "Cannot read ...: its data file ....raw is not there.");
    EXPECT_EQ(without_names("Cannot read /else/where.dcm: it is cut short.", input),
              "Cannot read ...: it is cut short.");
    EXPECT_EQ(without_names("Cannot read " + input + "/sub/a.dcm: 3 and/or 4 m/s.", input),
              "Cannot read ...: 3 and/or 4 m/s.");
    EXPECT_EQ(without_names("1 of 42 slices is a repeat.", input), "1 of 42 slices is a repeat.");
    EXPECT_EQ(without_names("The samples are casting, head.", "sample:none"), "The samples are casting, head.");
}

TEST_F(FilesTest, TheListHoldsTen) {
    for (int i = 0; i < 12; ++i) open(write(QStringLiteral("v%1.nrrd").arg(i), 8));
    ASSERT_EQ(recent()->entries().size(), RecentFeature::k_most);
    EXPECT_EQ(recent()->entries().front().input, path(QStringLiteral("v11.nrrd")));
    EXPECT_EQ(recent()->entries().back().input, path(QStringLiteral("v2.nrrd")));
}

TEST_F(FilesTest, ATableOfTheFileIsAPresetAndIsUndone) {
    open(k_casting);
    Document shown = document();
    const ValueRange values = shown.statistics->range;
    VoiTable table{"STEEP", values.lo, {}, 8};
    const auto count = std::size_t(values.width()) + 1;
    for (std::size_t i = 0; i < count; ++i) table.share.push_back(i % 2 ? 255 : 0);
    shown.voi_tables = {std::make_shared<const VoiTable>(table)};
    window->documents()->open(shown);
    SliceView* axial = window->views()->slice(SliceKind::axial);
    const QImage before = axial->grab().toImage();
    const ValueRange window_before = document().settings.window;
    QComboBox* presets = window->slicesPanel()->presetBox();
    const int row = presets->findText(QStringLiteral("STEEP (table of the file)"));
    ASSERT_GT(row, 0);
    presets->setCurrentIndex(row);
    Q_EMIT presets->activated(row);
    EXPECT_EQ(document().settings.slices.function, VoiFunction::table);
    EXPECT_EQ(document().settings.window, (ValueRange{table.first, table.last()}));
    EXPECT_EQ(presets->currentIndex(), row);
    EXPECT_GT(difference(axial->grab().toImage(), before), 0.05);
    window->documents()->undo();
    EXPECT_EQ(document().settings.window, window_before);
    EXPECT_LT(difference(axial->grab().toImage(), before), 0.001);
    // A window of another name is linear again.
    window->documents()->redo();
    ASSERT_EQ(document().settings.slices.function, VoiFunction::table);
    presets->setCurrentIndex(2);
    Q_EMIT presets->activated(2);
    EXPECT_EQ(document().settings.slices.function, VoiFunction::linear);
    EXPECT_EQ(document().settings.window, values);
}

}  // namespace
}  // namespace lacuna::ui::test
