#include "core/io/itk_reader.h"

#include <zlib.h>

#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

#include "core/io/volume_writer.h"
#include "nifti_fixture.h"
#include "tests/support/test_data.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

template <class T>
std::string bytes_of(std::initializer_list<T> values) {
    return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(T)};
}

std::string mha(const std::string& type, const std::string& size, const std::string& data,
                const std::string& more = "") {
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + more +
           "DimSize = " + size + "\nElementType = " + type + "\nElementDataFile = LOCAL\n" + data;
}

/// Voxels of 2 mm, the first at (10, 20, 30).
nifti_1_header placed_header(short datatype, short bits, short x, short y, short z) {
    nifti_1_header h = nifti_header(datatype, bits, x, y, z);
    h.sform_code = 1;
    h.srow_x[0] = h.srow_y[1] = h.srow_z[2] = 2;
    h.srow_x[3] = 10, h.srow_y[3] = 20, h.srow_z[3] = 30;
    return h;
}

}  // namespace

TEST(ItkReader, BrokenFilesAreReadBySeveralThreadsAtOnce) {
    const ScratchFolder f;
    const std::string words = "NRRD0004\ntype: float\ndimension: 3\nsizes: 4 4 4\nencoding: raw\nendian: little\n";
    const auto file = f / "broken.nrrd";
    put_file(file, words + "kinds: these are none\n\n" + std::string(256, '\0'));
    std::atomic<int> refused{0};
    constexpr int k_threads = 4, k_times = 200;
    std::vector<std::jthread> readers;
    for (int t = 0; t < k_threads; ++t)
        readers.emplace_back([&] {
            for (int i = 0; i < k_times; ++i) try {
                    (void)read_itk_volume(file, ItkFormat::nrrd);
                } catch (const Error& error) {
                    refused += std::string(error.what()).find("\"these\" kind 1 of 3") != std::string::npos;
                }
        });
    readers.clear();
    EXPECT_EQ(refused, k_threads * k_times);
}

TEST(ItkReader, WideTypesBecomeTheSmallestThatHoldsEveryValue) {
    const ScratchFolder f;
    const auto type_of = [&](const std::string& met, const std::string& data) {
        return open_text(f, "v.mha", mha(met, "2 1 1", data)).type();
    };
    EXPECT_EQ(type_of("MET_INT", bytes_of<std::int32_t>({-1207, 3382})), VoxelType::i16);
    EXPECT_EQ(type_of("MET_INT", bytes_of<std::int32_t>({0, 255})), VoxelType::u8);
    EXPECT_EQ(type_of("MET_INT", bytes_of<std::int32_t>({-1, 127})), VoxelType::i8);
    EXPECT_EQ(type_of("MET_UINT", bytes_of<std::uint32_t>({0, 65535})), VoxelType::u16);
    EXPECT_EQ(type_of("MET_INT", bytes_of<std::int32_t>({-1, 32768})), VoxelType::f32);
    EXPECT_EQ(type_of("MET_LONG_LONG", bytes_of<std::int64_t>({-5, 300})), VoxelType::i16);
    EXPECT_EQ(type_of("MET_DOUBLE", bytes_of<double>({1, 2})), VoxelType::f32);
    EXPECT_EQ(type_of("MET_FLOAT", bytes_of<float>({1, 2})), VoxelType::f32) << "a type we have is not shrunk";
    EXPECT_EQ(type_of("MET_SHORT", bytes_of<std::int16_t>({1, 2})), VoxelType::i16) << "a type we have is not shrunk";
}

TEST(ItkReader, ValuesSurviveTheChangeOfTypeOrAWarningSaysNot) {
    const ScratchFolder f;
    const Volume exact = open_text(f, "v.mha", mha("MET_INT", "2 1 1", bytes_of<std::int32_t>({-16777216, 16777216})));
    EXPECT_EQ(exact.value(0, 0, 0), -16777216);
    EXPECT_FALSE(has_warning(exact, "rounded"));
    const Volume rounded = open_text(f, "v.mha", mha("MET_INT", "2 1 1", bytes_of<std::int32_t>({0, 16777217})));
    EXPECT_TRUE(has_warning(rounded, "rounded"));
    const Volume real = open_text(f, "v.mha", mha("MET_DOUBLE", "3 1 1", bytes_of<double>({0.5, NAN, -1e3})));
    EXPECT_EQ(real.value(2, 0, 0), -1e3);
    EXPECT_TRUE(has_warning(real, "1 voxels are not a finite"));
}

TEST(ItkReader, SpacingThatIsNotPositiveIsRefusedByName) {
    const ScratchFolder f;
    for (const char* s : {"1 0 1", "1 -1 1", "1 1 nan", "inf 1 1"}) {
        expect_error(Errc::bad_input, {"v.mha", "ElementSpacing"}, [&] {
            open_text(f, "v.mha", mha("MET_UCHAR", "2 1 1", "ab", "ElementSpacing = " + std::string(s) + "\n"));
        });
        expect_error(Errc::bad_input, {"v.nrrd", "spacings"}, [&] {
            open_text(f, "v.nrrd",
                      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 1 1\nspacings: " + std::string(s) +
                          "\nencoding: raw\n\nab");
        });
    }
    for (const float s : {0.0f, -2.0f, NAN}) {
        nifti_1_header h = placed_header(DT_UINT8, 8, 2, 1, 1);
        h.pixdim[2] = s;
        expect_error(Errc::bad_input, {"v.nii", "pixdim[2]"}, [&] { open_text(f, "v.nii", nifti_file(h, "ab")); });
    }
    expect_error(Errc::bad_input, {"v.nrrd"}, [&] {
        open_text(f, "v.nrrd",
                  "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 1 1\nspace: left-posterior-superior\n"
                  "space directions: (1,0,0) (0,0,0) (0,0,1)\nencoding: raw\n\nab");
    });
}

TEST(ItkReader, SkewedAxesAreRepairedUpToAThousandthAndRefusedBeyond) {
    const ScratchFolder f;
    const auto with = [&](double skew) {
        return open_text(
            f, "v.mha",
            mha("MET_UCHAR", "2 2 2", "abcdefgh", "TransformMatrix = 1 0 0 " + std::to_string(skew) + " 1 0 0 0 1\n"));
    };
    EXPECT_FALSE(has_warning(with(0), "right angles"));
    const Volume repaired = with(0.0005);
    ASSERT_TRUE(has_warning(repaired, "right angles"));
    EXPECT_GT(repaired.warnings.back().max_error_mm, 0.0002);
    EXPECT_LT(repaired.warnings.back().max_error_mm, 0.0006);
    EXPECT_STREQ(fault_of(repaired.geometry()), "");
    expect_error(Errc::bad_input, {"right angles"}, [&] { with(0.01); });
    expect_error(Errc::bad_input, {}, [&] {
        open_text(f, "v.mha", mha("MET_UCHAR", "2 1 1", "ab", "TransformMatrix = 0 0 0 0 0 0 0 0 0\n"));
    });
}

TEST(ItkReader, VectorsColoursAndTimeSeriesAreRefused) {
    const ScratchFolder f;
    expect_error(Errc::unsupported, {"3 values a voxel"},
                 [&] { open_text(f, "v.mha", mha("MET_UCHAR", "2 1 1", "aabbcc", "ElementNumberOfChannels = 3\n")); });
    expect_error(Errc::unsupported, {"v.nrrd"}, [&] {
        open_text(f, "v.nrrd",
                  "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 3 2 1 1\nkinds: RGB-color domain domain domain\n"
                  "encoding: raw\n\nabcdef");
    });
    expect_error(Errc::unsupported, {"v.nii"},
                 [&] { open_text(f, "v.nii", nifti_file(placed_header(DT_RGB24, 24, 2, 1, 1), "aabbcc")); });
    nifti_1_header time = placed_header(DT_UINT8, 8, 2, 1, 1);
    time.dim[0] = 4, time.dim[4] = 3, time.pixdim[4] = 1;
    expect_error(Errc::unsupported, {"3 volumes"}, [&] { open_text(f, "v.nii", nifti_file(time, "aabbcc")); });
}

TEST(ItkReader, APlaneIsAVolumeOfOneSlice) {
    const ScratchFolder f;
    const Volume v =
        open_text(f, "v.mha",
                  "ObjectType = Image\nNDims = 2\nBinaryData = True\nElementSpacing = 0.5 2\nDimSize = 2 3\n"
                  "ElementType = MET_UCHAR\nElementDataFile = LOCAL\nabcdef");
    EXPECT_EQ(v.geometry().size, glm::ivec3(2, 3, 1));
    EXPECT_EQ(v.geometry().spacing, glm::dvec3(0.5, 2, 1));
    const Volume n = open_text(f, "v.nrrd", "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 2 3\nencoding: raw\n\nabcdef");
    EXPECT_EQ(n.geometry().size, glm::ivec3(2, 3, 1));
    EXPECT_EQ(n.value(1, 2, 0), 'f');
}

TEST(ItkReader, NiftiIsTurnedFromRasToLps) {
    const ScratchFolder f;
    const Volume v =
        open_text(f, "v.nii", nifti_file(placed_header(DT_INT16, 16, 2, 1, 2), bytes_of<std::int16_t>({1, -2, 3, 4})));
    const glm::dvec3 at = v.geometry().voxel_to_mm({1, 0, 1});  // RAS (12, 20, 32)
    EXPECT_NEAR(at.x, -12, 1e-9);
    EXPECT_NEAR(at.y, -20, 1e-9);
    EXPECT_NEAR(at.z, 32, 1e-9);
    EXPECT_EQ(v.value(1, 0, 0), -2);
}

TEST(ItkReader, NiftiScalingIsAppliedAndAbsentScalingIgnored) {
    const ScratchFolder f;
    nifti_1_header h = placed_header(DT_UINT16, 16, 3, 1, 1);
    const std::string data = bytes_of<std::uint16_t>({0, 1024, 4095});
    h.scl_slope = 1, h.scl_inter = -1024;
    const Volume hu = open_text(f, "v.nii", nifti_file(h, data));
    EXPECT_EQ(hu.type(), VoxelType::i16) << "whole numbers stay whole";
    EXPECT_EQ(hu.value(0, 0, 0), -1024);
    EXPECT_EQ(hu.value(2, 0, 0), 3071);
    h.scl_slope = 0.25f, h.scl_inter = 1;
    const Volume scaled = open_text(f, "v.nii", nifti_file(h, data));
    EXPECT_EQ(scaled.type(), VoxelType::f32);
    EXPECT_EQ(scaled.value(2, 0, 0), 4095 * 0.25 + 1);
    for (const float slope : {0.0f, NAN}) {
        h.scl_slope = slope, h.scl_inter = slope;
        const Volume plain = open_text(f, "v.nii", nifti_file(h, data));
        EXPECT_EQ(plain.type(), VoxelType::u16);
        EXPECT_EQ(plain.value(2, 0, 0), 4095);
    }
}

TEST(ItkReader, BigEndianHeadersAndVoxelsAreSwapped) {
    const ScratchFolder f;
    const Volume n = open_text(f, "v.nrrd",
                               "NRRD0004\ntype: int16\ndimension: 3\nsizes: 2 1 1\nendian: big\nencoding: raw\n\n" +
                                   std::string("\x01\x02\xff\xfe", 4));
    EXPECT_EQ(n.value(0, 0, 0), 0x0102);
    EXPECT_EQ(n.value(1, 0, 0), -2);
    const Volume m =
        open_text(f, "v.mha",
                  "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = True\nDimSize = 2 1 1\n"
                  "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
                      std::string("\x01\x02\xff\xfe", 4));
    EXPECT_EQ(m.value(0, 0, 0), 0x0102);
}

TEST(ItkReader, HugeClaimsAreRefusedBeforeAnythingIsAllocated) {
    const ScratchFolder f;
    expect_error(Errc::bad_input, {"v.nrrd", "cut"}, [&] {
        open_text(f, "v.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 60000 60000 60000\nencoding: gzip\n\nabc");
    });
    expect_error(Errc::bad_input, {"v.mha", "bytes"},
                 [&] { open_text(f, "v.mha", mha("MET_UCHAR", "60000 60000 60000", "abc")); });
    expect_error(Errc::bad_input, {"more than any memory"},
                 [&] { open_text(f, "v.mha", mha("MET_UCHAR", "2000000000 2000000000 2000000000", "abc")); });
    expect_error(Errc::bad_input, {"v.nii", "bytes"},
                 [&] { open_text(f, "v.nii", nifti_file(placed_header(DT_UINT8, 8, 32767, 32767, 32767), "abc")); });
    expect_error(Errc::bad_input, {"0 voxels"}, [&] { open_text(f, "v.mha", mha("MET_UCHAR", "2 0 1", "")); });
}

TEST(ItkReader, AFileCutAnywhereIsRefusedWithoutAWordOnStderr) {
    const ScratchFolder f;
    const Volume original = extreme_volume<std::int16_t>(oblique_grid({7, 5, 9}));
    put_file(f / "whole.mha",
             mha("MET_SHORT", "7 5 9", {reinterpret_cast<const char*>(original.data()), original.bytes()}));
    for (const char* ending : {".nrrd", ".nii", ".nii.gz", ".mha"}) {
        const auto whole = f / ("whole" + std::string(ending));
        if (ending != std::string(".mha")) write_volume(original, whole);
        expect_same_voxels(original, open_volume(whole.string()));
        const std::string bytes = get_file(whole);
        testing::internal::CaptureStderr();
        for (std::size_t keep = 0; keep < bytes.size(); keep += keep < 400 ? 13 : 29) {
            const auto cut = f / ("cut" + std::string(ending));
            put_file(cut, bytes.substr(0, keep));
            try {
                open_volume(cut.string());
                ADD_FAILURE() << ending << " cut to " << keep << " of " << bytes.size() << " bytes was read";
            } catch (const Error& e) {
                EXPECT_NE(std::string(e.what()).find("cut"), std::string::npos) << e.what();
                EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
            }
        }
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << ending;
    }
}

TEST(ItkReader, ACompressedFileWithDamagedBytesIsRefused) {
    const ScratchFolder f;
    const Volume original = extreme_volume<std::uint16_t>(oblique_grid({31, 17, 23}));
    for (const char* ending : {".nrrd", ".nii.gz"}) {
        const auto file = f / ("v" + std::string(ending));
        write_volume(original, file);
        std::string bytes = get_file(file);
        for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 40; ++i) bytes[i] = char(~bytes[i]);
        put_file(file, bytes);
        expect_error(Errc::bad_input, {"v" + std::string(ending)}, [&] { open_volume(file.string()); });
    }
}

TEST(ItkReader, AHeaderWithoutItsDataFileIsRefused) {
    const ScratchFolder f;
    expect_error(Errc::bad_input, {"v.mhd", "none.raw", "not there"}, [&] {
        open_text(
            f, "v.mhd",
            "ObjectType = Image\nNDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nElementDataFile = none.raw\n");
    });
    expect_error(Errc::bad_input, {"v.nhdr", "none.raw", "not there"}, [&] {
        open_text(f, "v.nhdr",
                  "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 1 1\nencoding: raw\ndata file: none.raw\n");
    });
    expect_error(Errc::bad_input, {"v.mhd"}, [&] { open_text(f, "v.mhd", "not a header"); });
    expect_error(Errc::bad_input, {"v.nrrd"}, [&] { open_text(f, "v.nrrd", ""); });
    expect_error(Errc::bad_input, {"v.nii"}, [&] { open_text(f, "v.nii", ""); });
}

TEST(BrokenSets, EachGetsOneClearLine) {
    struct Row {
        const char* path;
        std::initializer_list<std::string> words;
    };
    for (const Row& row : {Row{"broken/aneurism_cut.nrrd", {"aneurism_cut.nrrd", "cut short"}},
                           Row{"broken/engine_missing_data.mhd", {"no_such_file.raw", "not there"}},
                           Row{"broken/engine_wrong_dims.mhd", {"8388608", "16777216"}}}) {
        LACUNA_NEEDS_DATA(path, row.path);
        testing::internal::CaptureStderr();
        expect_error(Errc::bad_input, row.words, [&] { open_volume(path.string()); });
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << row.path;
    }
}
