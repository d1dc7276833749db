#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/base/stopwatch.h"
#include "tests/support/test_data.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

Volume read_raw(const std::filesystem::path& file, const glm::ivec3& size) {
    const std::string bytes = read_file(file);
    EXPECT_EQ(bytes.size(), std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    return make_volume<std::uint8_t>(grid(size), [&](std::span<std::uint8_t> voxels) {
        std::copy_n(bytes.begin(), std::min(bytes.size(), voxels.size()), voxels.begin());
    });
}

TEST(RealData, TheEngineFallsIntoAirAndMetal) {
    LACUNA_NEEDS_DATA(file, "industrial/engine/engine.raw");
    const Volume engine = read_raw(file, {256, 256, 128});
    const Stopwatch clock;
    const RegionTable table = grown(engine, 0.1, Connectivity::c6, 64);
    EXPECT_LT(clock.ms(), 20'000);  // a gross fault only: the bench measures
    RecordProperty("regions", int(table.rows.size()));
    ASSERT_GE(table.rows.size(), 4u);
    // The air round the part comes first: the largest, at the frame, near 0. The two metals follow, far brighter.
    EXPECT_TRUE(table.rows[0].touches_border);
    EXPECT_LT(table.rows[0].mean, 10);
    EXPECT_GT(table.rows[0].fraction, 0.5);
    EXPECT_GT(std::max({table.rows[1].mean, table.rows[2].mean, table.rows[3].mean}), 100);
    for (const RegionCharacteristics& row : table.rows) {
        ASSERT_LE(row.max - row.min, 25);
        ASSERT_GE(row.voxels, 64);
        ASSERT_GE(row.tunnels, 0);
        ASSERT_LE(row.sphericity, 1);
    }
}

}  // namespace
}  // namespace lacuna::test
