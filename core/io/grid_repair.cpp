#include "core/io/grid_repair.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace lacuna {

namespace {

double largest_deviation(const glm::dmat3& d) {
    const glm::dmat3 product = glm::transpose(d) * d;
    double worst = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            const double off = std::abs(product[c][r] - (c == r ? 1.0 : 0.0));
            worst = off <= worst ? worst : off;  // a NaN wins
        }
    return worst;
}

/// The nearest orthogonal matrix by Newton's iteration for the polar decomposition (Higham 1986); keeps handedness.
glm::dmat3 nearest_orthonormal(glm::dmat3 d) {
    for (int i = 0; i < 20; ++i) d = 0.5 * (d + glm::transpose(glm::inverse(d)));
    return d;
}

}  // namespace

void repair_grid(const std::string& what, GridGeometry& geometry, std::vector<Warning>& warnings) {
    constexpr double k_silent = 1e-5, k_limit = 1e-3;
    for (int a = 0; a < 3; ++a) {
        if (!(geometry.spacing[a] > 0 && std::isfinite(geometry.spacing[a])))
            throw Error(Errc::bad_input, "Cannot read " + what + ": its spacing along axis " + std::to_string(a + 1) +
                                             " is " + std::to_string(geometry.spacing[a]) +
                                             ", but spacings must be positive numbers of mm.");
        if (!std::isfinite(geometry.origin[a]))
            throw Error(Errc::bad_input, "Cannot read " + what + ": its origin is not a finite position.");
    }
    const double deviation = largest_deviation(geometry.direction);
    if (!(deviation <= k_limit))
        throw Error(Errc::bad_input, "Cannot read " + what +
                                         ": its axes are not at right angles or not of unit length (deviation " +
                                         std::to_string(deviation) + "); resample it to a rectangular grid first.");
    if (deviation == 0) return;
    const glm::dmat3 sound = nearest_orthonormal(geometry.direction);
    const glm::dvec3 extent = glm::dvec3(geometry.size - 1) * geometry.spacing;
    double error_mm = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at(corner & 1 ? extent.x : 0, corner & 2 ? extent.y : 0, corner & 4 ? extent.z : 0);
        error_mm = std::max(error_mm, glm::length((sound - geometry.direction) * at));
    }
    geometry.direction = sound;
    if (deviation > k_silent)
        warnings.push_back({"The grid's axes are not exactly at right angles; they were made so.", error_mm});
}

}  // namespace lacuna
