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

    /// Changes the settings and waits for the list of the picture that follows.
    void change(const std::function<void(ViewSettings&)>& apply) {
        QSignalSpy updated(&feature(), &LimitsFeature::updated);
        window->bench()->edit(QStringLiteral("Test"), apply);
        ASSERT_TRUE(updated.wait(k_patience_ms));
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

    change([](ViewSettings& s) { s.mode = ViewMode::iso; });
    EXPECT_TRUE(list().contains(QStringLiteral("Walls between two samples")));
    EXPECT_FALSE(list().contains(QStringLiteral("Opacity of a step")));

    change([](ViewSettings& s) { s.mode = ViewMode::shear_warp; });
    EXPECT_TRUE(list().contains(QStringLiteral("Popping")));
    EXPECT_FALSE(meets("Popping"));
    QSignalSpy turned(&feature(), &LimitsFeature::updated);
    Camera camera = document().camera;
    camera.azimuth_deg = 45;
    camera.elevation_deg = 0;
    window->documents()->setCamera(camera);
    ASSERT_TRUE(turned.wait(k_patience_ms));
    EXPECT_TRUE(meets("Popping")) << list().toStdString();
    EXPECT_TRUE(list().contains(QStringLiteral("principal axis")));
}

}  // namespace
}  // namespace lacuna::ui::test
