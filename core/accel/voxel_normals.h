#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <type_traits>

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
                              : filter_ == VoxelGradient::sobel ? weighted<1, Sum>(p, {1, 2, 1}, {-1, 0, 1})
                                                                : weighted<2, double>(p, k_gauss, k_gauss_slope);
        gradient *= per_mm_;
        const double length = glm::length(gradient);
        return length > 0 && std::isfinite(length) ? gradient / length : glm::dvec3(0);
    }

private:
    using Sum = std::conditional_t<std::is_integral_v<T>, int, double>;  // 16 voxels of 16 bits fit an int
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
    template <int R, class S>
    glm::dvec3 weighted(const glm::ivec3& p, const std::array<S, 2 * R + 1>& smooth,
                        const std::array<S, 2 * R + 1>& slope) const {
        const glm::ivec3 last = view_.size - 1;
        const bool inner =
            p.x >= R && p.y >= R && p.z >= R && p.x + R <= last.x && p.y + R <= last.y && p.z + R <= last.z;
        const std::int64_t next_row = view_.size.x, next_slice = next_row * view_.size.y;
        if (inner) {
            const T* first = &view_(p.x - R, p.y - R, p.z - R);
            return filtered<R, S>(smooth, slope,
                                  [=](int i, int j, int k) { return S(first[k * next_slice + j * next_row + i]); });
        }
        return filtered<R, S>(smooth, slope, [&](int i, int j, int k) {
            const glm::ivec3 q = glm::clamp(p + glm::ivec3(i, j, k) - R, glm::ivec3(0), last);
            return S(view_(q.x, q.y, q.z));
        });
    }

    template <int R, class S, class Voxel>
    static glm::dvec3 filtered(const std::array<S, 2 * R + 1>& smooth, const std::array<S, 2 * R + 1>& slope,
                               Voxel&& voxel) {
        constexpr int n = 2 * R + 1;
        S along_x = 0, along_y = 0, along_z = 0;
        for (int k = 0; k < n; ++k) {
            S plane = 0, plane_x = 0, plane_y = 0;
            for (int j = 0; j < n; ++j) {
                S row = 0, row_x = 0;
                for (int i = 0; i < n; ++i) {
                    const S value = voxel(i, j, k);
                    row += smooth[std::size_t(i)] * value;
                    row_x += slope[std::size_t(i)] * value;
                }
                plane += smooth[std::size_t(j)] * row;
                plane_y += slope[std::size_t(j)] * row;
                plane_x += smooth[std::size_t(j)] * row_x;
            }
            along_x += smooth[std::size_t(k)] * plane_x;
            along_y += smooth[std::size_t(k)] * plane_y;
            along_z += slope[std::size_t(k)] * plane;
        }
        return glm::dvec3(along_x, along_y, along_z);
    }

    VolumeView<T> view_;
    glm::dvec3 per_mm_;
    VoxelGradient filter_;
};

}  // namespace lacuna
