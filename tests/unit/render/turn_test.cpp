#include "core/render/turn.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(FullTurn, ViewsAreEvenlySpreadFromTheFirst) {
    Camera first;
    first.azimuth_deg = 30;
    first.elevation_deg = 10;
    first.zoom = 2;
    EXPECT_EQ(full_turn(first, 1), std::vector<Camera>{first});
    const std::vector<Camera> turn = full_turn(first, 8);
    ASSERT_EQ(turn.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_DOUBLE_EQ(turn[i].azimuth_deg, 30 + 45.0 * double(i));
        EXPECT_EQ(turn[i].elevation_deg, 10);
        EXPECT_EQ(turn[i].zoom, 2);
    }
}

}  // namespace
}  // namespace lacuna
