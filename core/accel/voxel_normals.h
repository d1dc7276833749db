#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "core/volume/volume.h"

namespace lacuna {

/// How the gradient of a listed voxel is estimated: central differences (6 voxels), Sobel's operator (3x3x3) or the
/// derivative of a Gaussian of sigma 1 voxel (5x5x5). So few voxels are listed that the better filters are affordable.
enum class VoxelGradient { central, sobel, gaussian };

/// Unit gradients at voxels, along the grid's axes in mm; voxels beyond the border are taken from it. 0 where the
/// gradient is zero or not finite.
template <class T>
class VoxelNormals {
public:
    VoxelNormals(const Volume& volume, VoxelGradient filter)
        : view_(volume.view<T>()), per_mm_(1.0 / volume.geometry().spacing), filter_(filter) {}

    glm::dvec3 at(const glm::ivec3& p) const {
        glm::dvec3 gradient = filter_ == VoxelGradient::central ? central(p)
                              : filter_ == VoxelGradient::sobel ? weighted<1>(p, {1, 2, 1}, {-1, 0, 1})
                                                                : weighted<2>(p, k_gauss, k_gauss_slope);
        gradient *= per_mm_;
        const double length = glm::length(gradient);
        return length > 0 && std::isfinite(length) ? gradient / length : glm::dvec3(0);
    }

private:
    // exp(-x*x/2) and x*exp(-x*x/2) at -2 .. 2
    static constexpr std::array<double, 5> k_gauss{0.1353352832, 0.6065306597, 1, 0.6065306597, 0.1353352832};
    static constexpr std::array<double, 5> k_gauss_slope{-0.2706705665, -0.6065306597, 0, 0.6065306597, 0.2706705665};

    glm::dvec3 central(const glm::ivec3& p) const {
        glm::dvec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 before = p, after = p;
            before[axis] = std::max(p[axis] - 1, 0);
            after[axis] = std::min(p[axis] + 1, view_.size[axis] - 1);
            gradient[axis] = double(view_(after.x, after.y, after.z)) - double(view_(before.x, before.y, before.z));
        }
        return gradient;
    }

    /// A separable filter of 2R+1 voxels each way: `slope` along the axis of the derivative, `smooth` across it.
    template <int R>
    glm::dvec3 weighted(const glm::ivec3& p, const std::array<double, 2 * R + 1>& smooth,
                        const std::array<double, 2 * R + 1>& slope) const {
        std::array<int, 2 * R + 1> xs;
        for (int i = -R; i <= R; ++i) xs[std::size_t(i + R)] = std::clamp(p.x + i, 0, view_.size.x - 1);
        glm::dvec3 gradient(0);
        for (int dz = 0; dz <= 2 * R; ++dz) {
            const int z = std::clamp(p.z + dz - R, 0, view_.size.z - 1);
            for (int dy = 0; dy <= 2 * R; ++dy) {
                const T* row = view_.row(std::clamp(p.y + dy - R, 0, view_.size.y - 1), z);
                double smoothed = 0, sloped = 0;
                for (std::size_t i = 0; i < xs.size(); ++i) {
                    const double value = double(row[xs[i]]);
                    smoothed += smooth[i] * value;
                    sloped += slope[i] * value;
                }
                const auto y = std::size_t(dy), w = std::size_t(dz);
                gradient += glm::dvec3(smooth[y] * smooth[w] * sloped, slope[y] * smooth[w] * smoothed,
                                       smooth[y] * slope[w] * smoothed);
            }
        }
        return gradient;
    }

    VolumeView<T> view_;
    glm::dvec3 per_mm_;
    VoxelGradient filter_;
};

}  // namespace lacuna
