// Ways in and out that ask first: raw files, the DICOM browser, anonymised export, DICOM servers.
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QTemporaryDir>

#include "core/io/dicom_writer.h"
#include "core/volume/samples.h"
#include "tests/gui/window_fixture.h"
#include "ui/dicom_browser.h"
#include "ui/features/import_feature.h"
#include "ui/pacs_dialog.h"
#include "ui/raw_import_dialog.h"

namespace lacuna::ui::test {

namespace {

class ImportTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        SampleOptions options;
        options.dims = {72, 60, 48};
        volume = make_sample("casting", options).volume;
        file = folder.filePath(QStringLiteral("unknown.raw"));
        QFile out(file);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(reinterpret_cast<const char*>(volume.data()), qint64(volume.bytes()));
    }

    /// The dialog that opening the file brings up, its proposals there and its first picture drawn.
    RawImportDialog* dialog() {
        QSignalSpy asked(window->loader(), &LoadController::layoutNeeded);
        window->openInput(file);
        EXPECT_TRUE(asked.count() > 0 || asked.wait(k_patience_ms));
        auto* found = window->findChild<RawImportDialog*>();
        if (!found) return nullptr;
        QSignalSpy previewed(found, &RawImportDialog::previewed);
        EXPECT_TRUE(previewed.count() > 0 || previewed.wait(k_patience_ms));
        return found;
    }

    QTemporaryDir folder;
    QString file;
    Volume volume;
};

TEST_F(ImportTest, ARawFileWithoutAHeaderIsProposedShownAndOpened) {
    RawImportDialog* import = dialog();
    ASSERT_NE(import, nullptr);
    ASSERT_FALSE(import->proposals().empty());
    EXPECT_EQ(import->layout().geometry.size, glm::ivec3(72, 60, 48));
    EXPECT_EQ(import->layout().type, volume.type());
    EXPECT_TRUE(import->proposalList()->item(0)->text().contains(QStringLiteral("% sure")));
    EXPECT_EQ(import->preview()->image().size(), QSize(72, 60));
    EXPECT_GT(lit(import->preview()->image()), 0.1);
    const QImage middle = import->preview()->image();
    QSignalSpy previewed(import, &RawImportDialog::previewed);
    import->sliceSlider()->setValue(0);
    ASSERT_TRUE(previewed.wait(k_patience_ms));
    EXPECT_GT(difference(import->preview()->image(), middle), 0.01);

    QSignalSpy finished(window->loader(), &LoadController::finished);
    QTest::mouseClick(import->openButton(), Qt::LeftButton);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    ASSERT_TRUE(window->documents()->hasDocument()) << window->messageBar()->text().toStdString();
    EXPECT_EQ(document().volume.geometry().size, glm::ivec3(72, 60, 48));
    EXPECT_EQ(document().options.raw, "72x60x48:" + std::string(name_of(volume.type())));
}

TEST_F(ImportTest, AnEmptyFileIsSaidAndNoLayoutAskedFor) {
    ASSERT_TRUE(QFile::resize(file, 0));
    QSignalSpy asked(window->loader(), &LoadController::layoutNeeded);
    QSignalSpy finished(window->loader(), &LoadController::finished);
    window->openInput(file);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_EQ(asked.count(), 0);
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("it is empty")))
        << window->messageBar()->text().toStdString();
}

TEST_F(ImportTest, AnArchiveIsToBeUnpackedFirst) {
    const QString zip = folder.filePath(QStringLiteral("study.zip"));
    QFile out(zip);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(QByteArray("PK\3\4\x14\0\0\0", 8) + QByteArray(400, 'x'));
    out.close();
    QSignalSpy finished(window->loader(), &LoadController::finished);
    window->openInput(zip);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("unpack it first")))
        << window->messageBar()->text().toStdString();
}

TEST_F(ImportTest, ASpacingOfMicrometresIsTakenToItsLastDigit) {
    RawImportDialog* import = dialog();
    ASSERT_NE(import, nullptr);
    const QList<QDoubleSpinBox*> boxes = import->findChildren<QDoubleSpinBox*>();
    ASSERT_EQ(boxes.size(), 3);
    EXPECT_EQ(boxes[0]->text(), QStringLiteral("1"));
    for (QDoubleSpinBox* box : boxes) {
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QStringLiteral("0.0070014"));
        QTest::keyClick(box, Qt::Key_Tab);
        EXPECT_EQ(box->text(), QStringLiteral("0.0070014"));
    }
    EXPECT_EQ(import->layout().geometry.spacing, glm::dvec3(0.0070014));
    QSignalSpy finished(window->loader(), &LoadController::finished);
    QTest::mouseClick(import->openButton(), Qt::LeftButton);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_EQ(document().volume.geometry().spacing, glm::dvec3(0.0070014)) << document().options.raw;
}

TEST_F(ImportTest, NumbersThatDoNotFitTheFileCannotBeOpened) {
    RawImportDialog* import = dialog();
    ASSERT_NE(import, nullptr);
    EXPECT_TRUE(import->openButton()->isEnabled());
    RawLayout layout = import->layout();
    layout.geometry.size.z += 1;
    import->setLayoutValues(layout);
    EXPECT_FALSE(import->openButton()->isEnabled());
    EXPECT_TRUE(import->sizeLine()->text().contains(QStringLiteral("too many")));
    layout.geometry.size.z = 20;
    import->setLayoutValues(layout);
    EXPECT_FALSE(import->openButton()->isEnabled());
    EXPECT_TRUE(import->sizeLine()->text().contains(QStringLiteral("left over")));
    for (QPushButton* button : import->findChildren<QPushButton*>())
        if (button->text().contains(QStringLiteral("depth"))) QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(import->layout().geometry.size.z, 48);
    EXPECT_TRUE(import->openButton()->isEnabled());
}

class DicomTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        for (const char* name : {"casting", "spheres"}) {
            SampleOptions options;
            options.dims = {40, 36, 20};
            Volume volume = make_sample(name, options).volume;
            volume.name = name;
            write_dicom_series(volume, (folder.path() + QLatin1Char('/') + QLatin1String(name)).toStdString());
        }
    }
    DicomBrowser* browser() {
        window->findChild<ImportFeature*>()->browse();
        return window->findChild<DicomBrowser*>();
    }
    QTemporaryDir folder;
};

TEST_F(DicomTest, TheBrowserFindsSearchesPicturesAndOpens) {
    DicomBrowser* found = browser();
    ASSERT_NE(found, nullptr);
    QSignalSpy looked(found, &DicomBrowser::looked), pictured(found, &DicomBrowser::pictured);
    found->look(folder.path());
    ASSERT_TRUE(looked.count() > 0 || looked.wait(k_patience_ms));
    EXPECT_EQ(found->catalogue().series_count(), 2);
    EXPECT_EQ(found->seriesShown(), 2);
    ASSERT_TRUE(pictured.count() > 0 || pictured.wait(k_patience_ms));
    QTest::keyClicks(found->searchBox(), QStringLiteral("SPHERES"));
    EXPECT_EQ(found->seriesShown(), 1);
    const QAbstractItemModel* model = found->tree()->model();
    const QModelIndex study = model->index(0, 0, model->index(0, 0));
    const QModelIndex series = model->index(0, 0, study);
    ASSERT_TRUE(series.isValid());
    EXPECT_GT(lit(series.data(Qt::DecorationRole).value<QIcon>().pixmap(64, 64).toImage()), 0.02);
    QSignalSpy finished(window->loader(), &LoadController::finished);
    found->tree()->setCurrentIndex(series);
    QTest::keyClick(found->tree(), Qt::Key_Return);
    ASSERT_TRUE(finished.count() > 0 || finished.wait(k_patience_ms));
    ASSERT_TRUE(window->documents()->hasDocument()) << window->messageBar()->text().toStdString();
    EXPECT_EQ(document().volume.geometry().size, glm::ivec3(40, 36, 20));
    EXPECT_FALSE(document().options.series.empty());
}

TEST_F(DicomTest, TheBrowserSaysWhatItCannotRead) {
    DicomBrowser* found = browser();
    QSignalSpy looked(found, &DicomBrowser::looked);
    found->look(folder.path() + QStringLiteral("/missing"));
    ASSERT_TRUE(looked.count() > 0 || looked.wait(k_patience_ms));
    EXPECT_TRUE(found->statusText()->text().contains(QStringLiteral("no such file")));
    EXPECT_EQ(found->seriesShown(), 0);
}

TEST_F(DicomTest, AnonymisedImagesOpenAsTheSameVolume) {
    open(folder.path() + QStringLiteral("/casting"));
    auto* feature = window->findChild<ImportFeature*>();
    QSignalSpy ended(feature, &ImportFeature::anonymised);
    const QString target = folder.path() + QStringLiteral("/out");
    feature->anonymise(target);
    ASSERT_TRUE(ended.count() > 0 || ended.wait(k_patience_ms));
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("20 ")))
        << window->messageBar()->text().toStdString();
    const std::string before = voxel_sha256(document().volume);
    open(target);
    EXPECT_EQ(voxel_sha256(document().volume), before);
}

TEST_F(DicomTest, AServerThatIsNotThereIsNamedAndNothingHangs) {
    PacsDialog dialog(window->findChild<TaskList*>());
    dialog.setServers({{"gone", "127.0.0.1", 1, "GONE", "LACUNA", 2, {}, {}}});
    QSignalSpy finished(&dialog, &PacsDialog::finished);
    dialog.test();
    ASSERT_TRUE(finished.count() > 0 || finished.wait(k_patience_ms));
    EXPECT_TRUE(dialog.statusText()->text().contains(QStringLiteral("refuses the connection")))
        << dialog.statusText()->text().toStdString();
    dialog.search();
    ASSERT_TRUE(finished.count() > 1 || finished.wait(k_patience_ms));
    EXPECT_EQ(dialog.results()->topLevelItemCount(), 0);
}

}  // namespace

}  // namespace lacuna::ui::test
