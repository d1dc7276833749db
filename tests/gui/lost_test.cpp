// What goes away under the window: the display, the data of a session, the format of a file. Each is said, and the work
// so far is kept.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "core/base/atomic_file.h"
#include "core/io/volume_writer.h"
#include "core/volume/samples.h"
#include "ui/features/presets_feature.h"
#include "window_fixture.h"

namespace lacuna::ui::test {
namespace {

class LostTest : public WindowTest {
protected:
    void SetUp() override {
        if (qEnvironmentVariableIsEmpty("LACUNA_TEST_HOME"))
            for (const QFileInfo& file : SessionFeature::autosaveFolder().entryInfoList(QDir::Files))
                QFile::remove(file.filePath());
        WindowTest::SetUp();
    }
    void TearDown() override { QDir(QString::fromStdString(PresetsFeature::folder())).removeRecursively(); }
    QString said() const { return window->messageBar()->text(); }
    void changeThings() {
        window->bench()->edit(QStringLiteral("Isovalue"), [](ViewSettings& s) { s.iso = 1234.5; });
        window->documents()->endGesture();
    }
    QString file(const char* name) const { return folder.filePath(QLatin1String(name)); }
    static QByteArray bytes(const QString& name) {
        QFile in(name);
        EXPECT_TRUE(in.open(QIODevice::ReadOnly)) << name.toStdString();
        return in.readAll();
    }
    void save(const QString& name) {
        QSignalSpy saved(window->session(), &SessionFeature::saved);
        window->session()->saveTo(name);
        ASSERT_TRUE(saved.wait(k_patience_ms)) << said().toStdString();
    }
    void writeData(const QString& name, int size, float value) {
        GridGeometry geometry;
        geometry.size = glm::ivec3(size);
        write_volume(make_volume<float>(geometry,
                                        [value](std::span<float> voxels) {
                                            std::fill(voxels.begin(), voxels.end(), value);
                                            voxels[5] = value + 1;
                                        }),
                     name.toStdString());
    }
    QTemporaryDir folder;
};

/// The other process of the next test: works, says so, and waits for its display to go.
TEST_F(LostTest, DISABLED_WorksUntilItsDisplayGoes) {
    open(k_casting);
    changeThings();
    window->documents()->setCursor({1, 2, 3});
    puts("worked");
    fflush(stdout);
    QTest::qWait(k_patience_ms);
}

TEST_F(LostTest, ADisplayThatGoesAwayTakesNoWorkAlong) {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("Xvfb"));
    if (program.isEmpty()) GTEST_SKIP() << "there is no Xvfb here";
    QProcess display;
    display.start(program,
                  {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"), QStringLiteral("0"),
                   QStringLiteral("1200x900x24"), QStringLiteral("-nolisten"), QStringLiteral("tcp")});
    QByteArray number;
    while (!number.contains('\n') && display.waitForReadyRead(k_patience_ms)) number += display.readAllStandardOutput();
    ASSERT_TRUE(number.contains('\n')) << display.readAllStandardError().toStdString();
    QProcess other;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    environment.insert(QStringLiteral("DISPLAY"), QStringLiteral(":") + QString::fromLatin1(number.trimmed()));
    environment.insert(QStringLiteral("LACUNA_TEST_HOME"), qEnvironmentVariable("XDG_DATA_HOME"));
    other.setProcessEnvironment(environment);
    other.setProcessChannelMode(QProcess::MergedChannels);
    other.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("--gtest_also_run_disabled_tests"),
                 QStringLiteral("--gtest_filter=LostTest.DISABLED_WorksUntilItsDisplayGoes")});
    QByteArray heard;
    while (!heard.contains("worked\n") && other.waitForReadyRead(k_patience_ms)) heard += other.readAll();
    ASSERT_TRUE(heard.contains("worked\n")) << heard.toStdString();
    display.kill();
    display.waitForFinished();
    ASSERT_TRUE(other.waitForFinished(k_patience_ms)) << "it outlives its display";
    EXPECT_NE(other.exitCode(), 0);

    window.reset();
    WindowTest::SetUp();
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->messageBar()->answerButtons().size() == 2; }, k_patience_ms))
        << heard.toStdString() << other.readAll().toStdString();
    QSignalSpy restored(window->session(), &SessionFeature::restored);
    QTest::mouseClick(window->messageBar()->answerButtons().front(), Qt::LeftButton);
    ASSERT_TRUE(restored.wait(k_patience_ms)) << said().toStdString();
    EXPECT_EQ(document().settings.iso, 1234.5);
    EXPECT_EQ(document().cursor_mm, glm::dvec3(1, 2, 3));
}

TEST_F(LostTest, WorkIsKeptSoonAfterTheHandRests) {
    open(k_casting);
    QSignalSpy kept(window->session(), &SessionFeature::autosaved);
    changeThings();
    ASSERT_TRUE(kept.count() > 0 || kept.wait(k_patience_ms));  // long before the interval of minutes
    const QStringList files = SessionFeature::autosaveFolder().entryList({QStringLiteral("autosave-*.lacuna")});
    ASSERT_EQ(files.size(), 1);
    EXPECT_EQ(load_session(SessionFeature::autosaveFolder().filePath(files.front()).toStdString()).settings.iso,
              1234.5);
}

TEST_F(LostTest, DataOfAnotherSizeIsOpenedAndTheSessionFileKept) {
    writeData(file("part.mhd"), 16, 10);
    open(file("part.mhd"));
    changeThings();
    save(file("a.lacuna"));
    const QByteArray session = bytes(file("a.lacuna"));
    writeData(file("part.mhd"), 12, 10);
    QSignalSpy opened(window->documents(), &DocumentController::opened);
    window->openInput(file("a.lacuna"));
    ASSERT_TRUE(opened.count() > 0 || opened.wait(k_patience_ms));
    EXPECT_TRUE(said().contains(QStringLiteral("16x16x16"))) << said().toStdString();
    EXPECT_EQ(document().volume.geometry().size, glm::ivec3(12));
    EXPECT_NE(document().settings.iso, 1234.5);
    EXPECT_EQ(bytes(file("a.lacuna")), session);
}

TEST_F(LostTest, DataThatCannotBeReadAnyMoreLeavesWhatIsOpen) {
    writeData(file("part.mhd"), 16, 10);
    open(file("part.mhd"));
    changeThings();
    save(file("a.lacuna"));
    for (const QFileInfo& one :
         QDir(folder.path()).entryInfoList({QStringLiteral("part*.raw"), QStringLiteral("part*.zraw")}))
        QFile::remove(one.filePath());
    QFile header(file("part.mhd"));
    ASSERT_TRUE(header.open(QIODevice::WriteOnly));
    header.write("NDims = 3\n");
    header.close();
    QSignalSpy failed(window->loader(), &LoadController::failed);
    window->openInput(file("a.lacuna"));
    ASSERT_TRUE(failed.count() > 0 || failed.wait(k_patience_ms));
    EXPECT_TRUE(window->messageBar()->isVisible());
    EXPECT_EQ(document().settings.iso, 1234.5);
    EXPECT_TRUE(window->documents()->history().can_undo());
}

TEST_F(LostTest, ASessionOfANewerVersionIsRefusedByNameAndNothingHappens) {
    open(k_casting);
    changeThings();
    write_file(file("new.lacuna").toStdString(), "{\"lacuna_session\":99,\"holograms\":[]}");
    window->openInput(file("new.lacuna"));
    ASSERT_TRUE(QTest::qWaitFor([this] { return said().contains(QStringLiteral("new.lacuna")); }, k_patience_ms));
    EXPECT_TRUE(said().contains(QStringLiteral("newer"))) << said().toStdString();
    EXPECT_EQ(document().settings.iso, 1234.5);
    EXPECT_TRUE(window->documents()->history().can_undo());
}

TEST_F(LostTest, APresetOfAnotherVersionIsListedWithItsFaultAndLeftAsItIs) {
    open(k_casting);
    changeThings();
    const ViewSettings before = document().settings;
    const std::string newer =
        R"({"version":7,"name":"of tomorrow","points":[{"value":0,"color":[1,1,1],"opacity":0}]})";
    const std::filesystem::path kept = PresetsFeature::folder() / "of tomorrow.json";
    std::filesystem::create_directories(PresetsFeature::folder());
    write_file(kept, newer);
    write_file(file("elsewhere.json").toStdString(), newer);
    auto* presets = window->findChild<PresetsFeature*>();
    presets->importFile(file("elsewhere.json"));
    ASSERT_TRUE(QTest::qWaitFor([this] { return said().contains(QStringLiteral("version")); }, k_patience_ms));
    presets->showGallery();
    bool listed = false;
    for (const PresetEntry& entry : list_presets(PresetsFeature::folder()))
        if (!entry.built_in()) {
            listed = true;
            EXPECT_NE(entry.fault.find("version"), std::string::npos) << entry.fault;
            presets->apply(entry);
        }
    EXPECT_TRUE(listed);
    EXPECT_EQ(document().settings, before);
    EXPECT_EQ(read_file(kept, 1 << 16), newer);
    // One of the first version, without a word of versions, is as good as ever.
    write_file(file("old.json").toStdString(),
               R"({"name":"of old","unit_distance_mm":1,"points":[{"value":0,"color":[1,1,1],"opacity":0.5}]})");
    QSignalSpy imported(presets, &PresetsFeature::imported);
    presets->importFile(file("old.json"));
    ASSERT_TRUE(imported.wait(k_patience_ms)) << said().toStdString();
    for (const PresetEntry& entry : list_presets(PresetsFeature::folder()))
        if (entry.name == "of old") presets->apply(entry);
    EXPECT_EQ(document().settings.tf.name, "of old");
}

}  // namespace
}  // namespace lacuna::ui::test
