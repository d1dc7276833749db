#include "core/classify/classification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>

namespace lacuna {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_inf = std::numeric_limits<double>::infinity();
using Answer = VisibilityTable::Answer;

TransferFunction ramp(double from, double to, double opacity_from, double opacity_to) {
    TransferFunction tf;
    tf.points = {{from, {1, 0, 0}, opacity_from}, {to, {0, 1, 0}, opacity_to}};
    return tf;
}

TEST(ClassificationTest, NanIsNowhere) {
    Classification c{ramp(0, 1, 1, 1), {}};
    EXPECT_EQ(c.range_of(k_nan), -1);
    EXPECT_FALSE(c.in_ranges(k_nan));
    EXPECT_EQ(c.at(k_nan).opacity, 0);
    c.ranges = {{"all", {-k_inf, k_inf}, {}}};
    EXPECT_EQ(c.range_of(k_nan), -1);
    EXPECT_FALSE(c.in_ranges(k_nan));
    EXPECT_EQ(c.at(k_nan).opacity, 0);
    EXPECT_TRUE(std::isnan(iso_measure(c, 0, k_nan)));
    EXPECT_TRUE(std::isnan(iso_measure({}, 0, k_nan)));
}

TEST(ClassificationTest, EndsBelongToTheRangeAndTheFirstCounts) {
    const Classification c{ramp(0, 100, 0.5, 0.5),
                           {{"a", {10, 20}, ramp(0, 1, 0.1, 0.1)}, {"b", {20, 30}, {}}, {"upside down", {60, 50}, {}}}};
    EXPECT_EQ(c.range_of(10), 0);
    EXPECT_EQ(c.range_of(20), 0);
    EXPECT_EQ(c.range_of(20.001), 1);
    EXPECT_EQ(c.range_of(55), -1);
    EXPECT_DOUBLE_EQ(c.at(20).opacity, 0.1);
    EXPECT_DOUBLE_EQ(c.at(30).opacity, 0.5);
    EXPECT_EQ(c.at(9.999).opacity, 0);
    EXPECT_FALSE(c.in_ranges(31));
}

TEST(IsoMeasure, SignIsTheVisibilityUnderRanges) {
    EXPECT_DOUBLE_EQ(iso_measure({}, 10, 12.5), 2.5);
    const Classification c{{}, {{"a", {0, 20}, {}}, {"b", {40, 50}, {}}}};
    for (double v = -5; v <= 60; v += 0.25) {
        const bool inside = v >= 10 && c.in_ranges(v);
        EXPECT_EQ(iso_measure(c, 10, v) >= 0, inside) << v;
    }
    for (double v = -5; v < 60; v += 0.25)  // continuous: slope 1 at most
        EXPECT_LE(std::abs(iso_measure(c, 10, v + 0.25) - iso_measure(c, 10, v)), 0.25 + 1e-12);
}

TEST(VisibilityTableTest, EmptyAndNanQueries) {
    const auto table = VisibilityTable::of_iso({}, 100, {0, 255});
    EXPECT_EQ(table.query({k_inf, -k_inf}), Answer::none);
    EXPECT_EQ(table.query({5, 4}), Answer::none);
    EXPECT_EQ(table.query({k_nan, k_nan}), Answer::some);
    EXPECT_EQ(VisibilityTable{}.query({0, 1}), Answer::none);
}

TEST(VisibilityTableTest, OutsideTheTableIsStillSound) {
    const auto table = VisibilityTable::of_iso({}, 300, {0, 255});
    EXPECT_EQ(table.query({0, 255}), Answer::none);
    EXPECT_NE(table.query({0, 400}), Answer::none);
    EXPECT_NE(table.query({350, 400}), Answer::none);
    EXPECT_EQ(table.query({-500, -400}), Answer::none);
    EXPECT_NE(table.query({-k_inf, k_inf}), Answer::none);
}

TEST(VisibilityTableTest, FractionsBetweenWholeNumbersCount) {
    // Nothing at a whole number is visible, yet interpolation between 10 and 11 passes through the range.
    const Classification c{{}, {{"between", {10.4, 10.6}, {}}}};
    for (const double hi : {255.0, 65535.0}) {
        const auto table = VisibilityTable::of_ranges(c, {0, hi});
        EXPECT_EQ(table.query({10, 11}), Answer::some);
        EXPECT_EQ(table.query({20, 21}), Answer::none);
    }
}

TEST(VisibilityTableTest, IsSharpForBytes) {
    const auto table = VisibilityTable::of_iso({}, 127.5, {0, 255});
    EXPECT_EQ(table.query({0, 127}), Answer::none);
    EXPECT_EQ(table.query({128, 255}), Answer::all);
    EXPECT_EQ(table.query({127, 128}), Answer::some);
}

TEST(VisibilityTableTest, ConstantAndUnsoundValueRanges) {
    EXPECT_EQ(VisibilityTable::of_iso({}, 7, {7, 7}).query({7, 7}), Answer::all);
    EXPECT_EQ(VisibilityTable::of_iso({}, 7.5, {7, 7}).query({7, 7}), Answer::none);
    EXPECT_EQ(VisibilityTable::of_ranges({}, {7, 7}).query({7, 7}), Answer::all);
    for (const ValueRange values : {ValueRange{k_nan, k_nan}, {1, 0}, {-k_inf, k_inf}, {0, k_inf}})
        EXPECT_NE(VisibilityTable::of_iso({}, 7, values).query({8, 9}), Answer::none);
    EXPECT_EQ(VisibilityTable::of_iso({}, k_nan, {0, 9}).query({0, 9}), Answer::none);
    EXPECT_EQ(VisibilityTable::of_opacity({}, {0, 9}).query({0, 9}), Answer::none) << "no points, nothing to see";
}

/// Fine values of [lo, hi]: its ends, every half step and the neighbours of every edge.
template <class Visible>
Answer brute_force(ValueRange range, std::span<const double> edges, Visible&& visible) {
    bool any = false, gap = false;
    const auto look = [&](double v) {
        if (!range.contains(v)) return;
        (visible(v) ? any : gap) = true;
    };
    look(range.lo);
    look(range.hi);
    for (const double e : edges)
        for (const double v : {e, std::nextafter(e, -k_inf), std::nextafter(e, k_inf)}) look(v);
    for (int i = 1; i < 64; ++i) look(range.lo + range.width() * i / 64);
    return any ? gap ? Answer::some : Answer::all : Answer::none;
}

TEST(VisibilityTableTest, NeverSaysNoneOrAllWrongly) {
    std::mt19937 random(11);
    const auto pick = [&](double lo, double hi) { return lo + (hi - lo) * double(random()) / 4294967295.0; };
    int certain = 0, possible = 0;
    for (int round = 0; round < 120; ++round) {
        const ValueRange values = round % 3 == 0   ? ValueRange{0, 255}
                                  : round % 3 == 1 ? ValueRange{-1024, 3071}
                                                   : ValueRange{-0.37, 1.93};
        const auto value = [&] {
            const double v = pick(values.lo - 0.1 * values.width(), values.hi + 0.1 * values.width());
            return random() % 2 && round % 3 < 2 ? std::floor(v) : v;
        };
        Classification c;
        std::vector<double> edges;
        for (unsigned i = 0; i < 1 + random() % 5; ++i)
            c.tf.points.push_back({value(), {1, 1, 1}, random() % 2 ? 0.0 : 0.4});
        std::sort(c.tf.points.begin(), c.tf.points.end(), [](auto& a, auto& b) { return a.value < b.value; });
        for (const TransferPoint& p : c.tf.points) edges.push_back(p.value);
        for (unsigned i = 0; i < random() % 4; ++i) {
            double lo = value(), hi = value();
            if (lo > hi) std::swap(lo, hi);
            c.ranges.push_back({"", {lo, hi}, {}});
            if (random() % 2) c.ranges.back().tf = ramp(lo, hi, random() % 2 ? 0.0 : 1.0, 0.0);
            edges.insert(edges.end(), {lo, hi});
        }
        const double iso = value();
        edges.push_back(iso);
        const VisibilityTable tables[]{VisibilityTable::of_opacity(c, values), VisibilityTable::of_iso(c, iso, values),
                                       VisibilityTable::of_ranges(c, values)};
        for (int q = 0; q < 120; ++q) {
            ValueRange range{value(), 0};
            range.hi = range.lo + (q % 4 == 0 ? 0 : pick(0, values.width() * (q % 2 ? 0.02 : 0.6)));
            const Answer truth[]{brute_force(range, edges, [&](double v) { return c.at(v).opacity > 0; }),
                                 brute_force(range, edges, [&](double v) { return iso_measure(c, iso, v) >= 0; }),
                                 brute_force(range, edges, [&](double v) { return c.in_ranges(v); })};
            for (int t = 0; t < 3; ++t) {
                const Answer answer = tables[t].query(range);
                if (answer != Answer::some) {
                    ASSERT_EQ(int(answer), int(truth[t]))
                        << "table " << t << " round " << round << " [" << range.lo << ", " << range.hi << "]";
                    ++certain;
                }
                possible += truth[t] != Answer::some;
            }
        }
    }
    EXPECT_GT(certain, 0.9 * possible) << "conservative, but too coarse to be of use";
}

TEST(VisibilityTableTest, AValueIsNoneOnlyWhereNoGradientCouldShowIt) {
    std::mt19937 random(11);
    const auto number = [&](int most) { return double(random() % unsigned(most)); };
    int none = 0, some = 0;
    for (int round = 0; round < 60; ++round) {
        Classification c{ramp(0, 40, 1, 1), {}};
        for (unsigned i = 0; i < 1 + random() % 3; ++i) {
            const double m = number(20), a = number(30), b = number(30);
            c.tf.shapes.push_back({{m, m + 1 + number(9)},
                                   {a, a + number(6)},
                                   {b, b + number(6)},
                                   glm::dvec3(1),
                                   number(3) / 2,
                                   number(3) / 2});
        }
        const VisibilityTable table = VisibilityTable::of_opacity(c, {0, 40});
        for (double lo = 0; lo < 40; lo += 1.25)
            for (const double width : {0.0, 0.5, 3.0}) {
                bool any = false, all = true;
                for (double v = lo; v <= lo + width; v += 0.125) {
                    for (double m = 0; m <= 32; m += 0.125) any = any || c.tf.at(v, m).opacity > 0;
                    all = all && c.tf.at(v).opacity > 0;  // shapes may be narrower than the steps over magnitudes
                }
                const Answer answer = table.query({lo, lo + width});
                if (any) {
                    ASSERT_NE(answer, Answer::none) << round << " at " << lo;
                }
                if (!all) {
                    ASSERT_NE(answer, Answer::all) << round << " at " << lo;
                }
                none += answer == Answer::none;
                some += any;
            }
    }
    EXPECT_GT(none, 500);  // it is of use
    EXPECT_GT(some, 500);
}

}  // namespace
}  // namespace lacuna
