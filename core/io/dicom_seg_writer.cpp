#include "core/io/dicom_seg_writer.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/error.h"

namespace lacuna {

namespace {

using namespace dicom;

void need(const OFCondition& done, const std::string& what) {
    if (done.bad())
        throw Error(Errc::unsupported,
                    "The DICOM segmentation cannot be made: " + what + " was refused (" + done.text() + ").");
}

const char* meaning_of(const std::string& type) {
    if (type == "void") return "Void";
    return type == "inclusion" ? "Inclusion" : "Part";
}

class SegmentationWriter {
public:
    SegmentationWriter(const MaskVolume& part, const LabelVolume& labels, const DicomSource& source,
                       const DicomProvenance& made)
        : part_(part), labels_(labels), source_(source), made_(made) {}

    void write(const std::vector<DicomSegment>& segments, const std::filesystem::path& target, const JobContext& job) {
        const glm::ivec3 n = labels_.geometry.size;
        check_size(segments, target, job);
        copy_context(source_, made_, context_);
        create(n);
        add_shared_groups();
        frame_.resize(std::size_t(n.x) * std::size_t(n.y));
        for (std::size_t s = 0; s < segments.size(); ++s) {
            add_segment(segments[s], s == 0);
            job.checkpoint(s + 1, segments.size());
        }
        DcmDataset set;
        need(document_->writeDataset(set), "the whole");
        refer_to_source(source_, set);
        fix_identity(made_, "seg", context_, set);
        save_dataset(set, target);
    }

private:
    /// Pixel data state their length in 32 bits, an even one below the mark of "undefined" (PS3.5, 7.1); their rows and
    /// columns in 16. What is larger is refused before a frame is made: DCMTK would cut the numbers down in silence.
    void check_size(const std::vector<DicomSegment>& segments, const std::filesystem::path& target,
                    const JobContext& job) const {
        const glm::ivec3 n = labels_.geometry.size;
        if (n.x > 65535 || n.y > 65535)
            throw Error(Errc::unsupported, fmt::format("Cannot write {}: frames of {} x {} are larger than a DICOM "
                                                       "segmentation's 65535 rows and columns; inspect a part of it.",
                                                       target.string(), n.x, n.y));
        constexpr std::uint64_t k_most_bits = 0xFFFFFFFEull * 8;
        const std::uint64_t most = k_most_bits / (std::uint64_t(n.x) * std::uint64_t(n.y));
        std::uint64_t planes = 0;
        for (const DicomSegment& s : segments) planes += std::uint64_t(std::max(1, s.last.z - s.first.z + 1));
        if (planes <= most) return;
        std::uint64_t frames = 0;
        for (std::size_t k = 0; k < segments.size(); ++k) {
            std::uint64_t own = 0;
            for (int z = segments[k].first.z; z <= segments[k].last.z; ++z) {
                own += has_voxels(segments[k], k == 0, z);
                if (frames + own <= most) continue;
                throw Error(Errc::unsupported,
                            fmt::format("Cannot write {}: its {} segments take more than the 4 GiB of frames that a "
                                        "DICOM segmentation holds; inspect a part of the volume, or fewer defects.",
                                        target.string(), segments.size()));
            }
            frames += std::max<std::uint64_t>(1, own);
            job.check();
        }
    }

    bool is_in(const DicomSegment& segment, bool is_part, int x, int y, int z) const {
        const std::uint32_t id = is_part ? part_(x, y, z) : labels_(x, y, z);
        return id != 0 && std::binary_search(segment.ids.begin(), segment.ids.end(), id);
    }

    bool has_voxels(const DicomSegment& segment, bool is_part, int z) const {
        for (int y = segment.first.y; y <= segment.last.y; ++y)
            for (int x = segment.first.x; x <= segment.last.x; ++x)
                if (is_in(segment, is_part, x, y, z)) return true;
        return false;
    }

    void create(const glm::ivec3& n) {
        const IODGeneralEquipmentModule::EquipmentInfo equipment(made_.software.c_str(), made_.software.c_str(),
                                                                 made_.version.c_str(), made_.version.c_str());
        const ContentIdentificationMacro content("1", "DEFECTS", "Defects found in a part", made_.software.c_str());
        DcmSegmentation* made = nullptr;
        need(DcmSegmentation::createBinarySegmentation(made, Uint16(n.y), Uint16(n.x), equipment, content),
             "its frame size");
        document_.reset(made);
        need(document_->importFromSourceImage(context_), "the source's patient or study");
        need(document_->getSeries().setSeriesNumber("901"), "the series number");
        need(document_->getSeries().setSeriesInstanceUID(uid_for(made_, "seg-series").c_str()), "the series UID");
        const OFString organization(uid_for(made_, "seg-dimensions").c_str());
        IODMultiframeDimensionModule& dimensions = document_->getDimensions();
        need(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, organization, DCM_SegmentIdentificationSequence,
                                          "Segment"),
             "a dimension");
        need(
            dimensions.addDimensionIndex(DCM_ImagePositionPatient, organization, DCM_PlanePositionSequence, "Position"),
            "a dimension");
    }

    void add_shared_groups() {
        const GridGeometry& g = labels_.geometry;
        FGPixelMeasures measures;
        need(measures.setPixelSpacing((decimal(g.spacing.y) + "\\" + decimal(g.spacing.x)).c_str()), "the spacing");
        need(measures.setSliceThickness(decimal(g.spacing.z).c_str()), "the slice thickness");
        need(measures.setSpacingBetweenSlices(decimal(g.spacing.z).c_str()), "the slice spacing");
        need(document_->addForAllFrames(measures), "the spacing");
        FGPlaneOrientationPatient axes;
        const auto x = g.direction[0], y = g.direction[1];
        need(axes.setImageOrientationPatient(decimal(x.x).c_str(), decimal(x.y).c_str(), decimal(x.z).c_str(),
                                             decimal(y.x).c_str(), decimal(y.y).c_str(), decimal(y.z).c_str()),
             "the orientation");
        need(document_->addForAllFrames(axes), "the orientation");
    }

    void add_segment(const DicomSegment& segment, bool is_part) {
        const CodeSequenceMacro category("260787004", "SCT", "Physical object");
        const CodeSequenceMacro type(segment.type.c_str(), "99LACUNA", meaning_of(segment.type));
        DcmSegment* made = nullptr;
        need(DcmSegment::create(made, segment.label.c_str(), category, type, DcmSegTypes::SAT_AUTOMATIC,
                                made_.software.c_str()),
             "segment " + segment.label);
        if (!segment.description.empty()) need(made->setSegmentDescription(segment.description.c_str()), "a text");
        if (!segment.tracking_uid.empty()) {
            need(made->setTrackingID(segment.label.c_str()), "a tracking id");
            need(made->setTrackingUID(segment.tracking_uid.c_str()), "a tracking UID");
        }
        Uint16 number = 0;
        need(document_->addSegment(made, number), "segment " + segment.label);
        bool any = false;
        for (int z = segment.first.z; z <= segment.last.z; ++z)
            any = add_frame(segment, is_part, number, z, false) || any;
        // A segment needs a frame, even where nothing is in it.
        if (!any) add_frame(segment, is_part, number, segment.first.z, true);
    }

    /// @return false, and nothing is added, for a plane without a voxel of the segment (unless `empty_too`)
    bool add_frame(const DicomSegment& segment, bool is_part, Uint16 number, int z, bool empty_too) {
        const GridGeometry& grid = labels_.geometry;
        std::fill(frame_.begin(), frame_.end(), Uint8(0));
        bool any = false;
        for (int y = segment.first.y; y <= segment.last.y; ++y)
            for (int x = segment.first.x; x <= segment.last.x; ++x) {
                if (!is_in(segment, is_part, x, y, z)) continue;
                frame_[std::size_t(y) * std::size_t(grid.size.x) + std::size_t(x)] = 1;
                any = true;
            }
        if (!any && !empty_too) return false;
        FGPlanePosPatient position;
        const glm::dvec3 at = grid.voxel_to_mm({0, 0, z});
        need(position.setImagePositionPatient(decimal(at.x).c_str(), decimal(at.y).c_str(), decimal(at.z).c_str()),
             "a position");
        FGFrameContent content;
        need(content.setDimensionIndexValues(number, 0), "a dimension index");
        need(content.setDimensionIndexValues(Uint32(z + 1), 1), "a dimension index");
        const std::unique_ptr<FGDerivationImage> derivation(derived_from(z));
        OFVector<FGBase*> groups;
        groups.push_back(&position);
        groups.push_back(&content);
        if (derivation) groups.push_back(derivation.get());
        need(document_->addFrame(frame_.data(), number, groups), "a frame");
        return true;
    }

    /// The source image nearest to a plane.
    FGDerivationImage* derived_from(int z) const {
        const auto nearest = std::min_element(
            source_.images.begin(), source_.images.end(),
            [z](const auto& a, const auto& b) { return std::abs(a.plane - z) < std::abs(b.plane - z); });
        if (nearest->sop_class_uid.empty() || nearest->sop_instance_uid.empty()) return nullptr;
        OFVector<ImageSOPInstanceReferenceMacro> images;
        ImageSOPInstanceReferenceMacro image;
        need(image.setReferencedSOPClassUID(nearest->sop_class_uid.c_str()), "the source's class");
        need(image.setReferencedSOPInstanceUID(nearest->sop_instance_uid.c_str()), "the source's UID");
        if (nearest->frame > 0 && nearest->frame <= 65535)
            need(image.addReferencedFrameNumber(Uint16(nearest->frame)), "the source's frame");
        images.push_back(image);
        return FGDerivationImage::createMinimal(
            images, "Segmentation", CodeSequenceMacro("113076", "DCM", "Segmentation"),
            CodeSequenceMacro("121322", "DCM", "Source image for image processing operation"));
    }

    const MaskVolume& part_;
    const LabelVolume& labels_;
    const DicomSource& source_;
    const DicomProvenance& made_;
    DcmDataset context_;
    std::unique_ptr<DcmSegmentation> document_;
    std::vector<Uint8> frame_;
};

}  // namespace

void write_dicom_segmentation(const MaskVolume& part, const LabelVolume& labels,
                              const std::vector<DicomSegment>& segments, const DicomSource& source,
                              const DicomProvenance& made, const std::filesystem::path& target, const JobContext& job) {
    if (segments.empty() || segments.size() > 65535)
        throw Error(Errc::unsupported, "A DICOM segmentation holds 1 to 65535 segments.");
    SegmentationWriter(part, labels, source, made).write(segments, target, job);
}

}  // namespace lacuna
