#include <algorithm>

#include "core/io/dicom_header.h"
#include "core/io/dicom_tags.h"

// The geometry and value scale of each frame: plain images carry them at the top of the data set, enhanced
// multi-frame images in functional groups (PS3.3 C.7.6.16), RT dose grids as one position and offsets (C.8.8.3).
namespace lacuna::dicom {

namespace {

constexpr double k_orthonormal_tolerance = 1e-4;

std::optional<glm::dvec3> position_in(DcmItem& item) {
    const auto xyz = numbers_of(item, DCM_ImagePositionPatient);
    if (xyz.empty()) return std::nullopt;
    if (xyz.size() != 3) throw std::runtime_error(tag_text(DCM_ImagePositionPatient) + " has not three values");
    return glm::dvec3(xyz[0], xyz[1], xyz[2]);
}

/// Sets the frame's axes, made exactly orthonormal; a deviation worse than rounding is refused.
void orientation_in(DcmItem& item, Frame& frame) {
    const auto six = numbers_of(item, DCM_ImageOrientationPatient);
    if (six.empty()) return;
    if (six.size() != 6) throw std::runtime_error(tag_text(DCM_ImageOrientationPatient) + " has not six values");
    const glm::dvec3 row(six[0], six[1], six[2]), column(six[3], six[4], six[5]);
    const double worst =
        std::max({std::abs(glm::length(row) - 1), std::abs(glm::length(column) - 1), std::abs(glm::dot(row, column))});
    if (!(worst <= k_orthonormal_tolerance))
        throw std::runtime_error(tag_text(DCM_ImageOrientationPatient) + " holds no two perpendicular unit vectors");
    frame.row = glm::normalize(row);
    frame.column = glm::normalize(column - glm::dot(column, frame.row) * frame.row);
    frame.has_orientation = true;
}

bool spacing_from(DcmItem& item, const DcmTagKey& tag, Frame& frame) {
    const auto two = numbers_of(item, tag);
    if (two.empty()) return false;
    if (two.size() != 2) throw std::runtime_error(tag_text(tag) + " has not two values");
    if (!(two[0] > 0 && two[1] > 0)) throw std::runtime_error(tag_text(tag) + " is not positive");
    frame.spacing = glm::dvec2(two[1], two[0]);  // the first value is the distance between rows
    return true;
}

void measures_in(DcmItem& item, Frame& frame) {
    spacing_from(item, DCM_PixelSpacing, frame);
    if (const auto value = number_of(item, DCM_SliceThickness)) {
        if (*value < 0) throw std::runtime_error(tag_text(DCM_SliceThickness) + " is negative");
        frame.thickness_mm = *value;
    }
    if (const auto value = number_of(item, DCM_SpacingBetweenSlices)) frame.step_mm = std::abs(*value);
}

void rescale_in(DcmItem& item, Frame& frame) {
    const auto slope = number_of(item, DCM_RescaleSlope), intercept = number_of(item, DCM_RescaleIntercept);
    if (!slope && !intercept) return;
    if (slope && *slope == 0) throw std::runtime_error(tag_text(DCM_RescaleSlope) + " is zero");
    frame.slope = slope.value_or(1);
    frame.intercept = intercept.value_or(0);
    frame.has_rescale = true;
    frame.rescale_type = text_of(item, DCM_RescaleType);
}

/// The window is only one way to show the image: a slip in it keeps nobody from the voxels.
void window_in(DcmItem& item, Frame& frame) {
    const auto center = readable_number_of(item, DCM_WindowCenter), width = readable_number_of(item, DCM_WindowWidth);
    if (!center || !width) return;
    frame.window_center = center;
    frame.window_width = width;
}

bool names_localizer(DcmItem& item, const DcmTagKey& tag) {
    for (unsigned long i = 0; i < 8; ++i) {
        const std::string value = text_of(item, tag, i);
        if (value == "LOCALIZER" || value == "SCOUT") return true;
    }
    return false;
}

void acquisition_in(DcmItem& item, std::initializer_list<DcmTagKey> tags, Frame& frame) {
    for (const DcmTagKey& tag : tags)
        if (const std::string value = text_of(item, tag); !value.empty())
            frame.acquisition += std::to_string(tag.getElement()) + "=" + value + ";";
}

/// Everything a frame may take from the top of the data set.
Frame plain_frame(DcmItem& data) {
    Frame frame;
    frame.position = position_in(data);
    orientation_in(data, frame);
    measures_in(data, frame);
    if (!frame.spacing && !spacing_from(data, DCM_ImagerPixelSpacing, frame))
        spacing_from(data, DCM_NominalScannedPixelSpacing, frame);
    rescale_in(data, frame);
    if (const auto scaling = number_of(data, DCM_DoseGridScaling)) {
        if (!(*scaling > 0)) throw std::runtime_error(tag_text(DCM_DoseGridScaling) + " is not positive");
        frame.slope = *scaling;
        frame.rescale_type = text_of(data, DCM_DoseUnits);
    }
    window_in(data, frame);
    acquisition_in(data, {DCM_AcquisitionNumber, DCM_TemporalPositionIdentifier, DCM_EchoTime, DCM_DiffusionBValue},
                   frame);
    frame.instance = readable_integer_of(data, DCM_InstanceNumber);
    frame.localizer = names_localizer(data, DCM_ImageType);
    return frame;
}

/// What one functional group item (shared or of a frame) says, written over what is known.
void apply_groups(DcmItem& groups, Frame& frame) {
    if (DcmItem* at = item_of(groups, DCM_PlanePositionSequence)) frame.position = position_in(*at);
    if (DcmItem* at = item_of(groups, DCM_PlaneOrientationSequence)) orientation_in(*at, frame);
    if (DcmItem* at = item_of(groups, DCM_PixelMeasuresSequence)) measures_in(*at, frame);
    if (DcmItem* at = item_of(groups, DCM_PixelValueTransformationSequence)) rescale_in(*at, frame);
    if (DcmItem* at = item_of(groups, DCM_FrameVOILUTSequence)) window_in(*at, frame);
    if (DcmItem* at = item_of(groups, DCM_FrameContentSequence))
        acquisition_in(*at, {DCM_FrameAcquisitionNumber, DCM_TemporalPositionIndex}, frame);
    if (DcmItem* at = item_of(groups, DCM_SegmentIdentificationSequence))
        acquisition_in(*at, {DCM_ReferencedSegmentNumber}, frame);
    if (DcmItem* at = item_of(groups, DCM_MREchoSequence)) acquisition_in(*at, {DCM_EffectiveEchoTime}, frame);
    if (DcmItem* at = item_of(groups, DCM_MRDiffusionSequence)) acquisition_in(*at, {DCM_DiffusionBValue}, frame);
    for (const DcmTagKey& type : {DCM_CTImageFrameTypeSequence, DCM_MRImageFrameTypeSequence})
        if (DcmItem* at = item_of(groups, type)) frame.localizer |= names_localizer(*at, DCM_FrameType);
}

void fill_enhanced(DcmItem& data, const Frame& top, File& file, int count) {
    Frame shared = top;
    if (DcmItem* groups = item_of(data, DCM_SharedFunctionalGroupsSequence)) apply_groups(*groups, shared);
    DcmSequenceOfItems* each = nullptr;
    data.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, each);
    if (each && each->card() < (unsigned long)(count))
        throw std::runtime_error(tag_text(DCM_PerFrameFunctionalGroupsSequence) + " describes " +
                                 std::to_string(each->card()) + " of " + std::to_string(count) + " frames");
    for (int f = 0; f < count; ++f) {
        Frame frame = shared;
        frame.number = f;
        frame.instance.reset();
        if (each) apply_groups(*each->getItem((unsigned long)(f)), frame);
        file.frames.push_back(std::move(frame));
    }
}

void fill_stack(DcmItem& data, const Frame& top, File& file, int count) {
    const auto offsets = numbers_of(data, DCM_GridFrameOffsetVector);
    const bool has_offsets = offsets.size() == std::size_t(count);
    const double step = top.step_mm > 0 ? top.step_mm : top.thickness_mm;
    for (int f = 0; f < count; ++f) {
        Frame frame = top;
        frame.number = f;
        if (count > 1 && frame.position) {
            const double along = has_offsets ? offsets[std::size_t(f)] - offsets[0] : step * f;
            if (has_offsets || step > 0)
                *frame.position += along * frame.normal();
            else
                frame.position.reset();
        }
        file.frames.push_back(std::move(frame));
    }
}

}  // namespace

void fill_frames(DcmItem& data, File& file, int count) {
    const Frame top = plain_frame(data);
    if (data.tagExists(DCM_SharedFunctionalGroupsSequence) || data.tagExists(DCM_PerFrameFunctionalGroupsSequence))
        fill_enhanced(data, top, file, count);
    else
        fill_stack(data, top, file, count);
}

}  // namespace lacuna::dicom
