// Closing the window over what still runs: asked about where work would be lost, and only there.
#include <QFile>
#include <QTemporaryDir>
#include <condition_variable>
#include <mutex>

#include "tests/gui/window_fixture.h"
#include "ui/dialogs/close_dialog.h"
#include "ui/tasks.h"

namespace lacuna::ui::test {
namespace {

/// Work that goes on until the test lets it end.
class Gate {
public:
    ~Gate() { open(); }
    void open() {
        const std::lock_guard lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }
    void pass(const JobContext& job) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, job.stop, [&] { return open_; });
        job.check();
    }

private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    bool open_ = false;
};

class ClosingTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        jobs = std::make_unique<Tasks<int>>(window.get(), window->bench()->tasks());
    }
    void TearDown() override { jobs.reset(); }
    /// A job that waits at `gate`, then ends, or fails where it has words.
    void run(const QString& name, const char* fails_with = nullptr) {
        jobs->start(
            name,
            [this, fails_with](const JobContext& job) {
                gate.pass(job);
                if (fails_with) throw Error(Errc::io, fails_with);
                return 0;
            },
            [this](Outcome<int> outcome) {
                ended += outcome.index() == 0;
                stopped += outcome.index() == 1;
                if (const Error* error = std::get_if<Error>(&outcome)) window->bench()->report(*error);
            });
    }
    CloseDialog* asked() const { return window->closeGuard()->dialog(); }

    Gate gate;
    std::unique_ptr<Tasks<int>> jobs;
    int ended = 0, stopped = 0;
};

TEST_F(ClosingTest, AsksOnceAndNamesWhatRuns) {
    run(QStringLiteral("Saving the volume"));
    run(QStringLiteral("Sending to a DICOM server"));
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(window->isVisible());
    ASSERT_NE(asked(), nullptr);
    EXPECT_TRUE(asked()->isVisible());
    EXPECT_TRUE(asked()->jobsText().contains(QStringLiteral("Saving the volume")));
    EXPECT_TRUE(asked()->jobsText().contains(QStringLiteral("Sending to a DICOM server")));
    const CloseDialog* first = asked();
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked(), first);
}

TEST_F(ClosingTest, WaitingClosesWhenTheWorkIsDone) {
    run(QStringLiteral("Saving the volume"));
    EXPECT_FALSE(window->close());
    ASSERT_NE(asked(), nullptr);
    QTest::mouseClick(asked()->waitButton(), Qt::LeftButton);
    QTest::qWait(50);
    EXPECT_TRUE(window->isVisible());
    EXPECT_TRUE(asked() && asked()->isVisible());
    gate.open();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window->isVisible(); }, k_patience_ms));
    EXPECT_EQ(ended, 1);
    EXPECT_EQ(stopped, 0);
}

TEST_F(ClosingTest, StoppingClosesAtOnceAndEndsTheWork) {
    run(QStringLiteral("Saving the volume"));
    EXPECT_FALSE(window->close());
    ASSERT_NE(asked(), nullptr);
    QTest::mouseClick(asked()->stopButton(), Qt::LeftButton);
    EXPECT_FALSE(window->isVisible());
    EXPECT_EQ(stopped, 1);
    EXPECT_TRUE(window->bench()->tasks()->rows().empty());
}

TEST_F(ClosingTest, KeepingTheWindowOpenKeepsTheWorkToo) {
    run(QStringLiteral("Saving the volume"));
    EXPECT_FALSE(window->close());
    ASSERT_NE(asked(), nullptr);
    QTest::keyClick(asked(), Qt::Key_Escape);
    EXPECT_TRUE(window->isVisible());
    gate.open();
    ASSERT_TRUE(QTest::qWaitFor([this] { return ended == 1; }, k_patience_ms));
    QTest::qWait(30);
    EXPECT_TRUE(window->isVisible());
    EXPECT_TRUE(window->close()) << "nothing runs any more";
}

TEST_F(ClosingTest, WorkThatFailsIsReadBeforeTheWindowCloses) {
    run(QStringLiteral("Saving the volume"), "Cannot write out.nrrd: the disk is full.");
    EXPECT_FALSE(window->close());
    ASSERT_NE(asked(), nullptr);
    QTest::mouseClick(asked()->waitButton(), Qt::LeftButton);
    gate.open();
    ASSERT_TRUE(QTest::qWaitFor([this] { return stopped == 1; }, k_patience_ms));
    QTest::qWait(30);
    EXPECT_TRUE(window->isVisible());
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("disk is full")));
    EXPECT_TRUE(!asked() || !asked()->isVisible());
}

TEST_F(ClosingTest, WhatLosesNothingIsNotAskedAbout) {
    open(k_casting);
    QTemporaryDir folder;
    Task<int> search(window.get(), window->bench()->tasks(), AtStake::nothing);
    search.start(
        QStringLiteral("Searching a DICOM server"), [this](const JobContext& job) { return gate.pass(job), 0; },
        [](Outcome<int>) {});
    window->openInput(QStringLiteral("sample:casting@200"));
    window->session()->saveTo(folder.filePath(QStringLiteral("a.lacuna")));
    ASSERT_GE(window->bench()->tasks()->rows().size(), 2u);
    EXPECT_TRUE(window->close());
    EXPECT_EQ(asked(), nullptr);
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("a.lacuna"))));
}

TEST_F(ClosingTest, AnExportOfTheWindowsOwnIsAskedAbout) {
    open(k_casting);
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("turn.png"));
    window->exports()->saveTurntable(file, 400);
    EXPECT_FALSE(window->close());
    ASSERT_NE(asked(), nullptr);
    EXPECT_TRUE(asked()->jobsText().contains(QStringLiteral("Drawing a turntable")));
    QTest::mouseClick(asked()->stopButton(), Qt::LeftButton);
    EXPECT_FALSE(window->isVisible());
}

}  // namespace
}  // namespace lacuna::ui::test
