#include "core/accel/bit_volume.h"

#include <gtest/gtest.h>

#include <random>

namespace lacuna {
namespace {

BitVolume noise(glm::ivec3 size, double share, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::bernoulli_distribution set(share);
    BitVolume bits(size);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) bits.row(y, z)[x >> 6] |= std::uint64_t(set(random)) << (x & 63);
    return bits;
}

const glm::ivec3 k_sizes[] = {{1, 1, 1}, {1, 1, 7}, {64, 3, 3}, {65, 5, 4}, {130, 66, 3}, {7, 129, 2}, {3, 3, 3}};

TEST(BitVolume, ErosionIsTheNeighbourhoodRule) {
    for (const glm::ivec3 size : k_sizes) {
        const BitVolume bits = noise(size, 0.97), less = eroded(bits);
        ASSERT_EQ(less.size(), size);
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    bool all = true;
                    for (int n = 0; n < 27; ++n) {
                        const glm::ivec3 p(x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1);
                        const bool in =
                            p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size.x && p.y < size.y && p.z < size.z;
                        all = all && in && bits(p.x, p.y, p.z);
                    }
                    ASSERT_EQ(less(x, y, z), all) << x << ' ' << y << ' ' << z << " of " << size.x;
                }
            }
        }
    }
}

TEST(BitVolume, TurningMovesEachVoxelOnce) {
    for (const glm::ivec3 size : k_sizes) {
        const BitVolume bits = noise(size, 0.3), out = turned(bits);
        ASSERT_EQ(out.size(), glm::ivec3(size.y, size.z, size.x));
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) ASSERT_EQ(out(y, z, x), bits(x, y, z));
        for (int x = 0; x < size.x; ++x)  // no bits beyond the rows' ends
            for (int z = 0; z < size.z; ++z)
                if (size.y & 63) {
                    ASSERT_EQ(out.row(z, x)[out.words_per_row() - 1] >> (size.y & 63), 0u);
                }
    }
}

TEST(BitVolume, ClearsExactlyTheSpan) {
    for (const auto& [first, last] : {std::pair(0, 0), {0, 64}, {63, 65}, {5, 130}, {64, 128}, {129, 130}, {7, 3}}) {
        BitVolume bits({130, 1, 1});
        for (int w = 0; w < 3; ++w) bits.row(0, 0)[w] = ~std::uint64_t(0);
        clear_bits(bits.row(0, 0), first, last);
        for (int x = 0; x < 130; ++x)
            ASSERT_EQ(bits(x, 0, 0), !(x >= first && x < last)) << first << ".." << last << " " << x;
    }
}

}  // namespace
}  // namespace lacuna
