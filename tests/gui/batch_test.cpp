// The batch dialog: a series is inspected, paused, cancelled and gone on with.
#include <QFile>
#include <QTemporaryDir>
#include <QToolButton>

#include "core/base/atomic_file.h"
#include "core/io/volume_writer.h"
#include "ui/dialogs/close_dialog.h"
#include "window_fixture.h"

namespace lacuna::ui::test {
namespace {

class BatchTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        ASSERT_TRUE(QTest::qWaitFor([this] { return window->bench()->engine() != nullptr; }, k_patience_ms));
        QDir(folder.path()).mkdir(QStringLiteral("parts"));
        for (const char* name : {"a", "b", "c"})
            write_volume(open_volume("sample:casting@32"),
                         path(QStringLiteral("parts/%1.mhd").arg(QLatin1String(name))));
        write_file(path(QStringLiteral("parts/d.mhd")), "no header at all");
        write_file(path(QStringLiteral("c.json")), R"({"limits":{"count":1000}})");
        dialog = window->batch()->dialog();
        dialog->show();
        dialog->partsEdit()->setText(folder.filePath(QStringLiteral("parts")));
        dialog->criteriaEdit()->setText(folder.filePath(QStringLiteral("c.json")));
        dialog->reportEdit()->setText(folder.filePath(QStringLiteral("report")));
    }
    std::string path(const QString& name) const { return folder.filePath(name).toStdString(); }
    QString cell(int row, int column) const { return dialog->model()->index(row, column).data().toString(); }

    QTemporaryDir folder;
    BatchDialog* dialog = nullptr;
};

TEST_F(BatchTest, ASeriesIsInspectedAndABrokenPartIsARow) {
    QSignalSpy finished(dialog, &BatchDialog::finished);
    QTest::mouseClick(dialog->startButton(), Qt::LeftButton);
    EXPECT_TRUE(dialog->running());
    EXPECT_FALSE(dialog->startButton()->isEnabled());
    for (const QToolButton* browse : dialog->findChildren<QToolButton*>()) EXPECT_FALSE(browse->isEnabled());
    EXPECT_EQ(window->bench()->tasks()->rows().size(), 1u);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    ASSERT_EQ(dialog->model()->rowCount(), 4);
    for (int row = 0; row < 3; ++row) EXPECT_EQ(cell(row, BatchModel::k_state), QStringLiteral("done")) << row;
    EXPECT_EQ(cell(3, BatchModel::k_state), QStringLiteral("broken"));
    EXPECT_FALSE(cell(3, BatchModel::k_reason).isEmpty());
    EXPECT_TRUE(dialog->messageText().contains(QStringLiteral("1 broken"))) << dialog->messageText().toStdString();
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("report/summary.html"))));
    EXPECT_TRUE(dialog->startButton()->isEnabled());
}

TEST_F(BatchTest, PausedCancelledAndGoneOnWith) {
    QSignalSpy finished(dialog, &BatchDialog::finished);
    QSignalSpy moved(dialog->model(), &BatchModel::dataChanged);
    QTest::mouseClick(dialog->startButton(), Qt::LeftButton);
    ASSERT_TRUE(moved.wait(k_patience_ms));
    dialog->pauseButton()->setChecked(true);
    // What was under way when the pause came is told, then nothing more happens.
    while (moved.wait(500)) {
    }
    const int before = dialog->model()->finishedParts();
    EXPECT_LT(before, 4);
    EXPECT_FALSE(moved.wait(300));
    EXPECT_TRUE(dialog->running());
    QTest::mouseClick(dialog->cancelButton(), Qt::LeftButton);
    EXPECT_EQ(finished.count(), 1);
    EXPECT_FALSE(dialog->running());
    EXPECT_TRUE(window->bench()->tasks()->rows().empty());
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("report/summary.html"))));
    QTest::mouseClick(dialog->startButton(), Qt::LeftButton);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("report/summary.html"))))
        << dialog->messageText().toStdString();
    EXPECT_EQ(dialog->model()->finishedParts(), 4);
}

TEST_F(BatchTest, ClosingLetsAPausedSeriesGoOnAndWaitsForIt) {
    QSignalSpy moved(dialog->model(), &BatchModel::dataChanged);
    QTest::mouseClick(dialog->startButton(), Qt::LeftButton);
    ASSERT_TRUE(moved.wait(k_patience_ms));
    dialog->pauseButton()->setChecked(true);
    EXPECT_FALSE(window->close());
    const QPointer<CloseDialog> asked = window->closeGuard()->dialog();
    ASSERT_NE(asked, nullptr);
    EXPECT_TRUE(asked->jobsText().contains(QStringLiteral("paused"))) << asked->jobsText().toStdString();
    asked->waitButton()->click();
    EXPECT_FALSE(dialog->pauseButton()->isChecked());
    EXPECT_FALSE(asked->waitButton()->isEnabled());
    EXPECT_FALSE(asked->jobsText().contains(QStringLiteral("paused"))) << asked->jobsText().toStdString();
    // Paused while the window waits: the same button lets it go on once more.
    dialog->pauseButton()->setChecked(true);
    EXPECT_TRUE(asked->waitButton()->isEnabled());
    asked->waitButton()->click();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window->isVisible(); }, k_patience_ms));
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("report/summary.html"))));
}

TEST_F(BatchTest, WhatIsNotNamedIsAskedForWhereItBelongs) {
    for (QLineEdit* field : {dialog->reportEdit(), dialog->criteriaEdit(), dialog->partsEdit()}) {
        field->clear();
        QTest::mouseClick(dialog->startButton(), Qt::LeftButton);
        EXPECT_FALSE(dialog->running());
        EXPECT_TRUE(dialog->messageText().startsWith(QStringLiteral("Name "))) << dialog->messageText().toStdString();
        EXPECT_EQ(dialog->focusWidget(), field);
    }
}

TEST_F(BatchTest, WhatIsOffIsSaidBeforeAnythingStarts) {
    dialog->criteriaEdit()->setText(folder.filePath(QStringLiteral("none.json")));
    QSignalSpy finished(dialog, &BatchDialog::finished);
    QTest::mouseClick(dialog->startButton(), Qt::LeftButton);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_FALSE(dialog->running());
    EXPECT_TRUE(dialog->startButton()->isEnabled());
    EXPECT_TRUE(dialog->messageText().contains(QStringLiteral("none.json"))) << dialog->messageText().toStdString();
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("report"))));
}

}  // namespace
}  // namespace lacuna::ui::test
