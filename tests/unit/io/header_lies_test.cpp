#include <zlib.h>

#include <cstring>
#include <limits>

#include "core/io/volume_writer.h"
#include "nifti_fixture.h"

// Headers of MetaImage, NRRD and NIfTI that contradict their data or themselves, or say something in a way that the
// image library passes over: what is opened has every voxel right, and where it should be, or is not opened.
using namespace lacuna;
using namespace lacuna::test;

namespace {

/// A thousand bytes that differ, and what they are packed.
std::string thousand() {
    std::string bytes;
    for (int i = 0; i < 1000; ++i) bytes += char((i * i * 7 + i) >> 3);
    return bytes;
}

std::string packed(const std::string& bytes) {
    std::string out(compressBound(uLong(bytes.size())), '\0');
    uLongf size = uLongf(out.size());
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
             uLong(bytes.size()));
    return out.substr(0, size);
}

std::string meta(const std::string& more, const std::string& data, const std::string& size = "10 10 10",
                 const std::string& spacing = "ElementSpacing = 1 1 1\n") {
    return "ObjectType = Image\nNDims = 3\n" + spacing + more + "DimSize = " + size +
           "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + data;
}

std::string nrrd(const std::string& more, const std::string& data = thousand()) {
    return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 10 10 10\n" + more + "\n" + data;
}

void expect_bytes(const Volume& volume, const std::string& bytes) {
    ASSERT_EQ(volume.bytes(), bytes.size());
    EXPECT_EQ(std::memcmp(volume.data(), bytes.data(), bytes.size()), 0);
}

/// 2x2x2 voxels.
nifti_1_header nifti(short datatype, short bits) {
    nifti_1_header h = nifti_header(datatype, bits, 2, 2, 2);
    h.qform_code = 1;
    return h;
}

}  // namespace

TEST(HeaderLies, TheLengthOfPackedMetaImageVoxelsIsWhatTheyUnpackTo) {
    const ScratchFolder f;
    const std::string bytes = thousand(), stream = packed(bytes);
    for (const char* size : {"", "CompressedDataSize = 100\n", "CompressedDataSize = 50000000000\n",
                             "CompressedDataSize = 1000000000000000000\n", "CompressedDataSize = -5\n"})
        expect_bytes(open_text(f, "v.mha", meta("CompressedData = True\n" + std::string(size), stream)), bytes);
}

TEST(HeaderLies, PackedVoxelsOfTheWrongLengthAreRefused) {
    const ScratchFolder f;
    for (const char* size : {"10 10 9", "10 10 11"})
        expect_error(Errc::bad_input, {"v.mha", "unpack to"},
                     [&] { open_text(f, "v.mha", meta("CompressedData = True\n", packed(thousand()), size)); });
}

TEST(HeaderLies, AMetaImageHeaderSizeCountsFromTheFilesFirstByte) {
    const ScratchFolder f;
    const std::string head = meta("HeaderSize = 200\n", ""), bytes = thousand();
    const auto both = [&](const std::string& text) {
        const Volume whole = open_text(f, "v.mha", text);
        const auto parts = open_volume_in_parts((f / "v.mha").string());
        ASSERT_TRUE(parts);
        std::string read(1000, '\0');
        read_box(*parts, {{0, 0, 0}, {10, 10, 10}}, reinterpret_cast<std::byte*>(read.data()));
        expect_bytes(whole, bytes);
        EXPECT_EQ(read, bytes);
    };
    both(head + std::string(200 - head.size(), 'x') + bytes);
    both(meta("HeaderSize = -1\n", "xyz" + bytes));
    expect_error(Errc::bad_input, {"v.mha", "HeaderSize 20"},
                 [&] { open_text(f, "v.mha", meta("HeaderSize = 20\n", std::string(20, 'x') + bytes)); });
    expect_error(Errc::bad_input, {"v.mha"},
                 [&] { open_text(f, "v.mha", meta("HeaderSize = -1\n", bytes.substr(1))); });
}

TEST(HeaderLies, NumbersMissingInATextAreNotZeros) {
    const ScratchFolder f;
    EXPECT_EQ(open_text(f, "v.mha", meta("BinaryData = False\n", "1 2 3 4 5 6 7 8", "2 2 2")).value(1, 1, 1), 8);
    expect_error(Errc::bad_input, {"v.mha", "4 numbers"},
                 [&] { open_text(f, "v.mha", meta("BinaryData = False\n", "1 2 3 4 ", "2 2 2")); });
}

TEST(HeaderLies, ContradictionsAreRefused) {
    const ScratchFolder f;
    expect_error(Errc::bad_input, {"v.mha", "contradict"}, [&] {
        open_text(f, "v.mha", meta("BinaryDataByteOrderMSB = True\nElementByteOrderMSB = False\n", thousand()));
    });
    expect_error(Errc::bad_input, {"v.nii", "bitpix"},
                 [&] { open_text(f, "v.nii", nifti_file(nifti(DT_INT32, 8), "abcdefgh")); });
    nifti_1_header early = nifti(DT_UINT8, 8);
    early.vox_offset = 348;
    expect_error(Errc::bad_input, {"v.nii", "vox_offset"},
                 [&] { open_text(f, "v.nii", nifti_file(early, "abcdefgh")); });
}

// MetaIO would say so on the terminal, in four lines.
TEST(HeaderLies, NumbersThatAreNoneAreRefusedInOneLine) {
    const ScratchFolder f;
    testing::internal::CaptureStderr();
    for (const char* line : {"ElementSpacing = 1 1 i\n", "Offset = 1 2\n", "TransformMatrix = 1 0 0 0 1 0 0 0\n"})
        expect_error(Errc::bad_input, {"v.mha", "numbers"},
                     [&] { open_text(f, "v.mha", meta(line, thousand(), "10 10 10", "")); });
    expect_error(Errc::bad_input, {"v.nrrd", "spacings"},
                 [&] { open_text(f, "v.nrrd", nrrd("spacings: 1 one 1\nencoding: raw\n")); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(HeaderLies, AnUnstatedNiftiOffsetIsTheSmallestThereMayBe) {
    const ScratchFolder f;
    nifti_1_header h = nifti(DT_UINT8, 8);
    h.vox_offset = 0;
    expect_bytes(open_text(f, "v.nii", nifti_file(h, "abcdefgh")), "abcdefgh");
}

// nifti1.h: "if the scl_slope field is nonzero, then each voxel value should be scaled".
TEST(HeaderLies, ASlopeOfZeroSwitchesTheInterceptOffToo) {
    const ScratchFolder f;
    nifti_1_header h = nifti(DT_UINT8, 8);
    h.scl_slope = 0, h.scl_inter = -1000;
    expect_bytes(open_text(f, "v.nii", nifti_file(h, "abcdefgh")), "abcdefgh");
}

TEST(HeaderLies, WideIntegersAreRescaledBeforeTheyAreRounded) {
    const ScratchFolder f;
    nifti_1_header h = nifti(DT_INT32, 32);
    h.scl_slope = 1, h.scl_inter = -16777216;
    std::string data;
    for (std::int32_t i = 0; i < 8; ++i) {
        const std::int32_t stored = 16777216 + i;
        data.append(reinterpret_cast<const char*>(&stored), sizeof stored);
    }
    const Volume v = open_text(f, "v.nii", nifti_file(h, data));
    EXPECT_EQ(v.type(), VoxelType::u8);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(v.value(i % 2, i / 2 % 2, i / 4), i);
}

TEST(HeaderLies, ANiftiFileWithoutOrientationIsWarnedOf) {
    const ScratchFolder f;
    nifti_1_header h = nifti(DT_UINT8, 8);
    EXPECT_FALSE(has_warning(open_text(f, "v.nii", nifti_file(h, "abcdefgh")), "orientation"));
    h.qform_code = 0;
    EXPECT_TRUE(has_warning(open_text(f, "v.nii", nifti_file(h, "abcdefgh")), "orientation"));
}

TEST(HeaderLies, LengthsAreTakenInTheUnitTheHeaderNames) {
    const ScratchFolder f;
    const auto expect_place = [](const Volume& v, double step, double at) {
        EXPECT_NEAR(v.geometry().spacing.x, step, 1e-12);
        EXPECT_NEAR(v.geometry().spacing.z, step, 1e-12);
        EXPECT_NEAR(v.geometry().origin.y, at, 1e-12);
    };
    const std::string place = "ElementSpacing = 5 5 5\nOffset = 100 200 300\n";
    expect_place(open_text(f, "v.mha", meta("DistanceUnits = um\n", thousand(), "10 10 10", place)), 0.005, 0.2);
    expect_place(open_text(f, "v.mha", meta("DistanceUnits = cm\n", thousand(), "10 10 10", place)), 50, 2000);
    expect_place(open_text(f, "v.mha", meta("DistanceUnits = mm\n", thousand(), "10 10 10", place)), 5, 200);
    EXPECT_TRUE(has_warning(open_text(f, "v.mha", meta("DistanceUnits = rods\n", thousand())), "'rods'"));
    const std::string space =
        "space: left-posterior-superior\nspace directions: (5,0,0) (0,5,0) (0,0,5)\nspace origin: (100,200,300)\n"
        "encoding: raw\n";
    expect_place(open_text(f, "v.nrrd", nrrd(space + "space units: \"um\" \"um\" \"um\"\n")), 0.005, 0.2);
    expect_place(open_text(f, "v.nrrd", nrrd(space + "space units: \"mm\" \"mm\" \"mm\"\n")), 5, 200);
    expect_error(Errc::bad_input, {"v.nrrd", "units"},
                 [&] { open_text(f, "v.nrrd", nrrd(space + "space units: \"um\" \"mm\" \"mm\"\n")); });
    const Volume axes = open_text(f, "v.nrrd", nrrd("spacings: 5 5 5\nunits: \"um\" \"mm\" \"cm\"\nencoding: raw\n"));
    EXPECT_NEAR(glm::length(axes.geometry().spacing - glm::dvec3(0.005, 5, 50)), 0, 1e-12);
}

TEST(HeaderLies, NrrdEndsOfAxesGiveSpacingAndOrigin) {
    const ScratchFolder f;
    const std::string ends = "axis mins: 10 0 0\naxis maxs: 30 9 20\nencoding: raw\n";
    const Volume v = open_text(f, "v.nrrd", nrrd("centerings: cell node cell\n" + ends));
    EXPECT_NEAR(glm::length(v.geometry().spacing - glm::dvec3(2, 1, 2)), 0, 1e-12);
    EXPECT_NEAR(glm::length(v.geometry().origin - glm::dvec3(11, 0, 1)), 0, 1e-12);
    expect_error(Errc::bad_input, {"v.nrrd", "axis mins"},
                 [&] { open_text(f, "v.nrrd", nrrd("axis mins: 0 0 9\naxis maxs: 9 9 0\nencoding: raw\n")); });
}

TEST(HeaderLies, WhatIsAssumedOrLeftOutIsSaid) {
    const ScratchFolder f;
    EXPECT_TRUE(has_warning(open_text(f, "v.nrrd", nrrd("encoding: raw\n")), "spacing is not stated"));
    EXPECT_FALSE(has_warning(open_text(f, "v.nrrd", nrrd("spacings: 1 1 1\nencoding: raw\n")), "spacing"));
    EXPECT_TRUE(has_warning(open_text(f, "v.mha", meta("", thousand(), "10 10 10", "")), "spacing is not stated"));
    EXPECT_FALSE(has_warning(open_text(f, "v.mha", meta("", thousand())), "spacing"));
    EXPECT_TRUE(has_warning(open_text(f, "v.mha", meta("ElementToIntensityFunctionSlope = 2\n", thousand())), "scale"));
}

TEST(HeaderLies, SkippedLinesAndBytesOfAnNrrdAreSkipped) {
    const ScratchFolder f;
    const std::string bytes = thousand();
    expect_bytes(open_text(f, "v.nrrd", nrrd("encoding: raw\nline skip: 2\nbyte skip: 3\n", "one\ntwo\nabc" + bytes)),
                 bytes);
    expect_bytes(open_text(f, "v.nrrd", nrrd("encoding: raw\nbyte skip: -1\n", "rubbish" + bytes)), bytes);
    expect_bytes(open_text(f, "v.nrrd", nrrd("encoding: gzip\nbyte skip: 7\n", packed("rubbish" + bytes))), bytes);
    expect_error(Errc::bad_input, {"v.nrrd"},
                 [&] { open_text(f, "v.nrrd", nrrd("encoding: raw\nbyte skip: -1\n", bytes.substr(1))); });
    expect_error(Errc::bad_input, {"v.nrrd", "lines"},
                 [&] { open_text(f, "v.nrrd", nrrd("encoding: raw\nline skip: 2000\n", bytes)); });
}

TEST(HeaderLies, NamesWithAPerCentSignAreNames) {
    const ScratchFolder f;
    const Volume original = extreme_volume<std::uint8_t>(oblique_grid({3, 4, 5}));
    for (const char* name : {"50%d.mhd", "LIST.mhd", "LOCAL.mhd", "a b=c.mhd"}) {
        write_volume(original, f / name);
        expect_same_voxels(original, open_volume((f / name).string()));
    }
}

/// A header of 2 x 2 x 3 bytes beside files a, s1 .. s3 of four bytes and one that is cut.
struct Slices {
    ScratchFolder f;
    std::string bytes = "abcdefghijkl";

    Slices() {
        for (int k = 0; k < 3; ++k)
            put_file(f / ("s" + std::to_string(k + 1) + ".raw"), bytes.substr(4 * std::size_t(k), 4));
        for (int k = 0; k < 3; ++k)
            put_file(f / ("p00" + std::to_string(2 * k) + ".raw"), "head" + bytes.substr(4 * std::size_t(k), 4));
        put_file(f / "cut.raw", "ab");
    }
    Volume meta(const std::string& data, const std::string& fields = "") const {
        put_file(f / "v.mhd", "ObjectType = Image\nNDims = 3\nDimSize = 2 2 3\nElementSpacing = 1 1 1\n" + fields +
                                  "ElementType = MET_UCHAR\nElementDataFile = " + data + "\n");
        return open_volume((f / "v.mhd").string());
    }
    Volume nrrd(const std::string& data) const {
        put_file(f / "v.nhdr",
                 "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 3\nspacings: 1 1 1\nencoding: raw\n"
                 "data file: " +
                     data + "\n");
        return open_volume((f / "v.nhdr").string());
    }
};

TEST(HeaderLies, VoxelsInSeveralFilesAreReadWhole) {
    const Slices slices;
    expect_bytes(slices.meta("s%d.raw"), slices.bytes);
    expect_bytes(slices.meta("s%d.raw 1 3"), slices.bytes);
    expect_bytes(slices.meta("s%01d.raw 1 3 1"), slices.bytes);
    expect_bytes(slices.meta("p%03d.raw 0 4 2", "HeaderSize = 4\n"), slices.bytes);
    expect_bytes(slices.meta("p%03d.raw 0 4 2", "HeaderSize = -1\n"), slices.bytes);
    expect_bytes(slices.meta("LIST\ns1.raw\ns2.raw\n\ns3.raw"), slices.bytes);
    expect_bytes(slices.meta("LIST 2\ns1.raw\ns2.raw\ns3.raw"), slices.bytes);
    put_file(slices.f / "whole.raw", slices.bytes);
    expect_bytes(slices.meta("LIST 3\nwhole.raw"), slices.bytes);
    expect_bytes(slices.nrrd("s%d.raw 1 3 1"), slices.bytes);
}

TEST(HeaderLies, FilesThatAreMissingOrCutAreNoZeros) {
    const Slices slices;
    for (const char* data : {"gone%d.raw", "s%d.raw 2 4 1", "s%02d.raw 1 3 1", "LIST\ns1.raw\ngone.raw\ns3.raw",
                             "LIST\ns1.raw\ncut.raw\ns3.raw", "LIST\ns1.raw\ns2.raw", "LIST 1\ns1.raw\ns2.raw\ns3.raw",
                             "s%d.raw 1 2 1", "s%d.raw 1 4 1"})
        expect_error(Errc::bad_input, {}, [&] { slices.meta(data); });
}

TEST(HeaderLies, APatternOfNamesIsNoProgram) {
    const Slices slices;
    for (const char* data : {"s%d%n.raw 1 3 1", "s%s%s%s%s%n.raw 1 3 1", "s%d%s%s%s%s.raw 1 3 1",
                             "s%1000000000d.raw 1 3 1", "s%*d.raw 1 3 1", "s%p.raw 1 3 1"}) {
        expect_error(Errc::bad_input, {"v.mhd", "pattern"}, [&] { slices.meta(data); });
        expect_error(Errc::bad_input, {"v.nhdr", "pattern"}, [&] { slices.nrrd(data); });
    }
    for (const char* data :
         {"s%d.raw 1 3 0", "s%d.raw 1 3 -1", "s%d.raw 3 1 1", "s%d.raw 0 1000000000 1", "s%d.raw 1 x 1"})
        expect_error(Errc::bad_input, {"v.mhd"}, [&] { slices.meta(data); });
}

TEST(HeaderLies, AnOrientationThatIsNoNumberIsRefused) {
    const ScratchFolder f;
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    const auto open = [&](const nifti_1_header& h) { return open_text(f, "v.nii", nifti_file(h, "abcdefgh")); };
    const nifti_1_header sound = nifti(DT_UINT8, 8);
    expect_bytes(open(sound), "abcdefgh");
    for (const float bad : {nan, infinite, -infinite}) {
        for (float nifti_1_header::*number : {&nifti_1_header::quatern_c, &nifti_1_header::qoffset_y}) {
            nifti_1_header h = sound;
            h.*number = bad;
            expect_error(Errc::bad_input, {"v.nii", "qform"}, [&] { open(h); });
        }
        nifti_1_header h = sound;
        h.sform_code = 1;
        h.srow_x[0] = h.srow_y[1] = h.srow_z[2] = 2;  // mm, as pixdim
        expect_bytes(open(h), "abcdefgh");
        h.srow_z[3] = bad;
        expect_error(Errc::bad_input, {"v.nii", "sform"}, [&] { open(h); });
    }
}

TEST(HeaderLies, UnpackingStopsWhenAsked) {
    const ScratchFolder f;
    const std::string zeros(std::size_t(8) << 20, '\0');
    put_file(f / "v.mha", meta("CompressedData = True\n", packed(zeros), "2048 2048 2"));
    std::stop_source stop;
    const JobContext job{stop.get_token(), [&](double done) {
                             if (done > 0.1) stop.request_stop();
                         }};
    expect_error(Errc::cancelled, {}, [&] { open_volume((f / "v.mha").string(), {}, job); });
}
