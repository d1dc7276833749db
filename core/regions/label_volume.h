#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/volume/grid_geometry.h"
#include "core/volume/volume.h"

namespace lacuna {

/// One id per voxel, x fastest; 0 is background (no region). Copies share the labels.
struct LabelVolume {
    GridGeometry geometry;
    std::shared_ptr<std::vector<std::uint32_t>> labels;

    std::uint32_t operator()(int x, int y, int z) const {
        return (*labels)[std::size_t(geometry.linear_index(x, y, z))];
    }
};

/// One byte per voxel, x fastest: 1 inside, 0 outside. Copies share the bytes.
struct MaskVolume {
    GridGeometry geometry;
    std::shared_ptr<std::vector<std::uint8_t>> labels;

    std::uint8_t operator()(int x, int y, int z) const {
        return (*labels)[std::size_t(geometry.linear_index(x, y, z))];
    }
};

}  // namespace lacuna
