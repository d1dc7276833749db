#include "core/io/volume_writer.h"
#include "tests/support/test_data.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

struct RealSet {
    const char* path;
    glm::ivec3 size;
    VoxelType type;
    double lo, hi;
    glm::dvec3 spacing;
    double mean;  ///< NaN: the list of sets does not say
};

void PrintTo(const RealSet& set, std::ostream* out) { *out << set.path; }

const double k_unsaid = std::nan("");
const RealSet k_sets[] = {
    {"medical/ct_head_tiff", {256, 256, 99}, VoxelType::u8, 0, 255, {1, 1, 1}, k_unsaid},
    {"medical/aneurism.nrrd", {256, 256, 256}, VoxelType::u8, 0, 255, {1, 1, 1}, 1.07},
    {"medical/torso_ct.nii.gz", {122, 101, 112}, VoxelType::i16, -1207, 3382, {3, 3, 3}, k_unsaid},
    {"medical/torso_ct_slab.nii.gz", {122, 101, 30}, VoxelType::i16, -1100, 1207, {3, 3, 3}, k_unsaid},
    {"medical/torso_ct_slab_labels.nii.gz", {122, 101, 30}, VoxelType::u8, 0, 117, {3, 3, 3}, k_unsaid},
    {"medical/ct_head_phantom_oblique.nii.gz",
     {175, 248, 58},
     VoxelType::u8,
     0,
     255,
     {0.8125, 0.8125, 2.397},
     k_unsaid},
    {"industrial/engine/engine.raw", {256, 256, 128}, VoxelType::u8, 0, 255, {1, 1, 1}, 22.35},
    {"industrial/engine/engine.mhd", {256, 256, 128}, VoxelType::u8, 0, 255, {1, 1, 1}, 22.35},
    {"industrial/engine/engine.dat", {256, 256, 128}, VoxelType::u8, 0, 255, {1, 1, 1}, 22.35},
    {"industrial/bonsai/bonsai.nhdr", {256, 256, 256}, VoxelType::u8, 0, 255, {1, 1, 1}, 13.71},
    {"industrial/am_struts/strut30_a.mhd", {184, 148, 240}, VoxelType::u8, 0, 198, glm::dvec3(0.0070014), k_unsaid},
    {"industrial/am_struts/strut30_b.mhd", {184, 148, 240}, VoxelType::u8, 0, 198, glm::dvec3(0.0070014), k_unsaid},
    {"industrial/am_struts/strut60_a.mhd", {184, 148, 240}, VoxelType::u8, 0, 198, glm::dvec3(0.0070014), k_unsaid},
    {"industrial/am_struts/strut60_b.mhd", {184, 148, 240}, VoxelType::u8, 0, 198, glm::dvec3(0.0070014), k_unsaid},
    {"industrial/porous_cube_synthetic", {256, 256, 256}, VoxelType::u8, 0, 255, {1, 1, 1}, k_unsaid},
    {"industrial/ketton_binary/ketton.nhdr", {256, 256, 256}, VoxelType::u8, 0, 255, {1, 1, 1}, 255 * (1 - 0.12686)},
    {"industrial/fiberform/fiberform_100.tif", {100, 100, 100}, VoxelType::u8, 0, 255, {1, 1, 1}, k_unsaid},
};

struct Summary {
    double lo = INFINITY, hi = -INFINITY, mean = 0;
};

Summary summary_of(const Volume& volume) {
    Summary s;
    visit_type(volume.type(), [&](auto tag) {
        double sum = 0;
        const auto voxels = volume.view<decltype(tag)>().voxels();
        for (const auto v : voxels) {
            s.lo = std::min(s.lo, double(v));
            s.hi = std::max(s.hi, double(v));
            sum += double(v);
        }
        s.mean = sum / double(voxels.size());
    });
    return s;
}

class RealSets : public testing::TestWithParam<RealSet> {};

}  // namespace

TEST_P(RealSets, HaveTheDimsTypeAndRangeTheirListStates) {
    const RealSet& set = GetParam();
    LACUNA_NEEDS_DATA(path, set.path);
    testing::internal::CaptureStderr();
    const Volume volume = open_volume(path.string());
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(volume.geometry().size, set.size);
    EXPECT_EQ(name_of(volume.type()), name_of(set.type));
    EXPECT_EQ(volume.name, path.filename().string());
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(volume.geometry().spacing[a], set.spacing[a], 1e-3 * set.spacing[a]);
    const Summary s = summary_of(volume);
    EXPECT_EQ(s.lo, set.lo);
    EXPECT_LE(s.hi, set.hi);
    const bool strut = std::string(set.path).find("strut") != std::string::npos;
    if (!strut) {  // 198 is the largest of all four
        EXPECT_EQ(s.hi, set.hi);
    }
    if (!std::isnan(set.mean)) {
        EXPECT_NEAR(s.mean, set.mean, 0.01);
    }
    const auto listed = list_series(path.string());
    ASSERT_EQ(listed.size(), 1u);
    EXPECT_EQ(listed[0].size, set.size);
}

INSTANTIATE_TEST_SUITE_P(Listed, RealSets, testing::ValuesIn(k_sets));
