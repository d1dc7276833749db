// The inspection panel and the effects panel in the whole window.
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>

#include "core/base/atomic_file.h"
#include "core/io/dicom_writer.h"
#include "core/session/session_file.h"
#include "core/volume/samples.h"
#include "tests/gui/window_fixture.h"

namespace lacuna::ui::test {

namespace {

class InspectionTest : public WindowTest {
protected:
    void inspect() {
        QSignalSpy finished(window->inspection(), &InspectionFeature::finished);
        QSignalSpy gathered(window->inspection(), &InspectionFeature::gathered);
        QTest::mouseClick(panel()->inspectButton(), Qt::LeftButton);
        ASSERT_TRUE(finished.count() > 0 || finished.wait(k_patience_ms));
        ASSERT_TRUE(document().inspection != nullptr) << window->messageBar()->text().toStdString();
        ASSERT_TRUE(gathered.count() > 0 || gathered.wait(k_patience_ms));
    }
    InspectionPanel* panel() const { return window->inspection()->panel(); }
    int rows() const { return panel()->table()->model()->rowCount(); }
};

TEST_F(InspectionTest, InspectingFillsTheTableAndColoursTheDefects) {
    open(k_casting);
    settle();
    const QImage before = picture();
    const QImage slice = window->views()->slice(SliceKind::axial)->grab().toImage();
    EXPECT_EQ(panel()->verdictText(), QStringLiteral("Not inspected"));
    inspect();
    EXPECT_EQ(rows(), int(document().inspection->defects.size()));
    ASSERT_GT(rows(), 0);
    settle();
    EXPECT_GT(difference(picture(), before), 0.002);
    panel()->table()->selectRow(0);
    const std::uint32_t id = document().selected_defect;
    ASSERT_GT(id, 0u);
    EXPECT_EQ(document().cursor_mm, document().inspection->defects[id - 1].centroid_mm);
    EXPECT_GT(difference(window->views()->slice(SliceKind::axial)->grab().toImage(), slice), 0.001);
}

TEST_F(InspectionTest, LimitsAreHeldAgainstTheTableAtOnce) {
    open(k_casting);
    inspect();
    OptionalValue* count = panel()->form()->limit(Rule::count);
    count->spin()->setValue(0);
    QTest::mouseClick(count->box(), Qt::LeftButton, {}, QPoint(8, count->box()->height() / 2));
    ASSERT_TRUE(count->box()->isChecked());
    EXPECT_EQ(panel()->judgement().verdict, Verdict::fail);
    EXPECT_TRUE(panel()->verdictText().contains(QStringLiteral("Fail"))) << panel()->verdictText().toStdString();
    count->spin()->setValue(100000);
    EXPECT_NE(panel()->judgement().verdict, Verdict::fail);
}

TEST_F(InspectionTest, AWordByHandStandsOverTheLimitsAndCanBeTakenBack) {
    open(k_casting);
    inspect();
    OptionalValue* diameter = panel()->form()->limit(Rule::defect_diameter_mm);
    diameter->spin()->setValue(1e6);
    diameter->box()->setChecked(true);
    ASSERT_NE(panel()->judgement().verdict, Verdict::fail);
    panel()->decide(1, false, QStringLiteral("at the sealing face"));
    EXPECT_EQ(panel()->judgement().verdict, Verdict::fail);
    ASSERT_EQ(panel()->judgement().by_hand.size(), 1u);
    EXPECT_EQ(panel()->judgement().by_hand[0].reason, "at the sealing face");
    EXPECT_EQ(panel()->judgement().defects[0].verdict, Verdict::fail);
    panel()->decide(1, true, {});
    EXPECT_TRUE(panel()->judgement().by_hand.empty());
    EXPECT_NE(panel()->judgement().verdict, Verdict::fail);
}

TEST_F(InspectionTest, TheFilterTakesWordsAndComparisons) {
    open(k_casting);
    inspect();
    const int all = rows();
    panel()->filterEdit()->setText(QStringLiteral("inclusion"));
    EXPECT_EQ(rows(), 0);
    panel()->filterEdit()->setText(QStringLiteral("voxels >= 30"));
    int expected = 0;
    for (const Defect& defect : document().inspection->defects) expected += defect.voxels >= 30;
    EXPECT_EQ(rows(), expected);
    EXPECT_LT(expected, all);
    panel()->filterEdit()->clear();
    EXPECT_EQ(rows(), all);
}

TEST_F(InspectionTest, AnEditOfWhatIsFoundSaysThatTheVerdictIsStale) {
    open(k_casting);
    inspect();
    panel()->form()->material()->box()->setChecked(true);
    EXPECT_TRUE(panel()->verdictText().contains(QStringLiteral("inspect again")))
        << panel()->verdictText().toStdString();
    EXPECT_TRUE(panel()->form()->criteria().detection.material.has_value());
    inspect();
    EXPECT_FALSE(panel()->verdictText().contains(QStringLiteral("inspect again")));
}

TEST_F(InspectionTest, CriteriaFilesAreReadAndWrittenOffTheWindowsThread) {
    open(k_casting);
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("c.json"));
    write_file(file.toStdString(), R"({"min_voxels":17,"limits":{"count":3}})");
    InspectionFeature* feature = window->inspection();
    QSignalSpy read(feature, &InspectionFeature::criteriaRead);
    feature->readCriteria(file);
    EXPECT_EQ(read.count(), 0) << "nothing is read before the call returns";
    ASSERT_TRUE(read.wait(k_patience_ms));
    EXPECT_EQ(panel()->form()->criteria().detection.min_voxels, 17);
    QSignalSpy written(feature, &InspectionFeature::written);
    const QString copy = folder.filePath(QStringLiteral("copy.json")),
                  other = folder.filePath(QStringLiteral("o.json"));
    feature->writeCriteria(copy);
    feature->writeCriteria(other);
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 2; }, k_patience_ms));
    for (const QString& name : {copy, other}) EXPECT_EQ(read_criteria(name.toStdString()).detection.min_voxels, 17);
    feature->readCriteria(folder.filePath(QStringLiteral("none.json")));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->messageBar()->text().contains(QStringLiteral("none.json")); },
                                k_patience_ms));
}

TEST_F(InspectionTest, OneReportDoesNotEndAnother) {
    open(QStringLiteral("sample:casting@32"));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->bench()->engine() != nullptr; }, k_patience_ms));
    QTemporaryDir folder;
    QSignalSpy written(window->inspection(), &InspectionFeature::written);
    for (const char* name : {"first", "second"})
        window->inspection()->writeReport(folder.filePath(QLatin1String(name)));
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 2; }, k_patience_ms))
        << window->messageBar()->text().toStdString();
    for (const char* name : {"first", "second"})
        EXPECT_TRUE(QFile::exists(folder.filePath(QLatin1String(name) + QStringLiteral("/report.json")))) << name;
}

TEST_F(InspectionTest, TheReportOfOneSeriesOfSeveralIsOfThatSeries) {
    QTemporaryDir folder;
    for (const char* name : {"one", "other"}) {
        SampleOptions options;
        options.size = std::string_view(name) == "one" ? 24 : 32;
        write_dicom_series(make_sample("casting", options).volume, folder.filePath(QLatin1String(name)).toStdString());
    }
    QSignalSpy asked(window->loader(), &LoadController::choiceNeeded);
    window->openInput(folder.path());
    ASSERT_TRUE(asked.wait(k_patience_ms)) << window->messageBar()->text().toStdString();
    for (QDialog* dialog : window->findChildren<QDialog*>())
        if (dialog->isVisible()) dialog->reject();
    QSignalSpy loaded(window->loader(), &LoadController::finished);
    OpenOptions second;
    second.series = "2";
    window->loader()->open(folder.path(), second);
    ASSERT_TRUE(loaded.wait(k_patience_ms));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->bench()->engine() != nullptr; }, k_patience_ms));
    const QString report = folder.filePath(QStringLiteral("report"));
    window->inspection()->writeReport(report);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->messageBar()->text().isEmpty(); }, k_patience_ms));
    EXPECT_FALSE(window->messageBar()->isError()) << window->messageBar()->text().toStdString();
    EXPECT_TRUE(QFile::exists(report + QStringLiteral("/report.json")));
    EXPECT_TRUE(QFile::exists(report + QStringLiteral("/seg.dcm")));
}

TEST_F(InspectionTest, DecisionsByHandAreNotWrittenOfOtherSettings) {
    open(k_casting);
    ASSERT_TRUE(QTest::qWaitFor([this] { return window->bench()->engine() != nullptr; }, k_patience_ms));
    QTemporaryDir folder;
    InspectionFeature* feature = window->inspection();
    inspect();
    panel()->decide(1, false, QStringLiteral("at the sealing face"));
    const auto decisions_saved = [&] {
        const QString file = folder.filePath(QStringLiteral("s.lacuna"));
        QSignalSpy saved(window->session(), &SessionFeature::saved);
        window->session()->saveTo(file);
        EXPECT_TRUE(saved.wait(k_patience_ms));
        return load_session(file.toStdString()).decisions.size();
    };
    EXPECT_EQ(decisions_saved(), 1u);
    Criteria criteria = panel()->form()->criteria();
    criteria.detection.min_voxels = 100;
    panel()->setCriteria(criteria);
    ASSERT_FALSE(panel()->isCurrent());
    feature->writeReport(folder.filePath(QStringLiteral("r")));
    EXPECT_TRUE(window->messageBar()->isError());
    EXPECT_TRUE(window->messageBar()->text().contains(QStringLiteral("inspect it again")));
    EXPECT_TRUE(window->bench()->tasks()->rows().empty());
    EXPECT_EQ(decisions_saved(), 0u);
}

TEST_F(InspectionTest, AnEffectChangesThePictureAndUndoTakesItBack) {
    open(k_casting);
    settle();
    const QImage before = picture();
    EffectsPanel* effects = window->effectsPanel();
    effects->box(EffectKind::brightness)->setChecked(true);
    ASSERT_EQ(document().settings.effects.size(), 1u);
    EXPECT_EQ(document().settings.effects[0].kind, EffectKind::brightness);
    settle();
    EXPECT_GT(difference(picture(), before), 0.05);
    window->documents()->undo();
    EXPECT_TRUE(document().settings.effects.empty());
    EXPECT_FALSE(effects->box(EffectKind::brightness)->isChecked());
    settle();
    EXPECT_EQ(difference(picture(), before), 0);
}

TEST_F(InspectionTest, AnEffectTheModeCannotServeIsOfferedNoMore) {
    open(k_casting);
    EffectsPanel* effects = window->effectsPanel();
    effects->box(EffectKind::ao)->setChecked(true);
    settle();
    ViewSettings next = document().settings;
    next.mode = ViewMode::mip;
    window->documents()->edit(QStringLiteral("View mode"), next);
    EXPECT_FALSE(effects->box(EffectKind::ao)->isEnabled());
    EXPECT_EQ(document().settings.effects.size(), 1u);
    settle();
    EXPECT_TRUE(window->messageBar()->isHidden()) << window->messageBar()->text().toStdString();
}

}  // namespace

}  // namespace lacuna::ui::test
