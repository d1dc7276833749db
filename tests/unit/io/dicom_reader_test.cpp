#include "core/io/dicom_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/base/atomic_file.h"
#include "tests/support/dicom_zoo.h"

namespace lacuna {
namespace {

using test::TemporaryFolder;
using test::write_zoo_slice;
using test::ZooSlice;
using test::ZooSyntax;

/// A folder's only series.
Volume open_only(const std::filesystem::path& folder, const OpenOptions& options = {}) {
    const auto found = find_dicom_series(folder);
    if (found.size() != 1) throw std::runtime_error("found " + std::to_string(found.size()) + " series");
    return read_dicom_series(found.front(), options);
}

/// The error a call throws; a test failure when it throws none.
template <class Call>
std::pair<Errc, std::string> error_of(Call&& call) {
    try {
        call();
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
    ADD_FAILURE() << "nothing was thrown";
    return {Errc::cancelled, ""};
}

bool warned(const Volume& volume, const std::string& part) {
    for (const Warning& w : volume.warnings)
        if (w.text.find(part) != std::string::npos) return true;
    return false;
}

/// Slices at the given z, stored value 100 * (index + 1) + 10 * y + x, written so that names and instance numbers run
/// against the positions.
void write_stack(const TemporaryFolder& folder, const std::vector<double>& z, ZooSlice like = {}) {
    for (std::size_t i = 0; i < z.size(); ++i) {
        like.position.z = z[i];
        like.instance = int(z.size() - i);
        like.stored = [i](int x, int y) { return int(100 * (i + 1)) + 10 * y + x; };
        write_zoo_slice(folder / ("slice" + std::to_string(z.size() - i)), like);
    }
}

TEST(DicomReader, GeometryAndValuesOfAPlainSeries) {
    const TemporaryFolder folder;
    ZooSlice like;
    like.pixel_spacing = "0.75\\0.5";  // rows first: y is 0.75
    like.position = {-10, 20, 0};
    write_stack(folder, {5, 7.5, 10}, like);
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.geometry().size, glm::ivec3(6, 5, 3));
    EXPECT_EQ(v.geometry().spacing, glm::dvec3(0.5, 0.75, 2.5));
    EXPECT_EQ(v.geometry().origin, glm::dvec3(-10, 20, 5));
    EXPECT_EQ(v.geometry().direction, glm::dmat3(1));
    EXPECT_EQ(v.type(), VoxelType::i16);
    EXPECT_EQ(v.unit, "HU");
    EXPECT_EQ(v.name, "zoo");
    EXPECT_TRUE(v.warnings.empty());
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 6; ++x) ASSERT_EQ(v.value(x, y, z), 100 * (z + 1) + 10 * y + x - 1024);
    ASSERT_TRUE(v.dicom);
    EXPECT_EQ(v.dicom->slices_found, 3);
    EXPECT_EQ(v.dicom->slices_used, 3);
    EXPECT_EQ(v.dicom->slice_spacing_min_mm, 2.5);
    EXPECT_TRUE(v.dicom->component.empty());
}

TEST(DicomReader, AxesOfAnObliqueSeriesMakeARightHandedGrid) {
    const TemporaryFolder folder;
    ZooSlice like;
    like.row = {0, 1, 0};
    like.column = {0, 0, -1};  // sagittal; the normal is -x
    for (int i = 0; i < 3; ++i) {
        like.position = {10.0 + 2 * i, 3, 4};
        like.stored = [i](int, int) { return 100 * i; };
        write_zoo_slice(folder / ("s" + std::to_string(i)), like);
    }
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.geometry().direction[2], glm::dvec3(-1, 0, 0));
    EXPECT_EQ(v.geometry().origin, glm::dvec3(14, 3, 4));
    EXPECT_EQ(v.geometry().spacing.z, 2);
    EXPECT_EQ(v.value(0, 0, 0), 200 - 1024);
    EXPECT_EQ(v.geometry().voxel_to_mm({2, 1, 2}), glm::dvec3(10, 4, 3.5));
}

struct FormatCase {
    const char* name;
    int allocated, stored;
    bool is_signed;
    std::string slope, intercept;
    std::vector<int> values;  // stored, one a slice pixel (0, 0); others are the first
    VoxelType type;
    std::vector<double> real;
};

class PixelFormats : public testing::TestWithParam<FormatCase> {};

TEST_P(PixelFormats, SmallestTypeThatHoldsEveryValue) {
    const FormatCase& row = GetParam();
    const TemporaryFolder folder;
    ZooSlice like;
    like.bits_allocated = row.allocated;
    like.bits_stored = row.stored;
    like.is_signed = row.is_signed;
    like.slope = row.slope;
    like.intercept = row.intercept;
    for (std::size_t i = 0; i < row.values.size(); ++i) {
        like.position.z = double(i);
        like.stored = [&](int x, int y) { return x == 0 && y == 0 ? row.values[i] : row.values[0]; };
        write_zoo_slice(folder / ("s" + std::to_string(i)), like);
    }
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.type(), row.type) << name_of(v.type());
    for (std::size_t i = 0; i < row.real.size(); ++i) EXPECT_EQ(v.value(0, 0, int(i)), row.real[i]) << i;
    EXPECT_EQ(v.value(5, 4, 1), row.real[0]);
}

INSTANTIATE_TEST_SUITE_P(
    Dicom, PixelFormats,
    testing::Values(
        FormatCase{"u8_kept", 8, 8, false, "1", "0", {0, 255, 7}, VoxelType::u8, {0, 255, 7}},
        FormatCase{"u8_to_hounsfield", 8, 8, false, "1", "-1024", {0, 255}, VoxelType::i16, {-1024, -769}},
        FormatCase{"i8", 8, 8, true, "1", "0", {-128, 127}, VoxelType::i8, {-128, 127}},
        FormatCase{"u16_full", 16, 16, false, "1", "0", {0, 65535}, VoxelType::u16, {0, 65535}},
        FormatCase{"u16_narrow", 16, 16, false, "1", "0", {0, 200}, VoxelType::u8, {0, 200}},
        FormatCase{"u16_narrow_signed", 16, 16, false, "1", "-100", {0, 200}, VoxelType::i8, {-100, 100}},
        FormatCase{"i16_shifted_out", 16, 16, true, "1", "-1024", {-32768, 32767}, VoxelType::f32, {-33792, 31743}},
        FormatCase{"i16_shifted_inside", 16, 16, true, "1", "-1024", {0, 4087}, VoxelType::i16, {-1024, 3063}},
        FormatCase{"twelve_signed", 16, 12, true, "1", "0", {-2048, 2047}, VoxelType::i16, {-2048, 2047}},
        FormatCase{"slope_two", 16, 12, false, "2", "-1000", {0, 4095}, VoxelType::i16, {-1000, 7190}},
        FormatCase{"slope_negative", 16, 12, false, "-1", "0", {0, 4095}, VoxelType::i16, {0, -4095}},
        FormatCase{"slope_half_whole", 16, 12, false, "0.5", "0", {0, 4094}, VoxelType::u16, {0, 2047}},
        FormatCase{"slope_half_odd", 16, 12, false, "0.5", "0", {0, 4095}, VoxelType::f32, {0, 2047.5}}),
    [](const auto& row) { return row.param.name; });

TEST(DicomReader, EverySliceHasItsOwnScale) {
    const TemporaryFolder folder;
    const std::vector<std::string> slopes = {"1", "0.25", "3"}, intercepts = {"0", "0.5", "-7"};
    ZooSlice like;
    like.modality = "PT";
    like.rescale_type = "BQML";
    for (int i = 0; i < 3; ++i) {
        like.position.z = i;
        like.slope = slopes[std::size_t(i)];
        like.intercept = intercepts[std::size_t(i)];
        like.stored = [](int x, int) { return 10 + x; };
        write_zoo_slice(folder / std::to_string(i), like);
    }
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.type(), VoxelType::f32);
    EXPECT_EQ(v.unit, "BQML");
    EXPECT_EQ(v.value(1, 0, 0), 11);
    EXPECT_EQ(v.value(1, 0, 1), 3.25);
    EXPECT_EQ(v.value(1, 0, 2), 26);
}

TEST(DicomReader, PaddingBecomesTheSmallestMeasuredValueAndIsCounted) {
    const TemporaryFolder folder;
    ZooSlice like;
    like.bits_stored = 16;
    like.is_signed = true;
    like.padding = -2000;
    like.padding_limit = -1990;
    for (int i = 0; i < 2; ++i) {
        like.position.z = i;
        like.stored = [i](int x, int y) { return x == 0 ? -1995 : 30 + 10 * i + y; };
        write_zoo_slice(folder / std::to_string(i), like);
    }
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.value(0, 3, 1), 30 - 1024);
    EXPECT_EQ(v.value(1, 2, 1), 42 - 1024);
    EXPECT_TRUE(warned(v, "10 voxels are padding"));
}

TEST(DicomReader, Monochrome1KeepsItsNumbers) {
    const TemporaryFolder folder;
    ZooSlice s;
    s.photometric = "MONOCHROME1";
    write_zoo_slice(folder / "a", s);
    const Volume v = open_only(folder / "a");
    EXPECT_EQ(v.value(1, 1, 0), 111 - 1024);
    EXPECT_EQ(v.dicom->photometric_interpretation, "MONOCHROME1");
}

class Syntaxes : public testing::TestWithParam<ZooSyntax> {};

TEST_P(Syntaxes, SamePixels) {
    const TemporaryFolder folder;
    ZooSlice like;
    like.size = {17, 9};
    like.syntax = GetParam();
    like.bits_stored = 16;
    like.is_signed = true;
    for (int i = 0; i < 2; ++i) {
        like.position.z = i;
        like.stored = [i](int x, int y) { return (x * 1931 + y * 771 + i * 13) % 5000 - 1000; };
        write_zoo_slice(folder / std::to_string(i), like);
    }
    const Volume v = open_only(folder.path());
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 17; ++x)
                ASSERT_EQ(v.value(x, y, z), (x * 1931 + y * 771 + z * 13) % 5000 - 1000 - 1024) << x << " " << y;
}

INSTANTIATE_TEST_SUITE_P(Dicom, Syntaxes,
                         testing::Values(ZooSyntax::implicit_le, ZooSyntax::explicit_le, ZooSyntax::explicit_be,
                                         ZooSyntax::deflated, ZooSyntax::rle, ZooSyntax::jpeg_lossless,
                                         ZooSyntax::jpeg_ls));

TEST(DicomReader, EightBitsInEverySyntax) {
    for (const ZooSyntax syntax : {ZooSyntax::implicit_le, ZooSyntax::explicit_le, ZooSyntax::explicit_be,
                                   ZooSyntax::rle, ZooSyntax::jpeg_lossless, ZooSyntax::jpeg_ls}) {
        const TemporaryFolder folder;
        ZooSlice s;
        s.size = {7, 3};  // odd: the element is padded
        s.bits_allocated = s.bits_stored = 8;
        s.slope.clear();
        s.syntax = syntax;
        s.stored = [](int x, int y) { return 40 * y + 3 * x; };
        write_zoo_slice(folder / "a", s);
        const Volume v = open_only(folder.path());
        EXPECT_EQ(v.type(), VoxelType::u8);
        EXPECT_EQ(v.unit, "");
        EXPECT_EQ(v.value(6, 2, 0), 98) << int(syntax);
        EXPECT_EQ(v.value(1, 0, 0), 3) << int(syntax);
    }
}

TEST(DicomReader, FilesWithoutPreambleAndMetaGroupAreRead) {
    for (const ZooSyntax syntax : {ZooSyntax::implicit_le, ZooSyntax::explicit_le}) {
        const TemporaryFolder folder;
        ZooSlice s;
        s.with_meta = false;
        s.syntax = syntax;
        write_zoo_slice(folder / "bare", s);
        EXPECT_TRUE(looks_like_dicom(folder / "bare"));
        EXPECT_EQ(open_only(folder.path()).value(2, 1, 0), 112 - 1024);
    }
}

TEST(DicomReader, EnhancedFramesInAnyOrder) {
    const TemporaryFolder folder;
    const std::vector<glm::dvec3> positions = {{1, 2, 6}, {1, 2, 0}, {1, 2, 4}, {1, 2, 2}};
    for (const ZooSyntax syntax : {ZooSyntax::explicit_le, ZooSyntax::rle, ZooSyntax::jpeg_ls}) {
        ZooSlice like;
        like.syntax = syntax;
        test::write_zoo_enhanced(folder / "multi", like, positions,
                                 [](int f, int x, int y) { return 100 * f + 10 * y + x; });
        const auto found = find_dicom_series(folder.path());
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].slices, 4);
        EXPECT_EQ(found[0].files.size(), 1u);
        const Volume v = read_dicom_series(found[0]);
        EXPECT_EQ(v.geometry().size, glm::ivec3(6, 5, 4));
        EXPECT_EQ(v.geometry().spacing, glm::dvec3(0.5, 0.5, 2));
        EXPECT_EQ(v.geometry().origin, glm::dvec3(1, 2, 0));
        const int frame_of_plane[] = {1, 3, 2, 0};
        for (int z = 0; z < 4; ++z) EXPECT_EQ(v.value(3, 2, z), 100 * frame_of_plane[z] + 23 - 1024) << z;
    }
}

TEST(DicomReader, AMissingSliceIsNamedAndNeverStretchesTheVolume) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 3, 4});
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.geometry().size.z, 5);
    EXPECT_EQ(v.geometry().spacing.z, 1);
    EXPECT_EQ(v.dicom->slices_missing, std::vector<int>{2});
    EXPECT_EQ(v.value(1, 1, 1), 211 - 1024);
    EXPECT_EQ(v.value(1, 1, 2), 261 - 1024);
    EXPECT_EQ(v.value(1, 1, 3), 311 - 1024);
    ASSERT_EQ(v.warnings.size(), 1u);
    EXPECT_EQ(v.warnings[0].max_error_mm, 1);
    EXPECT_NE(v.warnings[0].text.find("slice 2"), std::string::npos) << v.warnings[0].text;

    OpenOptions keep;
    keep.keep_gaps = true;
    const auto [code, text] = error_of([&] { open_only(folder.path(), keep); });
    EXPECT_EQ(code, Errc::bad_input);
    EXPECT_NE(text.find("slice3"), std::string::npos) << text;  // the files on both sides of the gap
    EXPECT_NE(text.find("slice2"), std::string::npos) << text;
}

TEST(DicomReader, DuplicatesAreSetAsideByName) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 2});
    std::filesystem::copy_file(folder / "slice2", folder / "twin");
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.geometry().size.z, 3);
    EXPECT_EQ(v.dicom->slices_found, 4);
    EXPECT_EQ(v.dicom->slices_used, 3);
    EXPECT_EQ(v.dicom->duplicates, std::vector<std::string>{"twin"});
    EXPECT_TRUE(warned(v, "twin"));
}

TEST(DicomReader, UnevenSpacingIsResampledToAnEvenStep) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 2, 3.5, 5, 6.5});
    const Volume v = open_only(folder.path());
    const double step = v.geometry().spacing.z;
    EXPECT_NEAR(step * (v.geometry().size.z - 1), 6.5, 1e-9);
    EXPECT_LE(step, 1.1);
    EXPECT_TRUE(warned(v, "unevenly spaced"));
    EXPECT_TRUE(v.dicom->slices_missing.empty());
    EXPECT_EQ(v.dicom->slice_spacing_max_mm, 1.5);
    // Values are linear between the slices: 100 a slice.
    const std::vector<double> at = {0, 1, 2, 3.5, 5, 6.5};
    for (int z = 0; z < v.geometry().size.z; ++z) {
        const double mm = z * step;
        std::size_t i = 0;
        while (i + 2 < at.size() && at[i + 1] <= mm) ++i;
        const double slice = double(i) + (mm - at[i]) / (at[i + 1] - at[i]);
        EXPECT_NEAR(v.value(2, 1, z), 100 * (slice + 1) + 12 - 1024, 0.51) << z;
    }
}

class Tilt : public testing::TestWithParam<double> {};

/// A series with tilted gantry of a body whose value is linear in space: the resampled volume must hold that function,
/// and beside the slices the smallest value.
TEST_P(Tilt, IsFoundFromThePositionsAndUndone) {
    const double angle = GetParam() * 3.14159265358979323846 / 180;
    const TemporaryFolder folder;
    ZooSlice like;
    like.size = {8, 20};
    like.pixel_spacing = "1\\1";
    like.row = {1, 0, 0};
    like.column = {0, std::cos(angle), std::sin(angle)};
    const auto body = [](const glm::dvec3& mm) { return 500 + 4 * mm.x + 10 * mm.y + 6 * mm.z; };
    for (int i = 0; i < 6; ++i) {
        like.position = {0, 0, 2.5 * i};
        like.stored = [&](int x, int y) {
            return int(std::lround(body(like.position + double(x) * like.row + double(y) * like.column)));
        };
        write_zoo_slice(folder / std::to_string(i), like);
    }
    const Volume v = open_only(folder.path());
    EXPECT_NEAR(v.dicom->gantry_tilt_deg, GetParam(), 1e-3);
    EXPECT_TRUE(warned(v, "gantry"));
    const GridGeometry& g = v.geometry();
    EXPECT_NEAR(g.spacing.z, 2.5 * std::cos(angle), 1e-6);
    EXPECT_EQ(g.size.x, 8);
    EXPECT_EQ(g.size.y, 20 + int(std::ceil(12.5 * std::abs(std::sin(angle)))));
    int inside = 0, outside = 0;
    for (int z = 0; z < g.size.z; ++z)
        for (int y = 0; y < g.size.y; ++y) {
            const glm::dvec3 mm = g.voxel_to_mm({3, y, z});
            const double row = glm::dot(mm - glm::dvec3(0, 0, 2.5 * z), like.column);
            if (row >= 0 && row <= 19) {
                EXPECT_NEAR(v.value(3, y, z), body(mm) - 1024, 1.1) << y << " " << z;
                ++inside;
            } else if (row <= -0.6 || row >= 19.6) {
                EXPECT_LE(v.value(3, y, z), 500 - 1024 + 1) << "beside the slice stands air";
                ++outside;
            }
        }
    EXPECT_GT(inside, 100);
    EXPECT_GT(outside, 5);
}

INSTANTIATE_TEST_SUITE_P(Dicom, Tilt, testing::Values(17.0, -17.0, 30.0, -5.0));

TEST(DicomReader, TiltDoesNotSmearPadding) {
    const TemporaryFolder folder;
    ZooSlice like;
    like.size = {4, 12};
    like.bits_stored = 16;
    like.is_signed = true;
    like.padding = -2000;
    const double angle = 0.3;
    like.column = {0, std::cos(angle), std::sin(angle)};
    like.stored = [](int, int y) { return y < 3 ? -2000 : y < 6 ? 24 : 1064; };  // padding, air, tissue of 40
    for (int i = 0; i < 5; ++i) {
        like.position.z = i;
        write_zoo_slice(folder / std::to_string(i), like);
    }
    const Volume v = open_only(folder.path());
    for (int z = 0; z < v.geometry().size.z; ++z)
        for (int y = 0; y < v.geometry().size.y; ++y) {
            const double value = v.value(1, y, z);
            EXPECT_TRUE(value == -1000 || value == 40) << value << " at " << y << " " << z;
        }
}

TEST(DicomReader, ALocalizerInTheFolderIsSetAside) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 2, 3});
    ZooSlice scout;
    scout.image_type = "ORIGINAL\\PRIMARY\\LOCALIZER";
    scout.size = {9, 9};
    scout.row = {0, 1, 0};
    scout.column = {0, 0, -1};
    write_zoo_slice(folder / "scout_same_series", scout);
    scout.series_uid += ".7";
    write_zoo_slice(folder / "scout_own_series", scout);
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.geometry().size, glm::ivec3(6, 5, 4));
    EXPECT_TRUE(warned(v, "scout_same_series"));
    EXPECT_TRUE(warned(v, "scout_own_series"));
}

TEST(DicomReader, SeriesAreSplitByUidSizeAndOverlappingAcquisitions) {
    const TemporaryFolder folder;
    ZooSlice other;
    other.series_uid += ".2";
    other.series_number = 2;
    std::filesystem::create_directory(folder / "sub");
    write_stack(folder, {0, 1, 2});
    for (int i = 0; i < 3; ++i)
        for (int pass = 1; pass <= 2; ++pass) {
            other.acquisition = pass;
            other.position.z = i;
            other.stored = [pass](int, int) { return 100 * pass; };
            write_zoo_slice(folder / ("sub/" + std::to_string(i) + "-" + std::to_string(pass)), other);
        }
    const auto found = find_dicom_series(folder.path());
    ASSERT_EQ(found.size(), 3u);
    for (const SeriesEntry& entry : found) EXPECT_EQ(entry.size, glm::ivec3(6, 5, 3));
    EXPECT_EQ(found[0].number, 1);
    EXPECT_NE(found[1].uid, found[2].uid);
    EXPECT_EQ(read_dicom_series(found[1]).value(0, 0, 1), 100 - 1024);
    EXPECT_EQ(read_dicom_series(found[2]).value(0, 0, 1), 200 - 1024);
}

TEST(DicomReader, AcquisitionNumbersThatChangeFromSliceToSliceKeepOneSeries) {
    const TemporaryFolder folder;
    ZooSlice s;
    for (int i = 0; i < 5; ++i) {
        s.position.z = i;
        s.acquisition = i + 1;
        write_zoo_slice(folder / std::to_string(i), s);
    }
    EXPECT_EQ(open_only(folder.path()).geometry().size.z, 5);
}

TEST(DicomReader, OtherFilesInTheFolderAreIgnored) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1});
    write_file(folder / "readme.txt", "no image");
    write_file(folder / "eight", std::string("\x08\0\0\0", 4));
    write_file(folder / "empty", "");
    EXPECT_EQ(open_only(folder.path()).geometry().size.z, 2);
    EXPECT_FALSE(looks_like_dicom(folder / "readme.txt"));
    EXPECT_FALSE(looks_like_dicom(folder / "empty"));
}

TEST(DicomReader, ASingleSliceTakesItsThickness) {
    const TemporaryFolder folder;
    ZooSlice s;
    s.thickness = "3.5";
    write_zoo_slice(folder / "a", s);
    EXPECT_EQ(open_only(folder.path()).geometry().spacing.z, 3.5);
    s.thickness.clear();
    write_zoo_slice(folder / "a", s);
    const Volume v = open_only(folder.path());
    EXPECT_EQ(v.geometry().spacing.z, 1);
    EXPECT_TRUE(warned(v, "1 mm is assumed"));
}

struct FaultCase {
    const char* name;
    std::function<void(ZooSlice&)> spoil;
    std::uintmax_t cut;
    const char* says;
};

class Faults : public testing::TestWithParam<FaultCase> {};

TEST_P(Faults, OneSentenceNamesTheFileAndTheFault) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 2});
    ZooSlice s;
    s.position.z = 3;
    GetParam().spoil(s);
    write_zoo_slice(folder / "spoilt", s);
    if (GetParam().cut) test::cut_file(folder / "spoilt", GetParam().cut);
    const auto [code, text] = error_of([&] { open_only(folder.path()); });
    EXPECT_EQ(code, Errc::bad_input);
    EXPECT_NE(text.find("spoilt"), std::string::npos) << text;
    EXPECT_NE(text.find(GetParam().says), std::string::npos) << text;
    EXPECT_EQ(text.find("Zoo"), std::string::npos) << "a patient's name: " << text;
}

INSTANTIATE_TEST_SUITE_P(
    Dicom, Faults,
    testing::Values(
        FaultCase{"cut_short", [](ZooSlice&) {}, 7, "cut short"},
        FaultCase{"cut_short_compressed", [](ZooSlice& s) { s.syntax = ZooSyntax::rle; }, 30, "cut short"},
        FaultCase{"zero_spacing", [](ZooSlice& s) { s.pixel_spacing = "0\\0.5"; }, 0, "PixelSpacing (0028,0030)"},
        FaultCase{"negative_spacing", [](ZooSlice& s) { s.pixel_spacing = "-1\\-1"; }, 0, "PixelSpacing (0028,0030)"},
        FaultCase{"spacing_no_number", [](ZooSlice& s) { s.pixel_spacing = "nan\\1"; }, 0, "PixelSpacing (0028,0030)"},
        FaultCase{"zero_slope", [](ZooSlice& s) { s.slope = "0"; }, 0, "RescaleSlope (0028,1053)"},
        FaultCase{"axes_not_perpendicular",
                  [](ZooSlice& s) {
                      s.column = {0.01, 1, 0};
                  },
                  0, "ImageOrientationPatient"}),
    [](const auto& row) { return row.param.name; });

TEST(DicomReader, NothingToReadIsSaidClearly) {
    const TemporaryFolder folder;
    EXPECT_NE(error_of([&] { find_dicom_series(folder.path()); }).second.find("empty"), std::string::npos);
    write_file(folder / "notes.txt", "nothing here");
    const auto [code, text] = error_of([&] { find_dicom_series(folder.path()); });
    EXPECT_EQ(code, Errc::bad_input);
    EXPECT_NE(text.find("no DICOM images"), std::string::npos) << text;
    EXPECT_EQ(error_of([&] { find_dicom_series(folder / "absent"); }).first, Errc::bad_input);
    EXPECT_EQ(error_of([&] { find_dicom_series(folder / "notes.txt"); }).first, Errc::bad_input);
}

TEST(DicomReader, AStopInTheMiddleCancels) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 2, 3, 4, 5, 6, 7});
    std::stop_source stop;
    JobContext job{stop.get_token(), [&](double done) {
                       if (done > 0.3) stop.request_stop();
                   }};
    const auto found = find_dicom_series(folder.path());
    EXPECT_EQ(error_of([&] { read_dicom_series(found.front(), {}, job); }).first, Errc::cancelled);
    EXPECT_EQ(error_of([&] { find_dicom_series(folder.path(), job); }).first, Errc::cancelled);
}

TEST(DicomReader, ProgressNeverFallsAndEndsAtOne) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 3, 4});
    double last = 0;
    bool fell = false;
    const JobContext job{{}, [&](double done) {
                             fell = fell || done < last;
                             last = done;
                         }};
    read_dicom_series(find_dicom_series(folder.path()).front(), {}, job);
    EXPECT_FALSE(fell);
    EXPECT_EQ(last, 1);
}

TEST(DicomReader, APartsComponentIsNamedAPatientNever) {
    const TemporaryFolder folder;
    ZooSlice s;
    write_zoo_slice(folder / "patient", s);
    EXPECT_TRUE(open_only(folder.path()).dicom->component.empty());
    std::filesystem::remove(folder / "patient");
    s.extra = {{{0x0014, 0x0028}, "Foundry"}};  // ComponentManufacturer: a DICONDE file
    write_zoo_slice(folder / "part", s);
    const auto component = open_only(folder.path()).dicom->component;
    ASSERT_GE(component.size(), 3u);
    EXPECT_EQ(component[0], (std::pair<std::string, std::string>("name", "Zoo^Animal")));
    EXPECT_EQ(component[1].first, "id");
    EXPECT_EQ(component[2].second, "Foundry");
}

TEST(DicomReader, AnEntryWithoutItsScanIsReadAnew) {
    const TemporaryFolder folder;
    write_stack(folder, {0, 1, 2});
    SeriesEntry entry = find_dicom_series(folder.path()).front();
    entry.scan.reset();
    EXPECT_EQ(read_dicom_series(entry).geometry().size.z, 3);
}

}  // namespace
}  // namespace lacuna
