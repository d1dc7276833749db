#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/job.h"

namespace lacuna {

/// One bit a voxel. A row (along x) fills whole 64-bit words, voxel x in bit x % 64; bits beyond its end are 0.
class BitVolume {
public:
    BitVolume() = default;
    /// All bits 0. @throws std::bad_alloc
    explicit BitVolume(glm::ivec3 size)
        : size_(size),
          words_per_row_((size.x + 63) / 64),
          words_(std::size_t(words_per_row_) * std::size_t(size.y) * std::size_t(size.z)) {}

    glm::ivec3 size() const { return size_; }
    int words_per_row() const { return words_per_row_; }
    std::size_t bytes() const { return words_.size() * sizeof(std::uint64_t); }
    std::uint64_t* row(int y, int z) { return words_.data() + offset(y, z); }
    const std::uint64_t* row(int y, int z) const { return words_.data() + offset(y, z); }
    /// @pre inside the volume
    bool operator()(int x, int y, int z) const { return row(y, z)[x >> 6] >> (x & 63) & 1; }

private:
    std::size_t offset(int y, int z) const {
        return (std::size_t(z) * std::size_t(size_.y) + std::size_t(y)) * std::size_t(words_per_row_);
    }
    glm::ivec3 size_{0};
    int words_per_row_ = 0;
    std::vector<std::uint64_t> words_;
};

/// Sets bits [first, last) of a row to 0.
void clear_bits(std::uint64_t* row, int first, int last);

/// Set voxels whose 26 neighbours are all set; outside the volume nothing is set. 64 voxels a step.
BitVolume eroded(const BitVolume& bits, const JobContext& job = {});

/// The same voxels with axes (y, z, x): voxel (x, y, z) becomes (y, z, x). By 64x64 bit transposes.
BitVolume turned(const BitVolume& bits, const JobContext& job = {});

}  // namespace lacuna
