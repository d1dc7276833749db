#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <functional>

#include "core/base/atomic_file.h"
#include "core/io/dicom_reader.h"
#include "tests/support/dicom_zoo.h"
#include "volume_fixture.h"

// What a reader meets at the edges: folders it may not open, tables instead of a scale, spacing given by hand.
namespace lacuna {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::write_zoo_slice;
using test::ZooSlice;
using test::ZooSyntax;

/// Acts as a user who may not open everything; the superuser may.
class AsNobody {
public:
    AsNobody() : was_root_(::geteuid() == 0) {
        if (was_root_ && ::seteuid(65534) != 0) throw std::runtime_error("cannot become another user");
    }
    ~AsNobody() {
        if (was_root_ && ::seteuid(0) != 0) std::abort();
    }

private:
    bool was_root_;
};

/// A folder that may not be opened until the end of the scope.
class Locked {
public:
    explicit Locked(fs::path path) : path_(std::move(path)) { fs::permissions(path_, fs::perms::none); }
    ~Locked() { fs::permissions(path_, fs::perms::all); }

private:
    fs::path path_;
};

bool warned(const Volume& volume, const std::string& part) {
    for (const Warning& w : volume.warnings)
        if (w.text.find(part) != std::string::npos) return true;
    return false;
}

TEST(DicomLimits, AFolderThatMayNotBeOpenedIsNotCalledEmpty) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::all);
    fs::create_directory(folder / "hidden");
    write_zoo_slice(folder / "hidden" / "a", {});
    const Locked lock(folder / "hidden");
    const AsNobody user;
    test::expect_error(Errc::io, {"hidden", "permission denied"}, [&] { find_dicom_series(folder / "hidden"); });
    test::expect_error(Errc::io, {"hidden", "permission denied"}, [&] { find_dicom_series(folder.path()); });
}

TEST(DicomLimits, WhatMayNotBeOpenedBesideASeriesIsNamed) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::all);
    fs::create_directory(folder / "hidden");
    write_zoo_slice(folder / "a", {});
    ZooSlice second;
    second.position.z = 1;
    write_zoo_slice(folder / "b", second);
    fs::permissions(folder / "a", fs::perms::all);
    const Locked lock(folder / "hidden"), file(folder / "b");
    const AsNobody user;
    const auto found = find_dicom_series(folder.path());
    ASSERT_EQ(found.size(), 1u);
    const Volume v = read_dicom_series(found.front());
    EXPECT_EQ(v.geometry().size.z, 1);
    EXPECT_TRUE(warned(v, "2 files or folders may not be opened")) << v.warnings.back().text;
    EXPECT_TRUE(warned(v, "hidden"));
}

ZooSlice with_table(bool is_signed) {
    ZooSlice slice;
    slice.slope.clear();
    slice.bits_stored = 16;
    slice.is_signed = is_signed;
    slice.modality_lut_first = is_signed ? -2 : 3;
    slice.modality_lut = {1000, 500, 40000, 7};
    slice.stored = [first = slice.modality_lut_first](int x, int y) { return first - 1 + x + (y == 4 ? 500 : 0); };
    return slice;
}

class ModalityTables : public testing::TestWithParam<std::tuple<bool, ZooSyntax>> {};

TEST_P(ModalityTables, TurnStoredIntoRealValues) {
    const auto [is_signed, syntax] = GetParam();
    const TemporaryFolder folder;
    ZooSlice slice = with_table(is_signed);
    slice.syntax = syntax;
    write_zoo_slice(folder / "a", slice);
    const Volume v = read_dicom_series(find_dicom_series(folder.path()).front());
    EXPECT_EQ(v.type(), VoxelType::u16);
    const double expected[] = {1000, 1000, 500, 40000, 7, 7};  // the ends go on
    for (int x = 0; x < 6; ++x) {
        EXPECT_EQ(v.value(x, 0, 0), expected[x]) << x;
        EXPECT_EQ(v.value(x, 4, 0), 7) << x;
    }
    EXPECT_EQ(v.unit, "OD");
}

INSTANTIATE_TEST_SUITE_P(Dicom, ModalityTables,
                         testing::Combine(testing::Bool(), testing::Values(ZooSyntax::explicit_le,
                                                                           ZooSyntax::explicit_be, ZooSyntax::rle)));

TEST(DicomLimits, AModalityTableThatIsCutIsRefused) {
    const TemporaryFolder folder;
    ZooSlice slice = with_table(false);
    slice.modality_lut_claims = 9;
    write_zoo_slice(folder / "a", slice);
    const auto found = find_dicom_series(folder.path());
    test::expect_error(Errc::bad_input, {"LUTData", "4 of 9"}, [&] { read_dicom_series(found.front()); });
}

TEST(DicomLimits, ASlipInWhatIsOnlyShownHidesNoImage) {
    const TemporaryFolder folder;
    ZooSlice slice;
    slice.extra = {{{0x0028, 0x1050}, "40\\"}, {{0x0028, 0x1051}, "400\\"}, {{0x0020, 0x0011}, "1.5"}};
    write_zoo_slice(folder / "a", slice);
    const Volume v = open_volume((folder / "a").string());
    EXPECT_EQ(v.dicom->window_center, 40);
    EXPECT_EQ(v.dicom->window_width, 400);
    EXPECT_EQ(v.value(0, 0, 0), 100 - 1024);
    slice.extra = {{{0x0028, 0x1050}, "40,5"}, {{0x0028, 0x1051}, "400"}, {{0x0020, 0x0013}, "7a"}};
    write_zoo_slice(folder / "b", slice);
    const Volume none = open_volume((folder / "b").string());
    EXPECT_FALSE(none.dicom->window_center);
    EXPECT_EQ(none.value(0, 0, 0), 100 - 1024);
}

/// A file whose header is made by hand.
void write_header(const std::filesystem::path& file, const std::function<void(DcmDataset&)>& fill) {
    DcmFileFormat format;
    DcmDataset& set = *format.getDataset();
    set.putAndInsertString(DCM_SOPClassUID, UID_CTImageStorage);
    set.putAndInsertString(DCM_SOPInstanceUID, "1.2.3");
    set.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
    set.putAndInsertUint16(DCM_SamplesPerPixel, 1);
    fill(set);
    ASSERT_TRUE(format.saveFile(file.c_str(), EXS_LittleEndianExplicit).good());
}

TEST(DicomLimits, FloatingPointPixelsOfAnotherWidthAreRefused) {
    const TemporaryFolder folder;
    write_header(folder / "a", [](DcmDataset& set) {
        const std::vector<Float32> pixels(4, 1.0f);
        set.putAndInsertUint16(DCM_Rows, 4);
        set.putAndInsertUint16(DCM_Columns, 4);
        set.putAndInsertUint16(DCM_BitsAllocated, 8);  // of which 16 bytes were enough
        set.putAndInsertFloat32Array(DCM_FloatPixelData, pixels.data(), 4);
    });
    test::expect_error(Errc::bad_input, {"BitsAllocated", "32"}, [&] { open_volume((folder / "a").string()); });
}

TEST(DicomLimits, AClaimBeyondAnyFileIsRefused) {
    const TemporaryFolder folder;
    write_header(folder / "a", [](DcmDataset& set) {
        const Uint16 pixel = 0;
        set.putAndInsertUint16(DCM_Rows, 32768);
        set.putAndInsertUint16(DCM_Columns, 32768);
        set.putAndInsertUint16(DCM_BitsAllocated, 16);
        set.putAndInsertString(DCM_NumberOfFrames, "1073741824");  // 2^64 bits in all: 0, were they counted in 64
        set.putAndInsertUint16Array(DCM_PixelData, &pixel, 1);
    });
    test::expect_error(Errc::bad_input, {"more pixels"}, [&] { open_volume((folder / "a").string()); });
}

TEST(DicomLimits, SpacingGivenByHandIsUsedAndSaid) {
    const TemporaryFolder folder;
    write_zoo_slice(folder / "a", {});
    OpenOptions options;
    options.spacing_mm = glm::dvec3(0.25, 0.25, 3);
    const Volume v = open_volume(folder.path().string(), options);
    EXPECT_EQ(v.geometry().spacing, glm::dvec3(0.25, 0.25, 3));
    EXPECT_TRUE(v.dicom.has_value());
    EXPECT_EQ(v.unit, "HU");
    EXPECT_TRUE(warned(v, "given by hand"));
    EXPECT_TRUE(warned(v, "0.5 x 0.5 x 1 mm"));
}

TEST(OpenVolume, ASampleTakesNoOtherGrid) {
    OpenOptions options;
    options.spacing_mm = glm::dvec3(1, 1, 5);
    test::expect_error(Errc::bad_usage, {"--spacing"}, [&] { open_volume("sample:spheres@16", options); });
    options = {};
    options.raw = "3x3x3:u8";
    test::expect_error(Errc::bad_usage, {"--raw"}, [&] { open_volume("sample:spheres@16", options); });
}

TEST(OpenVolume, SaysWhatAFolderHoldsInstead) {
    const TemporaryFolder folder;
    write_file(folder / "part_2x2x2_uint8.raw", "12345678");
    test::expect_error(Errc::bad_input, {"part_2x2x2_uint8.raw", "name the file"},
                       [&] { open_volume(folder.path().string()); });
    write_file(folder / "nothing.dcm", "");
    test::expect_error(Errc::bad_input, {"nothing.dcm", "is empty"},
                       [&] { open_volume((folder / "nothing.dcm").string()); });
    write_file(folder / "packed.gz", "\x1f\x8b and more");
    test::expect_error(Errc::unsupported, {"packed.gz", "unpack"},
                       [&] { open_volume((folder / "packed.gz").string()); });
}

}  // namespace
}  // namespace lacuna
