#include "core/io/dicom_resample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/base/parallel.h"

namespace lacuna::dicom {

namespace {

constexpr double k_on_plane = 1e-6;  // share of the way between two slices that counts as none

/// Rounds into the type; the value lies between values of the type, so it fits.
template <class T>
T to_voxel(double value) {
    if constexpr (std::is_floating_point_v<T>)
        return T(value);
    else
        return T(std::int64_t(std::lround(value)));
}

/// a + (b - a) t, or the nearer of both where one of them is air.
double mix(double a, double b, double t, const AirRule& air) {
    if (air.active && ((a <= air.highest) != (b <= air.highest))) return t < 0.5 ? a : b;
    return a + (b - a) * t;
}

/// Where a grid plane lies between the used slices.
struct Between {
    std::size_t low = 0, high = 0;
    double share = 0;  // 0: at low, 1: at high
};

Between locate(std::span<const double> along, double at) {
    const auto after = std::upper_bound(along.begin(), along.end(), at);
    const auto high = std::min<std::ptrdiff_t>(after - along.begin(), std::ptrdiff_t(along.size()) - 1);
    const std::ptrdiff_t low = std::max<std::ptrdiff_t>(high - 1, 0);
    Between found{std::size_t(low), std::size_t(high), 0};
    if (low == high) return found;
    found.share = std::clamp((at - along[found.low]) / (along[found.high] - along[found.low]), 0.0, 1.0);
    return found;
}

/// One slice with its shift: rows of the grid are sampled from it.
template <class T>
class ShiftedSlice {
public:
    ShiftedSlice(const T* pixels, glm::ivec2 size, glm::dvec2 start, const AirRule& air)
        : pixels_(pixels), size_(size), air_(air) {
        // Shifts of whole pixels stay exact.
        const glm::dvec2 snapped = glm::round(start);
        start_ = glm::ivec2(glm::floor(start));
        share_ = start - glm::floor(start);
        for (int a = 0; a < 2; ++a)
            if (std::abs(start[a] - snapped[a]) < 1e-4) {
                start_[a] = int(snapped[a]);
                share_[a] = 0;
            }
    }

    /// Grid row y into `row`; NaN where the slice does not reach.
    void sample_row(int y, std::span<double> row) const {
        std::fill(row.begin(), row.end(), std::numeric_limits<double>::quiet_NaN());
        const int y0 = start_.y + y;
        const double vy = double(y0) + share_.y;
        if (vy <= -0.5 || vy >= size_.y - 0.5) return;
        const T* low = pixels_ + std::int64_t(std::clamp(y0, 0, size_.y - 1)) * size_.x;
        const T* high = pixels_ + std::int64_t(std::clamp(share_.y > 0 ? y0 + 1 : y0, 0, size_.y - 1)) * size_.x;
        for (int x = 0; x < int(row.size()); ++x) {
            const int x0 = start_.x + x;
            const double vx = double(x0) + share_.x;
            if (vx <= -0.5 || vx >= size_.x - 0.5) continue;
            const int a = std::clamp(x0, 0, size_.x - 1), b = std::clamp(share_.x > 0 ? x0 + 1 : x0, 0, size_.x - 1);
            const double top = mix(low[a], low[b], share_.x, air_), bottom = mix(high[a], high[b], share_.x, air_);
            row[std::size_t(x)] = mix(top, bottom, share_.y, air_);
        }
    }

private:
    const T* pixels_;
    glm::ivec2 size_, start_{0};
    glm::dvec2 share_{0};
    const AirRule& air_;
};

template <class T>
void resample_plane(const T* slices, glm::ivec2 size, const StackPlan& plan, const AirRule& air, int plane, T* out) {
    const Between at = locate(plan.along_mm, plane * plan.grid.spacing.z);
    const std::int64_t each = std::int64_t(size.x) * size.y;
    const auto slice = [&](std::size_t i) {
        const glm::dvec2 start = -glm::dvec2(plan.margin_px) - plan.shift_px[i];
        return ShiftedSlice<T>(slices + each * std::int64_t(i), size, plan.sheared ? start : glm::dvec2(0), air);
    };
    // A slice that is off its plane by the rounding of its position is on it.
    double share = at.share;
    const double rounding = std::max(k_on_plane, plan.planes.empty() ? 0.0 : 0.02);
    if (share < rounding) share = 0;
    if (share > 1 - rounding) share = 1;
    const ShiftedSlice<T> low = slice(at.low), high = slice(at.high);
    std::vector<double> a(std::size_t(plan.grid.size.x)), b(a.size());
    for (int y = 0; y < plan.grid.size.y; ++y, out += plan.grid.size.x) {
        if (share < 1) low.sample_row(y, a);
        if (share > 0) high.sample_row(y, b);
        for (std::size_t x = 0; x < a.size(); ++x) {
            double value = share == 0 ? a[x] : share == 1 ? b[x] : 0;
            if (share > 0 && share < 1) {
                if (std::isnan(a[x]) || std::isnan(b[x]))
                    value = share < 0.5 ? a[x] : b[x];
                else
                    value = mix(a[x], b[x], share, air);
            }
            out[x] = to_voxel<T>(std::isnan(value) ? air.outside : value);
        }
    }
}

template <class T>
void fill_plane(T* voxels, const StackPlan& plan, const AirRule& air, int plane) {
    const auto after = std::upper_bound(plan.planes.begin(), plan.planes.end(), plane);
    const int high = *after, low = *(after - 1);
    const std::int64_t each = std::int64_t(plan.grid.size.x) * plan.grid.size.y;
    const T *a = voxels + each * low, *b = voxels + each * high;
    T* out = voxels + each * plane;
    const double share = double(plane - low) / (high - low);
    for (std::int64_t i = 0; i < each; ++i) out[i] = to_voxel<T>(mix(a[i], b[i], share, air));
}

}  // namespace

void fill_missing_planes(const VoxelBuffer& voxels, VoxelType type, const StackPlan& plan, const AirRule& air,
                         const JobContext& job) {
    visit_type(type, [&](auto tag) {
        using T = decltype(tag);
        parallel_for(
            0, std::int64_t(plan.missing.size()),
            [&](std::int64_t m) {
                fill_plane(reinterpret_cast<T*>(voxels.data()), plan, air, plan.missing[std::size_t(m)]);
            },
            job);
    });
}

VoxelBuffer resample_slices(const VoxelBuffer& slices, VoxelType type, glm::ivec2 size, const StackPlan& plan,
                            const AirRule& air, const JobContext& job) {
    VoxelBuffer result(std::size_t(plan.grid.voxel_count()) * size_of(type));
    visit_type(type, [&](auto tag) {
        using T = decltype(tag);
        const std::int64_t each = std::int64_t(plan.grid.size.x) * plan.grid.size.y;
        parallel_for(
            0, plan.grid.size.z,
            [&](std::int64_t plane) {
                resample_plane(reinterpret_cast<const T*>(slices.data()), size, plan, air, int(plane),
                               reinterpret_cast<T*>(result.data()) + each * plane);
            },
            job);
    });
    return result;
}

}  // namespace lacuna::dicom
