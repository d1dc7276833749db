#include "core/volume/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "core/base/parallel.h"
#include "core/volume/statistics.h"

namespace lacuna {
namespace {

SampleOptions clean(int size) {
    SampleOptions options;
    options.size = size;
    options.noise = 0;
    options.blur_voxels = 0;
    return options;
}

TEST(Samples, UnknownNameListsTheKnown) {
    try {
        make_sample("teapot");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), Errc::bad_usage);
        for (const std::string_view name : sample_names())
            EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << name;
    }
}

TEST(Samples, SizesAndNumbersOutsideAreRefused) {
    for (const int size : {-1, 1, 7, 131073}) EXPECT_THROW(make_sample("spheres", clean(size)), Error) << size;
    SampleOptions options = clean(16);
    options.noise = std::nan("");
    EXPECT_THROW(make_sample("spheres", options), Error);
    options.noise = 0;
    options.blur_voxels = std::numeric_limits<double>::infinity();
    EXPECT_THROW(make_sample("spheres", options), Error);
}

TEST(Samples, CancelLeavesNothing) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(make_sample("casting", clean(32), {stop.get_token(), nullptr}), Error);
}

class EachSample : public testing::TestWithParam<std::string_view> {};

TEST_P(EachSample, SameBytesForAnyNumberOfThreads) {
    SampleOptions options;
    options.size = 45;
    options.noise = 1.5;
    set_thread_count(1);
    const Volume one = make_sample(GetParam(), options).volume;
    set_thread_count(3);
    const Volume three = make_sample(GetParam(), options).volume;
    options.seed = 2;
    const Volume other = make_sample(GetParam(), options).volume;
    set_thread_count(0);
    ASSERT_EQ(one.bytes(), three.bytes());
    EXPECT_EQ(std::memcmp(one.data(), three.data(), one.bytes()), 0);
    EXPECT_NE(std::memcmp(one.data(), other.data(), one.bytes()), 0) << "the seed has no effect";
}

TEST_P(EachSample, SmallestSizeHasASoundGeometry) {
    const AnalyticSample s = make_sample(GetParam(), clean(8));
    EXPECT_STREQ(fault_of(s.volume.geometry()), "");
    EXPECT_EQ(s.volume.geometry().size, glm::ivec3(8));
    EXPECT_NEAR(s.volume.geometry().centre_mm().x, 0, 1e-9);
}

// Away from every edge a clean voxel is the exact level: what the culling leaves out would show here.
TEST_P(EachSample, VoxelsAwayFromEdgesAreTheExactValue) {
    const AnalyticSample s = make_sample(GetParam(), clean(61));
    const GridGeometry& grid = s.volume.geometry();
    const bool formula = GetParam() == "marschner-lobb";
    int checked = 0;
    for (int z = 1; z < 60; z += 2)
        for (int y = 1; y < 60; y += 2)
            for (int x = 1; x < 60; ++x) {
                const double expected = s.value(grid.voxel_to_mm({x, y, z}));
                bool edge = false;
                for (int n = 0; n < 27 && !formula; ++n)
                    edge = edge || s.value(grid.voxel_to_mm({x + 0.7 * (n % 3 - 1), y + 0.7 * (n / 3 % 3 - 1),
                                                             z + 0.7 * (n / 9 - 1)})) != expected;
                if (edge) continue;
                ++checked;
                // Ramps grow past one voxel where a distance is a lower bound only; there is no way to miss a part by
                // that, so only the exact formula is compared closely.
                const double slack = formula ? 1e-6 : 0.5 * std::abs(s.material - s.background);
                ASSERT_NEAR(s.volume.value(x, y, z), expected, slack) << x << ' ' << y << ' ' << z;
            }
    EXPECT_GT(checked, 15000);
}

INSTANTIATE_TEST_SUITE_P(All, EachSample, testing::ValuesIn(sample_names()), [](const auto& row) {
    std::string name(row.param);
    std::erase(name, '-');
    return name;
});

TEST(Casting, KeepsItsSizeAndItsPores) {
    const AnalyticSample small = make_sample("casting", clean(32)), large = make_sample("casting", clean(96));
    EXPECT_NEAR(large.volume.geometry().spacing.x, 51.2 / 96, 1e-12);
    ASSERT_EQ(small.objects.size(), large.objects.size());
    int voids = 0, inclusions = 0;
    for (std::size_t i = 0; i < small.objects.size(); ++i) {
        EXPECT_EQ(small.objects[i].centre_mm, large.objects[i].centre_mm);
        (small.objects[i].kind == "void" ? voids : inclusions) += 1;
    }
    EXPECT_GE(voids, 25);
    EXPECT_EQ(inclusions, 2);
}

TEST(Casting, PoresLieInMetalApartFromEachOtherAndAirSurroundsThePart) {
    for (const unsigned seed : {1u, 2u, 77u}) {
        SampleOptions options = clean(16);
        options.seed = seed;
        const AnalyticSample s = make_sample("casting", options);
        for (const SampleObject& o : s.objects) {
            EXPECT_EQ(s.value(o.centre_mm), o.kind == "void" ? 3000 : 45000);
            EXPECT_NEAR(o.volume_mm3, 4.0 / 3 * std::numbers::pi * o.radii_mm.x * o.radii_mm.y * o.radii_mm.z, 1e-9);
            for (int n = 0; n < 27; ++n) {
                if (n == 13) continue;
                const glm::dvec3 d = glm::normalize(glm::dvec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
                const double radius = 1 / glm::length(d / o.radii_mm);
                EXPECT_EQ(s.value(o.centre_mm + d * (radius + 0.05)), 30000) << "pore touches something";
                EXPECT_EQ(s.value(o.centre_mm + d * (radius + 0.5)), 30000) << "too near the surface";
            }
        }
        for (double a = -25.5; a <= 25.5; a += 0.5)
            for (double b = -25.5; b <= 25.5; b += 0.5)
                for (const double face : {-24.6, 24.6})
                    ASSERT_TRUE(s.value({face, a, b}) == 3000 && s.value({a, face, b}) == 3000 &&
                                s.value({a, b, face}) == 3000);
    }
}

TEST(Casting, NoiseAndLevelsAreTheStatedOnes) {
    SampleOptions options;
    options.size = 64;
    const AnalyticSample s = make_sample("casting", options);
    EXPECT_EQ(s.volume.type(), VoxelType::u16);
    double sum = 0, squares = 0, odd_even = 0;
    int n = 0;
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; x += 2, n += 2) {
                const double a = s.volume.value(x, y, z) - 3000, b = s.volume.value(x + 1, y, z) - 3000;
                sum += a + b;
                squares += a * a + b * b;
                odd_even += a * b;
            }
    EXPECT_NEAR(sum / n, 0, 20);
    EXPECT_NEAR(std::sqrt(squares / n), 500, 20);
    EXPECT_NEAR(odd_even / (n / 2), 0, 0.06 * 500 * 500) << "neighbours are not independent";
}

TEST(Spheres, VoxelSumsGiveTheExactVolumes) {
    const AnalyticSample s = make_sample("spheres");
    EXPECT_EQ(s.volume.type(), VoxelType::u8);
    double exact = 0, measured = 0;
    for (const SampleObject& o : s.objects) exact += o.volume_mm3;
    for (const std::uint8_t v : s.volume.view<std::uint8_t>().voxels()) measured += (v - 20.0) / 180.0;
    measured *= s.volume.geometry().voxel_volume_mm3();
    EXPECT_NEAR(measured / exact, 1, 0.003);
}

TEST(Spheres, HalfLevelLiesOnTheSurface) {
    SampleOptions options;
    options.blur_voxels = 0.7;
    const AnalyticSample s = make_sample("spheres", options);
    const SampleObject& o = s.objects.front();
    const GridGeometry& grid = s.volume.geometry();
    const glm::dvec3 c = grid.mm_to_voxel(o.centre_mm);
    const int y = int(std::lround(c.y)), z = int(std::lround(c.z));
    const glm::dvec3 row = grid.voxel_to_mm({0, y, z}) - o.centre_mm;
    const double surface = std::sqrt(o.radii_mm.x * o.radii_mm.x - row.y * row.y - row.z * row.z) + o.centre_mm.x;
    for (int x = int(c.x); x < grid.size.x - 1; ++x) {
        const double a = s.volume.value(x, y, z), b = s.volume.value(x + 1, y, z);
        if (!(a >= 110 && b < 110)) continue;
        const double crossing = grid.voxel_to_mm({x + (a - 110) / (a - b), y, z}).x;
        EXPECT_NEAR(crossing, surface, 0.03 * grid.spacing.x);
        return;
    }
    FAIL() << "no surface found";
}

TEST(Head, FacesTheFrontUpright) {
    const AnalyticSample s = make_sample("head", clean(64));
    EXPECT_EQ(s.volume.type(), VoxelType::i16);
    EXPECT_EQ(s.volume.unit, "HU");
    EXPECT_GT(s.value({0, -95, -26}), -200) << "the nose points to -y";
    EXPECT_EQ(s.value({0, 108, -26}), -1000) << "nothing behind the neck";
    EXPECT_EQ(s.value({0, 0, 112}), -1000) << "air above the crown (+z)";
    EXPECT_GT(s.value({0, 30, -114}), -200) << "the neck leaves through the bottom";
    EXPECT_EQ(s.value({40, 8, 60}), 37);
    EXPECT_GE(s.value({0, 8, 97}), 900) << "skull";
}

TEST(Vessels, AneurysmIsBrighter) {
    const AnalyticSample s = make_sample("vessels", clean(64));
    ASSERT_EQ(s.objects.size(), 1u);
    const double ratio = s.value(s.objects[0].centre_mm) / s.material;
    EXPECT_GE(ratio, 1.10);
    EXPECT_LE(ratio, 1.20);
}

TEST(MarschnerLobb, PublishedGridAndRange) {
    const AnalyticSample s = make_sample("marschner-lobb");
    EXPECT_EQ(s.volume.geometry().size, glm::ivec3(41));
    EXPECT_NEAR(s.volume.geometry().spacing.x, 0.05, 1e-12);
    EXPECT_NEAR(s.value({0, 0, -1}), (1 + 1 + 0.25 * 2) / 2.5, 1e-12);  // rings: cos(12 pi) = 1
    EXPECT_NEAR(s.value({1, 0, 1}), (1 - 1 + 0.25 * 2) / 2.5, 1e-12);   // cos(12 pi cos(pi/2)) = 1
    const VolumeStatistics stats = compute_statistics(s.volume);
    EXPECT_GE(stats.range.lo, 0);
    EXPECT_LE(stats.range.hi, 1);
}

}  // namespace
}  // namespace lacuna
