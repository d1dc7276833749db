#include <algorithm>
#include <cstring>
#include <filesystem>

#include "core/io/plain_file.h"
#include "core/io/volume_writer.h"
#include "nifti_fixture.h"

// Spellings of NIfTI and NRRD that are seldom met: voxels in a file of their own, axes that are none of space.
using namespace lacuna;
using namespace lacuna::test;
using namespace std::string_literals;

namespace {

/// 3x2x1 voxels "abcdef" of 2 mm, the first at (10, 20, 30) in RAS, as a pair.
nifti_1_header pair_header() {
    nifti_1_header h = nifti_header(DT_UINT8, 8, 3, 2, 1);
    h.sform_code = 1;
    h.srow_x[0] = h.srow_y[1] = h.srow_z[2] = 2;
    h.srow_x[3] = 10, h.srow_y[3] = 20, h.srow_z[3] = 30;
    h.vox_offset = 0;
    std::memcpy(h.magic, "ni1", 4);
    return h;
}

std::string bytes_of(const nifti_1_header& h) { return {reinterpret_cast<const char*>(&h), sizeof h}; }

void expect_pair(const Volume& v) {
    EXPECT_EQ(v.geometry().size, glm::ivec3(3, 2, 1));
    EXPECT_EQ(v.value(0, 0, 0), 'a');
    EXPECT_EQ(v.value(2, 1, 0), 'f');
    const glm::dvec3 at = v.geometry().voxel_to_mm({1, 1, 0});
    EXPECT_NEAR(at.x, -12, 1e-9);
    EXPECT_NEAR(at.y, -22, 1e-9);
    EXPECT_NEAR(at.z, 30, 1e-9);
}

/// A volume of 2x3x2 voxels "abcdefghijkl" behind a header line by line.
Volume nrrd(const ScratchFolder& f, const std::string& lines) {
    return open_text(f, "v.nrrd", "NRRD0005\ntype: uint8\n" + lines + "encoding: raw\n\nabcdefghijkl");
}

}  // namespace

TEST(NiftiPairs, AreReadByEitherFile) {
    const ScratchFolder f;
    put_file(f / "v.img", "abcdef");
    expect_pair(open_text(f, "v.hdr", bytes_of(pair_header())));
    expect_pair(open_volume((f / "v.img").string()));
    EXPECT_FALSE(needs_raw_layout(f / "v.img"));
    EXPECT_EQ(list_series((f / "v.img").string()).front().size, glm::ivec3(3, 2, 1));
}

TEST(NiftiPairs, OffsetsByteOrderAndPackedVoxelsAreTaken) {
    const ScratchFolder f;
    nifti_1_header h = pair_header();
    h.vox_offset = 5;
    put_file(f / "v.img", "-----abcdef");
    expect_pair(open_text(f, "v.hdr", bytes_of(h)));
    // Packed by the writer of this program, whose voxels lie 352 bytes into what is packed.
    write_volume(open_volume((f / "v.hdr").string()), f / "whole.nii.gz");
    std::filesystem::rename(f / "whole.nii.gz", f / "p.img.gz");
    h.vox_offset = 352;
    expect_pair(open_text(f, "p.hdr", bytes_of(h)));
    // The other byte order, of header and voxels.
    h = nifti_header(DT_INT16, 16, 2, 1, 1);
    h.qform_code = 1, h.vox_offset = 0;
    std::memcpy(h.magic, "ni1", 4);
    const auto turn = [](auto& value) {
        auto* bytes = reinterpret_cast<unsigned char*>(&value);
        std::reverse(bytes, bytes + sizeof value);
    };
    turn(h.sizeof_hdr);
    for (short& d : h.dim) turn(d);
    for (float& p : h.pixdim) turn(p);
    for (short* s : {&h.datatype, &h.bitpix, &h.qform_code}) turn(*s);
    put_file(f / "b.img", std::string("\x01\x02\xff\xfe", 4));
    const Volume swapped = open_text(f, "b.hdr", bytes_of(h));
    EXPECT_EQ(swapped.value(0, 0, 0), 0x102);
    EXPECT_EQ(swapped.value(1, 0, 0), -2);
}

TEST(NiftiPairs, HalfAPairIsRefusedInOneLine) {
    const ScratchFolder f;
    expect_error(Errc::bad_input, {"v.hdr", "v.img", "not there"},
                 [&] { open_text(f, "v.hdr", bytes_of(pair_header())); });
    put_file(f / "v.img", "abcde");
    expect_error(Errc::bad_input, {"v.hdr", "6 bytes", "5"}, [&] { open_volume((f / "v.hdr").string()); });
    expect_error(Errc::bad_input, {"v.hdr", "6 bytes", "5"}, [&] { open_volume((f / "v.img").string()); });
    nifti_1_header h = pair_header();
    h.vox_offset = -1;
    expect_error(Errc::bad_input, {"vox_offset"}, [&] { open_text(f, "v.hdr", bytes_of(h)); });
    // Headers of other formats (Analyze, ENVI) lie beside an .img too; it stays a raw file.
    put_file(f / "v.hdr", std::string(348, 'x'));
    expect_error(Errc::bad_input, {"v.hdr", "no NIfTI"}, [&] { open_volume((f / "v.hdr").string()); });
    EXPECT_TRUE(needs_raw_layout(f / "v.img"));
}

TEST(Nifti2, IsRefusedWithWhatToDo) {
    const ScratchFolder f;
    nifti_1_header h = nifti_header(DT_UINT8, 8, 3, 2, 1);
    h.sizeof_hdr = 540;
    expect_error(Errc::unsupported, {"v.nii", "NIfTI-2", "save it as"},
                 [&] { open_text(f, "v.nii", bytes_of(h) + std::string(300, '\0')); });
}

TEST(NrrdLeadingAxes, OfOneValueAVoxelAreNoneOfSpace) {
    const ScratchFolder f;
    const std::string own = "space: left-posterior-superior\n",
                      axes = "(0.5,0,0) (0,0.5,0) (0,0,2)\nspace origin: (7,8,9)\n";
    for (const std::string& lines :
         {"dimension: 4\nsizes: 1 2 3 2\nspacings: NaN 0.5 0.5 2\n"s,
          "dimension: 4\nsizes: 1 2 3 2\nspacings: 1 0.5 0.5 2\n"s,
          "dimension: 4\nsizes: 1 2 3 2\nspacings: 1 0.0005 0.0005 0.002\nunits: \"\" \"m\" \"m\" \"m\"\n"s,
          "dimension: 5\nsizes: 1 1 2 3 2\nspacings: NaN NaN 0.5 0.5 2\n"s,
          "dimension: 4\nsizes: 1 2 3 2\naxis mins: 0 0 0 0\naxis maxs: 1 1 1.5 4\n"s}) {
        const Volume v = nrrd(f, lines);
        EXPECT_EQ(v.geometry().size, glm::ivec3(2, 3, 2)) << lines;
        EXPECT_LT(glm::distance(v.geometry().spacing, glm::dvec3(0.5, 0.5, 2)), 1e-9) << lines;
        EXPECT_EQ(v.value(1, 0, 0), 'b') << lines;
        EXPECT_EQ(v.value(1, 2, 1), 'l') << lines;
    }
    for (const char* kind : {"scalar", "stub", "vector", "list"}) {
        const Volume v = nrrd(f, own + "dimension: 4\nsizes: 1 2 3 2\nkinds: " + kind +
                                     " domain domain domain\nspace directions: none " + axes);
        EXPECT_EQ(v.geometry().size, glm::ivec3(2, 3, 2)) << kind;
        EXPECT_LT(glm::distance(v.geometry().spacing, glm::dvec3(0.5, 0.5, 2)), 1e-9) << kind;
        EXPECT_LT(glm::distance(v.geometry().origin, glm::dvec3(7, 8, 9)), 1e-9) << kind;
        EXPECT_EQ(v.value(1, 2, 1), 'l') << kind;
    }
}

TEST(NrrdLeadingAxes, OfSeveralValuesAreRefused) {
    const ScratchFolder f;
    expect_error(Errc::unsupported, {"v.nrrd", "2 volumes"}, [&] { nrrd(f, "dimension: 5\nsizes: 1 3 2 1 2\n"); });
    expect_error(Errc::unsupported, {"v.nrrd"},
                 [&] { nrrd(f, "dimension: 4\nsizes: 2 2 3 1\nkinds: vector domain domain domain\n"); });
    expect_error(Errc::unsupported, {"v.nrrd", "kinds:"}, [&] {
        nrrd(f,
             "space: left-posterior-superior\ndimension: 4\nsizes: 1 2 3 2\n"
             "space directions: none (0.5,0,0) (0,0.5,0) (0,0,2)\n");
    });
}
