#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "ui/latest_job.h"
#include "ui/panels/cuts_panel.h"
#include "ui/views/slice_annotations.h"
#include "ui/views/slice_image.h"
#include "ui/views/slice_plane.h"
#include "ui/widgets/histogram_shape.h"
#include "ui/widgets/message_bar.h"
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
    geometry.axis_names = AxisNames::patient;
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
        const GridGeometry geometry = grid({4, 5, 6}, row.direction);
        const SlicePose p = slice_pose(geometry, kind, {1, 0, 0, 0}, geometry.centre_mm());
        return p.left + p.right + p.top + p.bottom;
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

TEST(SlicePose, AlongTheGridPixelsAreVoxels) {
    const glm::dmat3 turned({0, -1, 0}, {0, 0, 1}, {-1, 0, 0});
    const GridGeometry geometry = grid({4, 5, 6}, turned);
    for (const SliceKind kind : k_slice_kinds) {
        const SlicePose pose = slice_pose(geometry, kind, {1, 0, 0, 0}, geometry.voxel_to_mm({1.2, 2.9, 4.1}));
        EXPECT_FALSE(pose.oblique);
        EXPECT_TRUE(voxel_walk(geometry, pose.frame).on_grid);
        EXPECT_EQ(pose.index, (glm::ivec3(1, 3, 4)[pose.plane.w]));
        EXPECT_NEAR(pose.page_mm, geometry.spacing[pose.plane.w], 1e-12);
        EXPECT_NEAR(pose.frame.depth_mm(geometry.voxel_to_mm(glm::dvec3(1, 3, 4))), 0, 1e-12);
    }
}

TEST(SlicePose, TiltedPlanesStayAtRightAnglesAndGoThroughTheCrossHair) {
    const GridGeometry geometry = grid({40, 50, 20}, glm::dmat3({1, 0, 0}, {0, c20, -s20}, {0, s20, c20}));
    const glm::dvec3 cursor = geometry.voxel_to_mm({13.3, 21.7, 8.2});
    glm::dquat tilt(1, 0, 0, 0);
    for (int step = 0; step < 40; ++step) {
        // Turned about one view's normal, as its handles do.
        const SliceKind about = k_slice_kinds[std::size_t(step % 3)];
        const SlicePose before = slice_pose(geometry, about, tilt, cursor);
        tilt = glm::normalize(glm::angleAxis(0.1 + 0.03 * step, before.frame.normal()) * tilt);
        const SlicePose after = slice_pose(geometry, about, tilt, cursor);
        EXPECT_NEAR(glm::distance(after.frame.right, before.frame.right), 0, 1e-9) << "its own picture stays";
        const auto normals = slice_normals(geometry, tilt);
        for (std::size_t a = 0; a < 3; ++a) {
            EXPECT_NEAR(glm::length(normals[a]), 1, 1e-12);
            EXPECT_NEAR(glm::dot(normals[a], normals[(a + 1) % 3]), 0, 1e-12);
            const SlicePose pose = slice_pose(geometry, k_slice_kinds[a], tilt, cursor);
            EXPECT_NEAR(glm::distance(pose.frame.normal(), normals[a]), 0, 1e-9);
            if (pose.oblique) {
                EXPECT_NEAR(pose.frame.depth_mm(cursor), 0, 1e-9);
            }
        }
    }
}

TEST(SlicePose, ATiltedPictureShowsTheWholeBoxAndNamesItsSides) {
    const GridGeometry geometry = grid({40, 50, 20});
    const glm::dquat tilt = glm::angleAxis(glm::radians(45.0), glm::dvec3(0, 0, 1));
    const SlicePose coronal = slice_pose(geometry, SliceKind::coronal, tilt, geometry.centre_mm());
    EXPECT_TRUE(coronal.oblique);
    EXPECT_EQ(coronal.right.size(), 2u);
    EXPECT_NE(coronal.right.find('L'), std::string::npos);
    EXPECT_EQ(coronal.top, "H");
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 voxel(corner & 1 ? 39.5 : -0.5, corner & 2 ? 49.5 : -0.5, corner & 4 ? 19.5 : -0.5);
        const glm::dvec2 at = coronal.frame.to_picture(geometry.voxel_to_mm(voxel));
        EXPECT_GE(std::min(at.x, at.y), -1e-9);
        EXPECT_LE(at.x, coronal.frame.size.x + 1e-9);
        EXPECT_LE(at.y, coronal.frame.size.y + 1e-9);
    }
    EXPECT_FALSE(slice_pose(geometry, SliceKind::axial, tilt, geometry.centre_mm()).oblique);
}

QImage picture_of(const Volume& volume, SliceKind kind, glm::ivec3 voxel, const VoiWindow& window) {
    const SlicePose pose =
        slice_pose(volume.geometry(), kind, {1, 0, 0, 0}, volume.geometry().voxel_to_mm(glm::dvec3(voxel)));
    return slice_image(reslice(volume, pose.frame), {pose.frame.size.x, pose.frame.size.y}, window);
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
        const VoiWindow window = VoiWindow::of(0, 255, VoiFunction::linear_exact);
        const QImage axial = picture_of(volume, SliceKind::axial, {x, y, 4}, window);
        EXPECT_EQ(axial.size(), QSize(3, 4));
        EXPECT_EQ(qGray(axial.pixel(2, 0)), 255);
        const QImage coronal = picture_of(volume, SliceKind::coronal, {x, y, 4}, window);
        EXPECT_EQ(coronal.size(), QSize(3, 5));
        EXPECT_EQ(qGray(coronal.pixel(2, 0)), 255);
        const QImage sagittal = picture_of(volume, SliceKind::sagittal, {x, y, 4}, window);
        EXPECT_EQ(sagittal.size(), QSize(4, 5));
        EXPECT_EQ(qGray(sagittal.pixel(0, 0)), 255);
    }
}

TEST(SliceImage, NanAndFlatWindowsAreDrawn) {
    const Volume volume = make_volume<float>(grid({2, 1, 1}), [](std::span<float> v) {
        v[0] = std::nanf("");
        v[1] = 7;
    });
    const QImage flat = picture_of(volume, SliceKind::axial, {0, 0, 0}, {3, 0, VoiFunction::linear_exact});
    EXPECT_EQ(qGray(flat.pixel(0, 0)), 0);
    EXPECT_EQ(qGray(flat.pixel(1, 0)), 255);
    const QImage half = picture_of(volume, SliceKind::axial, {0, 0, 0}, {7, 14, VoiFunction::linear_exact});
    EXPECT_EQ(qGray(half.pixel(1, 0)), 128);
}

TEST(SliceImage, TintsCoverByTheirOpacity) {
    QImage image(2, 1, QImage::Format_RGB32);
    image.fill(qRgb(100, 100, 100));
    SliceOverlay overlay;
    overlay.id = 7;
    overlay.color = QColor(200, 0, 50);
    const std::vector<std::uint32_t> labels = {7, 0};
    QImage none = image, half = image, whole = image;
    tint_image(none, labels, overlay, 0);
    tint_image(half, labels, overlay, 0.5);
    tint_image(whole, labels, overlay, 1);
    EXPECT_EQ(none.pixel(0, 0), image.pixel(0, 0));
    EXPECT_EQ(half.pixel(0, 0), qRgb(150, 50, 75));
    EXPECT_EQ(whole.pixel(0, 0), qRgb(200, 0, 50));
    EXPECT_EQ(whole.pixel(1, 0), image.pixel(1, 0));
}

TEST(ScaleBar, LengthsAreRoundAndFit) {
    for (const double most : {0.0023, 0.07, 0.999, 1.0, 3.0, 49.0, 50.0, 730.0, 1e4}) {
        const ScaleLength length = scale_length(most);
        EXPECT_LE(length.mm, most * (1 + 1e-9));
        EXPECT_GT(length.mm, most / 2.6);
        const double digit = length.mm / std::pow(10.0, std::floor(std::log10(length.mm) + 1e-9));
        EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6) << digit;
    }
    EXPECT_EQ(scale_length(70).name, QStringLiteral("5 cm"));
    EXPECT_EQ(scale_length(0.27).name, QStringLiteral("0.2 mm"));
    EXPECT_EQ(scale_length(0.06).name, QStringLiteral("50 µm"));
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

TEST(ValueSlider, WhatWasSetBeyondTheLimitsIsSaidAsItIs) {
    ValueSlider slider(QStringLiteral("level"));
    slider.setLimits({0, 255});
    slider.setValue(-300);  // as a window dragged by the mouse may be
    EXPECT_EQ(slider.value(), -300);
    EXPECT_EQ(slider.slider()->value(), 0);
    slider.setValue(100);
    slider.spin()->setValue(-20);  // what is typed stays within
    EXPECT_EQ(slider.value(), 0);
}

TEST(ValueSlider, WhatIsTypedComesBackAsTyped) {
    ValueSlider slider(QStringLiteral("level"));
    slider.keepTypedDigits();
    slider.setLimits({-1024, 3071});
    QSignalSpy spy(&slider, &ValueSlider::valueEdited);
    const auto type = [&](const char* text) {
        slider.spin()->selectAll();
        QTest::keyClicks(slider.spin(), QLatin1String(text));
        QTest::keyClick(slider.spin(), Qt::Key_Return);
        return slider.spin()->text().toStdString();
    };
    for (const char* text : {"40.5", "-12.25", "0.1234", "300", "3070.9999"}) {
        EXPECT_EQ(type(text), text);
        EXPECT_EQ(slider.value(), QByteArray(text).toDouble());
        EXPECT_EQ(spy.takeLast().at(0).toDouble(), slider.value());
    }
    slider.setValue(812.34718293);  // as a drag in a slice leaves it
    EXPECT_EQ(slider.spin()->text(), QStringLiteral("812"));
    slider.setValue(0.1 + 0.2);
    EXPECT_EQ(slider.spin()->text(), QStringLiteral("0.3"));
    slider.slider()->setValue(333);
    EXPECT_EQ(slider.value(), std::round(slider.value())) << "the handle moves by whole steps";
    slider.setLimits({0, 1});
    EXPECT_EQ(type("0.5"), "0.50");
    EXPECT_EQ(type("0.123456"), "0.123456");
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

TEST(MessageBar, AQuestionOutlastsWhatElseIsSaid) {
    MessageBar bar;
    int restored = 0;
    bar.ask(QStringLiteral("Restore?"), {{QStringLiteral("Yes"), [&] { ++restored; }}, {QStringLiteral("No"), [] {}}});
    bar.showError(QStringLiteral("A preset cannot be read."));
    EXPECT_TRUE(bar.text().contains(QStringLiteral("preset")));
    EXPECT_TRUE(bar.text().contains(QStringLiteral("Restore?")));
    ASSERT_EQ(bar.answerButtons().size(), 2);
    bar.answerButtons().front()->click();
    EXPECT_EQ(restored, 1);
    EXPECT_EQ(bar.text(), QStringLiteral("A preset cannot be read."));
    bar.showNotice(QStringLiteral("Saved."));
    EXPECT_EQ(bar.text(), QStringLiteral("Saved."));
    EXPECT_TRUE(bar.answerButtons().isEmpty());
    bar.dismiss();
    EXPECT_TRUE(bar.isHidden());
    bar.ask(QStringLiteral("One?"), {{QStringLiteral("Yes"), [] {}}});
    bar.ask(QStringLiteral("Two?"), {{QStringLiteral("Yes"), [] {}}});
    EXPECT_EQ(bar.text(), QStringLiteral("Two?"));
    EXPECT_EQ(bar.answerButtons().size(), 1);
    bar.answerButtons().front()->click();
    EXPECT_TRUE(bar.isHidden());
}

TEST(MessageBar, AVeryLongFileNameMakesNoWindowWider) {
    MessageBar bar;
    const QString name = QStringLiteral("sehr_langer_name_").repeated(12);
    bar.showError(QStringLiteral("Cannot write /data/%1.lacuna: no room.").arg(name));
    EXPECT_LT(bar.minimumSizeHint().width(), 900);
    EXPECT_TRUE(bar.text().startsWith(QStringLiteral("Cannot write /data/sehr_langer_name_")));
    EXPECT_TRUE(bar.text().endsWith(QStringLiteral(".lacuna: no room.")));
    const auto* label = bar.findChild<QLabel*>();
    EXPECT_TRUE(label->toolTip().contains(name));  // all of it
    bar.showNotice(QStringLiteral("Cannot write /data/short.lacuna."));
    EXPECT_EQ(bar.text(), QStringLiteral("Cannot write /data/short.lacuna."));
    EXPECT_TRUE(label->toolTip().isEmpty());
}

TEST(MessageBar, AQuestionLeavesWhatWasSaidBefore) {
    MessageBar bar;
    bar.showError(QStringLiteral("Slice 62 of 100 is missing."));
    bar.ask(QStringLiteral("Restore?"), {{QStringLiteral("Yes"), [] {}}, {QStringLiteral("No"), [] {}}});
    EXPECT_TRUE(bar.text().contains(QStringLiteral("Slice 62"))) << bar.text().toStdString();
    EXPECT_TRUE(bar.text().contains(QStringLiteral("Restore?")));
    EXPECT_TRUE(bar.isError());
    bar.answerButtons().back()->click();
    EXPECT_FALSE(bar.isHidden());
    EXPECT_EQ(bar.text(), QStringLiteral("Slice 62 of 100 is missing."));
}

// A plot of attenuation coefficients under colours for Hounsfield units: most columns lie 2^31 bins and more away.
TEST(HistogramShape, ColumnsFarBesideTheDataStayEmpty) {
    std::vector<std::uint64_t> counts(4096, 0);
    counts.back() = 100;
    const QRectF plot(10, 20, 100, 50);
    const QPainterPath path = histogram_shape(counts, {0, 0.004}, {-1000, 3000}, false, plot);
    ASSERT_EQ(path.elementCount(), 102);  // from the corner over every column to the other corner
    for (int column = 0; column < 100; ++column)
        EXPECT_EQ(path.elementAt(column + 1).y, column == 25 ? plot.top() : plot.bottom()) << column;
}

}  // namespace
}  // namespace lacuna::ui
