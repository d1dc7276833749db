// What the window says of its picture's error, the budget, and the chart of plans.
#include "tests/gui/window_fixture.h"

namespace lacuna::ui::test {
namespace {

class AccuracyTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        window->resize(760, 620);
        open(QStringLiteral("sample:spheres@24"));
    }

    AccuracyFeature& feature() { return *window->accuracy(); }
    AccuracyMonitor& monitor() { return *feature().monitor(); }
    QString badge() { return feature().badge()->text(); }

    void change(const std::function<void(ViewSettings&)>& apply) {
        window->bench()->edit(QStringLiteral("Test"), apply);
        settle();
    }
    template <class Condition>
    void waitFor(Condition&& condition, const char* what) {
        ASSERT_TRUE(QTest::qWaitFor(condition, k_patience_ms)) << what << "; badge: " << badge().toStdString();
    }
    void pressB() { QTest::keyClick(window->views()->volumeView(), Qt::Key_B); }
};

TEST_F(AccuracyTest, TheBadgeSaysTheRuleOrMeasures) {
    EXPECT_TRUE(feature().badge()->isVisible());
    EXPECT_EQ(monitor().bound().known, ErrorKnown::bounded);
    EXPECT_TRUE(badge().contains(QStringLiteral("0.61/255"))) << badge().toStdString();
    change([](ViewSettings& s) { s.mode = ViewMode::iso; });
    EXPECT_EQ(monitor().bound().known, ErrorKnown::exact);
    change([](ViewSettings& s) { s.quality.sampler = Sampler::nearest; });
    waitFor([&] { return monitor().bound().known == ErrorKnown::measured; }, "nearest voxels are measured");
    EXPECT_GT(monitor().bound().levels, 1);
    EXPECT_TRUE(badge().contains(QStringLiteral("measured"))) << badge().toStdString();
    change([](ViewSettings& s) { s.mode = ViewMode::shear_warp; });
    EXPECT_EQ(monitor().bound().known, ErrorKnown::unknown);
    EXPECT_TRUE(badge().contains(QStringLiteral("brute force"))) << badge().toStdString();
}

TEST_F(AccuracyTest, OneKeyShowsBruteForceAndTheDifference) {
    change([](ViewSettings& s) { s.quality.sampler = Sampler::nearest; });
    const QImage own = picture();
    pressB();
    waitFor([&] { return monitor().truth() != nullptr; }, "brute force is drawn");
    EXPECT_EQ(feature().showing(), AccuracyFeature::Showing::brute_force);
    const QImage brute = picture();
    EXPECT_EQ(brute, to_image(monitor().truth()->frame()));
    EXPECT_GT(difference(own, brute), 0.01);
    pressB();
    EXPECT_GT(difference(brute, picture()), 0.01);
    EXPECT_TRUE(badge().contains(QStringLiteral("Difference"))) << badge().toStdString();
    EXPECT_EQ(qGray(picture().pixel(1, 1)), 0) << "nothing differs beside the object";
    // Another view: the difference of that one comes by itself.
    QTest::keyClick(window->views()->volumeView(), Qt::Key_Left);
    waitFor([&] { return !monitor().coarse() && monitor().truth() && badge().contains(QStringLiteral("Difference")); },
            "the difference follows the view");
    pressB();
    EXPECT_EQ(feature().showing(), AccuracyFeature::Showing::picture);
    EXPECT_EQ(picture(), to_image(*monitor().shown().frame));
    EXPECT_FALSE(badge().contains(QStringLiteral("Difference")));
}

TEST_F(AccuracyTest, TheBudgetChangesPlanAndBadgeAndIsUndone) {
    QSlider* slider = feature().budget()->slider();
    const auto planned = [&] {
        return monitor().answer() && document().planned && !monitor().planning() && !window->scheduler()->busy() &&
               to_json(monitor().plan()) == to_json(*document().planned);
    };
    slider->setFocus();
    feature().budget()->switchBox()->setChecked(true);  // at its end: exact
    ASSERT_EQ(document().settings.quality.error_budget, 0.0);
    waitFor(planned, "an exact plan is found");
    EXPECT_EQ(monitor().answer()->error, 0);
    EXPECT_EQ(monitor().plan().plan.ert, 0);
    const QString exact = badge(), line = feature().budget()->planLine();
    QTest::keyClick(slider, Qt::Key_Left);
    QTest::keyClick(slider, Qt::Key_Left);
    QTest::keyClick(slider, Qt::Key_Left);
    QTest::keyClick(slider, Qt::Key_Left);
    ASSERT_EQ(document().settings.quality.error_budget, 32.0);
    waitFor(planned, "a faster plan is found");
    EXPECT_LE(monitor().answer()->error, 32);
    EXPECT_TRUE(monitor().answer()->meets_budget);
    // Which plan is the fastest is for the clock to say; one that errs shows that it does.
    if (monitor().answer()->error > 0) {
        EXPECT_NE(badge(), exact);
        EXPECT_NE(feature().budget()->planLine(), line);
    }
    // From one end of the slider to the other plan and badge differ, whatever the machine.
    QTest::keyClick(slider, Qt::Key_Home);
    ASSERT_EQ(document().settings.quality.error_budget, 255.0);
    waitFor(planned, "the fastest plan is found");
    EXPECT_GT(monitor().answer()->error, 0) << "nothing exact is the fastest";
    EXPECT_NE(badge(), exact);
    EXPECT_NE(feature().budget()->planLine(), line);
    window->documents()->undo();
    window->documents()->undo();
    settle();
    EXPECT_NE(document().settings.quality.error_budget, 32.0);
    while (window->documents()->history().can_undo()) window->documents()->undo();
    EXPECT_FALSE(feature().budget()->switchBox()->isChecked());
    EXPECT_FALSE(document().planned);
}

TEST_F(AccuracyTest, PointsAppearInTheChartAndAClickUsesOne) {
    feature().dock()->show();
    feature().dock()->raise();
    waitFor([&] { return monitor().pointsAreOfThisView() && monitor().points().measured() >= 6; },
            "plans are measured while nothing else runs");
    const auto& points = monitor().points().result().points;
    EXPECT_EQ(points.front().error.max, 0);
    EXPECT_GE(feature().panel()->table()->rowCount(), 6);
    std::size_t point = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].refused.empty() && points[i].error.max > 0 && points[i].plan.plan.step > 0.6) point = i;
    if (point == 0) point = 2;
    const auto place = feature().panel()->placeOf(point);
    ASSERT_TRUE(place);
    ChartView* chart = feature().panel()->chart();
    const auto at = chart->positionOf(*place);
    ASSERT_TRUE(at);
    const ModePlan wanted = points[point].plan;
    QTest::mouseClick(chart, Qt::LeftButton, {}, at->toPoint());
    ASSERT_FALSE(document().settings.quality.plan.empty());
    settle();
    EXPECT_EQ(document().settings.quality.plan, to_json(monitor().plan()));
    // By the keyboard: Enter in the list.
    QTableWidget* table = feature().panel()->table();
    waitFor([&] { return table->rowCount() > 2 && !table->item(0, 1)->text().isEmpty(); }, "the list is filled again");
    table->setFocus();
    table->setCurrentCell(0, 0);
    QTest::keyClick(table, Qt::Key_Return);
    settle();
    EXPECT_EQ(document().settings.quality.plan, to_json(monitor().plan()));
    // Moving the view stops the measuring at once.
    QTest::keyClick(window->views()->volumeView(), Qt::Key_Right);
    EXPECT_TRUE(window->scheduler()->busy());
    settle();
}

TEST_F(AccuracyTest, ThePictureBeforeIsNotTakenForTheOneAskedFor) {
    ASSERT_TRUE(badge().contains(QStringLiteral("0.61/255"))) << badge().toStdString();
    window->bench()->edit(QStringLiteral("Test"), [](ViewSettings& s) { s.mode = ViewMode::iso; });
    window->scheduler()->cancel();  // as Cancel in the status line does
    EXPECT_FALSE(window->scheduler()->current());
    EXPECT_TRUE(badge().contains(QStringLiteral("not drawn"))) << badge().toStdString();
    change([](ViewSettings& s) { s.iso += 1; });
    EXPECT_TRUE(window->scheduler()->current());
    EXPECT_TRUE(badge().contains(QStringLiteral("exact"))) << badge().toStdString();
}

}  // namespace
}  // namespace lacuna::ui::test
