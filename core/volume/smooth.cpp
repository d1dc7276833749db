#include "core/volume/smooth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/parallel.h"

namespace lacuna {

namespace {

/// One half of a sampled Gaussian: weight of 0, 1, .. voxels' distance; both halves together sum to 1.
std::vector<float> half_kernel(double sigma_voxels) {
    const int radius = std::max(0, int(std::ceil(4 * sigma_voxels)));
    std::vector<double> weight(std::size_t(radius) + 1);
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        weight[std::size_t(i)] = std::exp(-0.5 * (i / sigma_voxels) * (i / sigma_voxels));
        sum += (i ? 2 : 1) * weight[std::size_t(i)];
    }
    std::vector<float> half;
    for (const double w : weight) half.push_back(float(w / sum));
    return half;
}

/// Adds lines of values weighted by a kernel: out = sum over i of kernel[|i|] * line(at + i), lines that exist.
template <class Line>
void blend_lines(const std::vector<float>& kernel, int at, int lines, std::size_t width, Line&& line, float* out) {
    const int radius = int(kernel.size()) - 1;
    std::fill(out, out + width, 0.0f);
    for (int i = std::max(-radius, -at); i <= std::min(radius, lines - 1 - at); ++i) {
        const float w = kernel[std::size_t(std::abs(i))];
        const float* from = line(at + i);
        for (std::size_t x = 0; x < width; ++x) out[x] += w * from[x];
    }
}

void blur_row(const std::vector<float>& kernel, const float* in, int width, float* out) {
    const int radius = int(kernel.size()) - 1;
    for (int x = 0; x < width; ++x) {
        float sum = 0;
        for (int i = std::max(-radius, -x); i <= std::min(radius, width - 1 - x); ++i)
            sum += kernel[std::size_t(std::abs(i))] * in[x + i];
        out[x] = sum;
    }
}

/// Sum of the weights within the border, a position.
std::vector<float> reach(const std::vector<float>& kernel, int n) {
    const std::vector<float> ones(std::size_t(n), 1.0f);
    std::vector<float> sums(ones.size());
    blur_row(kernel, ones.data(), n, sums.data());
    return sums;
}

/// Smooths values given slice by slice: along x and y each slice for itself, then along z.
class Blur {
public:
    Blur(glm::ivec3 size, glm::dvec3 sigma_voxels) : size_(size), slice_(std::size_t(size.x) * std::size_t(size.y)) {
        for (int a = 0; a < 3; ++a) kernels_[a] = half_kernel(sigma_voxels[a]);
        planes_.resize(slice_ * std::size_t(size.z));
    }

    const std::vector<float>& kernel(int axis) const { return kernels_[axis]; }

    /// @param values  one slice, changed
    void put_slice(int z, std::vector<float>& values) {
        std::vector<float> row(std::size_t(size_.x));
        for (int y = 0; y < size_.y; ++y) {
            float* line = values.data() + std::size_t(y) * std::size_t(size_.x);
            blur_row(kernels_[0], line, size_.x, row.data());
            std::copy(row.begin(), row.end(), line);
        }
        float* out = planes_.data() + std::size_t(z) * slice_;
        for (int y = 0; y < size_.y; ++y)
            blend_lines(
                kernels_[1], y, size_.y, std::size_t(size_.x),
                [&](int from) { return values.data() + std::size_t(from) * std::size_t(size_.x); },
                out + std::size_t(y) * std::size_t(size_.x));
    }

    void take_slice(int z, std::vector<float>& values) const {
        blend_lines(
            kernels_[2], z, size_.z, slice_, [&](int from) { return planes_.data() + std::size_t(from) * slice_; },
            values.data());
    }

private:
    glm::ivec3 size_;
    std::size_t slice_;
    std::vector<float> kernels_[3], planes_;
};

template <class T>
T rounded(float v) {
    if constexpr (std::is_floating_point_v<T>) return v;
    const float lo = float(std::numeric_limits<T>::lowest()), hi = float(std::numeric_limits<T>::max());
    return T(std::lround(std::clamp(v, lo, hi)));
}

template <class T>
Volume smooth(const Volume& volume, glm::dvec3 sigma_voxels, const JobContext& job) {
    constexpr bool k_may_be_nan = std::is_floating_point_v<T>;
    const VolumeView<T> view = volume.view<T>();
    const glm::ivec3 n = view.size;
    const std::size_t slice = std::size_t(n.x) * std::size_t(n.y);
    Blur values(n, sigma_voxels);
    std::optional<Blur> weights;
    if constexpr (k_may_be_nan) weights.emplace(n, sigma_voxels);
    parallel_for(
        0, n.z,
        [&](std::int64_t z) {
            const T* from = view.row(0, int(z));
            std::vector<float> plane(slice), finite(k_may_be_nan ? slice : 0);
            for (std::size_t i = 0; i < slice; ++i) {
                const bool is = !k_may_be_nan || std::isfinite(float(from[i]));
                plane[i] = is ? float(from[i]) : 0.0f;
                if (k_may_be_nan) finite[i] = is;
            }
            values.put_slice(int(z), plane);
            if (weights) weights->put_slice(int(z), finite);
        },
        job.part(0, 0.5));
    // Without NaN the weights left at the border factor into the axes.
    std::vector<float> left[3];
    for (int a = 0; a < 3; ++a) left[a] = reach(values.kernel(a), n[a]);
    VoxelBuffer buffer(std::size_t(volume.geometry().voxel_count()) * sizeof(T));
    T* out = reinterpret_cast<T*>(buffer.data());
    parallel_for(
        0, n.z,
        [&](std::int64_t z) {
            std::vector<float> plane(slice), weight(weights ? slice : 0);
            values.take_slice(int(z), plane);
            if (weights) weights->take_slice(int(z), weight);
            const T* from = view.row(0, int(z));
            T* to = out + std::size_t(z) * slice;
            for (std::size_t i = 0; i < slice; ++i) {
                const std::size_t x = i % std::size_t(n.x), y = i / std::size_t(n.x);
                const float w = weights ? weight[i] : left[0][x] * left[1][y] * left[2][std::size_t(z)];
                const bool is = !k_may_be_nan || std::isfinite(float(from[i]));
                to[i] = is ? rounded<T>(plane[i] / w) : std::numeric_limits<T>::quiet_NaN();
            }
        },
        job.part(0.5, 1));
    Volume result(volume.geometry(), volume.type(), std::move(buffer));
    result.name = volume.name;
    result.unit = volume.unit;
    result.warnings = volume.warnings;
    result.dicom = volume.dicom;
    return result;
}

}  // namespace

std::uint64_t gaussian_smooth_bytes(const Volume& volume) {
    const auto voxels = std::uint64_t(volume.geometry().voxel_count());
    return volume.bytes() + voxels * (volume.type() == VoxelType::f32 ? 8 : 4);
}

Volume gaussian_smooth(const Volume& volume, double sigma_mm, const JobContext& job) {
    const glm::dvec3 sigma_voxels = sigma_mm / volume.geometry().spacing;
    const double most = std::max({sigma_voxels.x, sigma_voxels.y, sigma_voxels.z});
    if (!(sigma_mm > 0) || !(most <= k_most_sigma_voxels))
        throw Error(Errc::bad_usage, "The smoothing must be above 0 mm and at most " +
                                         std::to_string(int(k_most_sigma_voxels)) +
                                         " voxels of the finest axis; give a smaller length in mm.");
    return visit_type(volume.type(), [&](auto tag) { return smooth<decltype(tag)>(volume, sigma_voxels, job); });
}

}  // namespace lacuna
