// What leaves the window as a file.
#include <QClipboard>
#include <QDir>
#include <QTemporaryDir>

#include "core/accuracy/error_bound.h"
#include "core/io/volume_reader.h"
#include "core/render/turn.h"
#include "ui/turntable.h"
#include "window_fixture.h"

namespace lacuna::ui::test {
namespace {

class ExportTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        open(k_casting);
    }
    ExportFeature* exports() const { return window->exports(); }
    QString path(const char* name) const { return folder.filePath(QLatin1String(name)); }
    /// Runs an export and waits until its file is told.
    template <class Start>
    bool wrote(Start&& start) {
        QSignalSpy written(exports(), &ExportFeature::written);
        start();
        return written.count() > 0 || written.wait(k_patience_ms);
    }
    QTemporaryDir folder;
};

TEST_F(ExportTest, ThePictureIsTheOneShown) {
    ASSERT_TRUE(wrote([this] { exports()->savePicture(path("a.png"), false); }));
    EXPECT_EQ(QImage(path("a.png")).size(), picture().size());
    EXPECT_LT(difference(QImage(path("a.png")), picture()), 0.001);
    window->views()->slice(SliceKind::axial)->setFocus();
    ASSERT_TRUE(wrote([this] { exports()->savePicture(path("b.png"), true); }));
    ASSERT_TRUE(wrote([this] { exports()->savePicture(path("c.png"), false); }));
    const QImage with(path("b.png")), without(path("c.png"));
    EXPECT_EQ(with.size(), without.size());
    EXPECT_GT(difference(with, without), 0.001);
}

TEST_F(ExportTest, ATiffHoldsTheSamePictureAsAPng) {
    ASSERT_TRUE(wrote([&] { exports()->savePicture(path("first.png"), true); }));  // the bar that says so takes room
    for (const bool annotated : {false, true}) {
        window->views()->slice(SliceKind::coronal)->setFocus();
        ASSERT_TRUE(wrote([&] { exports()->savePicture(path("a.png"), annotated); }));
        ASSERT_TRUE(wrote([&] { exports()->savePicture(path("a.tif"), annotated); }))
            << window->messageBar()->text().toStdString();
        const QImage png(path("a.png")), tiff(path("a.tif"));
        ASSERT_FALSE(tiff.isNull());
        EXPECT_EQ(tiff.convertToFormat(QImage::Format_RGB32), png.convertToFormat(QImage::Format_RGB32)) << annotated;
    }
}

TEST_F(ExportTest, AnEndingThatIsNoPictureIsSaid) {
    exports()->savePicture(path("a.bmp"), true);
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->messageBar()->text().contains(QStringLiteral(".png")); },
                                k_patience_ms));
    EXPECT_FALSE(QFile::exists(path("a.bmp")));
}

TEST_F(ExportTest, ATurntableTurnsOnce) {
    window->bench()->edit(QStringLiteral("Mode"), [](ViewSettings& s) { s.mode = ViewMode::mip; });
    settle();
    ASSERT_TRUE(wrote([this] { exports()->saveTurntable(path("turn.png"), 4); }));
    EXPECT_EQ(QDir(folder.path()).entryList({QStringLiteral("turn-*.png")}).size(), 4);
    const QImage front(path("turn-000.png")), side(path("turn-001.png"));
    EXPECT_GT(lit(front), 0.02);
    EXPECT_GT(difference(front, side), 0.01);
}

TEST_F(ExportTest, ATurntableKeepsTheBudgetInEveryPicture) {
    static constexpr double k_budget = 4;
    window->resize(760, 620);
    open(QStringLiteral("sample:spheres@24"));
    window->bench()->edit(QStringLiteral("Budget"), [](ViewSettings& s) { s.quality.error_budget = k_budget; });
    ASSERT_TRUE(wrote([this] { exports()->saveTurntable(path("turn.png"), 5); }))
        << window->messageBar()->text().toStdString();
    Scene scene = scene_of(document());
    const Plan brute = brute_force(scene, document().settings.quality.step);
    const std::vector<Camera> views = full_turn(scene.camera, 5);
    for (int i = 0; i < 5; ++i) {
        const QImage drawn =
            QImage(folder.filePath(QStringLiteral("turn-00%1.png").arg(i))).convertToFormat(QImage::Format_RGB888);
        ASSERT_FALSE(drawn.isNull()) << i;
        scene.camera = views[std::size_t(i)];
        scene.size = {drawn.width(), drawn.height()};
        const std::vector<std::uint8_t> truth =
            to_rgb8(window->bench()->engine()->render(scene, brute).frame, glm::dvec3(0));
        int largest = 0;
        for (int y = 0; y < drawn.height(); ++y)
            for (int x = 0; x < 3 * drawn.width(); ++x)
                largest = std::max(
                    largest, std::abs(int(drawn.constScanLine(y)[x]) -
                                      int(truth[std::size_t(y) * 3 * std::size_t(drawn.width()) + std::size_t(x)])));
        EXPECT_LE(largest, k_budget + 1) << i << ": both are rounded";
    }
}

TEST_F(ExportTest, ATurntableIsAFilmWhereFfmpegIs) {
    if (film_encoder().isEmpty()) GTEST_SKIP() << "ffmpeg is not installed";
    ASSERT_TRUE(wrote([this] { exports()->saveTurntable(path("turn.webm"), 3); }))
        << window->messageBar()->text().toStdString();
    EXPECT_GT(QFileInfo(path("turn.webm")).size(), 500);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

TEST_F(ExportTest, SurfaceAndVolumeAreWritten) {
    ASSERT_TRUE(wrote([this] { exports()->saveMesh(path("surface.stl")); }));
    EXPECT_GT(QFileInfo(path("surface.stl")).size(), 1000);
    ASSERT_TRUE(wrote([this] { exports()->saveVolume(path("volume.nrrd")); }));
    EXPECT_EQ(voxel_sha256(open_volume(path("volume.nrrd").toStdString())), voxel_sha256(document().volume));
}

TEST_F(ExportTest, OneExportDoesNotEndAnother) {
    QSignalSpy written(exports(), &ExportFeature::written);
    exports()->saveVolume(path("volume.nii.gz"));
    exports()->savePicture(path("a.png"), false);
    exports()->saveMesh(path("surface.stl"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 3; }, 10000)) << written.count();
    for (const char* name : {"volume.nii.gz", "a.png", "surface.stl"}) EXPECT_TRUE(QFile::exists(path(name))) << name;
}

TEST_F(ExportTest, ATurntableThatIsCancelledLeavesNothing) {
    QFile before(path("turn-000.png"));
    ASSERT_TRUE(before.open(QIODevice::WriteOnly) && before.write("mine") == 4);
    before.close();
    TaskList* tasks = window->bench()->tasks();
    QObject::connect(tasks, &TaskList::changed, window.get(), [tasks] {
        if (!tasks->rows().empty() && tasks->rows()[0].share > 0.3) tasks->cancelAll();
    });
    exports()->saveTurntable(path("turn.png"), 24);
    ASSERT_TRUE(QTest::qWaitFor([tasks] { return tasks->rows().empty(); }, k_patience_ms));
    window.reset();  // waits for the work to notice
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{QStringLiteral("turn-000.png")});
    EXPECT_EQ(QFileInfo(path("turn-000.png")).size(), 4);
}

TEST_F(ExportTest, TheClipboardGetsTheView) {
    exports()->copyPicture();
    EXPECT_FALSE(QGuiApplication::clipboard()->image().isNull());
}

}  // namespace
}  // namespace lacuna::ui::test
