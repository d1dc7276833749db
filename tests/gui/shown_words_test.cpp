// Words the window shows for what the core names: in its language, while files keep the core's.
#include <QComboBox>
#include <QLabel>

#include "tests/gui/window_fixture.h"
#include "ui/core_sentences.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/language.h"
#include "ui/models/batch_model.h"
#include "ui/number_text.h"
#include "ui/panels/preset_gallery.h"
#include "ui/plan_words.h"
#include "ui/preferences.h"
#include "ui/preset_title.h"

namespace lacuna::ui::test {
namespace {

class ShownWords : public testing::Test {
protected:
    void TearDown() override { use("en"); }
    static void use(const char* code) {
        preferences::set_language(QLatin1String(code));
        Language::instance()->apply();
    }
};

TEST_F(ShownWords, EveryWordOfAPlanIsKnown) {
    // What plans of every mode differ by, as the core says it: each part has a key of its own.
    const QString english = QStringLiteral(
        "octree, mode shear-warp, step 0.25, sampler nearest, gradient sobel,stored, integration preintegrated, refine "
        "regula-falsi, refine steps 5, ert 0.002, sparse 2, sparse aware true, cells 8, directions 24, voxel gradient "
        "gaussian, homogeneity 0.5, homogeneity angle 10, brick 64, kernel published");
    EXPECT_EQ(plan_in_own_words(english), english) << "English is the core's";
    use("de");
    const auto german = plan_in_own_words(english);
    ASSERT_TRUE(german.has_value());
    const QStringList parts = german->split(QStringLiteral(", ")), before = english.split(QStringLiteral(", "));
    EXPECT_TRUE(german->contains(QStringLiteral("Schritt 0,25, "))) << german->toStdString();
    for (const char* word : {"step", "nearest", "sobel,", "refine", "sparse", "true", "published", "brick"})
        EXPECT_FALSE(german->contains(QLatin1String(word))) << word << " in " << german->toStdString();
    EXPECT_EQ(parts.size(), before.size());
    EXPECT_EQ(plan_words(QStringLiteral("none")), structure_word(Structure::none));
    EXPECT_FALSE(plan_in_own_words(QStringLiteral("octree, colour blue")).has_value());
    EXPECT_FALSE(plan_in_own_words(QStringLiteral("part, step 2")).has_value());
    EXPECT_EQ(structure_title(Structure::octree), QStringLiteral("Octree"));
    EXPECT_TRUE(structure_title(Structure::none).endsWith(QStringLiteral(" (none)"))) << "as messages name it";
}

TEST_F(ShownWords, ReasonsOfPlansSpeakOfPlansInTheLanguageOfTheWindow) {
    use("de");
    EXPECT_EQ(
        core_sentence("octree, step 0.5, sampler nearest: 0.25/255 from brute force over the whole view and 1.5 ms a "
                      "frame, both measured (error budget 0.5/255)."),
        QStringLiteral("Octree, Schritt 0,5, Abtaster nächster: 0,25/255 Abweichung von Brute Force über die ganze "
                       "Ansicht und 1,5 ms je Bild, beides gemessen (Fehlerbudget 0,5/255)."));
}

TEST_F(ShownWords, PresetsHaveGermanNamesAndFilesKeepTheCores) {
    for (const std::string& name : preset_names()) EXPECT_EQ(preset_title(name).toStdString(), name);
    use("de");
    EXPECT_EQ(preset_title("bone"), QStringLiteral("Knochen"));
    EXPECT_EQ(preset_title(PresetEntry{"bone", "/x/bone.json"}), QStringLiteral("bone")) << "a user's own name";
    PresetGallery gallery;
    gallery.setEntries({{"bone"}, {"metal"}, {"mine", "/x/mine.json"}});
    EXPECT_EQ(gallery.list()->item(0)->text(), QStringLiteral("Knochen"));
    EXPECT_EQ(gallery.list()->item(2)->text(), QStringLiteral("mine"));
    gallery.choose(QStringLiteral("metal"));
    ASSERT_TRUE(gallery.chosen());
    EXPECT_EQ(gallery.chosen()->name, "metal");
}

TEST_F(ShownWords, ADevicesFaultIsSaidInGerman) {
    use("de");
    SettingsDialog dialog;
    DeviceInfo whole, broken;
    whole.name = "Whole";
    whole.usable = true;
    whole.rank_ms = 1;
    broken.index = 1;
    broken.name = "Broken";
    const auto tip_of = [&](const char* fault) {
        broken.fault = fault;
        dialog.showDevices({whole, broken});
        return dialog.deviceTable()->item(1, 3)->toolTip();
    };
    for (const char* fault :
         {"its driver has no compiler", "its driver says it is not available", "a sum gave 3 in place of 4",
          "sampling a ramp gave 0.500000 in place of 0.250000",
          "The device failed while running its self-test (clBuildProgram: CL_OUT_OF_RESOURCES); try another one with "
          "--device."}) {
        const QString tip = tip_of(fault);
        EXPECT_NE(tip, QLatin1String(fault)) << "said in English";
        EXPECT_FALSE(tip.isEmpty());
    }
    EXPECT_TRUE(tip_of("sampling a ramp gave 0.500000 in place of 0.250000").contains(QStringLiteral("0,5")));
    EXPECT_EQ(dialog.deviceTable()->item(0, 3)->toolTip(), QStringLiteral("Whole"));
}

TEST(BatchModel, SaysHowManyReasonsThereAreAndListsThemAll) {
    BatchModel model;
    model.setParts({{"a", "a.mhd"}, {"b", "b.mhd"}});
    BatchRow two, one;
    two.name = "a";
    two.verdict = Verdict::fail;
    two.reason = "First.";
    two.more_reasons = {"Second.", "Third."};
    one.name = "b";
    one.verdict = Verdict::fail;
    one.reason = "Only.";
    model.setRows({two, one});
    const QModelIndex cell = model.index(0, BatchModel::k_reason);
    EXPECT_EQ(model.data(cell, Qt::DisplayRole).toString(), QStringLiteral("First. (and 2 more)"));
    EXPECT_EQ(model.data(cell, Qt::ToolTipRole).toString(), QStringLiteral("First.\nSecond.\nThird."));
    EXPECT_EQ(model.data(model.index(1, BatchModel::k_reason), Qt::DisplayRole).toString(), QStringLiteral("Only."));
}

TEST(NumberText, KeepsTheDecimalsANumberWasWrittenWith) {
    EXPECT_EQ(as_typed_text(40.5, 0), QStringLiteral("40.5"));
    EXPECT_EQ(as_typed_text(40, 0), QStringLiteral("40"));
    EXPECT_EQ(as_typed_text(-0.1234, 0), QStringLiteral("-0.1234"));
    EXPECT_EQ(as_typed_text(1.0 / 3, 2), QStringLiteral("0.33"));
    EXPECT_EQ(as_typed_text(0.1 + 0.2, 0), QStringLiteral("0.3"));
    EXPECT_EQ(as_typed_text(1e6 + 0.25, 0), QStringLiteral("1000000.25"));
}

class NoteTest : public WindowTest {
protected:
    bool noted() const { return !window->findChild<RenderPanel*>()->note()->isHidden(); }
    void show(ViewMode mode) {
        window->bench()->edit(QStringLiteral("Mode"), [mode](ViewSettings& s) { switch_mode(s, mode); });
    }
};

TEST_F(NoteTest, AMinimumProjectionOfAPartInAirSaysWhyItIsDark) {
    open(k_casting);
    EXPECT_FALSE(noted());
    show(ViewMode::minip);
    EXPECT_TRUE(noted());
    show(ViewMode::mip);
    EXPECT_FALSE(noted());
    show(ViewMode::minip);
    // What it names as a help ends it: only the part's own values, or a box within the part.
    const double otsu = otsu_threshold(*document().statistics), most = document().statistics->range.hi;
    window->bench()->edit(QStringLiteral("Range"), [&](ViewSettings& s) {
        s.ranges.push_back({{"part", {otsu, most}, {}}, true, {}});
    });
    EXPECT_FALSE(noted());
    window->bench()->edit(QStringLiteral("Range"), [](ViewSettings& s) { s.ranges.front().enabled = false; });
    EXPECT_TRUE(noted());
    window->bench()->edit(QStringLiteral("Box"), [](ViewSettings& s) {
        s.roi.enabled = true;
        s.roi.lo = glm::dvec3(0.02);
        s.roi.hi = glm::dvec3(0.98);
    });
    EXPECT_TRUE(noted()) << "this box holds air all around";
}

}  // namespace
}  // namespace lacuna::ui::test
