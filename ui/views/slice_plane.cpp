#include "ui/views/slice_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/session/document.h"
#include "core/volume/axis_names.h"

namespace lacuna::ui {

namespace {

constexpr double k_along_grid = 1 - 1e-12;  ///< cosine under which a plane counts as tilted

/// Which grid axis serves which patient axis (x, y, z): the assignment with the largest total agreement.
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

/// The turn that takes one unit vector to another the shortest way.
glm::dquat shortest_turn(const glm::dvec3& from, const glm::dvec3& to) {
    const double cosine = glm::dot(from, to);
    if (cosine < -1 + 1e-12) {  // half a turn about any axis at right angles
        const glm::dvec3 other = std::abs(from.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        return glm::angleAxis(glm::pi<double>(), glm::normalize(glm::cross(from, other)));
    }
    const glm::dvec3 axis = glm::cross(from, to);
    return glm::normalize(glm::dquat(1 + cosine, axis.x, axis.y, axis.z));
}

/// The picture of one slice of the grid.
SliceFrame grid_frame(const GridGeometry& geometry, const SlicePlane& plane, int index) {
    SliceFrame frame;
    frame.right = plane.right;
    frame.down = plane.down;
    frame.pixel_mm = {geometry.spacing[plane.u], geometry.spacing[plane.v]};
    frame.size = {geometry.size[plane.u], geometry.size[plane.v]};
    glm::dvec3 corner;
    corner[plane.u] = plane.flip_u ? geometry.size[plane.u] - 0.5 : -0.5;
    corner[plane.v] = plane.flip_v ? geometry.size[plane.v] - 0.5 : -0.5;
    corner[plane.w] = index;
    frame.corner_mm = geometry.voxel_to_mm(corner);
    return frame;
}

/// A picture through a point that shows the shadow of the whole box of voxels.
SliceFrame covering_frame(const GridGeometry& geometry, const glm::dvec3& right, const glm::dvec3& down,
                          const glm::dvec3& through_mm) {
    SliceFrame frame;
    frame.right = right;
    frame.down = down;
    glm::dvec2 lo(std::numeric_limits<double>::infinity()), hi(-lo);
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 voxel;
        for (int a = 0; a < 3; ++a) voxel[a] = (corner >> a & 1) ? geometry.size[a] - 0.5 : -0.5;
        const glm::dvec3 mm = geometry.voxel_to_mm(voxel);
        const glm::dvec2 at(glm::dot(mm, right), glm::dot(mm, down));
        lo = glm::min(lo, at);
        hi = glm::max(hi, at);
    }
    const double extent = std::max(hi.x - lo.x, hi.y - lo.y);
    frame.pixel_mm = glm::dvec2(std::max(geometry.smallest_spacing_mm(), extent / k_most_pixels));
    frame.size = glm::max(glm::ivec2(glm::ceil((hi - lo) / frame.pixel_mm - 1e-9)), glm::ivec2(1));
    const glm::dvec3 normal = glm::cross(right, down);
    frame.corner_mm = right * lo.x + down * lo.y + normal * glm::dot(through_mm, normal);
    return frame;
}

}  // namespace

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
    plane.u = grid[layout.across];
    plane.v = grid[layout.down];
    plane.w = 3 - plane.u - plane.v;
    plane.flip_u = geometry.direction[plane.u][int(layout.across)] * layout.across_sign < 0;
    plane.flip_v = geometry.direction[plane.v][int(layout.down)] * layout.down_sign < 0;
    plane.right = geometry.direction[plane.u] * (plane.flip_u ? -1.0 : 1.0);
    plane.down = geometry.direction[plane.v] * (plane.flip_v ? -1.0 : 1.0);
    return plane;
}

SlicePose slice_pose(const GridGeometry& geometry, SliceKind kind, const glm::dquat& tilt,
                     const glm::dvec3& cursor_mm) {
    SlicePose pose;
    pose.plane = slice_plane(geometry, kind);
    pose.index = nearest_voxel(geometry, cursor_mm)[pose.plane.w];
    const glm::dvec3 base = pose.plane.normal(), normal = glm::normalize(tilt * base);
    pose.oblique = !(glm::dot(base, normal) >= k_along_grid);
    if (pose.oblique) {
        const glm::dquat turn = shortest_turn(base, normal);
        pose.frame = covering_frame(geometry, turn * pose.plane.right, turn * pose.plane.down, cursor_mm);
    } else {
        pose.frame = grid_frame(geometry, pose.plane, pose.index);
    }
    pose.page_mm = sheet_distance_mm(geometry, pose.frame.normal());
    pose.right = sides_of(geometry.axis_names, pose.frame.right);
    pose.left = sides_of(geometry.axis_names, -pose.frame.right);
    pose.bottom = sides_of(geometry.axis_names, pose.frame.down);
    pose.top = sides_of(geometry.axis_names, -pose.frame.down);
    return pose;
}

std::array<glm::dvec3, 3> slice_normals(const GridGeometry& geometry, const glm::dquat& tilt) {
    std::array<glm::dvec3, 3> normals;
    for (const SliceKind kind : k_slice_kinds)
        normals[std::size_t(kind)] = glm::normalize(tilt * slice_plane(geometry, kind).normal());
    return normals;
}

bool is_upright(const glm::dquat& tilt) { return std::abs(tilt.w) >= 1 - 1e-13; }

}  // namespace lacuna::ui
