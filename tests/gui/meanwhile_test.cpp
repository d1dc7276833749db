// A job that ends while a dialog asks: what was asked about is not what the window holds any more.
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

#include "tests/gui/window_fixture.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

class MeanwhileTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        preferences::set_save_folder(folder.path());
    }
    void TearDown() override { preferences::set_save_folder({}); }

    /// Once a dialog of this kind runs: lets something happen, then answers it.
    template <class Dialog>
    void whenAsked(const std::function<void()>& meanwhile, const std::function<void(Dialog&)>& answer) {
        driver.setInterval(20);
        QObject::connect(&driver, &QTimer::timeout, window.get(), [this, meanwhile, answer] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            if (!dialog) return;
            driver.stop();
            meanwhile();
            answer(*dialog);
        });
        driver.start();
    }
    void inspect() {
        QSignalSpy gathered(window->inspection(), &InspectionFeature::gathered);
        window->inspection()->inspect(panel()->form()->criteria().detection);
        ASSERT_TRUE(gathered.count() > 0 || gathered.wait(k_patience_ms));
        ASSERT_TRUE(document().inspection);
    }
    InspectionPanel* panel() const { return window->inspection()->panel(); }

    QTemporaryDir folder;
    QTimer driver;
};

TEST_F(MeanwhileTest, TheTableOfRegionsAskedForIsWrittenThoughOtherDataWasOpened) {
    open(k_casting);
    QSignalSpy found(window->regions(), &RegionsFeature::finished);
    window->regions()->compute();
    ASSERT_TRUE(found.wait(k_patience_ms));
    ASSERT_TRUE(document().regions);
    const std::size_t rows = document().regions->rows.size();
    const Document other = make_document("sample:spheres@24", open_volume("sample:spheres@24"));
    whenAsked<QFileDialog>([&] { window->documents()->open(other); },
                           [](QFileDialog& dialog) {
                               auto* edit = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
                               ASSERT_NE(edit, nullptr);
                               edit->setText(QStringLiteral("regions.csv"));
                               QTest::keyClick(edit, Qt::Key_Return);
                           });
    window->regions()->exportTable();
    ASSERT_FALSE(document().regions);
    QFile file(folder.filePath(QStringLiteral("regions.csv")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return file.exists(); }, k_patience_ms))
        << window->messageBar()->text().toStdString();
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(std::size_t(file.readAll().count('\n')), rows + 1);
}

TEST_F(MeanwhileTest, AWordByHandIsNotTakenForADefectFoundSince) {
    open(k_casting);
    inspect();
    ASSERT_GE(document().inspection->defects.size(), 1u);
    panel()->table()->selectRow(0);
    QPushButton* accept = nullptr;
    for (QPushButton* button : panel()->findChildren<QPushButton*>())
        if (button->accessibleName() == InspectionPanel::tr("Accept the chosen defect by hand")) accept = button;
    ASSERT_TRUE(accept && accept->isEnabled());
    const auto answer = [](QInputDialog& dialog) {
        dialog.setTextValue(QStringLiteral("an edge of the mould"));
        dialog.accept();
    };
    const auto anew = std::make_shared<const PartAnalysis>(*document().inspection);
    whenAsked<QInputDialog>([&] { window->documents()->setInspection(anew); }, answer);
    accept->click();
    EXPECT_TRUE(panel()->judgement().by_hand.empty());
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("choose the defect again")))
        << window->messageBar()->text().toStdString();
    panel()->table()->selectRow(0);
    driver.disconnect();
    whenAsked<QInputDialog>([] {}, answer);
    accept->click();
    EXPECT_EQ(panel()->judgement().by_hand.size(), 1u);
}

}  // namespace
}  // namespace lacuna::ui::test
