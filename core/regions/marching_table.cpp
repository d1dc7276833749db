#include "core/regions/marching_table.h"

#include <algorithm>
#include <utility>

namespace lacuna {

namespace {

int edge_between(int a, int b) {
    const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
    const int base = a & b;
    const int low_bit = axis == 0 ? base >> 1 & 1 : base & 1, high_bit = axis == 2 ? base >> 1 & 1 : base >> 2 & 1;
    return 4 * axis + low_bit + 2 * high_bit;
}

/// Corners of a face, counter-clockwise seen from outside the cube.
std::array<int, 4> corners_of_face(int axis, int side) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
    if (side) return {base, base | u, base | u | v, base | v};
    return {base, base | v, base | u | v, base | u};
}

bool share_face(int edge_a, int edge_b) {
    const auto [a0, a1] = corners_of_edge(edge_a);
    const auto [b0, b1] = corners_of_edge(edge_b);
    const int all_set = a0 & a1 & b0 & b1, any_set = a0 | a1 | b0 | b1;
    return all_set != 0 || any_set != 7;  // some coordinate agrees in all four corners
}

bool fan_is_clear(const std::vector<std::uint8_t>& loop) {
    for (std::size_t k = 2; k + 1 < loop.size(); ++k)
        if (share_face(loop[0], loop[k])) return false;
    return true;
}

MarchingCase build_case(int inside) {
    const auto is_inside = [inside](int corner) { return (inside >> corner & 1) != 0; };
    // On each face, from where its rim enters the inside to where it leaves again: a chord of the surface.
    std::array<int, 12> next;
    next.fill(-1);
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const std::array<int, 4> corner = corners_of_face(axis, side);
            for (int i = 0; i < 4; ++i) {
                if (is_inside(corner[i]) || !is_inside(corner[(i + 1) % 4])) continue;
                int j = i + 1;
                while (is_inside(corner[(j + 1) % 4])) ++j;
                next[edge_between(corner[i], corner[(i + 1) % 4])] = edge_between(corner[j % 4], corner[(j + 1) % 4]);
            }
        }
    MarchingCase result;
    for (int start = 0; start < 12; ++start) {
        if (next[start] < 0) continue;
        std::vector<std::uint8_t> loop;
        for (int edge = start; next[edge] >= 0;) {
            loop.push_back(std::uint8_t(edge));
            edge = std::exchange(next[edge], -1);
        }
        bool clear = fan_is_clear(loop);
        for (std::size_t turn = 1; turn < loop.size() && !clear; ++turn) {
            std::rotate(loop.begin(), loop.begin() + 1, loop.end());
            clear = fan_is_clear(loop);
        }
        (clear ? result.fans : result.wheels).push_back(std::move(loop));
    }
    return result;
}

}  // namespace

std::array<int, 2> corners_of_edge(int edge) {
    const int axis = edge / 4, low_bit = edge & 1, high_bit = edge >> 1 & 1;
    const int low = axis == 0 ? 2 : 1, high = axis == 2 ? 2 : 4;
    const int base = low_bit * low + high_bit * high;
    return {base, base | 1 << axis};
}

const std::array<MarchingCase, 256>& marching_cases() {
    static const std::array<MarchingCase, 256> cases = [] {
        std::array<MarchingCase, 256> all;
        for (int inside = 0; inside < 256; ++inside) all[std::size_t(inside)] = build_case(inside);
        return all;
    }();
    return cases;
}

}  // namespace lacuna
