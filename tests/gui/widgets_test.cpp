#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "ui/latest_job.h"
#include "ui/panels/cuts_panel.h"
#include "ui/views/slice_image.h"
#include "ui/views/slice_plane.h"
#include "ui/widgets/range_slider.h"
#include "ui/widgets/transfer_plot.h"
#include "ui/widgets/value_slider.h"

namespace lacuna::ui {
namespace {

GridGeometry grid(glm::ivec3 size, glm::dmat3 direction = glm::dmat3(1)) {
    GridGeometry geometry;
    geometry.size = size;
    geometry.spacing = {1, 1, 5};
    geometry.direction = direction;
    return geometry;
}

struct LetterCase {
    const char* name;
    glm::dmat3 direction;
    const char *axial, *coronal, *sagittal;  // left right top bottom
};
class Letters : public testing::TestWithParam<LetterCase> {};

TEST_P(Letters, AreTheRadiologists) {
    const LetterCase& row = GetParam();
    const auto letters = [&](SliceKind kind) {
        const SlicePlane p = slice_plane(grid({4, 5, 6}, row.direction), kind);
        return std::string{p.left, p.right, p.top, p.bottom};
    };
    EXPECT_EQ(letters(SliceKind::axial), row.axial);
    EXPECT_EQ(letters(SliceKind::coronal), row.coronal);
    EXPECT_EQ(letters(SliceKind::sagittal), row.sagittal);
}
const double c20 = std::cos(glm::radians(20.0)), s20 = std::sin(glm::radians(20.0));
INSTANTIATE_TEST_SUITE_P(
    Directions, Letters,
    testing::Values(LetterCase{"oblique", glm::dmat3({1, 0, 0}, {0, c20, -s20}, {0, s20, c20}), "RLAP", "RLHF", "APHF"},
                    LetterCase{"flipped", glm::dmat3({-1, 0, 0}, {0, -1, 0}, {0, 0, 1}), "RLAP", "RLHF", "APHF"},
                    LetterCase{"sagittal_stack", glm::dmat3({0, 1, 0}, {0, 0, -1}, {1, 0, 0}), "RLAP", "RLHF", "APHF"},
                    LetterCase{"plain", glm::dmat3(1), "RLAP", "RLHF", "APHF"}),
    [](const auto& row) { return row.param.name; });

TEST(SlicePlane, PicturePositionsAndVoxelsAreOneAnother) {
    const glm::dmat3 turned({0, -1, 0}, {0, 0, 1}, {-1, 0, 0});
    const GridGeometry geometry = grid({4, 5, 6}, turned);
    for (const SliceKind kind : {SliceKind::axial, SliceKind::coronal, SliceKind::sagittal}) {
        const SlicePlane plane = slice_plane(geometry, kind);
        const glm::dvec3 voxel = plane.to_voxel({1.25, 2.5}, 3, geometry.size);
        const glm::dvec2 back = plane.to_picture(voxel, geometry.size);
        EXPECT_NEAR(back.x, 1.25, 1e-12);
        EXPECT_NEAR(back.y, 2.5, 1e-12);
        EXPECT_EQ(voxel[plane.w], 3);
    }
}

TEST(SliceImage, TheLeftSideIsOnTheRightAndTheFrontOnTop) {
    for (const double sign : {1.0, -1.0}) {
        // One bright voxel at the patient's left, front, head corner, whichever way the grid runs.
        const GridGeometry geometry = grid({3, 4, 5}, glm::dmat3({sign, 0, 0}, {0, sign, 0}, {0, 0, 1}));
        const int x = sign > 0 ? 2 : 0, y = sign > 0 ? 0 : 3;
        const Volume volume = make_volume<std::uint8_t>(geometry, [&](std::span<std::uint8_t> v) {
            std::fill(v.begin(), v.end(), std::uint8_t(0));
            v[std::size_t(geometry.linear_index(x, y, 4))] = 255;
        });
        const QImage axial = slice_image(volume, slice_plane(geometry, SliceKind::axial), 4, {0, 255});
        EXPECT_EQ(axial.size(), QSize(3, 4));
        EXPECT_EQ(qGray(axial.pixel(2, 0)), 255);
        const QImage coronal = slice_image(volume, slice_plane(geometry, SliceKind::coronal), y, {0, 255});
        EXPECT_EQ(coronal.size(), QSize(3, 5));
        EXPECT_EQ(qGray(coronal.pixel(2, 0)), 255);
        const QImage sagittal = slice_image(volume, slice_plane(geometry, SliceKind::sagittal), x, {0, 255});
        EXPECT_EQ(sagittal.size(), QSize(4, 5));
        EXPECT_EQ(qGray(sagittal.pixel(0, 0)), 255);
    }
}

TEST(SliceImage, NanAndFlatWindowsAreDrawn) {
    const Volume volume = make_volume<float>(grid({2, 1, 1}), [](std::span<float> v) {
        v[0] = std::nanf("");
        v[1] = 7;
    });
    const SlicePlane plane = slice_plane(volume.geometry(), SliceKind::axial);
    const QImage flat = slice_image(volume, plane, 0, {3, 3});
    EXPECT_EQ(qGray(flat.pixel(0, 0)), 0);
    EXPECT_EQ(qGray(flat.pixel(1, 0)), 255);
    EXPECT_EQ(qGray(slice_image(volume, plane, 0, {0, 14}).pixel(1, 0)), 128);
}

TEST(RangeSlider, HandlesMoveByMouseAndKeysAndNeverCross) {
    RangeSlider slider;
    slider.resize(218, 24);
    slider.setLimits({0, 100});
    slider.setStep(1);
    slider.setRange({20, 80});
    slider.show();
    QSignalSpy spy(&slider, &RangeSlider::rangeEdited);
    EXPECT_EQ(spy.count(), 0);  // setters are silent
    QTest::mousePress(&slider, Qt::LeftButton, {}, slider.handlePosition(0).toPoint());
    QTest::mouseMove(&slider, QPoint(215, 12));
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, QPoint(215, 12));
    EXPECT_EQ(slider.range(), (ValueRange{80, 80}));
    slider.setRange({20, 80});
    slider.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&slider, Qt::Key_Right);
    EXPECT_EQ(slider.range(), (ValueRange{21, 80}));
    QTest::keyClick(&slider, Qt::Key_Home);
    EXPECT_EQ(slider.range(), (ValueRange{0, 80}));
    EXPECT_GT(spy.count(), 2);
}

TEST(ValueSlider, SettersAreSilentAndNumbersExact) {
    ValueSlider slider(QStringLiteral("value"));
    slider.setLimits({-1024, 3071});
    QSignalSpy spy(&slider, &ValueSlider::valueEdited);
    slider.setValue(137);
    EXPECT_EQ(spy.count(), 0);
    EXPECT_EQ(slider.value(), 137);
    ValueSlider around_zero(QStringLiteral("angle"));  // a fresh spin box is 0 already: the handle must still follow
    around_zero.setLimits({-90, 90});
    around_zero.setValue(0);
    EXPECT_EQ(around_zero.slider()->value(), around_zero.slider()->maximum() / 2);
    slider.slider()->setValue(500);
    EXPECT_EQ(spy.count(), 1);
}

TEST(TransferPlot, AKeptPointBeyondTheDataIsNotPulledIn) {
    TransferPlot plot;
    plot.resize(300, 180);
    plot.setHistogram({1, 2, 3}, {0, 100});
    TransferFunction function;
    function.points = {{-500, glm::dvec3(1), 0.5}, {50, glm::dvec3(1), 1}};
    plot.setFunction(function);
    plot.select(0);
    QTest::keyClick(&plot, Qt::Key_Up);
    EXPECT_EQ(plot.function().points[0].value, -500);
    EXPECT_NEAR(plot.function().points[0].opacity, 0.52, 1e-12);
}

TEST(CutPose, PlanesAndPosesAreOneAnother) {
    const GridGeometry geometry = grid({10, 20, 30}, glm::dmat3({0, -1, 0}, {0, 0, 1}, {-1, 0, 0}));
    for (const CutPose& pose : {CutPose{0, 0, 0}, CutPose{90, 0, 3}, CutPose{-120, 35, -7}, CutPose{0, 90, 1}}) {
        const CutPose back = pose_of(plane_of(pose, true, geometry), geometry);
        EXPECT_NEAR(back.azimuth_deg, pose.azimuth_deg, 1e-9);
        EXPECT_NEAR(back.elevation_deg, pose.elevation_deg, 1e-6);
        EXPECT_NEAR(back.distance_mm, pose.distance_mm, 1e-9);
    }
}

TEST(LatestJob, OnlyTheNewestTells) {
    QObject owner;
    LatestJob<int> job(&owner);
    std::vector<int> told;
    for (int i = 0; i < 20; ++i)
        job.start([i](const JobContext&) { return i; },
                  [&](Outcome<int> outcome) { told.push_back(std::get<int>(outcome)); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !told.empty(); }, 20000));
    QTest::qWait(20);
    EXPECT_EQ(told, std::vector<int>{19});
    EXPECT_FALSE(job.running());
}

TEST(LatestJob, ErrorsCrossAsValuesAndTheEndWaits) {
    QObject owner;
    bool seen = false, left = false;
    {
        LatestJob<int> job(&owner);
        job.start(
            [](const JobContext&) -> int { throw Error(Errc::io, "The disk is full."); },
            [&](Outcome<int> outcome) { seen = std::string(std::get<Error>(outcome).what()) == "The disk is full."; });
        ASSERT_TRUE(QTest::qWaitFor([&] { return seen; }, 20000));
        std::atomic<bool> begun = false;
        job.start(
            [&](const JobContext& context) {
                begun = true;
                while (!context.stopped()) std::this_thread::yield();
                left = true;
                return 0;
            },
            [&](Outcome<int>) { seen = false; });
        while (!begun) std::this_thread::yield();
    }
    EXPECT_TRUE(left);
    QCoreApplication::processEvents();
    EXPECT_TRUE(seen);
}

}  // namespace
}  // namespace lacuna::ui
