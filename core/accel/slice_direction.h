#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace lacuna {

/// A region of viewing directions (Csebfalvi, Konig, Groller 1999): those whose largest component, in voxels, lies
/// along one of the grid's six half-axes; or a quarter of these, told apart by the signs of the other two components.
/// Within a slice u and v are the other two axes, u the lower one.
struct SliceDirection {
    int axis = 2;          ///< the slices lie across this axis
    bool from_low = true;  ///< the eye is at the axis's low end: slice 0 is in front
    int u_lean = 0;  ///< +1: the view goes towards higher u, or keeps u; -1: towards lower u, or keeps it; 0: both
    int v_lean = 0;  ///< the same along v; 0 exactly where u_lean is

    static constexpr std::size_t k_count = 6 + 24;

    int u_axis() const { return axis == 0 ? 1 : 0; }
    int v_axis() const { return axis == 2 ? 1 : 2; }
    bool quarter() const { return u_lean != 0; }
    std::size_t index() const {
        const std::size_t side = std::size_t(2 * axis + (from_low ? 0 : 1));
        return quarter() ? 6 + 4 * side + std::size_t(2 * (v_lean < 0) + (u_lean < 0)) : side;
    }
    friend bool operator==(const SliceDirection&, const SliceDirection&) = default;
};

/// The region of a viewing direction given in voxels. Where two components are equally large the lower axis counts;
/// a component of exactly zero belongs to both neighbours, whose lists both hold all it can see: the positive one.
/// @pre regions is 6 or 24; along is not zero
inline SliceDirection slice_direction(const glm::dvec3& along, int regions) {
    SliceDirection direction{0, true};
    for (int other = 1; other < 3; ++other)
        if (std::fabs(along[other]) > std::fabs(along[direction.axis])) direction.axis = other;
    direction.from_low = along[direction.axis] > 0;
    if (regions == 6) return direction;
    direction.u_lean = along[direction.u_axis()] < 0 ? -1 : 1;
    direction.v_lean = along[direction.v_axis()] < 0 ? -1 : 1;
    return direction;
}

/// All regions of a partition. @pre regions is 6 or 24
inline std::vector<SliceDirection> slice_directions(int regions) {
    std::vector<SliceDirection> all;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool from_low : {true, false}) {
            if (regions == 6) {
                all.push_back({axis, from_low});
                continue;
            }
            for (const int v : {1, -1})
                for (const int u : {1, -1}) all.push_back({axis, from_low, u, v});
        }
    return all;
}

}  // namespace lacuna
