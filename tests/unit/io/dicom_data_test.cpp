#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/io/dicom_reader.h"
#include "core/volume/statistics.h"
#include "tests/support/test_data.h"

// The reader against files that scanners and other toolkits wrote.
namespace lacuna {
namespace {

namespace fs = std::filesystem;

Volume open_only(const fs::path& input) {
    const auto found = find_dicom_series(input);
    if (found.size() != 1) throw std::runtime_error("found " + std::to_string(found.size()) + " series");
    return read_dicom_series(found.front());
}

double sample(const Volume& volume, const glm::dvec3& mm) {
    const glm::dvec3 voxel = volume.geometry().mm_to_voxel(mm), low = glm::floor(voxel + 1e-9);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        glm::ivec3 at;
        for (int a = 0; a < 3; ++a) {
            const int up = corner >> a & 1;
            const double share = std::clamp(voxel[a] - low[a], 0.0, 1.0);
            weight *= up ? share : 1 - share;
            at[a] = std::clamp(int(low[a]) + up, 0, volume.geometry().size[a] - 1);
        }
        if (weight > 0) sum += weight * volume.value(at.x, at.y, at.z);
    }
    return sum;
}

TEST(DicomData, VisibleHumanHead) {
    LACUNA_NEEDS_DATA(folder, "medical/ct_head_vhf");
    const Volume v = open_only(folder);
    EXPECT_EQ(v.geometry().size, glm::ivec3(512, 512, 100));
    EXPECT_EQ(v.geometry().spacing, glm::dvec3(1, 1, 2)) << "the step between positions, not SliceThickness 1";
    EXPECT_EQ(v.geometry().origin.z, 1534);
    EXPECT_EQ(v.type(), VoxelType::i16);
    const auto range = compute_statistics(v).range;
    EXPECT_EQ(range, (ValueRange{-1024, 3063}));
    EXPECT_EQ(v.unit, "HU");
    EXPECT_TRUE(v.warnings.empty());
}

TEST(DicomData, TiltedGantryMeetsTheReferencePoints) {
    LACUNA_NEEDS_DATA(folder, "medical/ct_head_tilt");
    LACUNA_NEEDS_DATA(table, "medical/ct_head_tilt_reference_points.csv");
    const Volume v = open_only(folder);
    EXPECT_NEAR(v.dicom->gantry_tilt_deg, 16.5, 0.01);
    EXPECT_EQ(v.dicom->slices_used, 20);
    EXPECT_NEAR(v.geometry().spacing.z, 2.397, 1e-3);
    std::ifstream file(table);
    std::string line;
    std::getline(file, line);
    int rows = 0, exact = 0;
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream cells(line);
        std::string name;
        double column, row, value, spread;
        glm::dvec3 mm;
        ASSERT_TRUE(cells >> name >> column >> row >> mm.x >> mm.y >> mm.z >> value >> spread) << line;
        const double found = sample(v, mm);
        EXPECT_LE(std::abs(found - value), spread + 1) << line;
        exact += std::abs(found - value) <= 0.5 * spread + 1;
        ++rows;
    }
    EXPECT_EQ(rows, 200);
    EXPECT_GE(exact, 190) << "interpolation may move a value within its neighbourhood, not swap neighbours";
}

TEST(DicomData, OneImageInEveryLosslessSyntax) {
    LACUNA_NEEDS_DATA(folder, "dicom_zoo/one_ct_image_in_many_syntaxes");
    const Volume plain = open_only(folder / "ctimage_explicit_le.dcm");
    EXPECT_EQ(compute_statistics(plain).range, (ValueRange{-2000 - 1024, 2402 - 1024}));
    for (const char* name : {"implicit_le", "explicit_be", "deflated", "rle", "jpeg_lossless_p14", "jpeg_lossless_sv1",
                             "jpegls_lossless", "j2k_lossless"}) {
        const Volume other = open_only(folder / ("ctimage_" + std::string(name) + ".dcm"));
        ASSERT_EQ(other.bytes(), plain.bytes()) << name;
        EXPECT_TRUE(std::equal(plain.data(), plain.data() + plain.bytes(), other.data())) << name;
    }
    for (const auto& [name, limit] :
         {std::pair("jpegls_near_lossless", 4.0), std::pair("j2k_lossy", 60.0), std::pair("jpeg_baseline_8bit", 200.0),
          std::pair("jpeg_extended_12bit", 120.0)}) {
        const Volume lossy = open_only(folder / ("ctimage_" + std::string(name) + ".dcm"));
        double worst = 0, sum = 0;
        for (int y = 0; y < 512; ++y)
            for (int x = 0; x < 512; ++x) {
                const double error = std::abs(lossy.value(x, y, 0) - plain.value(x, y, 0));
                worst = std::max(worst, error);
                sum += error;
            }
        EXPECT_LE(worst, limit) << name;
        EXPECT_LE(sum / (512 * 512), 30) << name;
    }
}

struct ZooCase {
    const char* file;
    glm::ivec3 size;
    VoxelType type;
    double lo, hi;
};

class DicomZoo : public testing::TestWithParam<ZooCase> {};

TEST_P(DicomZoo, SizeTypeAndRange) {
    const ZooCase& row = GetParam();
    LACUNA_NEEDS_DATA(file, fs::path("dicom_zoo") / row.file);
    const Volume v = open_only(file);
    EXPECT_EQ(v.geometry().size, row.size);
    EXPECT_EQ(v.type(), row.type) << name_of(v.type());
    const ValueRange range = compute_statistics(v).range;
    EXPECT_NEAR(range.lo, row.lo, 1e-3);
    EXPECT_NEAR(range.hi, row.hi, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Files, DicomZoo,
    testing::Values(ZooCase{"ct/CT_small.dcm", {128, 128, 1}, VoxelType::i16, 128 - 1024, 2191 - 1024},
                    ZooCase{"ct/eCT_Supplemental.dcm", {512, 512, 2}, VoxelType::i16, -1024, 1196 - 1024},
                    ZooCase{"ct/explicit_VR-UN.dcm", {512, 512, 1}, VoxelType::i16, -1024, 1186},
                    ZooCase{"mr_and_other/MR_small.dcm", {64, 64, 1}, VoxelType::u16, 127, 2145},
                    ZooCase{"mr_and_other/MR_small_bigendian.dcm", {64, 64, 1}, VoxelType::u16, 127, 2145},
                    ZooCase{"mr_and_other/MR_small_RLE.dcm", {64, 64, 1}, VoxelType::u16, 127, 2145},
                    ZooCase{"mr_and_other/MR_small_padded.dcm", {64, 64, 1}, VoxelType::u16, 127, 2145},
                    ZooCase{"mr_and_other/emri_small.dcm", {64, 64, 10}, VoxelType::u16, 0, 467},
                    ZooCase{"mr_and_other/emri_small_jpeg_ls_lossless.dcm", {64, 64, 10}, VoxelType::u16, 0, 467},
                    ZooCase{"mr_and_other/rtdose.dcm", {10, 10, 15}, VoxelType::f32, 0.795, 1.254},
                    ZooCase{"mr_and_other/liver_1frame.dcm", {512, 512, 1}, VoxelType::u8, 0, 1},
                    ZooCase{"mr_and_other/parametric_map_float.dcm", {128, 128, 1}, VoxelType::f32, 0, 0.941579},
                    ZooCase{"mr_and_other/12bitUnsigned_0x0F0F.dcm", {384, 384, 1}, VoxelType::u16, 0, 4095}));

TEST(DicomData, ComponentSeriesInMicrometres) {
    LACUNA_NEEDS_DATA(folder, "dicom_zoo/diconde_style_derived");
    const Volume v = open_only(folder);
    EXPECT_EQ(v.geometry().size, glm::ivec3(184, 148, 24));
    EXPECT_NEAR(v.geometry().spacing.z, 0.0070014, 1e-9);
    EXPECT_EQ(v.type(), VoxelType::u8);
    EXPECT_TRUE(v.dicom->slices_missing.empty());
    ASSERT_GE(v.dicom->component.size(), 2u);
    EXPECT_EQ(v.dicom->component[0].second, "AM STRUT 30DEG");
}

TEST(DicomData, FolderOfSeveralSeriesIsListedWithoutTheDicomdir) {
    LACUNA_NEEDS_DATA(folder, "dicom_zoo/dicomdir");
    const auto found = find_dicom_series(folder);
    EXPECT_GT(found.size(), 5u);
    int images = 0;
    for (const SeriesEntry& entry : found) images += entry.slices;
    EXPECT_EQ(images, 29) << "31 files, two of them CT scouts";
    const auto square = find_dicom_series(folder / "98892001" / "CT2N");
    ASSERT_FALSE(square.empty());
    const Volume v = read_dicom_series(square.front());
    EXPECT_NEAR(v.geometry().spacing.x, 0.596847, 0.06);
    EXPECT_NE(v.geometry().spacing.x, v.geometry().spacing.y);
}

class BrokenFiles : public testing::TestWithParam<const char*> {};

TEST_P(BrokenFiles, AreRefusedInOneSentence) {
    LACUNA_NEEDS_DATA(file, fs::path("broken") / GetParam());
    try {
        open_only(file);
        FAIL() << "was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_input);
        EXPECT_NE(std::string(error.what()).find(GetParam()), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenFiles,
                         testing::Values("MR_truncated.dcm", "badVR.dcm", "ctimage_jpegls_cut.dcm", "empty_file.dcm",
                                         "rtplan_truncated.dcm", "meta_missing_tsyntax.dcm", "no_meta.dcm",
                                         "UN_sequence.dcm", "ExplVR_LitEndNoMeta.dcm", "aneurism_cut.nrrd"));

TEST(DicomData, JpegLsOfSevenBitsIsRefusedNotMisread) {
    LACUNA_NEEDS_DATA(file, "dicom_zoo/mr_and_other/JLSL_08_07_0_1F.dcm");
    try {
        open_only(file);
        FAIL() << "it was read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::unsupported);
        EXPECT_NE(std::string(error.what()).find("JPEG-LS of 7 bits"), std::string::npos) << error.what();
    }
}

TEST(DicomData, PicturesAndReportsAreNoVolumes) {
    LACUNA_NEEDS_DATA(folder, "dicom_zoo/mr_and_other");
    for (const char* colour : {"SC_rgb_small_odd.dcm", "SC_rgb_rle_2frame.dcm"}) {
        try {
            open_only(folder / colour);
            FAIL() << colour;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::unsupported) << error.what();
        }
    }
    EXPECT_THROW(open_only(folder / "reportsi.dcm"), Error);
    EXPECT_THROW(open_only(folder / "rtstruct.dcm"), Error);
    EXPECT_FALSE(looks_like_dicom(folder / "zipMR.gz"));
    EXPECT_TRUE(looks_like_dicom(folder / "rtstruct.dcm")) << "without a preamble";
}

}  // namespace
}  // namespace lacuna
