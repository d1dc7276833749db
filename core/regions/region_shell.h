#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/regions/label_volume.h"

namespace lacuna {

/// One region with the layers of voxels round it, walked slice by slice: how far each voxel of a window lies from the
/// region, from the region's outside, and from anything foreign. Distances are chessboard distances in voxels, capped
/// at reach + 1. Memory: a few slices of the window.
class RegionShell {
public:
    /// Foreign voxels: those with another label and, with a mask, those outside it.
    /// @param reach  layers round the region; the window is its box and reach + 1 voxels more on each side
    RegionShell(const LabelVolume& labels, const MaskVolume* part, std::uint32_t id, const glm::ivec3& bbox_first,
                const glm::ivec3& bbox_last, int reach);

    const glm::ivec3& first() const { return first_; }    ///< the window's first voxel; may lie outside the grid
    const glm::ivec3& extent() const { return extent_; }  ///< of the window

    struct SliceView {
        const std::uint8_t* own;      ///< distance to the region, 0 in it
        const std::uint8_t* beyond;   ///< in the region: distance to what is not of it; 0 outside
        const std::uint8_t* foreign;  ///< distance to foreign voxels, 0 in one
    };
    /// Distances of window slice z; call with z = 0, 1, ... extent.z - 1 in turn.
    SliceView slice(int z);

private:
    struct Field {
        std::vector<std::vector<std::uint8_t>> ring;  ///< in-slice distances of 2 * reach + 1 slices
        std::vector<std::uint8_t> result;
    };
    void load(int z);
    void spread(std::vector<std::uint8_t>& slice);
    void combine(Field& field, int z);

    const LabelVolume& labels_;
    const MaskVolume* part_;
    std::uint32_t id_;
    int reach_, loaded_;
    glm::ivec3 first_, extent_;
    std::size_t plane_, stride_ = 0, margin_ = 0;
    Field own_, beyond_, foreign_;
    std::vector<std::uint8_t> along_x_, along_y_;  ///< one slice before and behind a step of spread()
};

}  // namespace lacuna
