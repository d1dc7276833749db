#include "ui/views/slice_plane.h"

#include <algorithm>
#include <cmath>

namespace lacuna::ui {

namespace {

/// Letter of the patient direction a vector points to most.
char letter_of(const glm::dvec3& direction) {
    int axis = 0;
    for (int a = 1; a < 3; ++a)
        if (std::abs(direction[a]) > std::abs(direction[axis])) axis = a;
    static constexpr char k_letters[3][2] = {{'L', 'R'}, {'P', 'A'}, {'H', 'F'}};
    return k_letters[axis][direction[axis] < 0];
}

}  // namespace

std::array<int, 3> closest_grid_axes(const GridGeometry& geometry) {
    std::array<int, 3> order{0, 1, 2}, best = order;
    double best_sum = -1;
    do {
        double sum = 0;
        for (int patient = 0; patient < 3; ++patient)
            sum += std::abs(geometry.direction[order[std::size_t(patient)]][patient]);
        if (sum > best_sum + 1e-9) best_sum = sum, best = order;
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

SlicePlane slice_plane(const GridGeometry& geometry, SliceKind kind) {
    const std::array<int, 3> grid = closest_grid_axes(geometry);
    // Patient axes across and down the picture, and the sign each has there.
    struct Layout {
        std::size_t across, down;
        double across_sign, down_sign;
    };
    const Layout layout = kind == SliceKind::axial     ? Layout{0, 1, 1, 1}
                          : kind == SliceKind::coronal ? Layout{0, 2, 1, -1}
                                                       : Layout{1, 2, 1, -1};
    SlicePlane plane;
    plane.kind = kind;
    plane.u = grid[layout.across];
    plane.v = grid[layout.down];
    plane.w = 3 - plane.u - plane.v;
    plane.flip_u = geometry.direction[plane.u][int(layout.across)] * layout.across_sign < 0;
    plane.flip_v = geometry.direction[plane.v][int(layout.down)] * layout.down_sign < 0;
    const glm::dvec3 right = geometry.direction[plane.u] * (plane.flip_u ? -1.0 : 1.0);
    const glm::dvec3 down = geometry.direction[plane.v] * (plane.flip_v ? -1.0 : 1.0);
    plane.right = letter_of(right);
    plane.left = letter_of(-right);
    plane.bottom = letter_of(down);
    plane.top = letter_of(-down);
    return plane;
}

glm::dvec3 SlicePlane::to_voxel(const glm::dvec2& picture, double index, const glm::ivec3& size) const {
    glm::dvec3 voxel;
    voxel[u] = flip_u ? size[u] - 0.5 - picture.x : picture.x - 0.5;
    voxel[v] = flip_v ? size[v] - 0.5 - picture.y : picture.y - 0.5;
    voxel[w] = index;
    return voxel;
}

glm::dvec2 SlicePlane::to_picture(const glm::dvec3& voxel, const glm::ivec3& size) const {
    return {flip_u ? size[u] - 0.5 - voxel[u] : voxel[u] + 0.5, flip_v ? size[v] - 0.5 - voxel[v] : voxel[v] + 0.5};
}

}  // namespace lacuna::ui
