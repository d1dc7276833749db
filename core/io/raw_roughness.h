#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/job.h"
#include "core/volume/voxel_type.h"

namespace lacuna {

/// How bytes are read as voxels.
struct RawWords {
    VoxelType type = VoxelType::u8;
    bool big_endian = false;
};

/// Measures how rough a piece of a raw file is when it is read one way or another: the mean length, in bits, of the
/// differences between voxels a given distance apart, log2(1 + |difference|). Looked at only where bytes change.
class RawRoughness {
public:
    /// @param bytes  a piece of the file
    /// @param phase  bytes at its start before a whole word of four bytes begins, if words end with the file
    RawRoughness(std::span<const std::byte> bytes, std::size_t phase);

    /// Places looked at; 0: the piece is flat.
    std::size_t places() const { return places_.size(); }
    /// Bits a byte of differences to the word before. Infinite for floats of which many cannot be measured values.
    double of_neighbours(RawWords words) const;
    /// Bits a voxel of differences between voxels `lag` voxels apart.
    double at_lag(RawWords words, std::int64_t lag) const;
    /// The same for many lags. @throws Error(cancelled)
    std::vector<double> at_lags(RawWords words, const std::vector<std::int64_t>& lags, const JobContext& job) const;
    /// The largest lag that can be measured, in voxels of so many bytes.
    std::int64_t longest_lag(std::size_t word) const { return std::int64_t(bytes_.size() / word / 2) - 16; }
    /// Whether 16-bit words carry a sign: more of them step smoothly over 0 than over 32768.
    bool words_have_sign(bool big_endian) const;

private:
    std::span<const std::byte> bytes_;
    std::vector<std::size_t> places_;  ///< offsets of four-byte words whose surroundings change
};

}  // namespace lacuna
