#include "core/accel/bit_volume.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"

namespace lacuna {

void clear_bits(std::uint64_t* row, int first, int last) {
    for (int w = first >> 6; w << 6 < last; ++w) {
        const int lo = std::max(first - (w << 6), 0), hi = std::min(last - (w << 6), 64);
        if (lo >= hi) continue;
        const std::uint64_t below_hi = hi == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << hi) - 1;
        row[w] &= ~(below_hi & ~((std::uint64_t(1) << lo) - 1));
    }
}

BitVolume eroded(const BitVolume& bits, const JobContext& job) {
    const glm::ivec3 size = bits.size();
    const int words = bits.words_per_row();
    BitVolume along_x(size), out(size);
    parallel_for(
        0, size.z,
        [&](std::int64_t z) {
            for (int y = 0; y < size.y; ++y) {
                const std::uint64_t* in = bits.row(y, int(z));
                std::uint64_t* to = along_x.row(y, int(z));
                for (int w = 0; w < words; ++w) {
                    const std::uint64_t before = in[w] << 1 | (w > 0 ? in[w - 1] >> 63 : 0);
                    const std::uint64_t after = in[w] >> 1 | (w + 1 < words ? in[w + 1] << 63 : 0);
                    to[w] = in[w] & before & after;
                }
            }
        },
        job.part(0, 0.5));
    parallel_for(
        1, size.z - 1,
        [&](std::int64_t z) {
            for (int y = 1; y + 1 < size.y; ++y) {
                std::uint64_t* to = out.row(y, int(z));
                std::fill(to, to + words, ~std::uint64_t(0));
                for (int dz = -1; dz <= 1; ++dz) {
                    for (int dy = -1; dy <= 1; ++dy) {
                        const std::uint64_t* in = along_x.row(y + dy, int(z) + dz);
                        for (int w = 0; w < words; ++w) to[w] &= in[w];
                    }
                }
            }
        },
        job.part(0.5, 1));
    return out;
}

namespace {

/// Transposes a 64x64 bit matrix in place: bit j of word i becomes bit i of word j (Warren, Hacker's Delight, 7-3).
void transpose64(std::array<std::uint64_t, 64>& a) {
    std::uint64_t mask = 0x00000000FFFFFFFFu;
    for (unsigned j = 32; j != 0; j >>= 1, mask ^= mask << j) {
        for (unsigned k = 0; k < 64; k = ((k | j) + 1) & ~j) {
            const std::uint64_t swap = ((a[k] >> j) ^ a[k | j]) & mask;
            a[k] ^= swap << j;
            a[k | j] ^= swap;
        }
    }
}

}  // namespace

BitVolume turned(const BitVolume& bits, const JobContext& job) {
    const glm::ivec3 size = bits.size();
    BitVolume out({size.y, size.z, size.x});
    parallel_for(
        0, size.z,
        [&](std::int64_t z) {
            std::array<std::uint64_t, 64> block;
            for (int y0 = 0; y0 < size.y; y0 += 64) {
                for (int w = 0; w < bits.words_per_row(); ++w) {
                    for (int j = 0; j < 64; ++j)
                        block[std::size_t(j)] = y0 + j < size.y ? bits.row(y0 + j, int(z))[w] : 0;
                    transpose64(block);
                    for (int i = 0; i < 64 && w * 64 + i < size.x; ++i)
                        out.row(int(z), w * 64 + i)[y0 >> 6] = block[std::size_t(i)];
                }
            }
        },
        job);
    return out;
}

}  // namespace lacuna
