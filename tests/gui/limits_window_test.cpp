// The list of where the way of drawing on screen fails.
#include "tests/gui/window_fixture.h"

namespace lacuna::ui::test {
namespace {

class LimitsWindowTest : public WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        window->resize(760, 620);
        open(QStringLiteral("sample:spheres@24"));
    }

    LimitsFeature& feature() { return *window->limitsFeature(); }
    QString list() { return feature().text()->toPlainText(); }

    /// Changes the mode and waits for a list that has this.
    void changeMode(ViewMode mode, const char* expected) {
        window->bench()->edit(QStringLiteral("Test"), [mode](ViewSettings& s) { s.mode = mode; });
        ASSERT_TRUE(QTest::qWaitFor([&] { return list().contains(QLatin1String(expected)); }, k_patience_ms))
            << expected << " is not in\n"
            << list().toStdString();
    }
    bool meets(const char* name) {
        return std::any_of(feature().met().begin(), feature().met().end(),
                           [&](const MetLimit& met) { return met.limit->name == name; });
    }
};

TEST_F(LimitsWindowTest, FollowsTheModeAndMarksWhatTheSceneMeets) {
    EXPECT_TRUE(list().isEmpty()) << "nothing is measured while nobody looks";
    QSignalSpy updated(&feature(), &LimitsFeature::updated);
    QTest::keyClick(window.get(), Qt::Key_F1, Qt::ControlModifier);
    ASSERT_TRUE(updated.count() > 0 || updated.wait(k_patience_ms));
    EXPECT_TRUE(feature().dock()->isVisible());
    EXPECT_TRUE(feature().text()->hasFocus());
    EXPECT_GE(feature().listed(), 6);
    EXPECT_TRUE(list().contains(QStringLiteral("Opacity of a step"))) << list().toStdString();
    EXPECT_FALSE(list().contains(QStringLiteral("Popping")));

    changeMode(ViewMode::iso, "Walls between two samples");
    EXPECT_FALSE(list().contains(QStringLiteral("Opacity of a step")));
    changeMode(ViewMode::shear_warp, "Popping");
    EXPECT_FALSE(list().contains(QStringLiteral("Walls between two samples")));
    EXPECT_FALSE(meets("Popping"));
    Camera camera = document().camera;
    camera.azimuth_deg = 45;
    camera.elevation_deg = 0;
    window->documents()->setCamera(camera);
    ASSERT_TRUE(QTest::qWaitFor([&] { return meets("Popping"); }, k_patience_ms)) << list().toStdString();
    EXPECT_TRUE(list().contains(QStringLiteral("principal axis")));
}

}  // namespace
}  // namespace lacuna::ui::test
