// Files read box by box hold the voxels they hold when read whole, and what cannot be read so says it.
#include <cstring>

#include "core/io/volume_writer.h"
#include "core/volume/samples.h"
#include "tests/unit/io/volume_fixture.h"

namespace lacuna {
namespace {

void expect_same_boxes(const std::string& input, const OpenOptions& options = {}) {
    const Volume whole = open_volume(input, options);
    const std::optional<Volume> parts = open_volume_in_parts(input, options);
    ASSERT_TRUE(parts.has_value()) << input;
    EXPECT_FALSE(parts->in_memory());
    EXPECT_EQ(parts->type(), whole.type());
    EXPECT_EQ(parts->name, whole.name);
    EXPECT_EQ(parts->geometry().spacing, whole.geometry().spacing);
    EXPECT_NEAR(glm::length(parts->geometry().origin - whole.geometry().origin), 0, 1e-12);
    const glm::ivec3 size = whole.geometry().size;
    ASSERT_EQ(parts->geometry().size, size);
    for (const VoxelBox box : {VoxelBox{{0, 0, 0}, size}, VoxelBox{{1, 2, 3}, size - glm::ivec3(2, 4, 5)},
                               VoxelBox{{0, 3, 1}, {size.x, 2, 4}}, VoxelBox{size - 1, {1, 1, 1}}}) {
        const Volume a = extract_box(whole, box), b = extract_box(*parts, box);
        EXPECT_EQ(std::memcmp(a.data(), b.data(), a.bytes()), 0) << input;
    }
}

Volume small() {
    SampleOptions options;
    options.dims = {21, 17, 13};
    return make_sample("casting", options).volume;
}

TEST(VolumeInParts, RawFilesAndTheirSidecars) {
    const test::ScratchFolder folder;
    write_volume(small(), folder / "a.raw");
    write_volume(small(), folder / "b.mhd");
    expect_same_boxes((folder / "a.raw").string());
    expect_same_boxes((folder / "a.dat").string());
    expect_same_boxes((folder / "b.mhd").string());
    expect_same_boxes((folder / "b.raw").string());  // by its sidecar
    OpenOptions raw;
    raw.raw = "21x17x13:i16:0.5,0.5,2:be";
    expect_same_boxes((folder / "a.raw").string(), raw);
    raw.raw = "21x17x12:u16:+442";
    std::filesystem::resize_file(folder / "a.raw", 21 * 17 * 12 * 2 + 442);
    expect_same_boxes((folder / "a.raw").string(), raw);
    OpenOptions spaced;
    spaced.spacing_mm = glm::dvec3(1, 2, 3);
    expect_same_boxes((folder / "b.mhd").string(), spaced);
}

// The file is a hole but for a few bytes: places beyond 2^31 voxels and 2^32 bytes are counted right, and an offset
// that leaves 64 bits is none.
TEST(VolumeInParts, VoxelsBeyondTwoToTheThirtyTwo) {
    const test::ScratchFolder folder;
    const std::string file = (folder / "v.raw").string();
    constexpr std::uintmax_t k_bytes = std::uintmax_t(2000) * 2000 * 600 * 2 + 7;
    {
        std::ofstream out(file, std::ios::binary);
        const char last[] = {1, 2, 3, 4, 5, 6};  // the last three voxels, big-endian
        out.seekp(std::streamoff(k_bytes) - 6);
        out.write(last, 6);
        ASSERT_TRUE(out.flush());
    }
    OpenOptions raw;
    raw.raw = "2000x2000x600:u16:1,1,1:be:+7";
    const std::optional<Volume> parts = open_volume_in_parts(file, raw);
    ASSERT_TRUE(parts.has_value());
    const Volume end = extract_box(*parts, {{1996, 1999, 599}, {4, 1, 1}});
    EXPECT_EQ(end.value(0, 0, 0), 0);
    EXPECT_EQ(end.value(1, 0, 0), 0x0102);
    EXPECT_EQ(end.value(3, 0, 0), 0x0506);
    EXPECT_EQ(end.geometry().origin, glm::dvec3(1996, 1999, 599));
    raw.raw = "2000x2000x600:u16:1,1,1:+18446744073709551615";
    test::expect_error(Errc::bad_input, {"v.raw", "offset"}, [&] { open_volume_in_parts(file, raw); });
}

TEST(VolumeInParts, WhatIsWrittenInPartsIsTheSame) {
    const test::ScratchFolder folder;
    write_volume(small(), folder / "whole.mhd");
    SampleOptions options;
    options.dims = {21, 17, 13};
    for (const char* name : {"a.mhd", "a.nrrd", "c.raw"}) {
        write_volume(sample_in_parts("casting", options), folder / name);
        const Volume back = open_volume((folder / name).string());
        EXPECT_EQ(voxel_sha256(back), voxel_sha256(small())) << name;
        EXPECT_EQ(back.geometry().spacing, small().geometry().spacing);
        expect_same_boxes((folder / name).string());
    }
    EXPECT_THROW(write_volume(sample_in_parts("casting", options), folder / "a.nii.gz"), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.nii.gz"));
}

TEST(VolumeInParts, HeadersWithTheirVoxelsBehindThem) {
    const test::ScratchFolder folder;
    std::string voxels;
    for (int i = 0; i < 5 * 6 * 7; ++i) voxels += {char(i & 0xff), char(i >> 3)};
    const auto write = [&](const std::string& name, const std::string& head) {
        std::ofstream(folder / name, std::ios::binary) << head << voxels;
        expect_same_boxes((folder / name).string());
    };
    write("local.mha",
          "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = True\nElementSpacing = 1 2 3\n"
          "DimSize = 5 6 7\nElementType = MET_SHORT\nElementDataFile = LOCAL\n");
    write("big.nrrd", "NRRD0004\ntype: short\ndimension: 3\nsizes: 5 6 7\nencoding: raw\nendian: big\n\n");
    std::ofstream(folder / "data.bin", std::ios::binary) << std::string(9, 'x') << voxels;
    std::ofstream(folder / "detached.nhdr") << "NRRD0004\ntype: uint16\ndimension: 3\nsizes: 5 6 7\nencoding: raw\n"
                                               "endian: little\nbyte skip: 9\ndata file: data.bin\n";
    expect_same_boxes((folder / "detached.nhdr").string());
}

TEST(VolumeInParts, OthersCannotBe) {
    const test::ScratchFolder folder;
    write_volume(small(), folder / "packed.nrrd");
    write_volume(small(), folder / "a.nii");
    EXPECT_FALSE(open_volume_in_parts((folder / "packed.nrrd").string()).has_value());
    EXPECT_FALSE(open_volume_in_parts((folder / "a.nii").string()).has_value());
    EXPECT_FALSE(open_volume_in_parts(folder.path().string()).has_value());
    EXPECT_THROW(open_volume_in_parts((folder / "absent.raw").string()), Error);
    write_volume(small(), folder / "cut.raw");
    std::filesystem::resize_file(folder / "cut.raw", 100);
    EXPECT_THROW(open_volume_in_parts((folder / "cut.raw").string()), Error);
}

TEST(VolumeInParts, SamplesBySizes) {
    expect_same_boxes("sample:spheres@30x20x10");
    EXPECT_EQ(open_volume("sample:spheres@30x20x10").geometry().size, glm::ivec3(30, 20, 10));
    for (const char* wrong : {"sample:head@", "sample:head@20x", "sample:head@20x20", "sample:head@x20",
                              "sample:head@a", "sample:head@20xx20x20", "sample:head@0x20x20", "sample:head@-9"})
        EXPECT_THROW(open_volume_in_parts(wrong), Error) << wrong;
}

}  // namespace
}  // namespace lacuna
