// Volumes that do not lie in memory: boxes, pieces, statistics and samples agree with the volume read whole.
#include "core/volume/volume_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "core/volume/samples.h"
#include "core/volume/statistics.h"
#include "tests/support/memory_source.h"

namespace lacuna {
namespace {

template <class T>
Volume noisy(glm::ivec3 size, double scale, double offset) {
    GridGeometry grid;
    grid.size = size;
    return make_volume<T>(grid, [&](std::span<T> voxels) {
        std::uint64_t state = 1;
        for (T& v : voxels) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            v = T(offset + scale * double(state >> 40) / double(1 << 24));
        }
    });
}

void expect_equal_statistics(const Volume& volume) {
    const VolumeStatistics whole = compute_statistics(volume), parts = compute_statistics(test::elsewhere(volume));
    EXPECT_EQ(parts.range, whole.range);
    EXPECT_EQ(parts.nan_count, whole.nan_count);
    EXPECT_NEAR(parts.mean, whole.mean, 1e-9 * std::abs(whole.mean));
    EXPECT_NEAR(parts.stddev, whole.stddev, 1e-7 * whole.stddev);
    EXPECT_EQ(parts.histogram, whole.histogram);
    EXPECT_EQ(parts.histogram_range, whole.histogram_range);
    EXPECT_EQ(otsu_threshold(parts), otsu_threshold(whole));
}

TEST(VolumeInParts, HasNoVoxelsInMemory) {
    const Volume volume = test::elsewhere(noisy<std::uint16_t>({5, 4, 3}, 1000, 0));
    EXPECT_FALSE(volume.empty());
    EXPECT_FALSE(volume.in_memory());
    EXPECT_EQ(volume.bytes(), 0u);
    EXPECT_EQ(volume.total_bytes(), 120u);
    EXPECT_EQ(Volume(volume).identity(), volume.identity());
}

TEST(VolumeInParts, StatisticsAreThoseOfTheWhole) {
    expect_equal_statistics(noisy<std::uint8_t>({37, 70, 131}, 200, 3));
    expect_equal_statistics(noisy<std::int8_t>({1, 1, 200}, 200, -100));
    expect_equal_statistics(noisy<std::uint16_t>({65, 64, 63}, 60000, 100));
    expect_equal_statistics(noisy<std::int16_t>({129, 1, 67}, 4000, -1000));
    Volume floats = noisy<float>({31, 67, 66}, 1, -0.5);
    auto* voxels = reinterpret_cast<float*>(floats.buffer().data());
    voxels[5] = std::nanf("");
    voxels[90000] = std::numeric_limits<float>::infinity();
    expect_equal_statistics(floats);
    expect_equal_statistics(noisy<float>({9, 9, 9}, 0, 7));
    Volume only_nan = noisy<float>({3, 3, 3}, 0, 0);
    for (int i = 0; i < 27; ++i) reinterpret_cast<float*>(only_nan.buffer().data())[i] = std::nanf("");
    expect_equal_statistics(only_nan);
}

TEST(VolumeInParts, PiecesCoverEveryVoxelOnce) {
    const Volume volume = test::elsewhere(noisy<std::uint16_t>({10, 150, 133}, 1000, 0));
    std::int64_t own = 0;
    for_each_piece(volume, 16, [&](const VolumePiece& piece) {
        own += std::int64_t(piece.own.x) * piece.own.y * piece.own.z;
        EXPECT_EQ(piece.box.first % 16, glm::ivec3(0));
        EXPECT_EQ(piece.volume.value(3, piece.box.size.y - 1, piece.box.size.z - 1),
                  extract_box(volume, {piece.box.first + piece.box.size - 1 - glm::ivec3(6, 0, 0), {1, 1, 1}})
                      .value(0, 0, 0));
    });
    EXPECT_EQ(own, volume.geometry().voxel_count());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(for_each_piece(volume, 16, [](const VolumePiece&) {}, {stop.get_token(), nullptr}), Error);
}

TEST(VolumeInParts, ABoxLiesWhereItLay) {
    const Volume volume = noisy<std::int16_t>({12, 11, 10}, 1000, 0);
    const Volume box = extract_box(test::elsewhere(volume), {{3, 4, 5}, {6, 5, 4}});
    EXPECT_EQ(box.value(2, 1, 3), volume.value(5, 5, 8));
    EXPECT_EQ(box.geometry().voxel_to_mm({0, 0, 0}), volume.geometry().voxel_to_mm({3, 4, 5}));
}

TEST(VolumeInParts, SamplesArePaintedTheSameBoxByBox) {
    for (const std::string_view name : sample_names()) {
        SampleOptions options;
        options.dims = {70, 45, 38};
        const Volume whole = make_sample(name, options).volume, parts = sample_in_parts(name, options);
        ASSERT_EQ(whole.geometry().size, options.dims) << name;
        EXPECT_EQ(parts.geometry().spacing, whole.geometry().spacing);
        for (const VoxelBox box : {VoxelBox{{0, 0, 0}, {70, 45, 38}}, VoxelBox{{31, 7, 30}, {9, 30, 8}},
                                   VoxelBox{{69, 44, 37}, {1, 1, 1}}}) {
            const Volume a = extract_box(whole, box), b = extract_box(parts, box);
            EXPECT_EQ(std::memcmp(a.data(), b.data(), a.bytes()), 0) << name;
        }
    }
}

TEST(VolumeInParts, ASamplesAxesDivideTheSameSpace) {
    SampleOptions cube, flat;
    cube.size = 32;
    flat.dims = {64, 32, 8};
    const GridGeometry a = make_sample("spheres", cube).volume.geometry();
    const GridGeometry b = make_sample("spheres", flat).volume.geometry();
    EXPECT_NEAR(glm::length(a.spacing * glm::dvec3(a.size) - b.spacing * glm::dvec3(b.size)), 0, 1e-9);
    EXPECT_NEAR(glm::length(a.centre_mm() - b.centre_mm()), 0, 1e-9);
    flat.dims = {64, 32, 7};
    EXPECT_THROW(sample_in_parts("spheres", flat), Error);
    flat.dims = {131072, 131072, 131072};
    EXPECT_THROW(sample_in_parts("spheres", flat), Error);
    flat.dims = {131072, 2048, 64};
    EXPECT_EQ(sample_in_parts("spheres", flat).geometry().size, flat.dims);
}

}  // namespace
}  // namespace lacuna
