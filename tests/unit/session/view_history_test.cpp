#include "core/session/view_history.h"

#include <gtest/gtest.h>

#include <random>

namespace lacuna {
namespace {

Viewpoint at(double azimuth_deg, double x_mm = 0) {
    Viewpoint point;
    point.camera.azimuth_deg = azimuth_deg;
    point.cursor_mm.x = x_mm;
    return point;
}

TEST(ViewHistory, GoesBackAndForwardThroughGesturesAsWholes) {
    ViewHistory history;
    history.reset(at(0));
    EXPECT_FALSE(history.can_go_back());
    EXPECT_EQ(history.back_name(), "");
    for (int i = 1; i <= 10; ++i) history.note("turn", at(i));
    history.seal();
    history.note("turn", at(20));
    history.note("slices", at(20, 5));
    EXPECT_EQ(history.back_name(), "slices");
    EXPECT_EQ(history.back(), at(20));
    EXPECT_EQ(history.forward_name(), "slices");
    EXPECT_EQ(history.back(), at(10));
    EXPECT_EQ(history.back(), at(0));
    EXPECT_FALSE(history.can_go_back());
    EXPECT_EQ(history.forward(), at(10));
    EXPECT_EQ(history.now(), at(10));
    history.note("turn", at(11));  // what was gone back from is gone
    EXPECT_FALSE(history.can_go_forward());
    EXPECT_EQ(history.back(), at(10));
    EXPECT_EQ(history.back(), at(0));
}

TEST(ViewHistory, AGestureThatComesBackAndAMoveToTheSamePlaceAreNoSteps) {
    ViewHistory history;
    history.reset(at(3));
    history.note("turn", at(3));
    EXPECT_FALSE(history.can_go_back());
    history.note("turn", at(4));
    history.note("turn", at(3));
    EXPECT_FALSE(history.can_go_back());
    history.note("turn", at(5), true);  // nothing is left to join
    EXPECT_EQ(history.back(), at(3));
}

TEST(ViewHistory, WhatJoinsTakesItsNameAlong) {
    ViewHistory history;
    history.reset(at(0));
    history.note("slices", at(0, 1));
    history.note("both", at(9, 1), true);
    EXPECT_EQ(history.back_name(), "both");
    EXPECT_EQ(history.back(), at(0));
    EXPECT_EQ(history.forward(), at(9, 1));
}

TEST(ViewHistory, AnyWayBackAndForthMeetsTheSamePlaces) {
    std::mt19937 random(11);
    ViewHistory history(50);
    history.reset(at(0));
    std::vector<Viewpoint> places{at(0)};
    for (int i = 1; i <= 80; ++i) {
        places.push_back(at(i, double(random() % 7)));
        history.note("move", places.back());
        history.seal();
    }
    int steps = 0;
    for (; history.can_go_back(); ++steps) EXPECT_EQ(history.back(), places[places.size() - 2 - std::size_t(steps)]);
    EXPECT_EQ(steps, 50);  // the oldest are forgotten
    while (history.can_go_forward()) history.forward();
    EXPECT_EQ(history.now(), places.back());
}

}  // namespace
}  // namespace lacuna
