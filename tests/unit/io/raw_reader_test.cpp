#include "core/io/raw_reader.h"

#include <bit>
#include <cstring>

#include "core/base/parallel.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

std::string bytes_of(const Volume& v) { return {reinterpret_cast<const char*>(v.data()), v.bytes()}; }

std::string with_swapped_words(std::string bytes, std::size_t word) {
    for (std::size_t i = 0; i + word <= bytes.size(); i += word)
        std::reverse(bytes.begin() + long(i), bytes.begin() + long(i + word));
    return bytes;
}

GridGeometry plain_grid(glm::ivec3 size) {
    GridGeometry g;
    g.size = size;
    return g;
}

Volume open_raw(const std::filesystem::path& file, const std::string& raw) {
    OpenOptions options;
    options.raw = raw;
    return open_volume(file.string(), options);
}

}  // namespace

TEST(RawText, EveryFaultIsNamedAndIsAMatterOfUsage) {
    for (const char* text : {"",
                             "256",
                             "256x256x128",
                             "256x256:u8",
                             "256x256x0:u8",
                             "256x-1x4:u8",
                             "4x4x4:u12",
                             "4x4x4:U8",
                             "4x4x4:u8:1,1",
                             "4x4x4:u8:0,1,1",
                             "4x4x4:u8:1,-1,1",
                             "4x4x4:u8:nan,1,1",
                             "4x4x4:u8:1,1,inf",
                             "4x4x4:u8:+",
                             "4x4x4:u8:+-1",
                             "4x4x4:u8:+1k",
                             "4x4x4:u8:big",
                             "4xx4:u8",
                             "4x4x4x4:u8",
                             "99999999999x1x1:u8",
                             "x4x4:u8"})
        expect_error(Errc::bad_usage, {"WxHxD:TYPE", text}, [&] { parse_raw_text(text); });
}

TEST(RawText, ReadsEveryPartInAnyOrder) {
    const RawLayout a = parse_raw_text("256x255x128:i16:0.5,0.75,2:be:+4096");
    EXPECT_EQ(a.geometry.size, glm::ivec3(256, 255, 128));
    EXPECT_EQ(a.type, VoxelType::i16);
    EXPECT_EQ(a.geometry.spacing, glm::dvec3(0.5, 0.75, 2));
    EXPECT_TRUE(a.big_endian);
    EXPECT_EQ(a.offset, 4096u);
    const RawLayout b = parse_raw_text("1x1x7:f32:+8:be");
    EXPECT_EQ(b.geometry.size, glm::ivec3(1, 1, 7));
    EXPECT_TRUE(b.big_endian);
    EXPECT_FALSE(b.spacing_known);
    EXPECT_EQ(parse_raw_text("4x4x4:u8:+6000000000").offset, 6000000000u) << "offsets beyond 32 bits";
}

TEST(RawReader, EveryTypeAndByteOrderKeepsItsValues) {
    const ScratchFolder folder;
    for (const VoxelType type : {VoxelType::u8, VoxelType::i8, VoxelType::u16, VoxelType::i16, VoxelType::f32})
        for (const bool big : {false, true})
            for (const glm::ivec3 size : {glm::ivec3(5, 3, 7), glm::ivec3(1, 1, 9), glm::ivec3(1)}) {
                const Volume original = extreme_volume(type, plain_grid(size));
                std::string bytes = bytes_of(original);
                if (big) bytes = with_swapped_words(bytes, size_of(type));
                put_file(folder / "v.raw", "head!" + bytes);
                const std::string text = std::to_string(size.x) + "x" + std::to_string(size.y) + "x" +
                                         std::to_string(size.z) + ":" + std::string(name_of(type)) + ":1,2,3" +
                                         (big ? ":be" : "") + ":+5";
                const Volume read = open_raw(folder / "v.raw", text);
                expect_same_voxels(original, read);
                EXPECT_EQ(read.geometry().spacing, glm::dvec3(1, 2, 3));
                EXPECT_EQ(read.geometry().origin, glm::dvec3(0));
                EXPECT_FALSE(has_warning(read, "spacing"));
            }
}

TEST(RawReader, ChunksOfALargeFileMeetWithoutAGap) {
    const ScratchFolder folder;  // over two chunks of 8 MiB, odd size, big-endian
    const Volume original = extreme_volume<std::uint16_t>(plain_grid({257, 129, 301}));
    put_file(folder / "large.raw", with_swapped_words(bytes_of(original), 2));
    expect_same_voxels(original, open_raw(folder / "large.raw", "257x129x301:u16:be"));
}

TEST(RawReader, ASizeThatDoesNotMatchIsRefusedWithBothByteCounts) {
    const ScratchFolder folder;
    put_file(folder / "v.raw", std::string(100, 'x'));
    const auto open = [&](const char* raw) { return [&folder, raw] { open_raw(folder / "v.raw", raw); }; };
    expect_error(Errc::bad_input, {"100 bytes", "101 bytes"}, open("101x1x1:u8"));
    expect_error(Errc::bad_input, {"100 bytes", "99 bytes"}, open("99x1x1:u8"));
    expect_error(Errc::bad_input, {"100 bytes", "200 bytes"}, open("10x10x1:u16"));
    expect_error(Errc::bad_input, {"100 bytes", "101 bytes"}, open("100x1x1:u8:+1"));
    EXPECT_NO_THROW(open_raw(folder / "v.raw", "99x1x1:u8:+1"));
    expect_error(Errc::bad_input, {"more than any memory"}, open("2147483647x2147483647x2147483647:f32"));
    expect_error(Errc::bad_input, {"100 bytes", "549755813888 bytes"}, open("8192x8192x8192:u8"));
}

TEST(RawReader, WithoutAnyDescriptionSaysWhatToGive) {
    const ScratchFolder folder;
    put_file(folder / "v.raw", "12345678");
    expect_error(Errc::bad_input, {"v.raw", "--raw"}, [&] { open_volume((folder / "v.raw").string()); });
    expect_error(Errc::io, {"none.raw"}, [&] { open_volume((folder / "none.raw").string()); });
    expect_error(Errc::io, {"no such file"}, [&] { open_volume(""); });
}

TEST(RawReader, AFileNameMayDescribeIt) {
    const ScratchFolder folder;
    put_file(folder / "engine_4x3x2_uint8.raw", std::string(24, 'a'));
    put_file(folder / "foot-2x2x2-int16.raw", std::string(16, 'a'));
    put_file(folder / "a_2x1x1_float32.vol", std::string(8, '\0'));
    const Volume v = open_volume((folder / "engine_4x3x2_uint8.raw").string());
    EXPECT_EQ(v.geometry().size, glm::ivec3(4, 3, 2));
    EXPECT_TRUE(has_warning(v, "spacing"));
    EXPECT_EQ(v.name, "engine_4x3x2_uint8.raw");
    EXPECT_EQ(open_volume((folder / "foot-2x2x2-int16.raw").string()).type(), VoxelType::i16);
    EXPECT_EQ(open_volume((folder / "a_2x1x1_float32.vol").string()).type(), VoxelType::f32);
    put_file(folder / "b_4x3x3_uint8.raw", std::string(24, 'a'));
    expect_error(Errc::bad_input, {"24 bytes", "36 bytes"},
                 [&] { open_volume((folder / "b_4x3x3_uint8.raw").string()); });
}

TEST(RawReader, SpacingCanBeGivenByTheCaller) {
    const ScratchFolder folder;
    put_file(folder / "e_4x3x2_uint8.raw", std::string(24, 'a'));
    OpenOptions options;
    options.spacing_mm = glm::dvec3(0.5, 0.5, 2);
    const Volume v = open_volume((folder / "e_4x3x2_uint8.raw").string(), options);
    EXPECT_EQ(v.geometry().spacing, glm::dvec3(0.5, 0.5, 2));
    EXPECT_FALSE(has_warning(v, "spacing"));
    options.spacing_mm = glm::dvec3(1, 0, 1);
    expect_error(Errc::bad_input, {"spacing"}, [&] { open_volume((folder / "e_4x3x2_uint8.raw").string(), options); });
}

TEST(DatSidecar, DescribesTheFileItNames) {
    const ScratchFolder folder;
    put_file(folder / "s.raw", std::string(4 * 3 * 2 * 2, 'a'));
    put_file(folder / "s.dat",
             "ObjectFileName: s.raw\r\nResolution:\t4 3 2\r\nSliceThickness: 0.5 0.5 2\r\nFormat: USHORT\r\n");
    for (const char* name : {"s.dat", "s.raw"}) {
        const Volume v = open_volume((folder / name).string());
        EXPECT_EQ(v.type(), VoxelType::u16);
        EXPECT_EQ(v.geometry().size, glm::ivec3(4, 3, 2));
        EXPECT_EQ(v.geometry().spacing, glm::dvec3(0.5, 0.5, 2));
        EXPECT_EQ(v.name, name);
    }
}

TEST(DatSidecar, EveryFaultNamesTheLine) {
    const ScratchFolder folder;
    put_file(folder / "s.raw", std::string(24, 'a'));
    const auto refused = [&](const std::string& text, std::initializer_list<std::string> words,
                             Errc code = Errc::bad_input) {
        put_file(folder / "s.dat", text);
        expect_error(code, words, [&] { open_volume((folder / "s.dat").string()); });
    };
    refused("", {"ObjectFileName"});
    refused("ObjectFileName: none.raw\n", {"none.raw", "not there"});
    refused("ObjectFileName: s.raw\nFormat: UCHAR\n", {"Resolution"});
    refused("ObjectFileName: s.raw\nResolution: 4 3\nFormat: UCHAR\n", {"Resolution"});
    refused("ObjectFileName: s.raw\nResolution: 4 3 2\nFormat: RGBA\n", {"Format", "RGBA"});
    refused("ObjectFileName: s.raw\nResolution: 4 3 2\nSliceThickness: 1 0 1\nFormat: UCHAR\n",
            {"SliceThickness", "positive"});
    refused("ObjectFileName: s.raw\nResolution: 4 3 2\nSliceThickness: 1 -1 1\nFormat: UCHAR\n", {"SliceThickness"});
    refused("ObjectFileName: s.raw\nResolution: 4 3 2\nSliceThickness: 1 nan 1\nFormat: UCHAR\n", {"SliceThickness"});
    refused("ObjectFileName: s.raw\nResolution: 4 3 3\nFormat: UCHAR\n", {"24 bytes", "36 bytes"});
    refused("ObjectFileName: s.raw\nResolution: 4 3 -2\nFormat: UCHAR\n", {"-2"});
}

TEST(VgiSidecar, GivesSizeTypeOffsetAndResolution) {
    const ScratchFolder folder;
    put_file(folder / "p.vol", "1234567" + std::string(4 * 3 * 2 * 2, 'b'));
    const std::string head =
        "{volume1}\n[representation]\nsize = 4 3 2\ndatatype = unsigned integer\ndatarange = 0 -1\nbitsperelement = "
        "16\n"
        "[file1]\nSkipHeader = 7\nFileFormat = raw\nSize = 4 3 2\nName = p.vol\nDatatype = unsigned integer\n"
        "BitsPerElement = 16\n{volumeprimitive12}\n[geometry]\nresolution = 50 50 100\n";
    put_file(folder / "p.vgi", head + "unit = um\n");
    for (const char* name : {"p.vgi", "p.vol"}) {
        const Volume v = open_volume((folder / name).string());
        EXPECT_EQ(v.geometry().size, glm::ivec3(4, 3, 2));
        EXPECT_EQ(v.type(), VoxelType::u16);
        EXPECT_NEAR(v.geometry().spacing.z, 0.1, 1e-12);
    }
    put_file(folder / "p.vgi", head + "unit = parsec\n");
    expect_error(Errc::unsupported, {"parsec"}, [&] { open_volume((folder / "p.vgi").string()); });
    put_file(folder / "p.vgi", "[geometry]\nunit = mm\n");
    expect_error(Errc::bad_input, {"[file1]"}, [&] { open_volume((folder / "p.vgi").string()); });
}

TEST(RawReader, NanVoxelsAreKeptAndCounted) {
    const ScratchFolder folder;
    const float values[4] = {1, NAN, INFINITY, -2};
    put_file(folder / "f.raw", {reinterpret_cast<const char*>(values), sizeof values});
    const Volume v = open_raw(folder / "f.raw", "2x2x1:f32");
    EXPECT_TRUE(has_warning(v, "2 voxels are not a finite number"));
    EXPECT_TRUE(std::isnan(v.value(1, 0, 0)));
}

TEST(RawReader, ValuesNoPictureCanBeMadeOfAreSaid) {
    const ScratchFolder folder;
    const auto warned = [&](float least, float most) {
        const float values[4] = {least, 0, NAN, most};
        put_file(folder / "f.raw", {reinterpret_cast<const char*>(values), sizeof values});
        return has_warning(open_raw(folder / "f.raw", "2x2x1:f32"), "beyond what pictures can be calculated with");
    };
    EXPECT_TRUE(warned(-3e38f, 3e38f));  // their difference is infinite
    EXPECT_TRUE(warned(-1e-40f, 1e-39f));
    EXPECT_FALSE(warned(-1.5e38f, 1.5e38f));
    EXPECT_FALSE(warned(-1e-37f, 1e-36f));
    EXPECT_FALSE(warned(0, 0));
}

TEST(RawReader, AStoppedJobIsCancelled) {
    const ScratchFolder folder;
    put_file(folder / "c.raw", std::string(1000, 'x'));
    std::stop_source stop;
    stop.request_stop();
    OpenOptions options;
    options.raw = "10x10x10:u8";
    expect_error(Errc::cancelled, {}, [&] {
        open_volume((folder / "c.raw").string(), options, {stop.get_token(), nullptr});
    });
}

TEST(VoxelDigest, IsTheStandardsSha256OfTheBytes) {
    const ScratchFolder folder;
    put_file(folder / "abc.raw", "abc");  // FIPS 180-2, appendix B.1
    EXPECT_EQ(voxel_sha256(open_raw(folder / "abc.raw", "3x1x1:u8")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(OpenVolume, SamplesAreNamedWithTheirSize) {
    const Volume v = open_volume("sample:spheres@24");
    EXPECT_EQ(std::max({v.geometry().size.x, v.geometry().size.y, v.geometry().size.z}), 24);
    EXPECT_EQ(list_series("sample:spheres@24").size(), 1u);
    expect_error(Errc::bad_usage, {"sample:spheres@x"}, [] { open_volume("sample:spheres@x"); });
    expect_error(Errc::bad_usage, {}, [] { open_volume("sample:spheres@-3"); });
    expect_error(Errc::bad_usage, {"nonsense"}, [] { open_volume("sample:nonsense"); });
}

TEST(OpenVolume, FoldersAndFilesWithoutAVolumeAreRefused) {
    const ScratchFolder folder;
    expect_error(Errc::bad_input, {folder.path().string(), "empty"}, [&] { open_volume(folder.path().string()); });
    put_file(folder / "readme.txt", "words");
    expect_error(Errc::bad_input, {"no DICOM"}, [&] { open_volume(folder.path().string()); });
    expect_error(Errc::bad_input, {"readme.txt", "neither DICOM"},
                 [&] { open_volume((folder / "readme.txt").string()); });
    put_file(folder / "v_2x2x2_uint8.raw", "12345678");
    OpenOptions options;
    options.series = "2";
    expect_error(Errc::bad_usage, {"series '2'"},
                 [&] { open_volume((folder / "v_2x2x2_uint8.raw").string(), options); });
}
