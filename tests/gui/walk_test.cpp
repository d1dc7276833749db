// A newcomer's path through the window, as the README tells it: open a DICOM series, look, colour, cut, take a range,
// measure, find regions, inspect, export, save, lose the program, and find the work again. With LACUNA_SHOTS=FOLDER
// every step leaves a picture of the window there (docs/make_pictures.sh).
#include <signal.h>

#include <QAction>
#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/io/volume_reader.h"
#include "core/io/volume_writer.h"
#include "window_fixture.h"

namespace lacuna::ui::test {
namespace {

QString plain(QString text) { return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

QAction* find_action(const QList<QAction*>& actions, const QString& text) {
    for (QAction* action : actions) {
        if (action->menu())
            if (QAction* inner = find_action(action->menu()->actions(), text)) return inner;
        if (!action->menu() && plain(action->text()) == text) return action;
    }
    return nullptr;
}

class WalkTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        window->resize(1480, 940);
    }
    /// Chooses a command by its words, wherever in the menus it stands.
    void choose(const char* text) {
        QAction* action = find_action(window->menuBar()->actions(), QString::fromUtf8(text));
        ASSERT_NE(action, nullptr) << text;
        ASSERT_TRUE(action->isEnabled()) << text;
        action->trigger();
    }
    void shot(const char* name) {
        settle();
        const QString folder = qEnvironmentVariable("LACUNA_SHOTS");
        if (folder.isEmpty()) return;
        QDir().mkpath(folder);
        QApplication::processEvents();
        ASSERT_TRUE(window->grab().save(QDir(folder).filePath(QLatin1String(name) + QStringLiteral(".png"))));
    }
    /// A series of the built-in head, as a scanner would hand it over.
    static void writeSeries(const QString& folder) {
        QDir().mkpath(folder);
        write_volume(open_volume("sample:head@64"), folder.toStdString());
    }
    /// Looks, colours, cuts and measures; what the session has to bring back.
    void work() {
        choose("Bone");
        choose("Maximum projection (MIP)");
        settle();
        const QImage mip = picture();
        choose("Volume (emission–absorption)");
        settle();
        EXPECT_GT(difference(mip, picture()), 0.02);
        shot("walk-2-look");
        const QImage whole = picture();
        choose("Add a cutting plane");
        ASSERT_EQ(document().settings.cuts.size(), 1u);
        settle();
        EXPECT_GT(difference(whole, picture()), 0.01);
        shot("walk-3-cut");
        choose("Add a segmentation range");
        ASSERT_EQ(document().settings.ranges.size(), 1u);
        choose("Distance");
        SliceView* axial = window->views()->slice(SliceKind::axial);
        const QRectF at = axial->pictureRect();
        drag(axial, at.center() - QPointF(0.2 * at.width(), 0), at.center() + QPointF(0.2 * at.width(), 0));
        ASSERT_EQ(document().settings.measurements.size(), 1u) << at.width() << " wide, " << axial->width();
        choose("Cross-hair");
        shot("walk-4-measure");
    }
};

TEST_F(WalkTest, FromTheSeriesToTheReport) {
    QTemporaryDir folder;
    writeSeries(folder.filePath(QStringLiteral("series")));
    open(folder.filePath(QStringLiteral("series")));
    shot("walk-1-open");
    work();
    const ViewSettings before = document().settings;

    QSignalSpy found(window->regions(), &RegionsFeature::finished);
    choose("Compute regions");
    ASSERT_TRUE(found.wait(k_patience_ms));
    ASSERT_TRUE(document().regions);
    EXPECT_GE(document().regions->rows.size(), 1u);
    QSignalSpy inspected(window->inspection(), &InspectionFeature::finished);
    choose("Inspect the part");
    ASSERT_TRUE(inspected.wait(k_patience_ms));
    shot("walk-5-inspect");

    QSignalSpy written(window->exports(), &ExportFeature::written);
    window->exports()->savePicture(folder.filePath(QStringLiteral("view.png")), true);
    ASSERT_TRUE(written.wait(k_patience_ms));
    EXPECT_FALSE(QImage(folder.filePath(QStringLiteral("view.png"))).isNull());

    QSignalSpy saved(window->session(), &SessionFeature::saved);
    window->session()->saveTo(folder.filePath(QStringLiteral("work.lacuna")));
    ASSERT_TRUE(saved.wait(k_patience_ms));
    shot("walk-6-saved");

    while (window->documents()->history().can_undo()) window->documents()->undo();
    EXPECT_TRUE(document().settings.cuts.empty());
    EXPECT_TRUE(document().settings.measurements.empty());
    QSignalSpy restored(window->session(), &SessionFeature::restored);
    window->openInput(folder.filePath(QStringLiteral("work.lacuna")));
    ASSERT_TRUE(restored.wait(k_patience_ms)) << window->messageBar()->text().toStdString();
    EXPECT_EQ(document().settings, before);
}

/// The other process of the next test: works, keeps what it did, says so, and waits for its end.
TEST_F(WalkTest, DISABLED_WorksUntilItIsKilled) {
    open(qEnvironmentVariable("LACUNA_WALK_INPUT"));
    work();
    QSignalSpy kept(window->session(), &SessionFeature::autosaved);
    window->session()->autosave();
    ASSERT_TRUE(kept.count() > 0 || kept.wait(k_patience_ms));
    puts("kept");
    fflush(stdout);
    QTest::qWait(k_patience_ms);
}

TEST_F(WalkTest, KilledAndTakenUpAgain) {
    QTemporaryDir folder;
    writeSeries(folder.filePath(QStringLiteral("series")));
    QProcess other;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LACUNA_WALK_INPUT"), folder.filePath(QStringLiteral("series")));
    environment.insert(QStringLiteral("LACUNA_TEST_HOME"), qEnvironmentVariable("XDG_DATA_HOME"));
    environment.remove(QStringLiteral("LACUNA_SHOTS"));
    other.setProcessEnvironment(environment);
    other.setProcessChannelMode(QProcess::MergedChannels);
    other.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("--gtest_also_run_disabled_tests"),
                 QStringLiteral("--gtest_filter=WalkTest.DISABLED_WorksUntilItIsKilled")});
    QByteArray said;
    while (!said.contains("\nkept\n") && other.waitForReadyRead(k_patience_ms)) said += other.readAll();
    ASSERT_TRUE(said.contains("\nkept\n")) << said.toStdString();
    ASSERT_EQ(kill(pid_t(other.processId()), SIGKILL), 0);
    other.waitForFinished();

    window.reset();
    SetUp();
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->messageBar()->answerButtons().size() == 2; }, k_patience_ms));
    QSignalSpy restored(window->session(), &SessionFeature::restored);
    QTest::mouseClick(window->messageBar()->answerButtons().front(), Qt::LeftButton);
    ASSERT_TRUE(restored.wait(k_patience_ms)) << window->messageBar()->text().toStdString();
    settle();
    EXPECT_EQ(document().settings.cuts.size(), 1u);
    EXPECT_EQ(document().settings.measurements.size(), 1u);
    EXPECT_EQ(document().settings.mode, ViewMode::ea);
    shot("walk-7-recovered");
}

}  // namespace
}  // namespace lacuna::ui::test
