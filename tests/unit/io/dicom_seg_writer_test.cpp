#include "core/io/dicom_seg_writer.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/volume_reader.h"
#include "tests/support/dicom_zoo.h"

namespace lacuna {
namespace {

using test::TemporaryFolder;
using test::write_zoo_slice;
using test::ZooSlice;

struct Labelled {
    MaskVolume part;
    LabelVolume labels;

    explicit Labelled(const glm::ivec3& size) {
        part.geometry.size = labels.geometry.size = size;
        const auto voxels = std::size_t(part.geometry.voxel_count());
        part.labels = std::make_shared<std::vector<std::uint8_t>>(voxels, std::uint8_t(1));
        labels.labels = std::make_shared<std::vector<std::uint32_t>>(voxels, 1u);
    }

    std::vector<DicomSegment> segments(std::size_t count) const {
        const DicomSegment one{"Defect", "void", "", {1}, {0, 0, 0}, part.geometry.size - 1, ""};
        return std::vector<DicomSegment>(count, one);
    }
};

void expect_refused(const Labelled& labelled, std::size_t segments, const std::string& said) {
    TemporaryFolder folder;
    std::filesystem::create_directories(folder / "in");
    write_zoo_slice(folder / "in" / "1.dcm", ZooSlice{});
    const auto source = find_dicom_source((folder / "in").string(), {});
    ASSERT_NE(source, nullptr);
    try {
        write_dicom_segmentation(labelled.part, labelled.labels, labelled.segments(segments), *source,
                                 {"seed", "Lacuna", "0", "part"}, folder / "seg.dcm");
        ADD_FAILURE() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::unsupported);
        EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "seg.dcm"));
}

TEST(DicomSegmentation, MoreFramesThanPixelDataCanHoldAreRefusedBeforeOneIsMade) {
    // A frame is 128 KiB, eight a segment: 4096 of them are 4 GiB.
    expect_refused(Labelled({1024, 1024, 8}), 4096, "4 GiB");
}

TEST(DicomSegmentation, FramesWiderThanDicomCountsAreRefused) {
    expect_refused(Labelled({65537, 1, 1}), 1, "65535 rows and columns");
    expect_refused(Labelled({1, 65537, 1}), 1, "65535 rows and columns");
}

}  // namespace
}  // namespace lacuna
