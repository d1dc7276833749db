#include "core/render/stored_gradients.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

constexpr int k_top_exponent = 30, k_nan_exponent = 31;
constexpr int k_most_mantissa = 255;

/// Rows y-1 .. y+1 of slices z-1 .. z+1 around one row of voxels, repeated beyond the border.
template <class T>
using Rows = std::array<std::array<const T*, 3>, 3>;  // [z][y]

template <class T>
Rows<T> rows_around(const VolumeView<T>& view, int y, int z) {
    Rows<T> rows;
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            rows[std::size_t(k)][std::size_t(j)] =
                view.row(std::clamp(y + j - 1, 0, view.size.y - 1), std::clamp(z + k - 1, 0, view.size.z - 1));
    return rows;
}

template <class T>
float value_of(T v) {
    if constexpr (std::is_floating_point_v<T>)
        return std::isfinite(v) ? v : std::numeric_limits<float>::quiet_NaN();
    else
        return float(v);
}

/// Differences after minus before along each axis (not halved), a vector a voxel of the row.
template <class T>
void central_row(const Rows<T>& rows, int width, glm::vec3* out) {
    const T* row = rows[1][1];
    for (int x = 0; x < width; ++x) {
        const int before = std::max(x - 1, 0), after = std::min(x + 1, width - 1);
        out[x] = {value_of(row[after]) - value_of(row[before]), value_of(rows[1][2][x]) - value_of(rows[1][0][x]),
                  value_of(rows[2][1][x]) - value_of(rows[0][1][x])};
    }
}

/// The same of values smoothed by (1 2 1)/4 along the other two axes: first across the rows, then along the row.
template <class T>
void sobel_row(const Rows<T>& rows, int width, glm::vec3* out, std::vector<glm::vec3>& columns) {
    constexpr float k_weight[3] = {0.25f, 0.5f, 0.25f}, k_sign[3] = {-1, 0, 1};
    columns.resize(std::size_t(width));  // of a column: smoothed, differenced along y, along z
    for (int x = 0; x < width; ++x) {
        glm::vec3 sum(0);
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t j = 0; j < 3; ++j) {
                const float v = value_of(rows[k][j][x]);
                sum += v * glm::vec3(k_weight[j] * k_weight[k], k_sign[j] * k_weight[k], k_weight[j] * k_sign[k]);
            }
        columns[std::size_t(x)] = sum;
    }
    for (int x = 0; x < width; ++x) {
        const glm::vec3 m = columns[std::size_t(std::max(x - 1, 0))], c = columns[std::size_t(x)];
        const glm::vec3 n = columns[std::size_t(std::min(x + 1, width - 1))];
        const glm::vec3 smooth = 0.25f * (m + n) + 0.5f * c;
        out[x] = {n.x - m.x, smooth.y, smooth.z};
    }
}

}  // namespace

std::uint32_t pack_gradient(const glm::dvec3& g) {
    const double largest = std::max({std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)});
    if (!(largest < std::numeric_limits<double>::infinity()) || glm::any(glm::isnan(g)))
        return std::uint32_t(k_nan_exponent) << 27;
    int exponent = 0;  // largest = f * 2^exponent, f in [1/2, 1)
    if (largest > 0) std::frexp(largest * (256.0 / k_most_mantissa), &exponent);
    const int e = std::clamp(exponent + k_top_exponent, 0, k_top_exponent);
    const double unit = std::ldexp(1.0, k_top_exponent + 8 - e);
    const auto mantissa = [&](double v) {
        return std::uint32_t(std::clamp<long>(std::lround(v * unit), -k_most_mantissa, k_most_mantissa)) & 511u;
    };
    return mantissa(g.x) | mantissa(g.y) << 9 | mantissa(g.z) << 18 | std::uint32_t(e) << 27;
}

glm::dvec3 unpack_gradient(std::uint32_t word) {
    const int e = int(word >> 27);
    if (e == k_nan_exponent) return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    const auto mantissa = [&](int shift) { return double(std::int32_t(word << shift) >> 23); };
    return glm::dvec3(mantissa(23), mantissa(14), mantissa(5)) * std::ldexp(1.0, e - k_top_exponent - 8);
}

VoxelBuffer make_stored_gradients(const Volume& volume, GradientFilter filter, ValueRange values,
                                  const JobContext& job) {
    const GridGeometry& grid = volume.geometry();
    const glm::ivec3 n = grid.size, stored = glm::max(n, glm::ivec3(2));
    const double bound = std::max(values.width(), 1e-30) / (2 * grid.smallest_spacing_mm());
    int exponent = 0;
    std::frexp(bound * (256.0 / k_most_mantissa), &exponent);
    const auto scale = float(std::ldexp(1.0, std::clamp(exponent, -80, 80)));
    const glm::dvec3 to_units = 0.5 / (grid.spacing * double(scale));

    const std::size_t row_words = std::size_t(stored.x), slice_words = row_words * std::size_t(stored.y);
    VoxelBuffer buffer((slice_words * std::size_t(stored.z) + 1) * sizeof(std::uint32_t));
    auto* words = reinterpret_cast<std::uint32_t*>(buffer.data());
    std::memcpy(words, &scale, sizeof scale);
    ++words;
    visit_type(volume.type(), [&](auto tag) {
        using T = decltype(tag);
        const auto view = volume.view<T>();
        parallel_for(
            0, stored.z,
            [&](std::int64_t z) {
                std::vector<glm::vec3> row(std::size_t(n.x)), columns;
                for (int y = 0; y < stored.y; ++y) {
                    const Rows<T> rows = rows_around(view, std::min(y, n.y - 1), std::min(int(z), n.z - 1));
                    if (filter == GradientFilter::sobel)
                        sobel_row(rows, n.x, row.data(), columns);
                    else
                        central_row(rows, n.x, row.data());
                    std::uint32_t* out = words + std::size_t(z) * slice_words + std::size_t(y) * row_words;
                    for (int x = 0; x < stored.x; ++x)
                        out[x] = pack_gradient(glm::dvec3(row[std::size_t(std::min(x, n.x - 1))]) * to_units);
                }
            },
            job);
    });
    return buffer;
}

}  // namespace lacuna
