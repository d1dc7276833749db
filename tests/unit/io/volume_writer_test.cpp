#include "core/io/volume_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <sys/resource.h>

#include <csignal>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/dicom_reader.h"
#include "core/io/dicom_writer.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

constexpr VoxelType k_types[] = {VoxelType::u8, VoxelType::i8, VoxelType::u16, VoxelType::i16, VoxelType::f32};

/// Limits the size of files this process writes, as a full disk would.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit now{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &now);
    }
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

/// Noise that no compressor shortens.
Volume noise_volume(glm::ivec3 size) {
    return make_volume<std::uint16_t>(oblique_grid(size), [](std::span<std::uint16_t> voxels) {
        std::uint64_t state = 1;
        for (auto& v : voxels) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            v = std::uint16_t(state >> 40);
        }
    });
}

class EveryFormat : public testing::TestWithParam<const char*> {};

}  // namespace

// What no DICOM element can hold is refused before a file is begun; nobody touches the voxels, so they take no memory.
TEST(WriteDicomSeries, RefusesSlicesThatNoElementHolds) {
    const ScratchFolder folder;
    for (const glm::ivec3 size : {glm::ivec3(65536, 1, 1), glm::ivec3(65535, 32769, 1)}) {
        GridGeometry grid;
        grid.size = size;
        const Volume volume(grid, VoxelType::u8, VoxelBuffer(std::size_t(grid.voxel_count())));
        try {
            write_dicom_series(volume, folder / "series");
            FAIL() << size.x << " x " << size.y;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::unsupported) << error.what();
            EXPECT_FALSE(std::filesystem::exists(folder / "series"));
        }
    }
}

TEST_P(EveryFormat, KeepsValuesTypeAndObliqueGeometry) {
    const ScratchFolder folder;
    for (const VoxelType type : k_types)
        for (const glm::ivec3 size : {glm::ivec3(6, 5, 7), glm::ivec3(1, 1, 4)}) {
            const Volume original = extreme_volume(type, oblique_grid(size));
            const auto file = folder / GetParam();
            write_volume(original, file);
            const Volume read = open_volume(file.string());
            SCOPED_TRACE(std::string(name_of(type)));
            expect_same_voxels(original, read);
            // NIfTI stores 32 bit floats: 100 mm to within 1e-5.
            const bool nifti = std::string(GetParam()).find(".nii") != std::string::npos;
            expect_same_geometry(original.geometry(), read.geometry(), nifti ? 5e-5 : 1e-9);
        }
}

TEST_P(EveryFormat, KeepsALeftHandedGridInPlace) {
    const ScratchFolder folder;
    GridGeometry g = oblique_grid({4, 5, 3});
    g.direction[2] = -g.direction[2];
    const Volume original = extreme_volume<std::int16_t>(g);
    write_volume(original, folder / GetParam());
    const Volume read = open_volume((folder / GetParam()).string());
    expect_same_voxels(original, read);
    expect_same_geometry(g, read.geometry(), 5e-5);
}

TEST_P(EveryFormat, AFullDiskLeavesNothingBehind) {
    const ScratchFolder folder;
    const Volume volume = noise_volume({64, 64, 32});
    const FileSizeLimit limit(100000);
    expect_error(Errc::io, {"Cannot write", "v."}, [&] { write_volume(volume, folder / GetParam()); });
    EXPECT_EQ(folder.entries(), 0u);
}

TEST_P(EveryFormat, AStoppedJobLeavesNothingBehind) {
    const ScratchFolder folder;
    std::stop_source stop;
    stop.request_stop();
    expect_error(Errc::cancelled, {}, [&] {
        write_volume(noise_volume({9, 9, 9}), folder / GetParam(), {stop.get_token(), nullptr});
    });
    EXPECT_EQ(folder.entries(), 0u);
}

TEST_P(EveryFormat, AMissingFolderIsNamed) {
    const ScratchFolder folder;
    expect_error(Errc::io, {"none"}, [&] { write_volume(noise_volume({2, 2, 2}), folder / "none" / GetParam()); });
}

TEST_P(EveryFormat, BytesDoNotDependOnTheNumberOfThreads) {
    const ScratchFolder folder;
    const Volume volume = noise_volume({128, 128, 100});  // several chunks
    set_thread_count(1);
    write_volume(volume, folder / GetParam());
    const std::string one = get_file(folder / GetParam());
    set_thread_count(5);
    write_volume(volume, folder / GetParam());
    set_thread_count(0);
    EXPECT_TRUE(one == get_file(folder / GetParam()));
    expect_same_voxels(volume, open_volume((folder / GetParam()).string()));
}

INSTANTIATE_TEST_SUITE_P(Written, EveryFormat, testing::Values("v.nrrd", "v.mhd", "v.nii", "v.nii.gz", "v.raw"));

TEST(VolumeWriter, AnUnknownEndingListsTheKnown) {
    const ScratchFolder folder;
    expect_error(Errc::bad_usage, {"v.xyz", ".nrrd", ".nii.gz"}, [&] {
        write_volume(noise_volume({2, 2, 2}), folder / "v.xyz");
    });
    expect_error(Errc::bad_input, {"no volume"}, [&] { write_volume(Volume(), folder / "v.nrrd"); });
}

TEST(VolumeWriter, AnExistingFileIsReplacedOrKeptWhole) {
    const ScratchFolder folder;
    const Volume first = extreme_volume<std::uint8_t>(oblique_grid({3, 3, 3}));
    write_volume(first, folder / "v.nrrd");
    {
        const FileSizeLimit limit(1000);
        expect_error(Errc::io, {}, [&] { write_volume(noise_volume({32, 32, 32}), folder / "v.nrrd"); });
    }
    expect_same_voxels(first, open_volume((folder / "v.nrrd").string()));
}

TEST(VolumeWriter, APairNeverReplacesAFileThatIsNotItsOwn) {
    const ScratchFolder folder;
    put_file(folder / "scan.raw", "the scanner's own voxels");
    expect_error(Errc::io, {"scan.mhd", "scan.raw"}, [&] {
        write_volume(noise_volume({9, 9, 9}), folder / "scan.mhd");
    });
    EXPECT_EQ(get_file(folder / "scan.raw"), "the scanner's own voxels");
    put_file(folder / "notes.dat", "notes");
    expect_error(Errc::io, {"notes.raw", "notes.dat"}, [&] {
        write_volume(noise_volume({9, 9, 9}), folder / "notes.raw");
    });
    EXPECT_EQ(get_file(folder / "notes.dat"), "notes");
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(LabelWriter, UsesTheSmallestTypeThatHoldsEveryId) {
    const ScratchFolder folder;
    LabelVolume labels{oblique_grid({2, 2, 1}), std::make_shared<std::vector<std::uint32_t>>(4, 0u)};
    const auto type_with = [&](std::uint32_t largest) {
        labels.labels->back() = largest;
        write_labels(labels, folder / "l.nrrd");
        const std::string text = get_file(folder / "l.nrrd");
        const auto at = text.find("type: ") + 6;
        EXPECT_EQ(open_volume((folder / "l.nrrd").string()).value(1, 1, 0), largest);
        return text.substr(at, text.find('\n', at) - at);
    };
    EXPECT_EQ(type_with(0), "uint8");
    EXPECT_EQ(type_with(255), "uint8");
    EXPECT_EQ(type_with(256), "uint16");
    EXPECT_EQ(type_with(65536), "uint32");
    expect_same_geometry(labels.geometry, open_volume((folder / "l.nrrd").string()).geometry(), 1e-9);
    expect_error(Errc::bad_usage, {".nrrd"}, [&] { write_labels(labels, folder / "l.mhd"); });
    labels.labels->pop_back();
    expect_error(Errc::bad_input, {"fit"}, [&] { write_labels(labels, folder / "l.nrrd"); });
}

namespace {

std::string text_of(DcmDataset& set, const DcmTagKey& key) {
    OFString value;
    set.findAndGetOFStringArray(key, value);
    return value.c_str();
}

}  // namespace

TEST(DicomWriter, SlicesCarryPositionOrientationAndStoredValues) {
    const ScratchFolder folder;
    Volume volume = extreme_volume<std::int16_t>(oblique_grid({4, 3, 5}));
    volume.unit = "HU";
    write_volume(volume, folder / "series");
    std::set<std::string> instances, series;
    for (int z = 0; z < 5; ++z) {
        DcmFileFormat file;
        const auto path = folder / ("series/slice0000" + std::to_string(z + 1) + ".dcm");
        ASSERT_TRUE(file.loadFile(path.c_str()).good());
        EXPECT_EQ(file.getDataset()->getOriginalXfer(), EXS_LittleEndianExplicit);
        DcmDataset& set = *file.getDataset();
        instances.insert(text_of(set, DCM_SOPInstanceUID));
        series.insert(text_of(set, DCM_SeriesInstanceUID));
        EXPECT_EQ(text_of(set, DCM_SOPClassUID), UID_CTImageStorage);
        EXPECT_EQ(text_of(set, DCM_PixelSpacing), "1.25\\0.7") << "rows first";
        const glm::dvec3 at = volume.geometry().voxel_to_mm({0, 0, z});
        for (int a = 0; a < 3; ++a) {
            Float64 position = 0;
            ASSERT_TRUE(
                set.findAndGetFloat64(DCM_ImagePositionPatient, position, static_cast<unsigned long>(a)).good());
            EXPECT_NEAR(position, at[a], 1e-9);
        }
        const Uint16* words = nullptr;
        unsigned long count = 0;
        ASSERT_TRUE(set.findAndGetUint16Array(DCM_PixelData, words, &count).good());
        ASSERT_EQ(count, 12u);
        for (int i = 0; i < 12; ++i) EXPECT_EQ(Sint16(words[i]), volume.value(i % 4, i / 4, z));
    }
    EXPECT_EQ(instances.size(), 5u) << "every slice has its own UID";
    EXPECT_EQ(series.size(), 1u);
}

TEST(DicomWriter, ASeriesReadsBackInPlace) {
    const ScratchFolder folder;
    for (const VoxelType type : {VoxelType::u8, VoxelType::i8, VoxelType::u16, VoxelType::i16}) {
        const Volume volume = extreme_volume(type, oblique_grid({4, 3, 5}));
        const auto target = folder / ("series_" + std::string(name_of(type)));
        write_volume(volume, target);
        const Volume read = open_volume(target.string());
        expect_same_geometry(volume.geometry(), read.geometry(), 1e-6);
        for (int z = 0; z < 5; ++z)
            for (int i = 0; i < 12; ++i) ASSERT_EQ(read.value(i % 4, i / 4, z), volume.value(i % 4, i / 4, z));
        EXPECT_EQ(list_series(target.string()).size(), 1u);
    }
}

TEST(DicomWriter, WholeFloatsAreStoredAndFractionsRefused) {
    const ScratchFolder folder;
    const auto floats = [](std::initializer_list<float> values) {
        GridGeometry g;
        g.size = {int(values.size()), 1, 1};
        return make_volume<float>(g, [&](std::span<float> v) { std::copy(values.begin(), values.end(), v.begin()); });
    };
    write_volume(floats({40000, 100000}), folder / "offset");
    const Volume read = open_volume((folder / "offset").string());
    EXPECT_EQ(read.value(0, 0, 0), 40000);
    EXPECT_EQ(read.value(1, 0, 0), 100000);
    expect_error(Errc::unsupported, {"fractions", ".nrrd"}, [&] { write_volume(floats({0.5f, 1}), folder / "a"); });
    expect_error(Errc::unsupported, {"NaN"}, [&] { write_volume(floats({NAN, 1}), folder / "b"); });
    expect_error(Errc::unsupported, {"16 bits"}, [&] { write_volume(floats({0, 65536}), folder / "c"); });
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(DicomWriter, NeverMixesWithOtherFilesAndLeavesNothingOnFailure) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "full");
    put_file(folder / "full/other.dcm", "x");
    expect_error(Errc::io, {"not empty"}, [&] { write_volume(noise_volume({4, 4, 4}), folder / "full"); });
    std::filesystem::create_directory(folder / "empty");
    EXPECT_NO_THROW(write_volume(noise_volume({4, 4, 4}), folder / "empty"));
    {
        const FileSizeLimit limit(3000);
        expect_error(Errc::io, {"nothing was written"}, [&] {
            write_volume(noise_volume({64, 64, 2}), folder / "series");
        });
    }
    std::stop_source stop;
    stop.request_stop();
    expect_error(Errc::cancelled, {}, [&] {
        write_volume(noise_volume({4, 4, 4}), folder / "series/", {stop.get_token(), nullptr});
    });
    EXPECT_EQ(folder.entries(), 2u);
}
