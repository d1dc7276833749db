#include "core/chart/axis_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace lacuna {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

Extent extent(std::initializer_list<double> values, Scale scale) {
    Extent made;
    for (const double v : values) made.add(v, scale);
    return made;
}

Axis axis(Scale scale) {
    Axis made;
    made.scale = scale;
    return made;
}

TEST(AxisScale, LinearPlacesInProportion) {
    Axis x = axis(Scale::linear);
    x.lo = 0, x.hi = 10;
    const AxisScale scale(x, {}, 100, 300);
    EXPECT_DOUBLE_EQ(scale.at(0), 100);
    EXPECT_DOUBLE_EQ(scale.at(10), 300);
    EXPECT_DOUBLE_EQ(scale.at(2.5), 150);
    const AxisScale down(x, {}, 300, 100);  // y grows downwards on a page
    EXPECT_DOUBLE_EQ(down.at(2.5), 250);
}

TEST(AxisScale, LogPlacesByRatio) {
    Axis x = axis(Scale::log);
    x.lo = 0.01, x.hi = 100;
    const AxisScale scale(x, {}, 0, 400);
    EXPECT_NEAR(scale.at(0.1), 100, 1e-9);
    EXPECT_NEAR(scale.at(1), 200, 1e-9);
    EXPECT_TRUE(std::isnan(scale.at(0)));
    EXPECT_TRUE(std::isnan(scale.at(-1)));
    EXPECT_TRUE(std::isnan(scale.at(k_nan)));
    EXPECT_TRUE(std::isnan(scale.at(std::numeric_limits<double>::infinity())));
}

TEST(AxisScale, ZeroHasALaneOnlyWhereItIsAskedForAndThere) {
    Axis x = axis(Scale::log);
    x.zero_lane = true;
    EXPECT_FALSE(AxisScale(x, extent({1, 100}, Scale::log), 0, 400).has_lane());
    const AxisScale lane(x, extent({0, 1, 100}, Scale::log), 0, 400);
    EXPECT_TRUE(lane.has_lane());
    EXPECT_LT(lane.at(0), lane.lane_end());
    EXPECT_GT(lane.at(0), 0);
    EXPECT_GT(lane.at(1), lane.lane_end());
    EXPECT_EQ(lane.ticks(6).front().label, "0");
    const AxisScale up(x, extent({0, 1, 100}, Scale::log), 400, 0);
    EXPECT_GT(up.at(0), up.lane_end());
    EXPECT_LT(up.at(1), up.lane_end());
}

TEST(AxisScale, HoldsAllItsDataWithAMargin) {
    for (const Scale kind : {Scale::linear, Scale::log}) {
        const Extent data = extent({3, 0.5, 800, k_nan}, kind);
        const AxisScale scale(axis(kind), data, 0, 100);
        EXPECT_LT(scale.lo(), 0.5);
        EXPECT_GT(scale.hi(), 800);
    }
}

TEST(AxisScale, BarsStandOnZero) {
    const AxisScale scale(axis(Scale::linear), extent({5, 9}, Scale::linear), 0, 100, true);
    EXPECT_EQ(scale.lo(), 0);
    EXPECT_GT(scale.hi(), 9);
}

TEST(AxisScale, OneValueOrNoneStillMakesAnAxis) {
    for (const Scale kind : {Scale::linear, Scale::log})
        for (const Extent& data : {Extent{}, extent({7}, kind), extent({0}, kind)}) {
            const AxisScale scale(axis(kind), data, 0, 100);
            EXPECT_LT(scale.lo(), scale.hi());
            EXPECT_GE(scale.ticks(5).size(), 1u);
        }
}

TEST(AxisScale, ValuesApartByRoundingAloneAreOne) {
    for (const double value : {1.0, -3.7e9, 5e-7}) {
        Extent extent;
        extent.add(value, Scale::linear);
        extent.add(std::nextafter(value, 1e300), Scale::linear);
        const AxisScale scale({}, extent, 0, 100);
        EXPECT_LT(scale.lo(), value);
        EXPECT_LT(scale.ticks(5).size(), 20u);
        EXPECT_GT(scale.ticks(5).size(), 1u);
    }
}

TEST(AxisScale, RefusesEndsThatAreOff) {
    Axis x = axis(Scale::linear);
    x.lo = 2, x.hi = 2;
    EXPECT_THROW(AxisScale(x, {}, 0, 100), Error);
    x.lo = k_nan;
    EXPECT_THROW(AxisScale(x, {}, 0, 100), Error);
    Axis log = axis(Scale::log);
    log.lo = 0, log.hi = 2;
    EXPECT_THROW(AxisScale(log, {}, 0, 100), Error);
}

TEST(AxisScale, TicksAscendLieInsideAndSomeAreNamed) {
    for (const Scale kind : {Scale::linear, Scale::log})
        for (const double lo : {1e-9, 0.013, 1.0, 77.0, 4e6})
            for (const double ratio : {1.01, 1.9, 4.0, 30.0, 1e3, 1e9}) {
                Axis x = axis(kind);
                x.lo = lo, x.hi = lo * ratio;
                const AxisScale scale(x, {}, 0, 400);
                const std::vector<Tick> ticks = scale.ticks(6);
                double before = -1;
                int named = 0;
                for (const Tick& tick : ticks) {
                    EXPECT_GT(tick.value, before);
                    EXPECT_GE(scale.at(tick.value), -1e-3);
                    EXPECT_LE(scale.at(tick.value), 400 + 1e-3);
                    before = tick.value;
                    named += !tick.label.empty();
                }
                EXPECT_LE(named, 14) << lo << " " << ratio;
                if (kind == Scale::linear || ratio > 3) {
                    EXPECT_GE(named, 2) << lo << " " << ratio << (kind == Scale::log ? " log" : "");
                }
            }
}

TEST(AxisScale, CategoriesAreNamedWhereTheyStand) {
    Axis x;
    x.categories = {"none", "octree", "eacd"};
    const AxisScale scale(x, extent({0, 1, 2}, Scale::linear), 0, 300);
    EXPECT_DOUBLE_EQ(scale.at(0), 50);
    EXPECT_DOUBLE_EQ(scale.at(2), 250);
    EXPECT_EQ(scale.ticks(2)[1].label, "octree");
}

TEST(Readable, NumbersAsReadersWantThem) {
    EXPECT_EQ(readable(0), "0");
    EXPECT_EQ(readable(0.25), "0.25");
    EXPECT_EQ(readable(1500), "1500");
    EXPECT_EQ(readable(25000), "25\u2009000");
    EXPECT_EQ(readable(-3), "\u22123");
    EXPECT_EQ(readable(1e-7), "10⁻⁷");
    EXPECT_EQ(readable(3e9), "3·10⁹");
    EXPECT_EQ(readable(0.1 + 0.2), "0.3");
    EXPECT_EQ(readable(9.99999e-6), "10⁻⁵");
}

}  // namespace
}  // namespace lacuna
