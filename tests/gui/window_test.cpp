#include <QAccessible>
#include <QDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QTabBar>
#include <QTemporaryDir>
#include <algorithm>

#include "core/io/volume_writer.h"
#include "core/volume/samples.h"
#include "tests/gui/window_fixture.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

TEST_F(WindowTest, AWrongPathIsSaidInTheMessageBar) {
    QSignalSpy finished(window->loader(), &LoadController::finished);
    window->openInput(QStringLiteral("no/such/folder"));
    ASSERT_TRUE(finished.wait(k_patience_ms));
    EXPECT_FALSE(window->documents()->hasDocument());
    EXPECT_TRUE(window->messageBar()->isVisible());
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("no/such/folder")));
    EXPECT_FALSE(window->statusLine()->cancelButton()->isVisible());
}

TEST_F(WindowTest, ALoadCanBeCancelled) {
    QSignalSpy cancelled(window->loader(), &LoadController::cancelled);
    window->openInput(QStringLiteral("sample:casting@600"));
    ASSERT_TRUE(window->statusLine()->cancelButton()->isVisible());
    QTest::mouseClick(window->statusLine()->cancelButton(), Qt::LeftButton);
    EXPECT_EQ(cancelled.count(), 1);
    EXPECT_FALSE(window->statusLine()->cancelButton()->isVisible());
    QElapsedTimer clock;
    clock.start();
    open(k_casting);  // waits for the cancelled work to let go, then works as ever
    EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("casting")));
}

TEST_F(WindowTest, EveryModeDrawsAnotherPicture) {
    open(k_casting);
    std::vector<QImage> pictures;
    for (int mode = 1; mode <= 7; ++mode) {
        QTest::keyClick(window->views()->volumeView(), Qt::Key(Qt::Key_0 + mode));
        ASSERT_EQ(document().settings.mode, mode_names()[std::size_t(mode - 1)].mode);
        settle();
        const bool dark = document().settings.mode == ViewMode::minip;  // air all around: black is right
        EXPECT_GT(lit(picture()), dark ? -1 : 0.02) << "mode " << mode;
        for (std::size_t other = 0; other < pictures.size(); ++other)
            EXPECT_GT(difference(picture(), pictures[other]), 0.001) << "modes " << mode << " and " << other + 1;
        pictures.push_back(picture());
    }
    EXPECT_FALSE(window->messageBar()->isVisible()) << window->messageBar()->text().toStdString();
}

TEST_F(WindowTest, MovingGivesCoarseFramesAndRestAFullOne) {
    open(k_casting);
    ViewSettings slow = document().settings;
    slow.quality.step = 0.05;  // too slow to be drawn in full while moving
    window->documents()->edit(QStringLiteral("Quality"), slow);
    settle();
    std::vector<bool> coarse;
    const auto listen =
        QObject::connect(window->scheduler(), &FrameScheduler::frameReady, window.get(),
                         [&](const QImage&, const FrameFacts& facts) { coarse.push_back(facts.coarse); });
    for (int i = 0; i < 30; ++i) {
        QTest::keyClick(window->views()->volumeView(), Qt::Key_Left);
        QTest::qWait(5);
    }
    settle();
    QObject::disconnect(listen);
    ASSERT_GE(coarse.size(), 2u);
    EXPECT_LE(coarse.size(), 31u);
    EXPECT_TRUE(coarse.front());
    EXPECT_FALSE(coarse.back());
    EXPECT_EQ(std::count(coarse.begin(), coarse.end(), false), 1);
    EXPECT_EQ(document().camera.azimuth_deg, 150);
}

TEST_F(WindowTest, TheCameraTurnsByMouseAndKeysAndComesBack) {
    open(k_casting);
    QTest::keyClick(window->views()->volumeView(), Qt::Key_1);
    settle();
    const QImage front = picture();
    VolumeView* view = window->views()->volumeView();
    drag(view, view->rect().center(), view->rect().center() + QPoint(90, 30));
    EXPECT_NE(document().camera.azimuth_deg, 0);
    settle();
    EXPECT_GT(difference(picture(), front), 0.01);
    QTest::keyClick(view, Qt::Key_0);
    settle();
    EXPECT_EQ(difference(picture(), front), 0);
    QTest::keyClick(view, Qt::Key_L);
    EXPECT_EQ(document().camera.azimuth_deg, 90);
    QTest::keyClick(view, Qt::Key_Left);
    EXPECT_EQ(document().camera.azimuth_deg, 95);
    QTest::keyClick(view, Qt::Key_Plus);
    EXPECT_GT(document().camera.zoom, 1);
    QTest::keyClick(view, Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_TRUE(document().camera.center_mm.has_value());
}

TEST_F(WindowTest, ARangeHandleChangesThePicture) {
    open(k_casting);
    QTest::keyClick(window->views()->volumeView(), Qt::Key_3);
    window->tabs()->setCurrentWidget(window->rangesPanel());
    QTest::mouseClick(window->rangesPanel()->addButton(), Qt::LeftButton);
    ASSERT_EQ(document().settings.ranges.size(), 1u);
    settle();
    const QImage before = picture();
    const ValueRange range_before = document().settings.ranges[0].range.range;
    RangeSlider* slider = window->rangesPanel()->row(0)->slider();
    QApplication::sendPostedEvents();
    ASSERT_GT(slider->width(), 60);
    const QPointF from = slider->handlePosition(1);
    drag(slider, from, {slider->handlePosition(0).x() + 12, from.y()});
    const ValueRange range_after = document().settings.ranges[0].range.range;
    EXPECT_LT(range_after.hi, range_before.hi);
    EXPECT_EQ(range_after.lo, range_before.lo);
    settle();
    EXPECT_GT(difference(picture(), before), 0.001);
    QTest::keyClick(window->views()->volumeView(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().settings.ranges[0].range.range, range_before);
    settle();
    EXPECT_EQ(difference(picture(), before), 0);
}

TEST_F(WindowTest, ACutChangesThePicture) {
    open(k_casting);
    QTest::keyClick(window->views()->volumeView(), Qt::Key_1);
    settle();
    const QImage whole = picture();
    window->tabs()->setCurrentWidget(window->cutsPanel());
    QTest::mouseClick(window->cutsPanel()->addButton(), Qt::LeftButton);
    ASSERT_EQ(document().settings.cuts.size(), 1u);
    settle();
    const QImage cut = picture();
    EXPECT_GT(difference(cut, whole), 0.01);
    window->cutsPanel()->offsetSlider()->slider()->triggerAction(QAbstractSlider::SliderPageStepAdd);
    settle();
    EXPECT_GT(difference(picture(), cut), 0.001);
    window->cutsPanel()->list()->item(0)->setCheckState(Qt::Unchecked);
    EXPECT_FALSE(document().settings.cuts[0].enabled);
    settle();
    EXPECT_EQ(difference(picture(), whole), 0);
}

TEST_F(WindowTest, ATransferPointChangesThePictureAndUndoBringsItBack) {
    open(k_casting);
    const QImage before = picture();
    const TransferFunction function = document().settings.tf;
    TransferPlot* plot = window->transferPanel()->plot();
    int top = 0;  // the first point that is rather opaque: the material lies behind it
    while (top + 1 < int(function.points.size()) && function.points[std::size_t(top)].opacity < 0.5) ++top;
    const QPointF from = plot->pointPosition(top);
    drag(plot, from, {from.x(), plot->height() - 30.0});
    EXPECT_EQ(plot->selected(), top);
    EXPECT_LT(document().settings.tf.points[std::size_t(top)].opacity, function.points[std::size_t(top)].opacity);
    settle();
    EXPECT_GT(difference(picture(), before), 0.005);
    EXPECT_EQ(window->documents()->history().undo_name(), "Transfer function");
    QTest::keyClick(window->views()->volumeView(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().settings.tf, function);
    EXPECT_EQ(plot->function(), function);
    settle();
    EXPECT_EQ(difference(picture(), before), 0);
    QTest::keyClick(window->views()->volumeView(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(document().settings.tf == function);
}

TEST_F(WindowTest, ARegionRowHighlightsItsRegion) {
    open(k_casting);
    QSignalSpy finished(window->regions(), &RegionsFeature::finished);
    QTest::mouseClick(window->regions()->panel()->computeButton(), Qt::LeftButton);
    ASSERT_TRUE(finished.count() > 0 || finished.wait(k_patience_ms));
    ASSERT_TRUE(document().regions != nullptr);
    QTableView* table = window->regions()->panel()->table();
    ASSERT_GT(table->model()->rowCount(), 0);
    settle();
    const QImage before = picture();
    SliceView* axial = window->views()->slice(SliceKind::axial);
    QSignalSpy gathered(window->regions(), &RegionsFeature::gathered);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(0, 1)).center());
    ASSERT_TRUE(gathered.count() > 0 || gathered.wait(k_patience_ms));
    EXPECT_EQ(document().selected_region, 1u);
    EXPECT_EQ(document().cursor_mm, document().regions->rows[0].centroid_mm);
    ASSERT_TRUE(document().highlight != nullptr);
    settle();
    EXPECT_GT(difference(picture(), before), 0.005);
    const QImage tinted = axial->grab().toImage();
    table->clearSelection();
    EXPECT_EQ(document().selected_region, 0u);
    EXPECT_GT(difference(tinted, axial->grab().toImage()), 0.01);
    settle();
    EXPECT_EQ(difference(picture(), before), 0);
}

TEST_F(WindowTest, TheKeyboardAloneDoesTheJob) {
    QSignalSpy finished(window->loader(), &LoadController::finished);
    QTest::keyClick(window.get(), Qt::Key_5, Qt::ControlModifier | Qt::AltModifier);
    ASSERT_TRUE(finished.count() > 0 || finished.wait(k_patience_ms));
    ASSERT_TRUE(window->documents()->hasDocument());
    EXPECT_TRUE(document().input.find("marschner-lobb") != std::string::npos);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_4);
    EXPECT_EQ(document().settings.mode, ViewMode::lmip);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_6, Qt::ControlModifier);
    ASSERT_EQ(QApplication::focusWidget(), window->transferPanel()->plot());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_PageUp);
    const int chosen = window->transferPanel()->plot()->selected();
    const TransferFunction before = document().settings.tf;
    QTest::keyClick(QApplication::focusWidget(),
                    before.points[std::size_t(chosen)].opacity > 0.5 ? Qt::Key_Down : Qt::Key_Up);
    EXPECT_NE(document().settings.tf.points[std::size_t(chosen)].opacity, before.points[std::size_t(chosen)].opacity);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Insert);
    EXPECT_EQ(document().settings.tf.points.size(), before.points.size() + 1);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Delete);
    EXPECT_EQ(document().settings.tf.points.size(), before.points.size());
    QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(document().settings.ranges.size(), 1u);
    QTest::keyClick(window.get(), Qt::Key_X, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(document().settings.cuts.size(), 1u);
    QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
    SliceView* axial = window->views()->slice(SliceKind::axial);
    ASSERT_EQ(QApplication::focusWidget(), axial);
    const int page = axial->index();
    QTest::keyClick(axial, Qt::Key_PageUp);
    EXPECT_EQ(axial->index(), page + 1);
}

TEST_F(WindowTest, SlicesAreLinkedAndWindowed) {
    open(k_casting);
    SliceView* axial = window->views()->slice(SliceKind::axial);
    SliceView* coronal = window->views()->slice(SliceKind::coronal);
    const int before = coronal->index();
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->rect().center() + QPoint(10, 25));
    EXPECT_GT(coronal->index(), before);  // further down in an axial slice is further back
    EXPECT_TRUE(window->statusLine()->readout().contains(QStringLiteral("mm")));
    const ValueRange window_before = document().settings.window;
    const QImage grey = axial->grab().toImage();
    const QPoint middle = axial->rect().center();
    QTest::mousePress(axial, Qt::RightButton, {}, middle);
    QTest::mouseMove(axial, middle + QPoint(40, 20));
    QTest::mouseRelease(axial, Qt::RightButton, {}, middle + QPoint(40, 20));
    EXPECT_GT(document().settings.window.width(), window_before.width());
    EXPECT_GT(difference(axial->grab().toImage(), grey), 0.01);
}

TEST_F(WindowTest, MaximisingAViewHidesTheOthers) {
    open(k_casting);
    QTest::keyClick(window.get(), Qt::Key_3, Qt::ControlModifier);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_M);
    EXPECT_TRUE(window->views()->slice(SliceKind::coronal)->isVisible());
    EXPECT_FALSE(window->views()->volumeView()->isVisible());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_M);
    EXPECT_TRUE(window->views()->volumeView()->isVisible());
}

TEST_F(WindowTest, ClosingWhileAFrameIsInFlightNeitherHangsNorCrashes) {
    open(QStringLiteral("sample:casting@64"));
    ViewSettings slow = document().settings;
    slow.quality.step = 0.01;
    window->documents()->edit(QStringLiteral("Quality"), slow);
    QTest::qWait(FrameScheduler::k_still_ms / 2);  // into a frame that takes seconds
    EXPECT_TRUE(window->scheduler()->busy());
    QElapsedTimer clock;
    clock.start();
    window->close();
    window.reset();
    EXPECT_LT(clock.elapsed(), 3000);
}

TEST_F(WindowTest, ClosingWhileLoadingNeitherHangsNorCrashes) {
    window->openInput(QStringLiteral("sample:casting@400"));
    QElapsedTimer clock;
    clock.start();
    window.reset();
    EXPECT_LT(clock.elapsed(), 10000);
}

TEST_F(WindowTest, EveryControlHasAName) {
    open(k_casting);
    window->rangesPanel()->addRange();
    int checked = 0;
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith(QStringLiteral("qt_"))) continue;
        if (qobject_cast<QTabBar*>(widget) || qobject_cast<QHeaderView*>(widget)) continue;
        if (widget->window() != window.get()) continue;  // pop-ups of combo boxes
        QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
        ASSERT_NE(face, nullptr);
        EXPECT_FALSE(face->text(QAccessible::Name).isEmpty()) << widget->metaObject()->className();
        ++checked;
    }
    EXPECT_GT(checked, 40);
}

TEST_F(WindowTest, TheMemoryLimitOfTheSettingsHoldsForWhatIsOpened) {
    preferences::set_memory_limit_mib(1);
    QSignalSpy failed(window->loader(), &LoadController::failed);
    window->openInput(QStringLiteral("sample:spheres@160"));
    const bool refused = failed.wait(k_patience_ms);
    preferences::set_memory_limit_mib(0);
    ASSERT_TRUE(refused);
    EXPECT_FALSE(window->documents()->hasDocument());
    const QString words = window->messageBar()->text();
    EXPECT_TRUE(words.contains(QStringLiteral("only 1 MB may be used"))) << words.toStdString();
    EXPECT_TRUE(words.contains(QStringLiteral("settings"))) << words.toStdString();
    open(QStringLiteral("sample:spheres@16"));
}

TEST_F(WindowTest, TwoSeriesAreOfferedForChoice) {
    QTemporaryDir folder;
    SampleOptions options;
    options.size = 16;
    const std::filesystem::path root = folder.path().toStdString();
    try {
        write_volume(make_sample("spheres", options).volume, root / "one" / "");
        options.seed = 2;
        write_volume(make_sample("spheres", options).volume, root / "two" / "");
    } catch (const Error& error) {
        GTEST_SKIP() << "skipped: no DICOM series could be written: " << error.what();
    }
    QSignalSpy choice(window->loader(), &LoadController::choiceNeeded);
    window->openInput(folder.path());
    ASSERT_TRUE(choice.wait(k_patience_ms)) << window->messageBar()->text().toStdString();
    auto* dialog = window->findChild<QDialog*>();
    ASSERT_NE(dialog, nullptr);
    QSignalSpy opened(window->documents(), &DocumentController::opened);
    dialog->accept();
    ASSERT_TRUE(opened.wait(k_patience_ms));
    EXPECT_EQ(document().volume.geometry().size.x, 16);
}

}  // namespace
}  // namespace lacuna::ui::test
