#include "core/volume/axis_names.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {

std::string_view axis_end(AxisNames names, int axis, bool negative) {
    static constexpr std::string_view k_patient[3][2] = {{"L", "R"}, {"P", "A"}, {"H", "F"}};
    static constexpr std::string_view k_xyz[3][2] = {{"+X", "-X"}, {"+Y", "-Y"}, {"+Z", "-Z"}};
    return (names == AxisNames::patient ? k_patient : k_xyz)[axis][negative];
}

std::string sides_of(AxisNames names, const glm::dvec3& direction) {
    const double threshold = std::sin(glm::radians(25.0));
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]) + 1e-9; });
    std::string sides;
    for (const int axis : axes)
        if (sides.empty() || std::abs(direction[axis]) >= threshold)
            sides += axis_end(names, axis, direction[axis] < 0);
    return sides;
}

std::string axis_span(AxisNames names, const glm::dvec3& direction) {
    const int axis = closest_axis(direction);
    const bool backwards = direction[axis] < 0;
    // A dash between signs would be read as one of them.
    return std::string(axis_end(names, axis, !backwards)) + (names == AxisNames::patient ? "–" : "…") +
           std::string(axis_end(names, axis, backwards));
}

AxisPlace place_along(AxisNames names, int axis, double mm) {
    static constexpr std::string_view k_axes[3] = {"X", "Y", "Z"};
    if (names == AxisNames::patient) return {axis_end(names, axis, mm < 0), std::abs(mm)};
    return {k_axes[axis], mm};
}

int closest_axis(const glm::dvec3& direction) {
    int axis = 0;
    for (int a = 1; a < 3; ++a)
        if (std::abs(direction[a]) > std::abs(direction[axis])) axis = a;
    return axis;
}

}  // namespace lacuna
