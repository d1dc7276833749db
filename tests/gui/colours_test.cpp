// The colours: points of a transfer function, gradient opacity, colour maps, presets.
#include <QLineEdit>
#include <QMessageBox>
#include <QMouseEvent>
#include <QTemporaryDir>

#include "core/base/atomic_file.h"
#include "core/classify/colour_maps.h"
#include "tests/gui/window_fixture.h"
#include "ui/features/colours_feature.h"
#include "ui/features/presets_feature.h"
#include "ui/widgets/point_fields.h"

namespace lacuna::ui {
namespace {

/// A plot over a histogram with two peaks, and a function of five points.
class PlotTest : public testing::Test {
protected:
    void SetUp() override {
        std::vector<std::uint64_t> counts(200, 0);
        for (int i = 0; i < 200; ++i)
            counts[std::size_t(i)] = std::uint64_t(1e6 * std::exp(-std::pow((i - 40) / 8.0, 2)) +
                                                   1e5 * std::exp(-std::pow((i - 150) / 8.0, 2)));
        plot.resize(420, 240);
        plot.setHistogram(counts, {0, 200});
        function.points = {{10, glm::dvec3(1), 0.1},
                           {60, glm::dvec3(1), 0.3},
                           {90, glm::dvec3(1), 0.5},
                           {120, glm::dvec3(1), 0.7},
                           {190, glm::dvec3(1), 0.9}};
        plot.setFunction(function);
        plot.show();
    }
    void drag(QPointF from, QPointF to, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&plot, Qt::LeftButton, modifiers, from.toPoint());
        for (int i = 1; i <= 4; ++i) {
            const QPointF at = from + (to - from) * i / 4.0;
            QMouseEvent move(QEvent::MouseMove, at, plot.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
            QApplication::sendEvent(&plot, &move);
        }
        QTest::mouseRelease(&plot, Qt::LeftButton, modifiers, to.toPoint());
    }
    TransferPlot plot;
    TransferFunction function;
};

TEST_F(PlotTest, ABoxSelectsAndSeveralMoveTogether) {
    QSignalSpy ended(&plot, &TransferPlot::gestureEnded);
    drag(plot.pointPosition(1) + QPointF(-15, 20), plot.pointPosition(3) + QPointF(15, -15));
    EXPECT_EQ(plot.selection(), (std::set<int>{1, 2, 3}));
    EXPECT_EQ(ended.count(), 0);  // nothing was edited
    const QPointF held = plot.pointPosition(2);
    drag(held, held + QPointF(20, 12), Qt::AltModifier);
    const auto& points = plot.function().points;
    const double moved = points[1].value - 60;
    EXPECT_GT(moved, 5);
    EXPECT_NEAR(points[2].value - 90, moved, 1e-9);
    EXPECT_NEAR(points[3].value - 120, moved, 1e-9);
    EXPECT_LT(points[1].opacity, 0.3);
    EXPECT_NEAR(points[3].opacity - points[1].opacity, 0.4, 1e-9);
    EXPECT_EQ(points[0].value, 10);
    EXPECT_EQ(points[4].value, 190);
    EXPECT_EQ(ended.count(), 1);
    QTest::keyClick(&plot, Qt::Key_Delete);
    EXPECT_EQ(plot.function().points.size(), 2u);
    QTest::keyClick(&plot, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&plot, Qt::Key_Delete);
    EXPECT_EQ(plot.function().points.size(), 1u);  // one stays
}

TEST_F(PlotTest, PointsStayInOrderHoweverFarTheyAreDragged) {
    drag(plot.pointPosition(2), plot.pointPosition(4) + QPointF(100, 0));
    EXPECT_NO_THROW(check(plot.function()));
    EXPECT_LE(plot.function().points[2].value, 120);
    drag(plot.pointPosition(2), {0, 0});
    EXPECT_NO_THROW(check(plot.function()));
    EXPECT_LE(plot.function().points[2].opacity, 1);
}

TEST_F(PlotTest, PointsSnapToPeaksUnlessAltIsHeld) {
    ASSERT_EQ(plot.landmarks().size(), 3u);
    const double peak = plot.landmarks()[2];
    const QPointF near(plot.xOf(peak) + 3, plot.pointPosition(3).y());
    drag(plot.pointPosition(3), near, Qt::AltModifier);
    EXPECT_NE(plot.function().points[3].value, peak);
    plot.setFunction(function);
    drag(plot.pointPosition(3), near);
    EXPECT_DOUBLE_EQ(plot.function().points[3].value, peak);
}

TEST_F(PlotTest, ShiftClickTakesPointsInAndOut) {
    plot.select(0);
    QTest::mouseClick(&plot, Qt::LeftButton, Qt::ShiftModifier, plot.pointPosition(2).toPoint());
    EXPECT_EQ(plot.selection(), (std::set<int>{0, 2}));
    QTest::mouseClick(&plot, Qt::LeftButton, Qt::ShiftModifier, plot.pointPosition(0).toPoint());
    EXPECT_EQ(plot.selection(), (std::set<int>{2}));
    EXPECT_EQ(plot.selected(), 2);
    EXPECT_EQ(plot.function(), function);
}

TEST_F(PlotTest, FieldsTakeExactNumbers) {
    PointFields fields(&plot, true);
    fields.setLimits({-100, 300}, QStringLiteral("HU"));
    QSignalSpy edited(&fields, &PointFields::functionEdited);
    plot.select(2);
    EXPECT_EQ(fields.valueField()->value(), 90);
    fields.valueField()->setValue(105);
    fields.opacityField()->setValue(0.25);
    EXPECT_EQ(plot.function().points[2].value, 105);
    EXPECT_EQ(plot.function().points[2].opacity, 0.25);
    EXPECT_EQ(edited.count(), 2);
    fields.valueField()->setValue(400);  // no further than the next point
    EXPECT_EQ(plot.function().points[2].value, 120);
}

TEST_F(PlotTest, FieldsSayWhereAPointStoodStill) {
    PointFields fields(&plot, true);
    fields.setLimits({-100, 300}, QString());
    plot.select(2);
    fields.valueField()->setValue(400);
    ASSERT_EQ(fields.valueField()->value(), 120);  // against the next point
    fields.valueField()->setValue(150);
    EXPECT_EQ(plot.function().points[2].value, 120);
    EXPECT_EQ(fields.valueField()->value(), 120);
}

TEST_F(PlotTest, FieldsKeepAPointFarBeyondTheData) {
    TransferFunction wider = plot.function();
    wider.points.push_back({3000, glm::dvec3(1), 1});  // of a file made for other data
    plot.setFunction(wider);
    PointFields fields(&plot, true);
    fields.setLimits({-100, 300}, QString());
    const int last = int(wider.points.size()) - 1;
    plot.select(last);
    EXPECT_EQ(fields.valueField()->value(), 3000);
    fields.opacityField()->setValue(0.25);
    EXPECT_EQ(plot.function().points.back().opacity, 0.25);
    EXPECT_EQ(plot.function().points.back().value, 3000);
    plot.select(0);
    EXPECT_EQ(fields.valueField()->maximum(), 300);
}

TEST_F(PlotTest, TheHistogramIsLinearOrLogarithmic) {
    const QImage logarithmic = plot.grab().toImage();
    plot.setLogarithmic(false);
    EXPECT_GT(test::difference(plot.grab().toImage(), logarithmic), 0.02);
}

class ColoursTest : public test::WindowTest {
protected:
    void SetUp() override {
        home = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", data.path().toUtf8());
        WindowTest::SetUp();
        presets = window->findChild<PresetsFeature*>();
        ASSERT_TRUE(presets);
    }
    void TearDown() override {
        window.reset();  // before its folder goes
        qputenv("XDG_DATA_HOME", home);
    }
    TransferPanel* panel() { return window->transferPanel(); }
    QTemporaryDir data;
    QByteArray home;  ///< the data folder of all other tests
    PresetsFeature* presets = nullptr;
};

TEST_F(ColoursTest, EachDragIsOneStepOfUndo) {
    open(test::k_casting);
    TransferPlot* plot = panel()->plot();
    const TransferFunction first = document().settings.tf;
    const QPointF middle(0, plot->height() / 2.0);
    drag(plot, plot->pointPosition(1), {plot->pointPosition(1).x() + 4, middle.y()});
    const TransferFunction second = document().settings.tf;
    ASSERT_NE(second, first);
    drag(plot, plot->pointPosition(1), {plot->pointPosition(1).x() + 5, middle.y() - 20});
    ASSERT_NE(document().settings.tf, second);
    window->documents()->undo();
    EXPECT_EQ(document().settings.tf, second);
    window->documents()->undo();
    EXPECT_EQ(document().settings.tf, first);
    EXPECT_EQ(plot->function(), first);
}

TEST_F(ColoursTest, AColourMapRecoloursAndUndoes) {
    open(test::k_casting);
    const TransferFunction before = document().settings.tf;
    panel()->applyColorMap(QStringLiteral("heat"));
    const TransferFunction& after = document().settings.tf;
    EXPECT_EQ(after.points.front().color, colour_map_at("heat", 0));
    EXPECT_EQ(after.points.back().color, colour_map_at("heat", 1));
    EXPECT_NEAR(after.at(0.5 * (before.points[0].value + before.points[1].value)).opacity,
                before.at(0.5 * (before.points[0].value + before.points[1].value)).opacity, 1e-9);
    window->documents()->undo();
    EXPECT_EQ(document().settings.tf, before);
}

TEST_F(ColoursTest, AGradientCurveFadesAndIsCountedOffTheWindowsThread) {
    open(test::k_casting);
    const QImage before = picture();
    QSignalSpy counted(panel()->histograms(), &HistogramController::jointCounted);
    panel()->showPage(TransferPanel::k_gradients);
    ASSERT_TRUE(counted.count() > 0 || counted.wait(test::k_patience_ms));
    panel()->gradientPage()->use()->click();
    ASSERT_EQ(document().settings.tf.gradient_opacity.size(), 2u);
    settle();
    EXPECT_GT(test::difference(picture(), before), 0.005);
    TransferPlot* plot = panel()->gradientPage()->plot();
    plot->select(0);
    QTest::keyClick(plot, Qt::Key_Up);
    EXPECT_NEAR(document().settings.tf.gradient_opacity[0].opacity, 0.02, 1e-12);
    panel()->gradientPage()->use()->click();
    EXPECT_TRUE(document().settings.tf.gradient_opacity.empty());
    panel()->gradientPage()->use()->click();  // what was drawn comes back
    EXPECT_NEAR(document().settings.tf.gradient_opacity.at(0).opacity, 0.02, 1e-12);
}

TEST_F(ColoursTest, TheShownPartIsCountedAgain) {
    open(test::k_casting);
    QSignalSpy counted(panel()->histograms(), &HistogramController::counted);
    ViewSettings cut = document().settings;
    cut.cuts = {{{{1, 0, 0}, -document().volume.geometry().centre_mm().x, true}, true}};
    window->documents()->edit(QStringLiteral("cut"), cut);
    EXPECT_EQ(counted.count(), 0);  // the whole volume is asked for
    panel()->histogramBox()->setCurrentIndex(1);
    Q_EMIT panel()->histogramBox()->activated(1);
    ASSERT_TRUE(counted.wait(test::k_patience_ms));
    const auto counts = counted.last().at(0).value<std::vector<std::uint64_t>>();
    std::uint64_t shown = 0, all = 0;
    for (const std::uint64_t n : counts) shown += n;
    for (const std::uint64_t n : document().statistics->histogram) all += n;
    EXPECT_GT(shown, all / 3);
    EXPECT_LT(shown, all * 2 / 3);
}

TEST_F(ColoursTest, PresetsAreDrawnAppliedWithTheirTechniqueAndUndone) {
    open(test::k_casting);
    QSignalSpy drawn(presets->thumbnails(), &PresetThumbnails::drawn);
    presets->showGallery();
    ASSERT_TRUE(drawn.count() > 0 || drawn.wait(test::k_patience_ms));
    EXPECT_GT(test::lit(drawn.first().at(1).value<QImage>()), 0.01);
    const ViewSettings before = document().settings;
    PresetEntry mip{"mine", "mine.json", PresetFile{before.tf, Technique{"mip", "none", 1.0}}};
    presets->apply(mip);
    EXPECT_EQ(document().settings.mode, ViewMode::mip);
    EXPECT_EQ(document().settings.quality.step, 1.0);
    window->documents()->undo();
    EXPECT_EQ(document().settings, before);
    presets->gallery()->techniqueBox()->setChecked(false);
    presets->gallery()->choose(QStringLiteral("grey"));
    QTest::keyClick(presets->gallery()->list(), Qt::Key_Return);
    EXPECT_EQ(document().settings.tf.name, "grey");
    EXPECT_EQ(document().settings.mode, before.mode);
    EXPECT_EQ(document().settings.shading, before.shading);
}

TEST_F(ColoursTest, OwnPresetsAreKeptAndBrokenOnesNamed) {
    open(test::k_casting);
    const auto marked = [&](const char* name) {
        return QTest::qWaitFor(
            [&] {
                const PresetEntry* chosen = presets->gallery()->chosen();
                return chosen && chosen->name == name;
            },
            test::k_patience_ms);
    };
    presets->saveAs(QString());
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->messageBar()->isError(); }, test::k_patience_ms));
    presets->saveAs(QStringLiteral("My castings"));
    ASSERT_TRUE(marked("My castings"));
    EXPECT_FALSE(window->messageBar()->isError());  // what it lacked before is over
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("My castings")));
    write_file(PresetsFeature::folder() / "later.json", "{\"version\": 7}");
    presets->showGallery();
    const std::vector<PresetEntry> all = list_presets(PresetsFeature::folder());
    ASSERT_EQ(all.size(), preset_names().size() + 2);
    const PresetEntry& own = all[preset_names().size()];
    EXPECT_EQ(own.name, "My castings");
    EXPECT_EQ(own.preset->technique->mode, "ea");
    const ViewSettings before = document().settings;
    presets->apply(all.back());
    EXPECT_EQ(document().settings, before);
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("version 7")));
    presets->rename(own, QStringLiteral("bone"));  // taken
    EXPECT_TRUE(QTest::qWaitFor([&] { return window->messageBar()->text().contains(QStringLiteral("bone")); },
                                test::k_patience_ms));
    presets->rename(own, QStringLiteral("Castings"));
    ASSERT_TRUE(marked("Castings"));
    presets->saveAs(QStringLiteral("Castings"));  // one's own: asked before it is replaced
    QMessageBox* question = nullptr;
    ASSERT_TRUE(QTest::qWaitFor([&] { return (question = window->findChild<QMessageBox*>()) != nullptr; },
                                test::k_patience_ms));
    QSignalSpy listed(presets, &PresetsFeature::listed);
    question->button(QMessageBox::Yes)->click();
    ASSERT_TRUE(listed.wait(test::k_patience_ms));
    EXPECT_EQ(list_presets(PresetsFeature::folder()).size(), preset_names().size() + 2);
    ASSERT_TRUE(marked("Castings"));
    presets->remove(*presets->gallery()->chosen());
    ASSERT_TRUE(listed.wait(test::k_patience_ms));
    EXPECT_EQ(list_presets(PresetsFeature::folder()).size(), preset_names().size() + 1);
    EXPECT_TRUE(std::filesystem::exists(PresetsFeature::folder() / "later.json"));
}

TEST_F(ColoursTest, APresetThatWasReplacedIsDrawnAnew) {
    open(test::k_casting);
    presets->showGallery();
    PresetThumbnails* pictures = presets->thumbnails();
    const QString name = QStringLiteral("Own");
    QString key;
    const auto drawn = [&](auto&& as_wanted) {
        return QTest::qWaitFor(
            [&] {
                const PresetEntry* chosen = presets->gallery()->chosen();
                if (!chosen || chosen->name != name.toStdString()) return false;
                key = PresetGallery::keyOf(*chosen);
                return !pictures->picture(key).isNull() && as_wanted(pictures->picture(key));
            },
            test::k_patience_ms);
    };
    presets->saveAs(name);
    ASSERT_TRUE(drawn([](const QImage&) { return true; }));
    const QImage before = pictures->picture(key);
    ViewSettings other = document().settings;
    for (TransferPoint& point : other.tf.points) point.color = {0, 0, 1};
    window->documents()->edit(QStringLiteral("Blue"), other);
    settle();
    presets->saveAs(name);
    QMessageBox* question = nullptr;
    ASSERT_TRUE(QTest::qWaitFor([&] { return (question = window->findChild<QMessageBox*>()) != nullptr; },
                                test::k_patience_ms));
    QTest::qWait(400);  // pictures are drawn again as soon as they are wanted
    question->button(QMessageBox::Yes)->click();
    EXPECT_TRUE(drawn([&](const QImage& now) { return test::difference(now, before) > 0.01; }));
}

TEST_F(ColoursTest, ShapesOfValueAndGradientAreDrawnDraggedAndUndone) {
    open(test::k_casting);
    QSignalSpy counted(panel()->histograms(), &HistogramController::jointCounted);
    window->tabs()->setCurrentWidget(panel());
    panel()->showPage(TransferPanel::k_shapes);
    ASSERT_TRUE(counted.count() > 0 || counted.wait(test::k_patience_ms));
    const ViewSettings before = document().settings;
    const QImage by_values = picture();
    ShapePlot* plot = panel()->shapesPage()->plot();
    const ValueRange values = document().statistics->range;
    const double steepest = counted.last().at(0).value<std::shared_ptr<const JointHistogram>>()->magnitudes.hi;
    // A box over everything steep: surfaces alone are left.
    drag(plot, plot->positionOf(values.lo + 0.02 * values.width(), 0.95 * steepest),
         plot->positionOf(values.hi - 0.02 * values.width(), 0.3 * steepest));
    ASSERT_EQ(document().settings.tf.shapes.size(), 1u);
    const TransferShape drawn = document().settings.tf.shapes[0];
    EXPECT_TRUE(document().settings.tf.is_2d());
    EXPECT_NEAR(drawn.magnitude.lo, 0.3 * steepest, 0.03 * steepest);
    settle();
    EXPECT_GT(test::difference(picture(), by_values), 0.01);
    EXPECT_GT(test::lit(picture()), 0.01);
    // The upper right corner, then the whole.
    const QPointF corner = plot->corners(drawn)[2];
    drag(plot, corner, corner + QPointF(-20, 15));
    const TransferShape formed = document().settings.tf.shapes[0];
    EXPECT_TRUE(formed.is_rectangle());
    EXPECT_LT(formed.at_hi.hi, drawn.at_hi.hi);
    EXPECT_LT(formed.magnitude.hi, drawn.magnitude.hi);
    EXPECT_EQ(formed.at_lo.lo, drawn.at_lo.lo);
    panel()->shapesPage()->kindBox()->setCurrentIndex(1);
    Q_EMIT panel()->shapesPage()->kindBox()->activated(1);
    EXPECT_FALSE(document().settings.tf.shapes[0].is_rectangle());
    QTest::keyClick(plot, Qt::Key_Right);
    panel()->shapesPage()->opacityField()->setValue(0.125);
    EXPECT_EQ(document().settings.tf.shapes[0].opacity, 0.125);
    panel()->shapesPage()->use()->click();
    EXPECT_FALSE(document().settings.tf.is_2d());
    EXPECT_EQ(document().settings.tf.shapes.size(), 1u);  // kept for another time
    QTest::keyClick(plot, Qt::Key_Delete);
    EXPECT_TRUE(document().settings.tf.shapes.empty());
    while (window->documents()->history().can_undo()) window->documents()->undo();
    EXPECT_EQ(document().settings, before);
}

TEST_F(ColoursTest, ANewRangeHasANameAndAColourOfItsOwn) {
    open(test::k_casting);
    RangesPanel* ranges = window->rangesPanel();
    for (int i = 0; i < 3; ++i) ranges->addRange();
    Q_EMIT ranges->row(1)->removeRequested();
    ASSERT_EQ(document().settings.ranges.size(), 2u);
    ranges->addRange();
    const std::vector<RangeSetting>& all = document().settings.ranges;
    ASSERT_EQ(all.size(), 3u);
    EXPECT_NE(all[2].range.name, all[1].range.name);
    EXPECT_NE(all[2].color, all[1].color);
}

TEST_F(ColoursTest, RangesSayWhatTheyHoldAndHaveColoursOfTheirOwn) {
    open(test::k_casting);
    RangesPanel* ranges = window->rangesPanel();
    QSignalSpy counted(ranges, &RangesPanel::counted);
    ranges->addRange();
    ranges->addRange();
    ASSERT_TRUE(counted.count() > 0 || counted.wait(test::k_patience_ms));
    while (ranges->row(1)->countText() == QStringLiteral("…")) ASSERT_TRUE(counted.wait(test::k_patience_ms));
    const Document& shown = document();
    const std::vector<RangeCount> counts = count_ranges(
        shown.volume, *shown.statistics, {shown.settings.ranges[0].range.range, shown.settings.ranges[1].range.range});
    const QString first = ranges->row(0)->countText();
    EXPECT_TRUE(first.contains(QLocale().toString(qulonglong(counts[0].voxels)))) << first.toStdString();
    ranges->row(1)->nameField()->setText(QStringLiteral("air"));
    QTest::keyClick(ranges->row(1)->nameField(), Qt::Key_Return);
    EXPECT_EQ(shown.settings.ranges[1].range.name, "air");
    // Where they overlap, the upper one counts: order matters and is said.
    Q_EMIT ranges->row(1)->upRequested();
    EXPECT_EQ(shown.settings.ranges[0].range.name, "air");
    Q_EMIT ranges->row(0)->colorsBox()->activated(RangeRow::k_one_color);
    ASSERT_TRUE(shown.settings.ranges[0].range.tf);
    EXPECT_EQ(shown.settings.ranges[0].range.tf->points[0].color, shown.settings.ranges[0].color);
    // Own colours are edited with the scene's tools.
    const TransferFunction scene = shown.settings.tf;
    Q_EMIT ranges->row(1)->colorsBox()->activated(RangeRow::k_own);
    ASSERT_TRUE(shown.settings.ranges[1].range.tf);
    EXPECT_EQ(window->tabs()->currentWidget(), panel());
    EXPECT_EQ(panel()->targetBox()->currentIndex(), 2);
    panel()->applyColorMap(QStringLiteral("ocean"));
    EXPECT_EQ(shown.settings.ranges[1].range.tf->points.front().color, colour_map_at("ocean", 0));
    EXPECT_EQ(shown.settings.tf, scene);
}

TEST_F(ColoursTest, FunctionsAreReadAndWrittenOffTheWindowsThread) {
    open(test::k_casting);
    QTemporaryDir folder;
    auto* colours = window->findChild<ColoursFeature*>();
    TransferFunction other = document().settings.tf;
    other.points.front().opacity = 0.375;
    const QString file = folder.filePath(QStringLiteral("other.json"));
    save_transfer_function(other, file.toStdString());
    QSignalSpy loaded(colours, &ColoursFeature::loaded);
    colours->loadFunction(file);
    EXPECT_EQ(loaded.count(), 0) << "nothing is read before the call returns";
    ASSERT_TRUE(loaded.wait(test::k_patience_ms));
    EXPECT_EQ(document().settings.tf.points.front().opacity, 0.375);
    QSignalSpy written(colours, &ColoursFeature::written);
    const QString first = folder.filePath(QStringLiteral("a.json")), second = folder.filePath(QStringLiteral("b.json"));
    colours->saveFunction(first);
    colours->saveFunction(second);
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 2; }, test::k_patience_ms));
    for (const QString& name : {first, second})
        EXPECT_EQ(load_transfer_function(name.toStdString()).points.front().opacity, 0.375);
    window->documents()->undo();
    EXPECT_NE(document().settings.tf.points.front().opacity, 0.375);
    // What was to colour the data before does not colour what was opened meanwhile.
    colours->loadFunction(file);
    window->documents()->open(make_document("sample:spheres@24", open_volume("sample:spheres@24")));
    QTest::qWait(50);
    EXPECT_EQ(loaded.count(), 1);
    EXPECT_NE(document().settings.tf.points.front().opacity, 0.375);
}

}  // namespace
}  // namespace lacuna::ui
