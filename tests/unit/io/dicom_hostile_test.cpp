#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/base/atomic_file.h"
#include "core/io/dicom_reader.h"
#include "core/io/volume_writer.h"
#include "tests/support/dicom_zoo.h"
#include "tests/support/test_data.h"
#include "volume_fixture.h"

// Files whose header and pixels contradict each other, and byte orders few writers use.
namespace lacuna {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::write_zoo_slice;
using test::ZooSlice;
using test::ZooSyntax;

constexpr unsigned k_rows = 0x10, k_columns = 0x11, k_pixel_representation = 0x103;

/// Overwrites a number of group 0028 of a little-endian file.
void claim(const fs::path& from, const fs::path& to, unsigned element, unsigned pixels) {
    std::string bytes = read_file(from);
    const std::string tag = {'\x28', '\0', char(element & 255), char(element >> 8), 'U', 'S', '\2', '\0'};
    const std::size_t at = bytes.find(tag);
    ASSERT_NE(at, std::string::npos);
    bytes[at + 8] = char(pixels & 255);
    bytes[at + 9] = char(pixels >> 8);
    write_file(to, bytes);
}

Volume read_one(const fs::path& file) { return read_dicom_series(find_dicom_series(file).front()); }

TEST(DicomHostile, CompressedPixelsOfAnotherSizeThanTheHeaderSaysAreRefused) {
    const TemporaryFolder folder;
    for (const ZooSyntax syntax : {ZooSyntax::rle, ZooSyntax::jpeg_lossless, ZooSyntax::jpeg_ls}) {
        SCOPED_TRACE(int(syntax));
        ZooSlice slice;
        slice.size = {24, 20};
        slice.syntax = syntax;
        write_zoo_slice(folder / "sound.dcm", slice);
        EXPECT_EQ(read_one(folder / "sound.dcm").value(23, 19, 0), 100 + 190 + 23 - 1024);
        for (const unsigned element : {k_rows, k_columns})
            for (const unsigned pixels : {12u, 36u}) {
                claim(folder / "sound.dcm", folder / "lie.dcm", element, pixels);
                test::expect_error(Errc::bad_input, {"lie.dcm", std::to_string(pixels)},
                                   [&] { read_one(folder / "lie.dcm"); });
            }
    }
}

// The decoder behind it writes what the code stream holds into memory of the size that the header claims.
TEST(DicomHostile, Jpeg2000OfAnotherSizeThanTheHeaderSaysIsRefused) {
    LACUNA_NEEDS_DATA(sound, "dicom_zoo/one_ct_image_in_many_syntaxes/ctimage_j2k_lossless.dcm");
    const TemporaryFolder folder;
    for (const unsigned element : {k_rows, k_columns})
        for (const unsigned pixels : {256u, 600u}) {
            claim(sound, folder / "lie.dcm", element, pixels);
            test::expect_error(Errc::bad_input, {"lie.dcm", "512 x 512", std::to_string(pixels)},
                               [&] { read_one(folder / "lie.dcm"); });
        }
    claim(sound, folder / "unsigned.dcm", k_pixel_representation, 0);
    test::expect_error(Errc::bad_input, {"unsigned.dcm", "signed numbers"}, [&] { read_one(folder / "unsigned.dcm"); });
}

TEST(DicomHostile, MorePixelsThanTheHeaderSaysAreWarnedOf) {
    const TemporaryFolder folder;
    write_zoo_slice(folder / "sound.dcm", {});
    EXPECT_TRUE(read_one(folder / "sound.dcm").warnings.empty());
    claim(folder / "sound.dcm", folder / "lie.dcm", k_columns, 3);
    const Volume volume = read_one(folder / "lie.dcm");
    ASSERT_EQ(volume.warnings.size(), 1u);
    EXPECT_NE(volume.warnings[0].text.find("more pixels than rows, columns and frames say"), std::string::npos);
}

// PS3.5 8.1.1: two pixels of 8 bits share a word, the first in its lower half, which big-endian files store second.
TEST(DicomHostile, BytesInBigEndianWordsAreReadInTheirOrder) {
    const TemporaryFolder folder;
    ZooSlice slice;
    slice.size = {5, 3};  // frames of an odd number of bytes
    slice.bits_allocated = slice.bits_stored = 8;
    slice.intercept = "0";
    slice.syntax = ZooSyntax::explicit_be;
    const auto stored = [](int frame, int x, int y) { return 100 * frame + 10 * y + x; };
    test::write_zoo_enhanced(folder / "bytes.dcm", slice, {{0, 0, 0}, {0, 0, 1}}, stored);
    std::string bytes = read_file(folder / "bytes.dcm");
    const std::string head = {'\x7F', '\xE0', '\0', '\x10', 'O', 'B'};
    const std::size_t at = bytes.find(head);
    ASSERT_NE(at, std::string::npos);
    bytes[at + 5] = 'W';
    for (std::size_t i = at + 12; i + 1 < at + 12 + 30; i += 2) std::swap(bytes[i], bytes[i + 1]);
    write_file(folder / "words.dcm", bytes);
    for (const char* name : {"bytes.dcm", "words.dcm"}) {
        const Volume volume = read_one(folder / name);
        for (int f = 0; f < 2; ++f)
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 5; ++x) EXPECT_EQ(volume.value(x, y, f), stored(f, x, y)) << name;
    }
}

// A terminal would obey control characters; Latin-1 is no UTF-8.
TEST(DicomHostile, DescriptionsAreTextThatCanBeShown) {
    const TemporaryFolder folder;
    ZooSlice slice;
    slice.description =
        "Sch\xE4"
        "del \x1B[31mrot\x07";
    slice.extra = {{{0x0008, 0x0005}, "ISO_IR 100"}};
    write_zoo_slice(folder / "a.dcm", slice);
    const Volume volume = read_one(folder / "a.dcm");
    EXPECT_EQ(volume.dicom->description,
              "Sch\xC3\xA4"
              "del [31mrot");
    EXPECT_EQ(volume.name, volume.dicom->description);
}

TEST(DicomHostile, PaddingIsNoValueOfATable) {
    const TemporaryFolder folder;
    ZooSlice slice;
    slice.modality_lut = std::vector<int>(60, 0);
    for (int i = 0; i < 60; ++i) slice.modality_lut[std::size_t(i)] = 1000 + 3 * i;
    slice.modality_lut_first = 100;
    slice.stored = [](int x, int y) { return x == 2 ? 159 : 101 + 5 * y + x; };
    write_zoo_slice(folder / "plain.dcm", slice);
    EXPECT_EQ(read_one(folder / "plain.dcm").value(2, 1, 0), 1177);
    slice.padding = 159;
    write_zoo_slice(folder / "padded.dcm", slice);
    const Volume volume = read_one(folder / "padded.dcm");
    EXPECT_EQ(volume.value(2, 1, 0), 1003);  // the smallest measured
    EXPECT_EQ(volume.value(3, 1, 0), 1027);
    ASSERT_EQ(volume.warnings.size(), 1u);
    EXPECT_NE(volume.warnings[0].text.find("5 voxels are padding"), std::string::npos);
}

TEST(DicomHostile, AVolumeWithoutUnitDoesNotComeBackInHounsfieldUnits) {
    const TemporaryFolder folder;
    Volume volume = test::extreme_volume<std::uint8_t>(test::oblique_grid({4, 3, 2}));
    for (const char* unit : {"", "HU"}) {
        volume.unit = unit;
        const fs::path target = folder / (std::string("out") + unit);
        write_volume(volume, target);
        EXPECT_EQ(open_volume(target.string()).unit, unit);
    }
}

}  // namespace
}  // namespace lacuna
