#include "core/volume/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

template <class T, class Fn>
Volume made(glm::ivec3 size, glm::dvec3 spacing, Fn&& value) {
    GridGeometry grid;
    grid.size = size;
    grid.spacing = spacing;
    return make_volume<T>(grid, [&](std::span<T> voxels) {
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) voxels[i++] = T(value(x, y, z));
    });
}

/// The definition, voxel by voxel: all weights at once, no separation.
double brute_force(const Volume& volume, double sigma, int x, int y, int z) {
    const GridGeometry& g = volume.geometry();
    glm::ivec3 radius;
    for (int a = 0; a < 3; ++a) radius[a] = int(std::ceil(4 * sigma / g.spacing[a]));
    double sum = 0, weights = 0;
    for (int k = std::max(0, z - radius.z); k <= std::min(g.size.z - 1, z + radius.z); ++k)
        for (int j = std::max(0, y - radius.y); j <= std::min(g.size.y - 1, y + radius.y); ++j)
            for (int i = std::max(0, x - radius.x); i <= std::min(g.size.x - 1, x + radius.x); ++i) {
                const double v = volume.value(i, j, k);
                if (!std::isfinite(v)) continue;
                const glm::dvec3 d = glm::dvec3(i - x, j - y, k - z) * g.spacing;
                const double w = std::exp(-0.5 * glm::dot(d, d) / (sigma * sigma));
                sum += w * v;
                weights += w;
            }
    return sum / weights;
}

double wild(int x, int y, int z) { return 100 + 90 * std::sin(1.3 * x + 0.7 * y * y - 2.1 * z) * std::cos(z + x * y); }

TEST(Smooth, EqualsTheDefinitionOnAnyShapeAndSpacing) {
    for (const glm::ivec3 size :
         {glm::ivec3(13, 9, 11), glm::ivec3(1, 1, 17), glm::ivec3(1, 1, 1), glm::ivec3(6, 1, 5)})
        for (const glm::dvec3 spacing : {glm::dvec3(1), glm::dvec3(1, 1, 5), glm::dvec3(0.4, 0.7, 1.1)}) {
            const Volume floats = made<float>(size, spacing, wild);
            const Volume bytes = made<std::uint8_t>(size, spacing, wild);
            const Volume smooth = gaussian_smooth(floats, 1.2), rounded = gaussian_smooth(bytes, 1.2);
            for (int z = 0; z < size.z; ++z)
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x) {
                        EXPECT_NEAR(smooth.value(x, y, z), brute_force(floats, 1.2, x, y, z), 2e-4);
                        EXPECT_NEAR(rounded.value(x, y, z), brute_force(bytes, 1.2, x, y, z), 0.501);
                    }
        }
}

TEST(Smooth, NaNStaysWhereItIsAndSpoilsNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const Volume volume = made<float>({9, 8, 7}, {1, 1, 2}, [&](int x, int y, int z) {
        return x == 4 && y == 4 ? nan : x == 0 && z == 6 ? inf : float(wild(x, y, z));
    });
    const Volume smooth = gaussian_smooth(volume, 1.5);
    for (int z = 0; z < 7; ++z)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 9; ++x) {
                const double v = smooth.value(x, y, z);
                if (std::isfinite(volume.value(x, y, z)))
                    EXPECT_NEAR(v, brute_force(volume, 1.5, x, y, z), 2e-4);
                else
                    EXPECT_TRUE(std::isnan(v));
            }
}

TEST(Smooth, FlatStaysFlatToTheLastValue) {
    for (int value : {-32768, -5, 0, 32767}) {
        const Volume smooth =
            gaussian_smooth(made<std::int16_t>({7, 5, 6}, glm::dvec3(1), [&](int, int, int) { return value; }), 2);
        for (const std::int16_t v : smooth.view<std::int16_t>().voxels()) EXPECT_EQ(v, value);
    }
}

TEST(Smooth, AnImpulseSpreadsBySigmaInMillimetres) {
    const glm::dvec3 spacing(0.5, 1, 1.5);
    const glm::ivec3 size(61, 41, 31);
    const Volume smooth = gaussian_smooth(
        made<float>(size, spacing, [&](int x, int y, int z) { return x == 30 && y == 20 && z == 15 ? 1000 : 0; }), 2);
    double mass = 0;
    glm::dvec3 spread(0);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const double v = smooth.value(x, y, z);
                const glm::dvec3 d = glm::dvec3(x - 30, y - 20, z - 15) * spacing;
                mass += v;
                spread += v * d * d;
            }
    EXPECT_NEAR(mass, 1000, 0.1);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(std::sqrt(spread[a] / mass), 2, 0.01) << a;
}

TEST(Smooth, KeepsWhatTheVolumeIsCalled) {
    Volume volume = made<std::uint8_t>({4, 4, 4}, glm::dvec3(1), wild);
    volume.name = "part";
    volume.unit = "HU";
    const Volume smooth = gaussian_smooth(volume, 1);
    EXPECT_EQ(smooth.name, "part");
    EXPECT_EQ(smooth.unit, "HU");
    EXPECT_EQ(smooth.type(), VoxelType::u8);
}

TEST(Smooth, RefusesSenselessLengthsAndStops) {
    const Volume volume = made<std::uint8_t>({4, 4, 4}, glm::dvec3(1), wild);
    for (double sigma : {0.0, -1.0, std::nan(""), 1e9}) EXPECT_THROW(gaussian_smooth(volume, sigma), Error) << sigma;
    std::stop_source source;
    source.request_stop();
    try {
        gaussian_smooth(volume, 1, {source.get_token(), nullptr});
        FAIL() << "a stopped job returned a volume";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::cancelled);
    }
}

}  // namespace
}  // namespace lacuna
