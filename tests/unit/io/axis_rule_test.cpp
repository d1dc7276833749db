#include "core/io/axis_rule.h"

#include "core/io/volume_writer.h"
#include "nifti_fixture.h"
#include "tests/support/dicom_zoo.h"

// What the axes of each format's volumes are called: by the one rule of core/io/axis_rule.h, up to the opened volume.
using namespace lacuna;
using namespace lacuna::test;

namespace {

constexpr AxisNames k_xyz = AxisNames::xyz, k_patient = AxisNames::patient;

AxisNames names_of(const Volume& volume) { return volume.geometry().axis_names; }

std::string nrrd(const std::string& more) {
    return "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n" + more + "\n01234567";
}

const std::string k_directions = "space directions: (1,0,0) (0,1,0) (0,0,1)\n";

std::string meta(const std::string& more) {
    return "ObjectType = Image\nNDims = 3\n" + more +
           "ElementSpacing = 1 1 1\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n01234567";
}

Volume part(AxisNames names) {
    GridGeometry g = oblique_grid({5, 4, 3});
    g.axis_names = names;
    return extreme_volume<std::uint8_t>(g);
}

}  // namespace

TEST(AxisRule, NrrdOfAPatientsSpaceAlone) {
    const ScratchFolder f;
    for (const char* space : {"left-posterior-superior", "right-anterior-superior", "left-anterior-superior", "LPS",
                              "RAS", "Left-Posterior-Superior"})
        EXPECT_EQ(names_of(open_text(f, "v.nrrd", nrrd("space: " + std::string(space) + "\n" + k_directions))),
                  k_patient)
            << space;
    for (const char* space : {"scanner-xyz", "3D-right-handed", "3D-left-handed"})
        EXPECT_EQ(names_of(open_text(f, "v.nrrd", nrrd("space: " + std::string(space) + "\n" + k_directions))), k_xyz)
            << space;
    EXPECT_EQ(names_of(open_text(f, "v.nrrd", nrrd("space dimension: 3\n" + k_directions))), k_xyz);
    EXPECT_EQ(names_of(open_text(f, "v.nrrd", nrrd("spacings: 1 1 1\n"))), k_xyz);
    const std::string lps = "space: left-posterior-superior\n" + k_directions;
    EXPECT_EQ(names_of(open_text(f, "v.nrrd", nrrd(lps + "axes:=xyz\n"))), k_xyz);
    EXPECT_EQ(names_of(open_text(f, "v.nrrd", nrrd(lps + "axes:=other: xyz\n# axes:=xyz\n"))), k_patient);
}

TEST(AxisRule, MetaImageOfAStatedOrientationAlone) {
    const ScratchFolder f;
    EXPECT_EQ(names_of(open_text(f, "v.mha", meta("AnatomicalOrientation = RAI\n"))), k_patient);
    EXPECT_EQ(names_of(open_text(f, "v.mha", meta("AnatomicalOrientation = LPS\n"))), k_patient);
    EXPECT_EQ(names_of(open_text(f, "v.mha", meta("AnatomicalOrientation = ???\n"))), k_xyz);
    EXPECT_EQ(names_of(open_text(f, "v.mha", meta(""))), k_xyz);
}

TEST(AxisRule, NiftiThatStatesAnOrientationAlone) {
    const ScratchFolder f;
    nifti_1_header h = nifti_header(DT_UINT8, 8, 2, 2, 2);
    EXPECT_EQ(names_of(open_text(f, "v.nii", nifti_file(h, "01234567"))), k_xyz);
    h.qform_code = NIFTI_XFORM_SCANNER_ANAT;
    EXPECT_EQ(names_of(open_text(f, "v.nii", nifti_file(h, "01234567"))), k_patient);
    h.qform_code = 0;
    h.sform_code = NIFTI_XFORM_ALIGNED_ANAT;
    for (int a = 0; a < 3; ++a) (a == 0 ? h.srow_x : a == 1 ? h.srow_y : h.srow_z)[a] = 2;
    EXPECT_EQ(names_of(open_text(f, "v.nii", nifti_file(h, "01234567"))), k_patient);
}

TEST(AxisRule, RawIsAPartWithAndWithoutASidecar) {
    const ScratchFolder f;
    put_file(f / "v_2x2x2_uint8.raw", "01234567");
    EXPECT_EQ(names_of(open_volume((f / "v_2x2x2_uint8.raw").string())), k_xyz);
    put_file(f / "w.raw", "01234567");
    put_file(f / "w.dat", "ObjectFileName: w.raw\nResolution: 2 2 2\nSliceThickness: 1 1 1\nFormat: UCHAR\n");
    EXPECT_EQ(names_of(open_volume((f / "w.dat").string())), k_xyz);
}

TEST(AxisRule, DicomOfAPatientButNotOfAPart) {
    const TemporaryFolder f;
    ZooSlice s;
    write_zoo_slice(f / "slice", s);
    EXPECT_EQ(names_of(open_volume((f / "slice").string())), k_patient);
    s.extra = {{{0x0014, 0x0028}, "Foundry"}};  // ComponentManufacturer: a DICONDE file
    write_zoo_slice(f / "slice", s);
    EXPECT_EQ(names_of(open_volume((f / "slice").string())), k_xyz);
}

TEST(AxisRule, AnImageWithoutOrientationHasNoSides) {
    EXPECT_EQ(axis_names_of({FileFormat::dicom, {}, false}), k_xyz);
    EXPECT_EQ(axis_names_of({FileFormat::tiff}), k_xyz);
    EXPECT_EQ(axis_names_of({FileFormat::vgi}), k_xyz);
}

TEST(AxisRule, SamplesOfABodyAreAPatients) {
    for (const char* name : {"head", "vessels"})
        EXPECT_EQ(names_of(open_volume("sample:" + std::string(name) + "@8")), k_patient) << name;
    for (const char* name : {"casting", "spheres", "marschner-lobb"})
        EXPECT_EQ(names_of(open_volume("sample:" + std::string(name) + "@8")), k_xyz) << name;
}

TEST(AxisRule, WrittenFilesKeepIt) {
    const ScratchFolder f;
    for (const AxisNames names : {k_xyz, k_patient})
        for (const char* name : {"v.nrrd", "v.mhd"}) {
            const Volume original = part(names);
            write_volume(original, f / name);
            const Volume read = open_volume((f / name).string());
            EXPECT_EQ(names_of(read), names) << name;
            expect_same_geometry(original.geometry(), read.geometry(), 1e-9);
            expect_same_voxels(original, read);
        }
    const LabelVolume labels{part(k_xyz).geometry(), std::make_shared<std::vector<std::uint32_t>>(60, 1u)};
    write_labels(labels, f / "l.nrrd");
    EXPECT_EQ(names_of(open_volume((f / "l.nrrd").string())), k_xyz);
}
