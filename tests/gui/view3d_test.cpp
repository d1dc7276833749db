// The hand in the 3D view: cutting planes and the box by their handles, points picked, levels, free rotation, modes.
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>

#include "core/session/cut_gizmo.h"
#include "tests/gui/window_fixture.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

class View3dTest : public WindowTest {
protected:
    VolumeView* view() const { return window->views()->volumeView(); }
    const ViewSettings& settings() const { return document().settings; }
    const CuttingPlane& plane(std::size_t cut = 0) const { return settings().cuts.at(cut).plane; }
    PlaneGizmo gizmo(std::size_t cut = 0) const {
        return gizmo_of(plane(cut), document().volume.geometry(), view()->rays());
    }
    QPointF at(const glm::dvec3& mm) const { return to_point(*in_picture(view()->rays(), mm)); }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(view(), which, modifiers);
    }
    void openTurned() {
        open(k_casting);
        key(Qt::Key_1);
        Camera camera = document().camera;
        camera.azimuth_deg = 35, camera.elevation_deg = 25;
        window->documents()->setCamera(camera);
        key(Qt::Key_X, Qt::ControlModifier | Qt::AltModifier);
        ASSERT_EQ(settings().cuts.size(), 1u);
        settle();
    }
};

TEST_F(View3dTest, TheArrowMovesACutAndUndoBringsItBackInOneStep) {
    openTurned();
    const QImage before = picture();
    const CuttingPlane was = plane();
    const PlaneGizmo handles = gizmo();
    drag(view(), at(handles.anchor), at(handles.anchor + 6.0 * handles.normal));
    EXPECT_NEAR(glm::dot(plane().normal, was.normal), 1, 1e-12);
    EXPECT_NEAR(plane().offset - was.offset, -6, 2 * view()->rays().pixel_mm);
    EXPECT_EQ(document().camera.azimuth_deg, 35) << "the drag was the handle's, not the camera's";
    EXPECT_EQ(window->documents()->history().undo_name(), "Move a cut");
    settle();
    EXPECT_GT(difference(picture(), before), 0.002);
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(plane(), was);
    settle();
    EXPECT_EQ(difference(picture(), before), 0);
}

TEST_F(View3dTest, ATiltHandleTiltsAboutTheAnchorAndThePanelFollows) {
    openTurned();
    const PlaneGizmo handles = gizmo();
    const double azimuth = window->cutsPanel()->offsetSlider()->value();
    drag(view(), at(handles.tilt[0]), at(handles.tilt[0]) + QPointF(25, 18));
    const double turn = glm::degrees(std::acos(std::min(1.0, glm::dot(plane().normal, handles.normal))));
    EXPECT_GT(turn, 3);
    EXPECT_NEAR(glm::dot(plane().normal, handles.anchor) + plane().offset, 0, 1e-6);
    EXPECT_NEAR(azimuth, window->cutsPanel()->offsetSlider()->value(), 10) << "shown, whatever it came to";
    EXPECT_EQ(window->documents()->history().undo_name(), "Tilt a cut");
    // With Ctrl it finds an axis again.
    const PlaneGizmo tilted = gizmo();
    QTest::mousePress(view(), Qt::LeftButton, Qt::ControlModifier, at(tilted.tilt[0]).toPoint());
    QTest::mouseMove(view(), at(tilted.tilt[0]).toPoint() + QPoint(4, 2));
    QTest::mouseMove(view(), at(tilted.tilt[0]).toPoint() + QPoint(5, 3));
    QMouseEvent move(QEvent::MouseMove, at(tilted.tilt[0]) + QPointF(6, 3), view()->mapToGlobal(QPointF(6, 3)),
                     Qt::NoButton, Qt::LeftButton, Qt::ControlModifier);
    QApplication::sendEvent(view(), &move);
    EXPECT_NEAR(std::abs(glm::dot(plane().normal, snapped(plane().normal, document().volume.geometry()))), 1, 1e-9);
    QTest::mouseRelease(view(), Qt::LeftButton, Qt::ControlModifier, at(tilted.tilt[0]).toPoint());
}

TEST_F(View3dTest, KeysAloneMoveTiltFlipOpenAndRemoveCuts) {
    openTurned();
    view()->setFocus();
    const CuttingPlane was = plane();
    const double voxel = document().volume.geometry().smallest_spacing_mm();
    key(Qt::Key_PageDown);
    EXPECT_NEAR(plane().offset, was.offset - voxel, 1e-9);
    key(Qt::Key_PageUp, Qt::ControlModifier);
    EXPECT_NEAR(plane().offset, was.offset + 9 * voxel, 1e-9);
    key(Qt::Key_Left, Qt::AltModifier | Qt::ShiftModifier);
    EXPECT_NEAR(glm::degrees(std::acos(glm::dot(plane().normal, was.normal))), 2, 1.5);
    const CuttingPlane tilted = plane();
    key(Qt::Key_C, Qt::ShiftModifier);
    EXPECT_NEAR(glm::dot(plane().normal, tilted.normal), -1, 1e-9);
    EXPECT_TRUE(plane().cap);
    key(Qt::Key_O);
    EXPECT_FALSE(plane().cap);
    EXPECT_FALSE(window->cutsPanel()->capBox()->isChecked());
    key(Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(settings().cuts.size(), 2u);
    EXPECT_NEAR(glm::dot(plane(1).normal, view()->rays().forward), 1, 1e-9);
    EXPECT_EQ(window->cutsPanel()->current(), 1);
    key(Qt::Key_C);
    EXPECT_EQ(window->cutsPanel()->current(), 0);
    key(Qt::Key_Delete, Qt::ShiftModifier);
    ASSERT_EQ(settings().cuts.size(), 1u);
    EXPECT_NEAR(glm::dot(plane().normal, view()->rays().forward), 1, 1e-9);
    for (int i = 0; i < 8; ++i) key(Qt::Key_X, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(settings().cuts.size(), 6u);
    settle();
    EXPECT_FALSE(window->messageBar()->isVisible()) << window->messageBar()->text().toStdString();
}

TEST_F(View3dTest, AnotherCutsOutlineChoosesIt) {
    openTurned();
    key(Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(window->cutsPanel()->current(), 1);
    key(Qt::Key_C);
    ASSERT_EQ(window->cutsPanel()->current(), 0);
    const std::vector<glm::dvec3> section = gizmo(1).section;
    bool chosen = false;
    for (std::size_t i = 0; i < section.size() && !chosen; ++i) {  // an edge no handle of the other one covers
        const glm::dvec3 middle = glm::mix(section[i], section[(i + 1) % section.size()], 0.4);
        QTest::mouseClick(view(), Qt::LeftButton, {}, at(middle).toPoint());
        chosen = window->cutsPanel()->current() == 1;
    }
    EXPECT_TRUE(chosen);
}

TEST_F(View3dTest, TheBoxIsDraggedByItsSidesAndSwitchedOff) {
    open(k_casting);
    key(Qt::Key_1);
    Camera camera = document().camera;
    camera.azimuth_deg = 35, camera.elevation_deg = 25;
    window->documents()->setCamera(camera);
    settle();
    const QImage whole = picture();
    key(Qt::Key_B, Qt::ShiftModifier);
    EXPECT_TRUE(settings().roi.enabled);
    EXPECT_TRUE(window->cutsPanel()->boxPanel()->enabledBox()->isChecked());
    const BoxRoi was = settings().roi;
    const GridGeometry& geometry = document().volume.geometry();
    const glm::dvec3 top = side_of(was, 5, geometry);
    drag(view(), at(top), at(top - 8.0 * geometry.direction[2]));
    const double share = 8 / (geometry.spacing.z * geometry.size.z);
    EXPECT_NEAR(was.hi.z - settings().roi.hi.z, share, 0.3 * share);
    EXPECT_EQ(settings().roi.lo, was.lo);
    settle();
    EXPECT_GT(difference(picture(), whole), 0.01);
    // The same by keys, in the panel.
    window->tabs()->setCurrentWidget(window->cutsPanel());
    RangeSlider* ends = window->cutsPanel()->boxPanel()->ends(0);
    const double lo = settings().roi.lo.x;
    QTest::keyClick(ends, Qt::Key_Right);
    EXPECT_NEAR(settings().roi.lo.x, lo + 1.0 / geometry.size.x, 0.51 / geometry.size.x);
    key(Qt::Key_B, Qt::ShiftModifier);
    EXPECT_FALSE(settings().roi.enabled);
    settle();
    EXPECT_EQ(difference(picture(), whole), 0);
}

TEST_F(View3dTest, HandlesAreDrawnAndCanBeHidden) {
    openTurned();
    const QImage with = view()->grab().toImage();
    key(Qt::Key_H, Qt::ControlModifier | Qt::AltModifier);
    const QImage without = view()->grab().toImage();
    EXPECT_GT(difference(with, without), 0.002);
    const CuttingPlane was = plane();
    drag(view(), at(gizmo().anchor), at(gizmo().anchor) + QPointF(20, 20));
    EXPECT_EQ(plane(), was) << "what is not seen cannot be taken hold of";
}

TEST_F(View3dTest, AClickReadsOutThePointAndShiftTakesTheSlicesThere) {
    open(k_casting);
    key(Qt::Key_1);
    settle();
    const glm::dvec3 cursor = document().cursor_mm;
    QTest::mouseClick(view(), Qt::LeftButton, {}, view()->rect().center());
    ASSERT_TRUE(window->pick()->marked().has_value());
    const glm::dvec3 mm = *window->pick()->marked();
    EXPECT_EQ(document().cursor_mm, cursor);
    // The surface has the isovalue's side on either hand of it, a voxel apart.
    const GridGeometry& geometry = document().volume.geometry();
    const auto value = [&](const glm::dvec3& p) {
        const glm::ivec3 voxel = nearest_voxel(geometry, p);
        return document().volume.value(voxel.x, voxel.y, voxel.z);
    };
    const glm::dvec3 inwards = view()->rays().forward * (1.5 * geometry.smallest_spacing_mm());
    EXPECT_LT(value(mm - inwards), settings().iso);
    EXPECT_GT(value(mm + inwards), settings().iso);
    EXPECT_TRUE(window->statusLine()->readout().contains(QStringLiteral("mm")));
    QTest::mouseClick(view(), Qt::LeftButton, Qt::ShiftModifier, view()->rect().center());
    EXPECT_EQ(document().cursor_mm, mm);
    QTest::mouseClick(view(), Qt::LeftButton, {}, {3, 3});
    EXPECT_FALSE(window->pick()->marked().has_value()) << "nothing is shown there";
    window->documents()->setCursor(cursor);
    key(Qt::Key_Space, Qt::ShiftModifier);
    EXPECT_LT(glm::length(document().cursor_mm - mm), 2 * geometry.smallest_spacing_mm());
}

TEST_F(View3dTest, TheFocusGoesWhereAPointWasChosen) {
    open(k_casting);
    key(Qt::Key_1);
    settle();
    key(Qt::Key_Space, Qt::ControlModifier);
    ASSERT_EQ(settings().effects.size(), 1u);
    EXPECT_EQ(settings().effects[0].kind, EffectKind::dof);
    const auto mm = window->pick()->pointAt(QRectF(view()->rect()).center());
    ASSERT_TRUE(mm);
    const GridGeometry& geometry = document().volume.geometry();
    EXPECT_NEAR(settings().effects[0].value(0), focus_at(*mm, view()->rays(), geometry), 0.01);
    settle();
    // A right click offers the same; it must not have zoomed.
    const double zoom = document().camera.zoom;
    QTest::mouseClick(view(), Qt::RightButton, {}, view()->rect().center());
    EXPECT_EQ(document().camera.zoom, zoom);
    auto* menu = view()->findChild<QMenu*>(QStringLiteral("view_menu"));
    ASSERT_NE(menu, nullptr);
    menu->actions().at(1)->trigger();
    EXPECT_TRUE(document().camera.center_mm.has_value());
    menu->close();
}

TEST_F(View3dTest, CtrlAndTheRightButtonDragWhatTheModeShowsBy) {
    open(k_casting);
    const auto levels = [this](const QPoint& by) {
        const QPoint from = view()->rect().center();
        QTest::mousePress(view(), Qt::RightButton, Qt::ControlModifier, from);
        QTest::mouseMove(view(), from + by / 2);
        QTest::mouseMove(view(), from + by);
        QTest::mouseRelease(view(), Qt::RightButton, Qt::ControlModifier, from + by);
    };
    key(Qt::Key_2);
    const double zoom = document().camera.zoom;
    const TransferFunction was = settings().tf;
    levels({40, 30});
    EXPECT_GT(settings().tf.points.back().value - settings().tf.points.front().value,
              was.points.back().value - was.points.front().value);
    EXPECT_EQ(window->documents()->history().undo_name(), "Levels");
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(settings().tf, was);
    key(Qt::Key_1);
    const double iso = settings().iso;
    levels({0, 20});
    EXPECT_GT(settings().iso, iso);
    key(Qt::Key_3);
    const ValueRange grey = settings().projection_window;
    levels({-60, 0});
    EXPECT_LT(settings().projection_window.width(), grey.width());
    key(Qt::Key_Up, Qt::ControlModifier);
    EXPECT_LT(settings().projection_window.lo + settings().projection_window.hi, grey.lo + grey.hi);
    EXPECT_EQ(document().camera.zoom, zoom);
}

TEST_F(View3dTest, FreeRotationRollsAndIsRemembered) {
    open(k_casting);
    ASSERT_FALSE(window->hand()->freeRotation()->isChecked());
    window->hand()->freeRotation()->trigger();
    EXPECT_TRUE(preferences::free_rotation());
    const QPointF rim(view()->width() / 2.0, 4);
    drag(view(), rim, rim + QPointF(view()->height() / 3.0, view()->height() / 4.0));
    EXPECT_GT(std::abs(document().camera.roll_deg), 5);
    window->hand()->freeRotation()->trigger();
    EXPECT_FALSE(preferences::free_rotation());
}

TEST_F(View3dTest, EachModeKeepsItsSettingsAndUndoSwitchesBack) {
    open(k_casting);
    key(Qt::Key_2);
    ViewSettings volume = settings();
    volume.shading = Shading::none;
    volume.effects = {{EffectKind::gamma, {1.5}}};
    window->documents()->edit(QStringLiteral("Shading"), volume);
    key(Qt::Key_1);
    EXPECT_EQ(settings().shading, Shading::phong);
    EXPECT_TRUE(settings().effects.empty());
    ViewSettings surface = settings();
    surface.iso += 1;
    window->documents()->edit(QStringLiteral("Isovalue"), surface);  // or both switches were one gesture
    window->renderPanel()->modeBox()->setCurrentIndex(1);
    EXPECT_EQ(settings().shading, Shading::none);
    EXPECT_EQ(settings().effects.size(), 1u);
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(settings().mode, ViewMode::iso);
    EXPECT_EQ(settings().shading, Shading::phong);
    settle();
}

TEST_F(View3dTest, OnlyStructuresThatServeCanBeChosen) {
    open(k_casting);
    key(Qt::Key_1);
    QComboBox* box = window->renderPanel()->structureBox();
    auto* items = qobject_cast<QStandardItemModel*>(box->model());
    const int visible = box->findData(int(Structure::visible)), octree = box->findData(int(Structure::octree));
    EXPECT_FALSE(items->item(visible)->isEnabled());
    EXPECT_TRUE(items->item(visible)->toolTip().contains(QStringLiteral("visible")));
    EXPECT_TRUE(items->item(octree)->isEnabled());
    EXPECT_TRUE(items->item(octree)->toolTip().isEmpty());
    const QImage before = picture();
    box->setCurrentIndex(octree);
    Q_EMIT box->activated(octree);
    EXPECT_EQ(settings().quality.structure, Structure::octree);
    settle();
    EXPECT_TRUE(window->statusLine()->frameText().contains(QStringLiteral("octree")))
        << window->statusLine()->frameText().toStdString();
    key(Qt::Key_3);
    EXPECT_EQ(box->currentIndex(), 0) << "that was the other mode's";
}

TEST_F(View3dTest, AFastHandNeverMakesFramesQueueUp) {
    open(k_casting);
    std::vector<std::pair<bool, bool>> frames;  // coarse; of the camera there is now
    QObject::connect(window->scheduler(), &FrameScheduler::frameReady, window.get(),
                     [&](const QImage&, const FrameFacts& facts) {
                         frames.emplace_back(facts.coarse, facts.scene->camera == document().camera);
                     });
    const QPoint middle = view()->rect().center();
    QTest::mousePress(view(), Qt::LeftButton, {}, middle);
    constexpr int k_moves = 200;
    for (int i = 1; i <= k_moves; ++i) QTest::mouseMove(view(), middle + QPoint(i % 60 + 12, i % 17));
    const std::size_t while_moving = frames.size();
    QTest::mouseRelease(view(), Qt::LeftButton, {}, middle);
    settle();
    ASSERT_FALSE(frames.empty());
    // After the last move: the frame in flight then, one of the newest view, and the full one. Nothing waits in line.
    EXPECT_LE(frames.size() - while_moving, 3u);
    EXPECT_FALSE(frames.back().first);
    EXPECT_TRUE(frames.back().second);
}

TEST_F(View3dTest, AmbientOcclusionIsSeenWhileItGathersItsSamples) {
    open(k_casting);
    key(Qt::Key_1);
    settle();
    std::vector<bool> coarse;
    const QMetaObject::Connection watching =
        QObject::connect(window->scheduler(), &FrameScheduler::frameReady, window.get(),
                         [&](const QImage& image, const FrameFacts& facts) {
                             if (image.size() == view()->pixelSize()) coarse.push_back(facts.coarse);
                         });
    window->bench()->edit(QStringLiteral("Effects"), [](ViewSettings& s) { s.effects = parse_effects("ao=8"); });
    settle();
    QObject::disconnect(watching);
    // Pictures of full size of 2 and 4 samples, then the one that stays.
    ASSERT_GE(coarse.size(), 3u);
    EXPECT_TRUE(coarse[coarse.size() - 3]);
    EXPECT_TRUE(coarse[coarse.size() - 2]);
    EXPECT_FALSE(coarse.back());
}

}  // namespace
}  // namespace lacuna::ui::test
