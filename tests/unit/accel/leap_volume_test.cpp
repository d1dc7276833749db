#include "core/accel/leap_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/regions/regions.h"
#include "core/volume/samples.h"
#include "tests/support/scenes.h"

namespace lacuna {
namespace {

/// Two plateaus and a ramp between them, of any type and spacing.
template <class T>
Volume plateaus(glm::ivec3 size, glm::dvec3 spacing, double low, double high, double noise = 0) {
    GridGeometry grid;
    grid.size = size;
    grid.spacing = spacing;
    return make_volume<T>(grid, [&](std::span<T> voxels) {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> share(0, 1);
        std::size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x, ++i) {
                    const double r = glm::length((glm::dvec3(x, y, z) + 0.5) / glm::dvec3(size) - 0.5) * 2;
                    const double share_high = std::clamp((0.8 - r) * 12, 0.0, 1.0);
                    voxels[i] = T(low + (high - low) * share_high + noise * share(random));
                }
    });
}

LeapOptions options_for(const Volume& volume, double width, LeapWay way = LeapWay::transform) {
    LeapOptions options;
    options.range_width = width;
    options.step_mm = 0.5 * volume.geometry().smallest_spacing_mm();
    options.way = way;
    options.min_voxels = 8;
    options.groups = {0.05, 0.5, 1};
    if (volume.type() == VoxelType::f32) options.quantisation = ValueRange{-1, 1};
    return options;
}

/// From random places in every leap voxel's cell, along random ways as long as promised: everything trilinear
/// reconstruction reads there has one value in the flattened volume.
void expect_promises_kept(const Volume& volume, const LeapVolume& leap) {
    const glm::ivec3 n = leap.size;
    const glm::dvec3 s = volume.geometry().spacing, last(n - 1);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> half(-0.5, 0.5);
    std::int64_t checked = 0;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x) {
                const std::uint16_t entry = leap.data()[(std::int64_t(z) * n.y + y) * n.x + x];
                if (!(entry & k_leap_bit)) continue;
                ++checked;
                const double reach = (entry & 0x7fff) * leap.unit_mm, value = leap.flat.value(x, y, z);
                for (int ray = 0; ray < 6; ++ray) {
                    const glm::dvec3 from = glm::dvec3(x, y, z) + glm::dvec3(half(random), half(random), half(random));
                    const glm::dvec3 way =
                        glm::normalize(glm::dvec3(half(random), half(random), half(random)) + 1e-9) / s;
                    const glm::dvec3 to =
                        glm::clamp(from + way * std::min(reach, 1e4) * (ray % 2 ? 1.0 : 0.5), glm::dvec3(0), last);
                    const glm::ivec3 c(to);
                    for (int corner = 0; corner < 8; ++corner) {
                        const glm::ivec3 w = glm::min(c + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2), n - 1);
                        ASSERT_EQ(leap.flat.value(w.x, w.y, w.z), value)
                            << "from " << x << ' ' << y << ' ' << z << " by " << reach << " mm";
                    }
                }
            }
    EXPECT_EQ(checked, leap.leap_voxels);
}

TEST(LeapVolume, KeepsWhatItPromisesInAllThreeWays) {
    const Volume volumes[] = {plateaus<std::uint8_t>({41, 37, 39}, {1, 1, 1}, 20, 200),
                              plateaus<std::int16_t>({44, 45, 23}, {1, 1, 2}, -900, 1200),
                              plateaus<std::uint16_t>({60, 61, 31}, {1, 1, 5}, 100, 60000),
                              plateaus<float>({36, 37, 35}, {0.5, 0.5, 0.5}, -0.5, 0.5)};
    for (const Volume& volume : volumes)
        for (const LeapWay way : {LeapWay::transform, LeapWay::kd_tree, LeapWay::groups})
            for (const double width : {0.0, 0.1}) {
                const LeapVolume leap = build_leap_volume(volume, options_for(volume, width, way));
                EXPECT_GT(leap.leap_voxels, 100) << int(volume.type());
                expect_promises_kept(volume, leap);
            }
}

TEST(LeapVolume, TreeMakesTheTransformsEntries) {
    const Volume volume = plateaus<std::uint8_t>({41, 37, 39}, {1, 1, 1.5}, 20, 200, 9);
    const LeapVolume a = build_leap_volume(volume, options_for(volume, 0.1));
    const LeapVolume b = build_leap_volume(volume, options_for(volume, 0.1, LeapWay::kd_tree));
    EXPECT_GT(a.leap_voxels, 1000);
    EXPECT_TRUE(std::equal(a.data(), a.data() + volume.geometry().voxel_count(), b.data()));
}

TEST(LeapVolume, GuardsHoldTheAverageAndTheRestItsOwn) {
    const Volume volume = plateaus<std::uint8_t>({33, 35, 31}, {1, 1, 1}, 20, 200, 9);
    const LeapOptions options = options_for(volume, 0.1);
    const LeapVolume leap = build_leap_volume(volume, options);
    RegionOptions growing;
    growing.range_width = 0.1;
    growing.min_voxels = options.min_voxels;
    const HomogeneousRegions regions = grow_homogeneous_regions(volume, growing);
    const RegionTable table = find_regions(volume, growing);
    ASSERT_EQ(regions.mean.size(), table.rows.size() + 1);
    for (const RegionCharacteristics& row : table.rows) EXPECT_NEAR(row.mean, regions.mean[row.id], 1e-9);
    EXPECT_EQ(*regions.labels.labels, *table.labels.labels);
    EXPECT_EQ(leap.regions, std::int64_t(table.rows.size()));
    for (std::int64_t i = 0; i < volume.geometry().voxel_count(); ++i) {
        const std::uint32_t label = (*regions.labels.labels)[std::size_t(i)];
        const double own = volume.view<std::uint8_t>().data[i], mean = std::round(regions.mean[label]);
        ASSERT_EQ(leap.flat.view<std::uint8_t>().data[i], label ? mean : own);
        if (leap.data()[i] & k_leap_bit) {
            ASSERT_NE(label, 0u);
            continue;
        }
        ASSERT_NEAR(leap.value_lo + leap.data()[i] * leap.value_scale, label ? mean : own, 1e-9);
    }
}

TEST(LeapVolume, ARayMeetsGuardsBeforeItLeaps) {
    const Volume flat = test::bumpy_ball<std::uint8_t>({21, 22, 23}, {1, 1, 1}, 0, 100);
    const LeapVolume leap = build_leap_volume(flat, options_for(flat, 0));
    EXPECT_EQ(leap.flat.data(), flat.data()) << "nothing to change";
    for (int z = 0; z < 23; ++z)
        for (int y = 0; y < 22; ++y)
            for (int x = 0; x < 21; ++x) {
                const int depth = std::min({x, y, z, 20 - x, 21 - y, 22 - z});
                const std::uint16_t entry = leap.data()[(z * 22 + y) * 21 + x];
                ASSERT_EQ((entry & k_leap_bit) != 0, depth >= 2) << depth;
                if (depth < 2) continue;
                ASSERT_GT(entry & 0x7fff, 20000) << "no boundary anywhere: as far as it likes";
            }
}

TEST(LeapVolume, UglyVolumesHaveSoundEntries) {
    for (const test::NamedVolume& v : test::ugly_volumes())
        for (const LeapWay way : {LeapWay::transform, LeapWay::kd_tree, LeapWay::groups}) {
            const LeapVolume leap = build_leap_volume(v.volume, options_for(v.volume, 0.15, way));
            expect_promises_kept(v.volume, leap);
            if (v.volume.type() != VoxelType::f32) continue;
            const float* values = v.volume.view<float>().data;
            for (std::int64_t i = 0; i < v.volume.geometry().voxel_count(); ++i)
                if (std::isnan(values[i])) {
                    ASSERT_EQ(leap.data()[i], k_leap_nan);
                    ASSERT_TRUE(std::isnan(leap.flat.view<float>().data[i]));
                }
        }
}

TEST(LeapVolume, SixteenBitsLoseAtMostTheLowest) {
    const Volume wide = plateaus<std::uint16_t>({20, 20, 20}, {1, 1, 1}, 0, 65535);
    const LeapVolume leap = build_leap_volume(wide, options_for(wide, 0));
    for (std::int64_t i = 0; i < 8000; ++i)
        if (!(leap.data()[i] & k_leap_bit)) {
            ASSERT_NEAR(leap.value_lo + leap.data()[i] * leap.value_scale, wide.view<std::uint16_t>().data[i], 1.01);
        }
    const Volume narrow = plateaus<std::int16_t>({20, 20, 20}, {1, 1, 1}, -1000, 3000);
    EXPECT_EQ(build_leap_volume(narrow, options_for(narrow, 0)).value_scale, 1.0);
}

TEST(LeapVolume, RegionsAreCutWhereTheClassChanges) {
    const Volume flat = test::bumpy_ball<std::uint8_t>({40, 20, 20}, {1, 1, 1}, 0, 100);
    std::vector<std::uint8_t> voxel_class(16000);
    for (std::size_t i = 0; i < voxel_class.size(); ++i) voxel_class[i] = i % 40 < 20 ? 0 : 255;
    LeapOptions options = options_for(flat, 0);
    options.voxel_class = voxel_class.data();
    for (const LeapWay way : {LeapWay::transform, LeapWay::kd_tree}) {
        options.way = way;
        const LeapVolume leap = build_leap_volume(flat, options);
        const std::uint16_t middle = leap.data()[(10 * 20 + 10) * 40 + 10];
        ASSERT_TRUE(middle & k_leap_bit);
        EXPECT_LE((middle & 0x7fff) * leap.unit_mm, 10.0) << "the other class begins 10 mm away";
        EXPECT_FALSE(leap.data()[(10 * 20 + 10) * 40 + 19] & k_leap_bit);
    }
}

TEST(LeapVolume, RefusesFloatsWithoutAQuantisationInOneLine) {
    const Volume volume = plateaus<float>({8, 8, 8}, {1, 1, 1}, 0, 1);
    LeapOptions options;
    options.step_mm = 0.5;
    try {
        build_leap_volume(volume, options);
        FAIL() << "quantised as it liked";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_usage);
        EXPECT_NE(std::string(error.what()).find("macrocells"), std::string::npos) << "names what can serve";
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
}

TEST(LeapVolume, RefusesOptionsOutOfRange) {
    const Volume volume = plateaus<std::uint8_t>({8, 8, 8}, {1, 1, 1}, 0, 100);
    const auto refused = [&](auto&& change) {
        LeapOptions options = options_for(volume, 0.1);
        change(options);
        EXPECT_THROW(build_leap_volume(volume, options), Error);
    };
    refused([](LeapOptions& o) { o.range_width = -0.1; });
    refused([](LeapOptions& o) { o.range_width = std::nan(""); });
    refused([](LeapOptions& o) { o.range_width = 1.1; });
    refused([](LeapOptions& o) { o.step_mm = 0; });
    refused([](LeapOptions& o) { o.step_mm = std::nan(""); });
    refused([](LeapOptions& o) { o.groups.probability = 2; });
    refused([](LeapOptions& o) { o.groups.relative_radius = std::nan(""); });
}

TEST(LeapVolume, StopsWhereverItStands) {
    const Volume volume = plateaus<std::uint8_t>({64, 64, 64}, {1, 1, 1}, 20, 200, 9);
    for (const LeapWay way : {LeapWay::transform, LeapWay::kd_tree, LeapWay::groups})
        for (const double at : {0.0, 0.5, 0.7, 0.95}) {
            std::stop_source source;
            double last = 0;
            const JobContext job{source.get_token(), [&](double done) {
                                     EXPECT_GE(done, last);
                                     last = done;
                                     if (done >= at) source.request_stop();
                                 }};
            EXPECT_THROW(build_leap_volume(volume, options_for(volume, 0.1, way), job), Error) << at;
        }
}

}  // namespace
}  // namespace lacuna
