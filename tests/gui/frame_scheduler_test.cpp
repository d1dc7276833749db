// The scheduler by itself: what it does when a frame fails, or has nowhere to be shown.
#include "ui/frame_scheduler.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <limits>
#include <set>

#include "core/volume/samples.h"
#include "core/volume/statistics.h"
#include "tests/gui/window_fixture.h"

namespace lacuna::ui::test {
namespace {

class SchedulerTest : public testing::Test {
protected:
    void SetUp() override {
        const Volume volume = make_sample("spheres", {.size = 24}).volume;
        scene = default_scene(volume, compute_statistics(volume));
        scheduler.setSize({64, 48});
        scheduler.setEngine(std::make_shared<Engine>(nullptr));
        QObject::connect(&scheduler, &FrameScheduler::frameReady, &scheduler,
                         [this](const QImage&, const FrameFacts& facts) {
                             full += !facts.coarse;
                             last = facts;
                         });
        QObject::connect(&scheduler, &FrameScheduler::busyChanged, &scheduler, [this](bool now) { busy = now; });
    }
    /// One that no renderer draws.
    Scene wrong() const {
        Scene scene_ = scene;
        scene_.camera.azimuth_deg = std::numeric_limits<double>::quiet_NaN();
        return scene_;
    }
    void show(const Scene& what) { scheduler.setScene(what, default_plan(scene)); }

    Scene scene;
    FrameScheduler scheduler;
    int full = 0;
    bool busy = false;
    FrameFacts last;
};

TEST_F(SchedulerTest, AFrameThatFailsIsSaidAndTheNextChangeDrawsAgain) {
    QSignalSpy failed(&scheduler, &FrameScheduler::failed);
    show(wrong());
    ASSERT_TRUE(failed.count() > 0 || failed.wait(k_patience_ms));
    EXPECT_FALSE(scheduler.busy());
    EXPECT_FALSE(busy);
    show(scene);
    EXPECT_TRUE(QTest::qWaitFor([this] { return full == 1; }, k_patience_ms));
    EXPECT_EQ(failed.count(), 1);
}

TEST_F(SchedulerTest, AChangeMadeWhileAFrameFailsIsDrawn) {
    QSignalSpy failed(&scheduler, &FrameScheduler::failed);
    show(wrong());
    scene.camera.azimuth_deg = 40;
    show(scene);  // before the failure is known
    ASSERT_TRUE(QTest::qWaitFor([this] { return full == 1 && !scheduler.busy(); }, k_patience_ms));
    EXPECT_EQ(last.scene->camera.azimuth_deg, 40);
    EXPECT_EQ(failed.count(), 0) << "of a picture nobody waits for";
    EXPECT_FALSE(busy);
}

TEST_F(SchedulerTest, NoPictureComesOfTheDataBefore) {
    std::set<const void*> seen;
    QObject::connect(&scheduler, &FrameScheduler::frameReady, &scheduler,
                     [&](const QImage&, const FrameFacts& facts) { seen.insert(facts.scene->volume.identity()); });
    show(scene);
    Scene other = scene;
    other.volume = make_sample("spheres", {.size = 20}).volume;
    scheduler.setScene(other, default_plan(other));  // while the first is drawn
    ASSERT_TRUE(QTest::qWaitFor([this] { return full == 1; }, k_patience_ms));
    EXPECT_EQ(seen, std::set<const void*>{other.volume.identity()});
}

TEST_F(SchedulerTest, WithoutAPlaceForThePictureNothingIsBusy) {
    show(scene);
    EXPECT_TRUE(busy);
    scheduler.setSize({});
    EXPECT_FALSE(scheduler.busy());
    EXPECT_FALSE(busy);
    scheduler.setSize({32, 32});
    ASSERT_TRUE(QTest::qWaitFor([this] { return full == 1; }, k_patience_ms));
    EXPECT_EQ(last.scene->size, glm::ivec2(32, 32));
}

TEST_F(SchedulerTest, PicturesOnTheWayComeBeforeTheLastWithThisEnginesFacts) {
    scene.mode = ViewMode::iso;
    scene.effects = parse_effects("ao=16");
    std::vector<FrameFacts> shown;
    QObject::connect(&scheduler, &FrameScheduler::frameReady, &scheduler,
                     [&](const QImage&, const FrameFacts& facts) { shown.push_back(facts); });
    show(scene);
    ASSERT_TRUE(QTest::qWaitFor([this] { return full == 1; }, k_patience_ms));
    // Without ao and coarse; then of 2, 4 and 8 samples; then of all.
    ASSERT_EQ(shown.size(), 5u);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].coarse, i < 4) << i;
        EXPECT_EQ(shown[i].scene->effects.size(), i == 0 ? 0u : 1u) << i;
        EXPECT_EQ(shown[i].device, QString::fromStdString(Engine(nullptr).device_name()));
        if (i > 1) {
            EXPECT_NE(shown[i].frame->color, shown[i - 1].frame->color) << i;
        }
    }
}

}  // namespace
}  // namespace lacuna::ui::test
