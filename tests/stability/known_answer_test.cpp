#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/io/volume_reader.h"
#include "core/regions/regions.h"
#include "core/volume/statistics.h"
#include "tests/support/test_data.h"

// From a file to numbers whose true values are known.
namespace lacuna {
namespace {

std::vector<std::vector<double>> rows_of(const std::filesystem::path& csv) {
    std::ifstream in(csv);
    std::string line;
    std::getline(in, line);  // names
    std::vector<std::vector<double>> rows;
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(std::stod(field));
    }
    return rows;
}

class PorousCube : public testing::TestWithParam<Connectivity> {};

TEST_P(PorousCube, HasSixtyTwoClosedVoids) {
    LACUNA_NEEDS_DATA(folder, "industrial/porous_cube_synthetic");
    RegionOptions options;
    options.threshold = ValueRange{0, 0};
    options.connectivity = GetParam();
    const RegionTable table = find_regions(open_volume(folder.string()), options);
    std::vector<RegionCharacteristics> voids;
    for (const auto& row : table.rows)
        if (!row.touches_border) voids.push_back(row);
    ASSERT_EQ(voids.size(), 62u);
    ASSERT_EQ(table.rows.size(), 63u) << "and the air around the cube";
    std::int64_t voxels = 0;
    for (const auto& row : voids) voxels += row.voxels;
    EXPECT_EQ(voxels, 17100);
    EXPECT_EQ(voids.front().voxels, 479);
    EXPECT_NEAR(100.0 * double(voxels) / std::pow(192.0, 3), 0.2416, 5e-5) << "porosity in percent";
    EXPECT_EQ(table.rows.front().holes, 1) << "the air around the cube encloses the cube and what is in it";

    const auto listed = rows_of(folder / "voids_reference.csv");
    ASSERT_EQ(listed.size(), voids.size());
    for (const auto& row : listed) {
        const glm::dvec3 centre(row[3], row[4], row[5]);
        const auto same = std::find_if(voids.begin(), voids.end(), [&](const RegionCharacteristics& v) {
            return glm::length(v.centroid_mm - centre) < 0.02;  // the list has two decimals
        });
        ASSERT_NE(same, voids.end()) << "no void at the place of number " << row[0];
        EXPECT_EQ(same->voxels, std::int64_t(row[1]));
        EXPECT_EQ(same->bbox_first, glm::ivec3(row[6], row[8], row[10]));
        EXPECT_EQ(same->bbox_last, glm::ivec3(row[7], row[9], row[11]));
    }
}

INSTANTIATE_TEST_SUITE_P(Voids, PorousCube, testing::Values(Connectivity::c6, Connectivity::c18, Connectivity::c26),
                         [](const auto& row) { return "c" + std::to_string(int(row.param)); });

TEST(Ketton, PorosityAndConnectedPores) {
    LACUNA_NEEDS_DATA(file, "industrial/ketton_binary/ketton.nhdr");
    RegionOptions options;
    options.threshold = ValueRange{0, 0};
    const Volume volume = open_volume(file.string());
    const RegionTable table = find_regions(volume, options);
    EXPECT_EQ(table.rows.size(), 2266u);
    std::int64_t pores = 0;
    for (const auto& row : table.rows) pores += row.voxels;
    EXPECT_NEAR(double(pores) / double(volume.geometry().voxel_count()), 0.12686, 5e-6);
    EXPECT_NEAR(table.rows.front().fraction, 0.995, 5e-4);
}

TEST(NiftiGeometry, IsTurnedToThePatientsAxes) {
    LACUNA_NEEDS_DATA(torso, "medical/torso_ct.nii.gz");
    const GridGeometry g = open_volume(torso.string()).geometry();
    EXPECT_EQ(g.direction, glm::dmat3({-1, 0, 0}, {0, -1, 0}, {0, 0, 1}))
        << "columns grow to the right, rows to the front";
    EXPECT_LT(glm::length(g.origin - glm::dvec3(177.95632934570312, -11.319000244140625, 94.3017578125)), 1e-9);
}

TEST(NiftiGeometry, ObliqueByTheGantrysAngle) {
    LACUNA_NEEDS_DATA(file, "medical/ct_head_phantom_oblique.nii.gz");
    const GridGeometry g = open_volume(file.string()).geometry();
    // The file's own affine, first three columns, with x and y turned from RAS to LPS.
    const glm::dvec3 columns[] = {
        {-0.8125, 0, 0}, {0, -0.779041051864624, -0.23076248168945312}, {0, -0.6807987689971924, 2.2983384132385254}};
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_LT(glm::length(g.direction[axis] * g.spacing[axis] - columns[axis]), 1e-5) << axis;
    EXPECT_NEAR(std::asin(std::abs(g.direction[1].z)) * 180 / M_PI, 16.5, 0.01);
    const glm::dvec3 far_corner = g.voxel_to_mm({174, 247, 57});
    const glm::dvec3 expected = glm::dvec3(69.02075958251953, 134.38560485839844, -13.56882095336914) +
                                174.0 * columns[0] + 247.0 * columns[1] + 57.0 * columns[2];
    EXPECT_LT(glm::length(far_corner - expected), 1e-3);
}

}  // namespace
}  // namespace lacuna
