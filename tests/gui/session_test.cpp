// Sessions: saved, opened, saved by themselves, and taken up again after a crash.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QProcess>
#include <QPushButton>
#include <QSysInfo>
#include <QTemporaryDir>

#include "core/io/volume_writer.h"
#include "window_fixture.h"

namespace lacuna::ui::test {
namespace {

class SessionTest : public WindowTest {
protected:
    void SetUp() override {
        for (const QFileInfo& file : SessionFeature::autosaveFolder().entryInfoList(QDir::Files))
            QFile::remove(file.filePath());
        WindowTest::SetUp();
    }
    SessionFeature* session() const { return window->session(); }

    void changeThings() {
        window->bench()->edit(QStringLiteral("Isovalue"), [](ViewSettings& s) { s.iso = 1234.5; });
        window->bench()->edit(QStringLiteral("Cut"), [](ViewSettings& s) {
            s.cuts.push_back({{{0, 1, 0}, 3, true}, true});
        });
        Camera camera = document().camera;
        camera.azimuth_deg = 77;
        window->documents()->setCamera(camera);
        window->documents()->setCursor({1, 2, 3});
    }
    void save(const QString& file) {
        QSignalSpy saved(session(), &SessionFeature::saved);
        session()->saveTo(file);
        ASSERT_TRUE(saved.wait(k_patience_ms)) << window->messageBar()->text().toStdString();
    }
    void reopen(const QString& file) {
        QSignalSpy restored(session(), &SessionFeature::restored);
        window->openInput(file);
        ASSERT_TRUE(restored.wait(k_patience_ms)) << window->messageBar()->text().toStdString();
    }
    void anotherWindow() {
        window.reset();
        WindowTest::SetUp();
    }
    /// A volume file of the test's own.
    QString writeData(float value) {
        const QString file = folder.filePath(QStringLiteral("part.mhd"));
        GridGeometry geometry;
        geometry.size = {16, 16, 16};
        write_volume(make_volume<float>(geometry,
                                        [value](std::span<float> voxels) {
                                            std::fill(voxels.begin(), voxels.end(), value);
                                            voxels[5] = value + 1;
                                        }),
                     file.toStdString());
        return file;
    }
    QTemporaryDir folder;
};

TEST_F(SessionTest, BringsEverythingBackInAnotherWindow) {
    open(k_casting);
    changeThings();
    const ViewSettings settings = document().settings;
    const Camera camera = document().camera;
    const QString file = folder.filePath(QStringLiteral("a.lacuna"));
    save(file);
    EXPECT_FALSE(window->isWindowModified());
    anotherWindow();
    reopen(file);
    EXPECT_EQ(document().settings, settings);
    EXPECT_EQ(document().camera, camera);
    EXPECT_EQ(document().cursor_mm, glm::dvec3(1, 2, 3));
    EXPECT_FALSE(window->documents()->history().can_undo());
}

TEST_F(SessionTest, ASaveThatEndsAfterOtherDataWasOpenedIsNotThatDatasSession) {
    open(k_casting);
    changeThings();
    const Document other = make_document("sample:spheres@24", open_volume("sample:spheres@24"));
    const QString file = folder.filePath(QStringLiteral("a.lacuna"));
    QSignalSpy saved(session(), &SessionFeature::saved);
    session()->saveTo(file);
    window->documents()->open(other);
    window->bench()->edit(QStringLiteral("Isovalue"), [](ViewSettings& s) { s.iso = 99; });
    ASSERT_TRUE(saved.count() > 0 || saved.wait(k_patience_ms));
    EXPECT_EQ(load_session(file.toStdString()).input, k_casting.toStdString());
    QVariantMap state;
    Q_EMIT window->bench()->stateWanted(state);
    EXPECT_EQ(state[QStringLiteral("session/file")].toString(), QString())
        << "Save would write over the other's session";
    EXPECT_TRUE(window->isWindowModified());
}

TEST_F(SessionTest, WhatChangesDuringASaveIsNotSaved) {
    open(k_casting);
    QSignalSpy saved(session(), &SessionFeature::saved);
    session()->saveTo(folder.filePath(QStringLiteral("a.lacuna")));
    changeThings();
    ASSERT_TRUE(saved.wait(k_patience_ms));
    EXPECT_TRUE(window->isWindowModified());
}

TEST_F(SessionTest, ClosingTheWindowDoesNotLoseASave) {
    open(k_casting);
    // Large enough that its voxels' hash, which is saved too, is not there at once.
    window->documents()->open(make_document("sample:spheres@400", open_volume("sample:spheres@400")));
    changeThings();
    const QString file = folder.filePath(QStringLiteral("a.lacuna"));
    session()->autosave();
    session()->saveTo(file);
    window->close();
    window.reset();
    ASSERT_TRUE(QFile::exists(file));
    EXPECT_EQ(load_session(file.toStdString()).settings.iso, 1234.5);
    EXPECT_TRUE(SessionFeature::autosaveFolder().entryList({QStringLiteral("autosave-*.lacuna")}).isEmpty());
}

TEST_F(SessionTest, WhatIsBeingKeptWhenOtherDataIsOpenedBecomesTheLastSession) {
    open(k_casting);
    changeThings();
    const Document other = make_document("sample:spheres@24", open_volume("sample:spheres@24"));
    QSignalSpy kept(session(), &SessionFeature::autosaved);
    session()->autosave();
    window->documents()->open(other);
    ASSERT_TRUE(kept.count() > 0 || kept.wait(k_patience_ms));
    ASSERT_TRUE(QFile::exists(SessionFeature::lastFile()));
    const Session last = load_session(SessionFeature::lastFile().toStdString());
    EXPECT_EQ(last.input, k_casting.toStdString());
    EXPECT_EQ(last.settings.iso, 1234.5);
    EXPECT_TRUE(SessionFeature::autosaveFolder().entryList({QStringLiteral("autosave-*.lacuna")}).isEmpty())
        << "after a crash the other data's session would be taken for this";
}

TEST_F(SessionTest, ASecondSaveDoesNotReplaceOneThatStillRuns) {
    open(k_casting);
    // Large enough that the first still hashes its voxels when the others come.
    window->documents()->open(make_document("sample:spheres@200", open_volume("sample:spheres@200")));
    changeThings();
    const QString first = folder.filePath(QStringLiteral("first.lacuna"));
    const QString second = folder.filePath(QStringLiteral("second.lacuna"));
    const auto iso = [this](double value) {
        window->bench()->edit(QStringLiteral("Isovalue"), [value](ViewSettings& s) { s.iso = value; });
    };
    QSignalSpy saved(session(), &SessionFeature::saved);
    session()->saveTo(first);
    iso(11);
    session()->saveTo(second);
    iso(12);
    session()->saveTo(second);  // takes the place of the one that waits for the same file
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved.count() == 2; }, k_patience_ms));
    EXPECT_EQ(load_session(first.toStdString()).settings.iso, 1234.5);
    EXPECT_EQ(load_session(second.toStdString()).settings.iso, 12);
    EXPECT_EQ(saved.at(0).at(0).toString(), first);
    EXPECT_EQ(saved.at(1).at(0).toString(), second);
    EXPECT_FALSE(window->isWindowModified());
    QVariantMap state;
    Q_EMIT window->bench()->stateWanted(state);
    EXPECT_EQ(state[QStringLiteral("session/file")].toString(), second);
}

TEST_F(SessionTest, ClosingTheWindowLosesNoneOfSeveralSaves) {
    open(k_casting);
    window->documents()->open(make_document("sample:spheres@300", open_volume("sample:spheres@300")));
    changeThings();
    const QString first = folder.filePath(QStringLiteral("first.lacuna"));
    const QString second = folder.filePath(QStringLiteral("second.lacuna"));
    session()->saveTo(first);
    window->bench()->edit(QStringLiteral("Isovalue"), [](ViewSettings& s) { s.iso = 11; });
    session()->saveTo(second);
    window->close();
    window.reset();
    ASSERT_TRUE(QFile::exists(first));
    ASSERT_TRUE(QFile::exists(second));
    EXPECT_EQ(load_session(first.toStdString()).settings.iso, 1234.5);
    EXPECT_EQ(load_session(second.toStdString()).settings.iso, 11);
}

TEST_F(SessionTest, IsNotShownOnDataThatWasOpenedOtherwiseMeanwhile) {
    const QString data = writeData(10);
    open(data);
    changeThings();
    const QString file = folder.filePath(QStringLiteral("a.lacuna"));
    save(file);
    anotherWindow();
    // The same file with a spacing given by hand: as another series of the same folder would be.
    QObject::connect(
        window->loader(), &LoadController::started, window.get(),
        [&] {
            OpenOptions options;
            options.spacing_mm = glm::dvec3(2);
            window->loader()->open(data, options);
        },
        Qt::SingleShotConnection);
    QSignalSpy finished(window->loader(), &LoadController::finished);
    session()->openFile(file);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    ASSERT_TRUE(window->documents()->hasDocument());
    EXPECT_EQ(document().volume.geometry().spacing, glm::dvec3(2));
    EXPECT_NE(document().settings.iso, 1234.5);
}

TEST_F(SessionTest, BringsAnInspectionAndItsDecisionsBack) {
    open(k_casting);
    QSignalSpy inspected(window->inspection(), &InspectionFeature::finished);
    window->inspection()->inspect(window->inspection()->panel()->form()->criteria().detection);
    ASSERT_TRUE(inspected.wait(k_patience_ms));
    ASSERT_TRUE(document().inspection);
    const std::size_t defects = document().inspection->defects.size();
    ASSERT_GE(defects, 1u);
    window->inspection()->panel()->decide(1, false, QStringLiteral("too near to the thread"));
    const QString file = folder.filePath(QStringLiteral("b.lacuna"));
    save(file);
    anotherWindow();
    QSignalSpy again(window->inspection(), &InspectionFeature::finished);
    reopen(file);
    ASSERT_TRUE(again.count() > 0 || again.wait(k_patience_ms));
    ASSERT_TRUE(document().inspection);
    EXPECT_EQ(document().inspection->defects.size(), defects);
    const auto& by_hand = window->inspection()->panel()->judgement().by_hand;
    ASSERT_EQ(by_hand.size(), 1u);
    EXPECT_EQ(by_hand[0].reason, "too near to the thread");
    EXPECT_FALSE(window->isWindowModified());  // it is what the file holds
    window->inspection()->panel()->decide(1, true, QStringLiteral("seen by eye"));
    EXPECT_TRUE(window->isWindowModified());
}

TEST_F(SessionTest, DecisionsAreNotTakenForDefectsOfAnotherInspection) {
    open(k_casting);
    QSignalSpy inspected(window->inspection(), &InspectionFeature::finished);
    DetectionOptions options = window->inspection()->panel()->form()->criteria().detection;
    window->inspection()->inspect(options);
    ASSERT_TRUE(inspected.wait(k_patience_ms));
    ASSERT_TRUE(document().inspection);
    ASSERT_GE(document().inspection->defects.size(), 1u);
    window->inspection()->panel()->decide(1, false, QStringLiteral("too near to the thread"));
    window->regions()->compute();
    QSignalSpy found(window->regions(), &RegionsFeature::finished);
    ASSERT_TRUE(found.wait(k_patience_ms));
    window->regions()->select(1);
    ASSERT_EQ(document().selected_region, 1u);
    const QString file = folder.filePath(QStringLiteral("d.lacuna"));
    save(file);
    anotherWindow();
    // Somebody inspects anew before the session's own inspection has come to its end.
    options.min_voxels += 1;
    QObject::connect(session(), &SessionFeature::restored, window.get(), [&] {
        window->inspection()->inspect(options);
        window->regions()->compute();
    });
    QSignalSpy anew(window->inspection(), &InspectionFeature::finished);
    QSignalSpy regions(window->regions(), &RegionsFeature::finished);
    reopen(file);
    ASSERT_TRUE(anew.count() > 0 || anew.wait(k_patience_ms));
    ASSERT_TRUE(regions.count() > 0 || regions.wait(k_patience_ms));
    ASSERT_TRUE(document().inspection);
    EXPECT_EQ(document().inspection->options.min_voxels, options.min_voxels);
    ASSERT_GE(document().inspection->defects.size(), 1u);
    EXPECT_TRUE(window->inspection()->panel()->judgement().by_hand.empty());
    EXPECT_EQ(document().selected_region, 0u);
}

TEST_F(SessionTest, BringsRegionsTheirOptionsAndTheChosenRowBack) {
    open(k_casting);
    RegionOptions options;
    options.threshold = ValueRange{document().settings.iso, document().statistics->range.hi};
    options.connectivity = Connectivity::c18;
    options.min_voxels = 3;
    options.merge_slivers = true;  // the panel has no field for it
    window->regions()->panel()->setOptions(options);
    const RegionOptions asked = window->regions()->panel()->options();
    QSignalSpy found(window->regions(), &RegionsFeature::finished);
    window->regions()->compute();
    ASSERT_TRUE(found.wait(k_patience_ms));
    ASSERT_TRUE(document().regions);
    ASSERT_GE(document().regions->rows.size(), 1u);
    const std::size_t rows = document().regions->rows.size();
    window->regions()->select(1);
    ASSERT_EQ(document().selected_region, 1u);
    window->documents()->setCursor({1, 2, 3});
    const QString file = folder.filePath(QStringLiteral("r.lacuna"));
    save(file);
    anotherWindow();
    QSignalSpy again(window->regions(), &RegionsFeature::finished);
    reopen(file);
    ASSERT_TRUE(again.count() > 0 || again.wait(k_patience_ms));
    ASSERT_TRUE(document().regions);
    EXPECT_EQ(document().regions->rows.size(), rows);
    EXPECT_EQ(document().selected_region, 1u);
    EXPECT_EQ(document().cursor_mm, glm::dvec3(1, 2, 3));
    const RegionOptions back = window->regions()->panel()->options();
    EXPECT_EQ(back.threshold, asked.threshold);
    EXPECT_EQ(back.connectivity, Connectivity::c18);
    EXPECT_EQ(back.min_voxels, 3);
    EXPECT_TRUE(back.merge_slivers);
}

TEST_F(SessionTest, WhatACrashLeftIsOfferedAgain) {
    open(k_casting);
    changeThings();
    const ViewSettings settings = document().settings;
    QSignalSpy kept(session(), &SessionFeature::autosaved);
    session()->autosave();
    ASSERT_TRUE(kept.wait(k_patience_ms));
    // A crash leaves the autosave behind without the lock of a living process.
    const QStringList files = SessionFeature::autosaveFolder().entryList({QStringLiteral("autosave-*.lacuna")});
    ASSERT_EQ(files.size(), 1);
    const QString orphan = SessionFeature::autosaveFolder().filePath(QStringLiteral("autosave-crashed.lacuna"));
    ASSERT_TRUE(QFile::rename(SessionFeature::autosaveFolder().filePath(files.front()), orphan));
    anotherWindow();
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->messageBar()->answerButtons().size() == 2; }, k_patience_ms));
    QSignalSpy restored(session(), &SessionFeature::restored);
    QTest::mouseClick(window->messageBar()->answerButtons().front(), Qt::LeftButton);
    ASSERT_TRUE(restored.wait(k_patience_ms));
    EXPECT_EQ(document().settings, settings);
    EXPECT_FALSE(QFile::exists(orphan));
    EXPECT_TRUE(QFile::exists(SessionFeature::lastFile()));
}

TEST_F(SessionTest, AnAutosaveThatFailedIsTriedAgain) {
    open(k_casting);
    QSignalSpy kept(session(), &SessionFeature::autosaved);
    session()->autosave();
    ASSERT_TRUE(kept.wait(k_patience_ms));
    const QDir autosaves = SessionFeature::autosaveFolder();
    const QStringList files = autosaves.entryList({QStringLiteral("autosave-*.lacuna")});
    ASSERT_EQ(files.size(), 1);
    // What no file can take the place of, until it is gone.
    ASSERT_TRUE(QFile::remove(autosaves.filePath(files.front())));
    ASSERT_TRUE(autosaves.mkpath(files.front() + QStringLiteral("/full")));
    changeThings();
    session()->autosave();
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return window->messageBar()->text().contains(QStringLiteral("Cannot write")); }, k_patience_ms));
    ASSERT_TRUE(QDir(autosaves.filePath(files.front())).removeRecursively());
    session()->autosave();  // as the timer would
    ASSERT_TRUE(kept.count() == 2 || kept.wait(5000));
    EXPECT_EQ(load_session(autosaves.filePath(files.front()).toStdString()).settings.iso, 1234.5);
}

TEST_F(SessionTest, ALivingWindowsAutosaveIsLeftAlone) {
    open(k_casting);
    changeThings();
    QSignalSpy kept(session(), &SessionFeature::autosaved);
    session()->autosave();
    ASSERT_TRUE(kept.wait(k_patience_ms));
    MainWindow second([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
    second.show();
    QTest::qWait(50);
    EXPECT_TRUE(second.messageBar()->answerButtons().isEmpty());
    window->close();
    EXPECT_TRUE(SessionFeature::autosaveFolder().entryList({QStringLiteral("autosave-*.lacuna")}).isEmpty());
}

TEST_F(SessionTest, LocksOfProgramsThatAreGoneAreRemoved) {
    QProcess gone;
    gone.start(QStringLiteral("true"), {});
    ASSERT_TRUE(gone.waitForStarted());
    const qint64 pid = gone.processId();
    ASSERT_TRUE(gone.waitForFinished());
    const QDir folder = SessionFeature::autosaveFolder();
    const auto lock_of = [&](const char* name, qint64 owner) {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::number(owner) + '\n' + QCoreApplication::applicationName().toUtf8() + '\n' +
                   QSysInfo::machineHostName().toUtf8() + "\n" + QSysInfo::machineUniqueId() + '\n' +
                   QSysInfo::bootUniqueId() + '\n');
        return file.fileName();
    };
    const QString stale = lock_of("autosave-gone.lock", pid);
    QLockFile living(folder.filePath(QStringLiteral("autosave-living.lock")));
    living.setStaleLockTime(0);
    ASSERT_TRUE(living.tryLock(0));
    const QString other = lock_of("other.lock", pid);
    const auto locks = [&] { return folder.entryList({QStringLiteral("autosave-*.lock")}, QDir::Files).size(); };
    ASSERT_EQ(locks(), 3);  // this window's, too
    MainWindow second([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !QFile::exists(stale); }, k_patience_ms));
    EXPECT_EQ(locks(), 3) << "those of the two windows, and the living one's";
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("autosave-living.lock"))));
    EXPECT_TRUE(QFile::exists(other)) << "none of ours";
    QFile::remove(other);
}

TEST_F(SessionTest, MovedOrChangedDataIsSaidAndNothingIsLost) {
    const QString data = writeData(10);
    open(data);
    changeThings();
    const QString file = folder.filePath(QStringLiteral("c.lacuna"));
    save(file);
    writeData(20);
    reopen(file);
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return window->messageBar()->text().contains(QStringLiteral("not the same")); }, k_patience_ms));
    ASSERT_TRUE(QFile::rename(data, folder.filePath(QStringLiteral("gone.mhd"))));
    window->openInput(file);
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return window->messageBar()->text().contains(QStringLiteral("not where it was")); }, k_patience_ms));
    EXPECT_EQ(window->messageBar()->answerButtons().size(), 2);
    EXPECT_TRUE(window->documents()->hasDocument());
    EXPECT_EQ(document().settings.iso, 1234.5);
}

}  // namespace
}  // namespace lacuna::ui::test
