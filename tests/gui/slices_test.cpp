#include <QClipboard>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <cmath>

#include "core/io/dicom_identity.h"
#include "core/io/volume_writer.h"
#include "core/volume/samples.h"
#include "tests/gui/window_fixture.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

class SlicesTest : public WindowTest {
protected:
    SliceView* view(SliceKind kind) const { return window->views()->slice(kind); }
    SliceMeasure* tool() const { return window->measure()->tool(); }
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(view(SliceKind::axial), Qt::Key(key), modifiers);
    }
    /// Where a voxel of the slice shown lies in the view.
    static QPointF at(SliceView* slice, const glm::dvec3& voxel) {
        return slice->toWidget(slice->volume().geometry().voxel_to_mm(voxel));
    }
    glm::dvec3 across(SliceView* slice, double pixels) const {
        return slice->pose().frame.right * (pixels / slice->pixelsPerMm());
    }
};

TEST_F(SlicesTest, PresetsAndFunctionsChangeTheGreyAndAreUndone) {
    open(QStringLiteral("sample:head@32"));
    ASSERT_EQ(document().volume.unit, "HU");
    SliceView* axial = view(SliceKind::axial);
    axial->setFocus();
    const ValueRange opened = document().settings.window;
    press(Qt::Key_3, Qt::AltModifier);
    EXPECT_EQ(document().settings.window, (ValueRange{-500, 1500})) << "bone";
    press(Qt::Key_1, Qt::AltModifier);
    EXPECT_EQ(document().settings.window, (ValueRange{0, 80})) << "brain";
    press(Qt::Key_7, Qt::AltModifier);
    EXPECT_EQ(document().settings.window, document().statistics->range);
    press(Qt::Key_0, Qt::AltModifier);
    EXPECT_EQ(document().settings.window, opened);
    const QImage grey = axial->grab().toImage();
    QComboBox* function = window->slicesPanel()->functionBox();
    function->setCurrentIndex(int(VoiFunction::sigmoid));
    Q_EMIT function->activated(int(VoiFunction::sigmoid));
    EXPECT_EQ(document().settings.slices.function, VoiFunction::sigmoid);
    EXPECT_GT(difference(axial->grab().toImage(), grey), 0.02);
    window->documents()->undo();
    EXPECT_EQ(document().settings.slices.function, VoiFunction::linear_exact);
    EXPECT_EQ(difference(axial->grab().toImage(), grey), 0);
}

TEST_F(SlicesTest, SlicesAloneDoNotDrawThe3DPictureAnew) {
    open(k_casting);
    QSignalSpy frames(window->scheduler(), &FrameScheduler::frameReady);
    view(SliceKind::axial)->setFocus();
    press(Qt::Key_3, Qt::ShiftModifier);
    EXPECT_EQ(document().settings.slices.slab, (Slab{10, SlabMode::minip}));
    EXPECT_FALSE(window->scheduler()->busy());
    EXPECT_EQ(frames.count(), 0);
}

TEST_F(SlicesTest, ASlabShowsItsLargestValues) {
    open(k_casting);
    SliceView* axial = view(SliceKind::axial);
    axial->setNotesShown(false);
    const QImage thin = axial->grab().toImage();
    window->bench()->edit(QStringLiteral("slab"), [](ViewSettings& s) { s.slices.slab = {1000, SlabMode::mip}; });
    const QImage mip = axial->grab().toImage();
    EXPECT_GT(lit(mip), lit(thin));
    window->bench()->edit(QStringLiteral("slab"), [](ViewSettings& s) { s.slices.slab = {1000, SlabMode::minip}; });
    EXPECT_LT(lit(axial->grab().toImage()), lit(thin));
    window->documents()->undo();
    window->documents()->undo();
}

TEST_F(SlicesTest, ADistanceIsDrawnMovedListedAndUndone) {
    open(k_casting);
    SliceView* axial = view(SliceKind::axial);
    axial->setFocus();
    press(Qt::Key_D);
    ASSERT_EQ(tool()->kind(), MeasurementKind::distance);
    const QImage before = axial->grab().toImage();
    const QPointF from = axial->rect().center() + QPointF(-40, 10), to = axial->rect().center() + QPointF(50, -20);
    drag(axial, from, to);
    ASSERT_EQ(document().settings.measurements.size(), 1u);
    const Measurement m = document().settings.measurements.front();
    EXPECT_NEAR(length_mm(m), std::hypot(90, 30) / axial->pixelsPerMm(), 1e-9);
    EXPECT_NEAR(axial->pose().frame.depth_mm(m.points_mm[0]), 0, 1e-9);
    EXPECT_GT(difference(axial->grab().toImage(), before), 0.001);
    EXPECT_EQ(window->measure()->panel()->table()->rowCount(), 1);
    QTest::keyClick(axial, Qt::Key_Escape);
    EXPECT_FALSE(tool()->kind().has_value());
    // Its end is a handle now.
    const glm::dvec3 cursor = document().cursor_mm;
    drag(axial, to, to + QPointF(0, 40));
    EXPECT_EQ(document().cursor_mm, cursor) << "the cross-hair stays";
    EXPECT_NEAR(length_mm(document().settings.measurements.front()), std::hypot(90, 10) / axial->pixelsPerMm(), 1e-6);
    // On another slice there is nothing of it.
    EXPECT_FALSE(lies_in(m, view(SliceKind::coronal)->pose().frame, view(SliceKind::coronal)->depthTolerance()));
    window->documents()->undo();
    EXPECT_EQ(document().settings.measurements.front(), m);
    EXPECT_EQ(tool()->selected(), m.id);
    QTest::keyClick(axial, Qt::Key_Delete);
    EXPECT_TRUE(document().settings.measurements.empty());
    EXPECT_EQ(tool()->selected(), 0u);
    window->documents()->undo();
    window->documents()->undo();
    EXPECT_TRUE(document().settings.measurements.empty());
    EXPECT_FALSE(window->documents()->history().can_undo());
}

TEST_F(SlicesTest, AnAngleIsThreeClicksAndARegionHasItsStatistics) {
    open(k_casting);
    SliceView* coronal = view(SliceKind::coronal);
    coronal->setFocus();
    tool()->setKind(MeasurementKind::angle);
    const QPointF middle = coronal->rect().center();
    for (const QPointF& off : {QPointF(40, 0), QPointF(0, 0), QPointF(0, -40)})
        QTest::mouseClick(coronal, Qt::LeftButton, {}, (middle + off).toPoint());
    ASSERT_EQ(document().settings.measurements.size(), 1u);
    EXPECT_NEAR(angle_deg(document().settings.measurements[0]), 90, 1e-9);
    tool()->setKind(MeasurementKind::rectangle);
    drag(coronal, middle + QPointF(-30, -30), middle + QPointF(20, 25));
    ASSERT_EQ(document().settings.measurements.size(), 2u);
    const Measurement m = document().settings.measurements[1];
    EXPECT_NEAR(area_mm2(m), 50 * 55 / std::pow(coronal->pixelsPerMm(), 2), 1e-6);
    const RegionStatistics s = region_statistics(document().volume, m);
    EXPECT_GT(s.pixels, 0);
    const QTableWidget* table = window->measure()->panel()->table();
    EXPECT_EQ(table->item(1, 8)->text(), QString::number(s.pixels));
    EXPECT_EQ(table->item(1, 4)->text(), QString::number(s.mean, 'g', 6));
    // A corner that is no point of it moves both of its neighbours.
    QTest::keyClick(coronal, Qt::Key_Escape);
    const QPointF corner = coronal->toWidget(handles_of(m)[2]);
    drag(coronal, corner, corner + QPointF(20, -10));
    EXPECT_NEAR(area_mm2(document().settings.measurements[1]), 70 * 65 / std::pow(coronal->pixelsPerMm(), 2),
                0.05 * area_mm2(m));
    // Choosing a row goes to its slice.
    window->documents()->setCursor(document().volume.geometry().voxel_to_mm({1, 1, 1}));
    window->measure()->panel()->table()->selectRow(0);
    EXPECT_EQ(tool()->selected(), document().settings.measurements[0].id);
    EXPECT_TRUE(lies_in(document().settings.measurements[0], coronal->pose().frame, coronal->depthTolerance()));
    window->measure()->copyTable();
    const QString copied = QGuiApplication::clipboard()->text();
    EXPECT_EQ(copied.count(QLatin1Char('\n')), 3);
    EXPECT_TRUE(copied.contains(
        QString::number(region_statistics(document().volume, document().settings.measurements[1]).stddev, 'g', 6)));
}

TEST(FreePlace, CoversNoneOfThoseTakenWhereThereIsRoom) {
    const QSizeF view(200, 100);
    const QRectF wanted(20, 20, 60, 15);
    EXPECT_EQ(free_place(wanted, {}, view), wanted);
    std::vector<QRectF> taken;
    for (int i = 0; i < 5; ++i) {
        const QRectF place = free_place(wanted, taken, view);
        for (const QRectF& other : taken) EXPECT_FALSE(place.intersects(other)) << i;
        EXPECT_TRUE(QRectF(QPointF(), view).contains(place)) << i;
        taken.push_back(place);
    }
    // At the lower edge there is room above only; beside the right edge it is pushed back into the view.
    const QRectF low = free_place(QRectF(20, 80, 60, 15), {QRectF(20, 80, 60, 15)}, view);
    EXPECT_LT(low.bottom(), 80);
    EXPECT_LE(free_place(QRectF(180, 20, 60, 15), {}, view).right(), 200);
    EXPECT_EQ(free_place(wanted, {QRectF(0, 0, 200, 100)}, view), wanted) << "no room at all";
}

TEST_F(SlicesTest, NumbersOfMeasurementsThatEndTogetherStandApart) {
    open(k_casting);
    SliceView* axial = window->views()->slice(SliceKind::axial);
    std::vector<Measurement> two;
    for (const double y : {-4.0, -6.0}) {
        Measurement m;
        m.id = next_measurement_id(two);
        m.kind = MeasurementKind::distance;
        m.right = axial->pose().frame.right;
        m.down = axial->pose().frame.down;
        const glm::dvec3 end = axial->toMm(QPointF(axial->width() * 0.5, axial->height() * 0.5));
        m.points_mm = {end + m.right * y, end};
        two.push_back(m);
    }
    window->bench()->edit(QStringLiteral("Measurements"), [&](ViewSettings& s) { s.measurements = two; });
    const std::vector<SliceMeasure::Label> labels = tool()->labels(*axial, QFontMetrics(axial->font()));
    ASSERT_EQ(labels.size(), 2u);
    EXPECT_FALSE(labels[0].where.intersects(labels[1].where));
}

TEST_F(SlicesTest, TheKeyboardAloneMeasures) {
    open(k_casting);
    SliceView* axial = view(SliceKind::axial);
    axial->setFocus();
    press(Qt::Key_D);
    press(Qt::Key_Space);
    for (int i = 0; i < 6; ++i) press(Qt::Key_Right);
    press(Qt::Key_Space);
    ASSERT_EQ(document().settings.measurements.size(), 1u);
    EXPECT_NEAR(length_mm(document().settings.measurements[0]),
                6 * document().volume.geometry().spacing[axial->pose().plane.u], 1e-9);
    press(Qt::Key_X);
    EXPECT_FALSE(tool()->kind().has_value());
}

TEST_F(SlicesTest, HandlesTiltTheTwoOtherPlanesAndTheCrossHairStaysLinked) {
    open(k_casting);
    SliceView* axial = view(SliceKind::axial);
    SliceView* coronal = view(SliceKind::coronal);
    SliceView* sagittal = view(SliceKind::sagittal);
    const SliceFrame own = axial->pose().frame;
    const auto handles = SliceCrossHair::handles(*axial);
    ASSERT_EQ(handles.size(), 4u);
    const QPointF middle = axial->toWidget(axial->cursorMm());
    const QPointF off = handles[1] - middle;
    const double turn = glm::radians(30.0);
    const QPointF goal = middle + QPointF(off.x() * std::cos(turn) - off.y() * std::sin(turn),
                                          off.x() * std::sin(turn) + off.y() * std::cos(turn));
    drag(axial, handles[1], goal);
    EXPECT_EQ(axial->pose().frame, own) << "the view that turns the others stays";
    EXPECT_TRUE(coronal->pose().oblique && sagittal->pose().oblique);
    EXPECT_NEAR(glm::dot(coronal->pose().frame.normal(), sagittal->pose().frame.normal()), 0, 1e-9);
    EXPECT_NEAR(glm::degrees(std::acos(std::abs(glm::dot(coronal->pose().frame.normal(), own.down)))), 30, 1.5);
    EXPECT_FALSE(coronal->grab().toImage().isNull());
    EXPECT_GT(lit(coronal->grab().toImage()), 0.02);
    // A click in a tilted plane moves the cross-hair there, and the others follow.
    const QPoint click = coronal->rect().center() + QPoint(20, 10);
    const glm::dvec3 goal_mm = coronal->toMm(click);
    QTest::mouseClick(coronal, Qt::LeftButton, {}, click);
    EXPECT_NEAR(glm::distance(document().cursor_mm, goal_mm), 0, 1e-9);
    EXPECT_NEAR(sagittal->pose().frame.depth_mm(goal_mm), 0, 1e-9);
    EXPECT_NEAR(coronal->pose().frame.depth_mm(goal_mm), 0, 1e-9);
    // Measurements lie in tilted planes as in others.
    tool()->setKind(MeasurementKind::ellipse);
    drag(coronal, coronal->rect().center() - QPointF(30, 20), coronal->rect().center() + QPointF(10, 25));
    ASSERT_EQ(document().settings.measurements.size(), 1u);
    EXPECT_GT(region_statistics(document().volume, document().settings.measurements[0]).pixels, 0);
    tool()->setKind(std::nullopt);
    axial->setFocus();
    press(Qt::Key_O, Qt::ShiftModifier);
    EXPECT_FALSE(coronal->pose().oblique || sagittal->pose().oblique);
    EXPECT_FALSE(lies_in(document().settings.measurements[0], coronal->pose().frame, coronal->depthTolerance()));
    QTest::keyClick(axial, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_TRUE(coronal->pose().oblique);
    window->documents()->undo();
    EXPECT_FALSE(coronal->pose().oblique);
}

TEST_F(SlicesTest, AThickTiltedSlabIsSampledAsideAndThenShown) {
    open(QStringLiteral("sample:casting@128"));
    SliceView* coronal = view(SliceKind::coronal);
    window->bench()->edit(QStringLiteral("tilt"), [](ViewSettings& s) {
        s.slices.tilt = glm::angleAxis(0.3, glm::normalize(glm::dvec3(0.2, 1, 0.4)));
        s.slices.slab = {200, SlabMode::mip};
    });
    coronal->repaint();
    EXPECT_TRUE(coronal->waiting());
    for (int i = 0; i < 20; ++i)  // as while a slider is dragged: nothing queues up
        window->bench()->edit(QStringLiteral("tilt"), [i](ViewSettings& s) { s.slices.slab.thickness_mm = 200 - i; });
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            for (SliceView* slice : window->views()->slices())
                if (slice->waiting()) return false;
            return true;
        },
        k_patience_ms));
    EXPECT_GT(lit(coronal->grab().toImage()), 0.1);
}

TEST_F(SlicesTest, TheOverlaysOpacityIsThatOfTheSlider) {
    open(k_casting);
    SliceView* axial = view(SliceKind::axial);
    axial->setNotesShown(false);
    auto labels = std::make_shared<LabelVolume>();
    labels->geometry = document().volume.geometry();
    labels->labels = std::make_shared<std::vector<std::uint32_t>>(std::size_t(labels->geometry.voxel_count()), 1u);
    SliceOverlay overlay;
    overlay.labels = labels;
    overlay.id = 1;
    const QImage plain = axial->grab().toImage();
    axial->setOverlay(overlay);
    const double strong = difference(axial->grab().toImage(), plain);
    EXPECT_GT(strong, 0.1);  // the slice fills a part of the view
    window->slicesPanel()->overlaySlider()->spin()->setValue(0);
    EXPECT_EQ(document().settings.slices.overlay_opacity, 0);
    EXPECT_EQ(difference(axial->grab().toImage(), plain), 0);
    window->documents()->undo();
    window->bench()->edit(QStringLiteral("tilt"),
                          [](ViewSettings& s) { s.slices.tilt = glm::angleAxis(0.4, glm::dvec3(1, 0, 0)); });
    axial->setOverlay({});
    const QImage tilted = axial->grab().toImage();
    axial->setOverlay(overlay);
    EXPECT_GT(difference(axial->grab().toImage(), tilted), 0.05) << "in tilted planes too";
}

TEST_F(SlicesTest, PatientDataIsShownAndHiddenEverywhere) {
    // What the program writes names its patient "Anonymous": a name like any other.
    QTemporaryDir folder;
    const std::filesystem::path root = std::filesystem::path(folder.path().toStdString()) / "testcase";
    SampleOptions options;
    options.size = 16;
    write_volume(make_sample("spheres", options).volume, root / "");
    preferences::set_hide_patient(false);
    open(QString::fromStdString(root.string()));
    ASSERT_TRUE(document().patient != nullptr);
    const auto shown = [this] {
        QString all = window->windowTitle();
        for (const SliceView* view : window->views()->slices()) all += view->patientWords().join(QLatin1Char('\n'));
        return all + window->statusLine()->readout() + window->messageBar()->text();
    };
    EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("Anonymous")));
    EXPECT_TRUE(view(SliceKind::coronal)->patientWords().contains(QStringLiteral("Anonymous")));
    const QImage with = view(SliceKind::axial)->grab().toImage();
    QTest::keyClick(window.get(), Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(window->patient()->hidden());
    for (const char* word : {"Anonymous", "testcase"}) EXPECT_FALSE(shown().contains(QLatin1String(word))) << word;
    EXPECT_GT(difference(view(SliceKind::axial)->grab().toImage(), with), 0.001);
    EXPECT_TRUE(preferences::hide_patient());
    window->patient()->setHidden(false);
    EXPECT_TRUE(shown().contains(QStringLiteral("Anonymous")));
    EXPECT_EQ(document().settings.slices.function, VoiFunction::linear) << "DICOM's, where a file names none";
}

}  // namespace
}  // namespace lacuna::ui::test
