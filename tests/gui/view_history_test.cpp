// View > Previous view and Next view: the camera and the cross-hair go back and forward, undo leaves them alone.
#include <QMenuBar>
#include <QMouseEvent>
#include <QTemporaryDir>

#include "tests/gui/window_fixture.h"
#include "ui/action_catalog.h"
#include "ui/features/view_history_feature.h"

namespace lacuna::ui::test {
namespace {

class ViewHistoryTest : public WindowTest {
protected:
    VolumeView* view() const { return window->views()->volumeView(); }
    const ViewHistory& history() const { return window->findChild<ViewHistoryFeature*>()->history(); }
    QAction* action(const QString& begin) const {
        for (const CatalogEntry& entry : catalog_of(window->menuBar()))
            if (entry.text.startsWith(begin)) return entry.action;
        return nullptr;
    }
    void back() { QTest::keyClick(view(), Qt::Key_Left, Qt::AltModifier); }
    void forward() { QTest::keyClick(view(), Qt::Key_Right, Qt::AltModifier); }
};

TEST_F(ViewHistoryTest, ADragIsOneStepAndGoesBackWhereItBegan) {
    open(k_casting);
    const Camera front = document().camera;
    drag(view(), view()->rect().center(), view()->rect().center() + QPoint(80, 20));
    const Camera turned = document().camera;
    ASSERT_FALSE(turned == front);
    EXPECT_EQ(action(QStringLiteral("Previous view"))->text(), QStringLiteral("Prev&ious view: 3D view"));
    drag(view(), view()->rect().center(), view()->rect().center() + QPoint(-10, 40));
    back();
    EXPECT_EQ(document().camera, turned);
    EXPECT_EQ(view()->camera(), turned);
    back();
    EXPECT_EQ(document().camera, front);
    EXPECT_FALSE(action(QStringLiteral("Previous view"))->isEnabled());
    back();
    EXPECT_EQ(document().camera, front);
    forward();
    EXPECT_EQ(document().camera, turned);
    EXPECT_FALSE(window->documents()->history().can_undo()) << "looking around is no edit";
}

TEST_F(ViewHistoryTest, SlicesAndCommandsAreStepsOfTheirOwn) {
    open(k_casting);
    const glm::dvec3 middle = document().cursor_mm;
    const Camera home = document().camera;
    SliceView* axial = window->views()->slice(SliceKind::axial);
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->pictureRect().center().toPoint() + QPoint(20, 12));
    const glm::dvec3 clicked = document().cursor_mm;
    ASSERT_NE(clicked, middle);
    QTest::keyClick(view(), Qt::Key_L);
    QTest::keyClick(view(), Qt::Key_H);
    EXPECT_EQ(document().camera.elevation_deg, 90);
    back();
    EXPECT_EQ(document().camera.azimuth_deg, 90);
    EXPECT_EQ(document().camera.elevation_deg, 0);
    back();
    EXPECT_EQ(document().camera, home);
    EXPECT_EQ(document().cursor_mm, clicked);
    EXPECT_EQ(history().back_name(), "cross-hair");
    QTest::mouseClick(axial, Qt::BackButton);
    EXPECT_EQ(document().cursor_mm, middle);
    EXPECT_EQ(axial->cursorMm(), middle);
    QTest::mouseClick(axial, Qt::ForwardButton);
    EXPECT_EQ(document().cursor_mm, clicked);
}

TEST_F(ViewHistoryTest, WhatMovesTogetherGoesBackTogether) {
    open(k_casting);
    const Document before = document();
    window->documents()->setCursor({1, 2, 3});
    Camera camera = before.camera;
    camera.center_mm = glm::dvec3(1, 2, 3);
    window->documents()->setCamera(camera);
    EXPECT_EQ(history().back_name(), "3D view and cross-hair");
    back();
    EXPECT_EQ(document().camera, before.camera);
    EXPECT_EQ(document().cursor_mm, before.cursor_mm);
}

TEST_F(ViewHistoryTest, TheZoomOfASliceGoesBackToo) {
    open(k_casting);
    SliceView* axial = window->views()->slice(SliceKind::axial);
    SliceView* coronal = window->views()->slice(SliceKind::coronal);
    const QRectF whole = axial->pictureRect();
    QTest::keyClick(axial, Qt::Key_Plus);
    QTest::keyClick(axial, Qt::Key_Plus);
    const QRectF near = axial->pictureRect();
    ASSERT_GT(near.width(), whole.width());
    EXPECT_EQ(history().back_name(), "zoom of a slice");
    QTest::mousePress(axial, Qt::MiddleButton, {}, QPoint(60, 60));
    QMouseEvent move(QEvent::MouseMove, QPointF(90, 75), axial->mapToGlobal(QPointF(90, 75)), Qt::NoButton,
                     Qt::MiddleButton, {});
    QApplication::sendEvent(axial, &move);
    QTest::mouseRelease(axial, Qt::MiddleButton, {}, QPoint(90, 75));
    EXPECT_EQ(axial->pictureRect().topLeft(), near.topLeft() + QPointF(30, 15));
    QTest::keyClick(coronal, Qt::Key_Plus);
    const QRectF moved = axial->pictureRect();
    back();
    EXPECT_EQ(coronal->zoom(), SliceZoom{});
    EXPECT_EQ(axial->pictureRect(), moved);
    back();
    EXPECT_EQ(axial->pictureRect(), near);
    back();
    EXPECT_EQ(axial->pictureRect(), whole);
    EXPECT_FALSE(history().can_go_back());
    forward();
    EXPECT_EQ(axial->pictureRect(), near);
    QTest::keyClick(axial, Qt::Key_Home);
    EXPECT_EQ(axial->pictureRect(), whole);
    back();
    EXPECT_EQ(axial->pictureRect(), near) << "showing all can be taken back";
    EXPECT_FALSE(window->documents()->history().can_undo());
}

TEST_F(ViewHistoryTest, PerspectiveGoesBackWithItsTick) {
    open(k_casting);
    QAction* perspective = action(QStringLiteral("Perspective"));
    perspective->trigger();
    EXPECT_TRUE(document().camera.fov_deg.has_value());
    back();
    EXPECT_FALSE(document().camera.fov_deg.has_value());
    EXPECT_FALSE(perspective->isChecked());
}

TEST_F(ViewHistoryTest, AVolumeOpenedAndASessionTakenUpBeginAnew) {
    open(k_casting);
    QTest::keyClick(view(), Qt::Key_L);
    ASSERT_TRUE(history().can_go_back());
    QTemporaryDir folder;
    QSignalSpy saved(window->session(), &SessionFeature::saved);
    window->session()->saveTo(folder.filePath(QStringLiteral("a.lacuna")));
    ASSERT_TRUE(saved.wait(k_patience_ms));
    QSignalSpy restored(window->session(), &SessionFeature::restored);
    window->openInput(folder.filePath(QStringLiteral("a.lacuna")));
    ASSERT_TRUE(restored.wait(k_patience_ms));
    EXPECT_EQ(document().camera.azimuth_deg, 90);
    EXPECT_FALSE(history().can_go_back());
    QTest::keyClick(view(), Qt::Key_A);
    EXPECT_TRUE(history().can_go_back());
}

}  // namespace
}  // namespace lacuna::ui::test
