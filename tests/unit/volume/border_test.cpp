#include "core/volume/border.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace lacuna;

namespace {

GridGeometry grid(glm::ivec3 size) {
    GridGeometry g;
    g.size = size;
    return g;
}

/// 1 on the six sides, 5 within.
Volume shell(glm::ivec3 size) {
    const GridGeometry g = grid(size);
    return make_volume<std::uint8_t>(g, [&](std::span<std::uint8_t> voxels) {
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const bool side =
                        x == 0 || y == 0 || z == 0 || x == size.x - 1 || y == size.y - 1 || z == size.z - 1;
                    voxels[std::size_t(g.linear_index(x, y, z))] = side ? 1 : 5;
                }
    });
}

}  // namespace

TEST(Border, CountsTheSidesAndNothingWithin) {
    for (const glm::ivec3 size :
         {glm::ivec3(4, 5, 6), glm::ivec3(1, 1, 1), glm::ivec3(1, 7, 3), glm::ivec3(300, 3, 5)}) {
        const Volume volume = shell(size);
        EXPECT_EQ(border_share(volume, {{0, 0, 0}, size}, [](double v) { return v == 1; }), 1) << size.x;
        EXPECT_EQ(border_share(volume, {{0, 0, 0}, size}, [](double v) { return v == 5; }), 0) << size.x;
    }
}

TEST(Border, OfABoxInsideIsThatBoxs) {
    const Volume volume = shell({6, 6, 6});
    EXPECT_EQ(border_share(volume, {{1, 1, 1}, {4, 4, 4}}, [](double v) { return v == 5; }), 1);
    // A 3x3x3 box at the corner: of the 6 sides' 54 places, those at x, y or z = 0.
    int outside = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 2})
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b) outside += side == 0 || a == 0 || b == 0;
    EXPECT_DOUBLE_EQ(border_share(volume, {{0, 0, 0}, {3, 3, 3}}, [](double v) { return v == 1; }), outside / 54.0);
}

TEST(Border, NanCountsAsTheCallerSays) {
    const Volume volume =
        make_volume<float>(grid({2, 2, 2}), [](std::span<float> v) { std::fill(v.begin(), v.end(), NAN); });
    EXPECT_EQ(border_share(volume, {{0, 0, 0}, {2, 2, 2}}, [](double v) { return v <= 1; }), 0);
}
