#include "core/volume/voi_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace lacuna {
namespace {

constexpr double k_tiny = 1e-9;

VoiWindow linear(double c, double w) { return {c, w, VoiFunction::linear}; }
VoiWindow exact(double c, double w) { return {c, w, VoiFunction::linear_exact}; }
VoiWindow sigmoid(double c, double w) { return {c, w, VoiFunction::sigmoid}; }

// The worked examples in the notes of PS3.3 C.11.2.1.2.1.
TEST(VoiWindow, LinearHasTheStandardsCorners) {
    EXPECT_EQ(voi_share(linear(2048, 4096), 0), 0);
    EXPECT_NEAR(voi_share(linear(2048, 4096), 1), (1 - 2047.5) / 4095 + 0.5, 1e-15);
    EXPECT_GT(voi_share(linear(2048, 4096), 1), 0);
    EXPECT_EQ(voi_share(linear(2048, 4096), 4095), 1);
    EXPECT_LT(voi_share(linear(2048, 4096), 4094), 1);
    EXPECT_EQ(voi_share(linear(2048, 4096), 5000), 1);
    EXPECT_EQ(voi_share(linear(0, 100), -50), 0);
    EXPECT_NEAR(voi_share(linear(0, 100), -49), 1.0 / 99, 1e-15);
    EXPECT_NEAR(voi_share(linear(0, 100), -0.5), 0.5, 1e-15);
    EXPECT_EQ(voi_share(linear(0, 100), 49), 1);
    EXPECT_LT(voi_share(linear(0, 100), 49 - 1e-6), 1);
    for (const double c : {0.0, 2048.0}) {  // width 1: a step between the whole numbers
        EXPECT_EQ(voi_share(linear(c, 1), c - 0.5), 0);
        EXPECT_EQ(voi_share(linear(c, 1), c - 0.5 + k_tiny), c == 0 ? 1 : voi_share(linear(c, 1), c));
        EXPECT_EQ(voi_share(linear(c, 1), c - 1), 0);
        EXPECT_EQ(voi_share(linear(c, 1), c), 1);
    }
    EXPECT_EQ(voi_share(linear(7, 0.25), 7), voi_share(linear(7, 1), 7));  // below what the standard allows
    EXPECT_EQ(voi_share(linear(7, 0.25), 6), 0);
}

TEST(VoiWindow, LinearExactReachesItsEnds) {
    EXPECT_EQ(voi_share(exact(2048, 4096), 0), 0);
    EXPECT_NEAR(voi_share(exact(2048, 4096), 2048), 0.5, 1e-15);
    EXPECT_NEAR(voi_share(exact(2048, 4096), 4095), 4095.0 / 4096, 1e-15);
    EXPECT_EQ(voi_share(exact(2048, 4096), 4096 + 1e-6), 1);
    EXPECT_EQ(voi_share(exact(0, 100), -50), 0);
    EXPECT_NEAR(voi_share(exact(0, 100), 25), 0.75, 1e-15);
    EXPECT_EQ(voi_share(exact(0, 1e-3), 0), 0.5);  // any width above 0
    EXPECT_EQ(voi_share(exact(5, 0), 5), 0);
    EXPECT_EQ(voi_share(exact(5, 0), 5 + k_tiny), 1);
}

TEST(VoiWindow, SigmoidIsTheLogisticFunction) {
    EXPECT_NEAR(voi_share(sigmoid(40, 400), 40), 0.5, 1e-15);
    EXPECT_NEAR(voi_share(sigmoid(40, 400), 240), 1 / (1 + std::exp(-2.0)), 1e-15);
    EXPECT_NEAR(voi_share(sigmoid(40, 400), -160), 1 / (1 + std::exp(2.0)), 1e-15);
    EXPECT_EQ(voi_share(sigmoid(0, 1), -1e6), 0);  // the exponential overflows: the share does not
    EXPECT_EQ(voi_share(sigmoid(0, 1), 1e6), 1);
    EXPECT_EQ(voi_share(sigmoid(3, 0), 3.5), 1);
    EXPECT_EQ(voi_share(sigmoid(3, 0), 2.5), 0);
}

TEST(VoiWindow, RowsAreTheSharesRoundedAndNanIsBlack) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<float> values = {nan, -inf, -50, -49, 0, 12.25F, 49, 50, 51, inf};
    std::vector<std::uint8_t> grey(values.size());
    for (const VoiWindow& window : {linear(0, 100), exact(0, 100), sigmoid(0, 100), linear(3, 1), exact(3, 0)}) {
        apply_voi(window, values, grey);
        EXPECT_EQ(grey[0], 0);
        EXPECT_EQ(grey.back(), 255);
        for (std::size_t i = 1; i < values.size(); ++i) {
            EXPECT_EQ(grey[i], std::lround(255 * voi_share(window, double(values[i])))) << values[i];
            EXPECT_GE(grey[i], grey[i - 1]);
        }
    }
}

TEST(VoiWindow, ATableIsReadAsTheStandardSays) {
    VoiTable steep{"", -2, {0, 10, 200, 255, 60}, 8};
    VoiWindow window = VoiWindow::of(steep.first, steep.last(), VoiFunction::table);
    window.table = std::make_shared<const VoiTable>(steep);
    for (std::size_t i = 0; i < steep.share.size(); ++i)
        EXPECT_DOUBLE_EQ(voi_share(window, steep.first + double(i)), steep.share[i] / 255.0) << i;
    EXPECT_EQ(voi_share(window, -1e9), 0);  // the first entry's below, the last one's above
    EXPECT_DOUBLE_EQ(voi_share(window, 1e9), 60 / 255.0);
    EXPECT_DOUBLE_EQ(voi_share(window, -0.5), 105 / 255.0);  // between entries
    EXPECT_EQ(voi_share(window, std::nan("")), 0);
    // Stretched over a window of another place and width.
    window.center = 100;
    window.width = 40;
    EXPECT_EQ(voi_share(window, 80), 0);
    EXPECT_DOUBLE_EQ(voi_share(window, 100), 200 / 255.0);
    EXPECT_DOUBLE_EQ(voi_share(window, 120), 60 / 255.0);
    // A row is its values one by one, whole grey levels unchanged.
    const std::vector<float> values = {80, 90, 100, 110, 120, std::nanf(""), 1e30F};
    std::vector<std::uint8_t> grey(values.size());
    apply_voi(window, values, grey);
    EXPECT_EQ(grey, (std::vector<std::uint8_t>{0, 10, 200, 255, 60, 0, 60}));
}

TEST(VoiWindow, ATableOfOddBitsOfOneEntryAndNone) {
    VoiWindow window = VoiWindow::of(0, 1, VoiFunction::table);
    EXPECT_EQ(voi_share(window, 0.25), 0.25) << "no table: linear";
    window.table = std::make_shared<const VoiTable>(VoiTable{"", 0, {0, 1023}, 10});
    EXPECT_EQ(voi_share(window, 1), 1);
    window.table = std::make_shared<const VoiTable>(VoiTable{"", 0, {0, 2000}, 10});  // beyond its bits
    EXPECT_EQ(voi_share(window, 1), 1);
    window = VoiWindow::of(5, 5, VoiFunction::table);
    window.table = std::make_shared<const VoiTable>(VoiTable{"", 5, {51}, 8});
    EXPECT_DOUBLE_EQ(voi_share(window, 5), 0.2);
    EXPECT_DOUBLE_EQ(voi_share(window, 7), 0.2);
    window.table = std::make_shared<const VoiTable>(VoiTable{"", 5, {0, 255}, 8});  // squeezed to a step
    EXPECT_EQ(voi_share(window, 5), 0);
    EXPECT_EQ(voi_share(window, 5.1), 1);
}

TEST(VoiWindow, OfARangeIsItsMiddleAndWidth) {
    EXPECT_EQ(VoiWindow::of(-160, 240, VoiFunction::linear), linear(40, 400));
}

}  // namespace
}  // namespace lacuna
