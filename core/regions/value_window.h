#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/regions/region_shell.h"
#include "core/volume/volume.h"

// Grey values in and round one region, as its surface and its partial volume are made from; seen by core alone.
namespace lacuna {

/// Reads a window's slices as floats; outside the grid NaN.
class SliceReader {
public:
    SliceReader(const Volume& volume, const glm::ivec3& first, const glm::ivec3& extent)
        : volume_(volume), first_(first), extent_(extent), values_(std::size_t(extent.x) * std::size_t(extent.y)) {}

    /// Slice z of the window; stands until the next call.
    const std::vector<float>& read(int z) {
        std::fill(values_.begin(), values_.end(), std::numeric_limits<float>::quiet_NaN());
        const glm::ivec3 size = volume_.geometry().size;
        const int at_z = first_.z + z;
        if (at_z < 0 || at_z >= size.z) return values_;
        const int x0 = std::max(0, -first_.x), x1 = std::min(extent_.x, size.x - first_.x);
        visit_type(volume_.type(), [&](auto tag) {
            const auto view = volume_.view<decltype(tag)>();
            for (int y = std::max(0, -first_.y); y < std::min(extent_.y, size.y - first_.y); ++y) {
                const auto* row = view.row(first_.y + y, at_z);
                float* to = values_.data() + std::size_t(y) * std::size_t(extent_.x);
                for (int x = x0; x < x1; ++x) to[x] = float(row[first_.x + x]);
            }
        });
        return values_;
    }

private:
    const Volume& volume_;
    glm::ivec3 first_, extent_;
    std::vector<float> values_;
};

/// A voxel beside the region belongs to its boundary layer unless something foreign is nearer.
inline bool in_boundary_layer(const RegionShell::SliceView& at, std::size_t i, int layers) {
    return at.own[i] <= layers && (at.own[i] <= 1 || at.foreign[i] >= at.own[i]) && at.foreign[i] > 0;
}

/// Grey-value integration: a voxel of the boundary layer counts by where its value lies between the levels of the two
/// sides, one of the region's core whole.
class PartialVolume {
public:
    void add_whole() { whole_ += 1; }
    void add(double value) { count_ += 1, sum_ += value; }
    /// Voxels summed by their value.
    double boundary_voxels() const { return count_; }
    double voxels(double inside_level, double outside_level) const {
        return whole_ + (count_ * outside_level - sum_) / (outside_level - inside_level);
    }

private:
    double whole_ = 0, count_ = 0, sum_ = 0;
};

}  // namespace lacuna
