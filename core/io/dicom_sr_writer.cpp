#include "core/io/dicom_sr_writer.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmsr/cmr/tid1500.h>
#include <dcmtk/dcmsr/dsrdoc.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace lacuna {

namespace {

using namespace dicom;
using Measurements = TID1500_MeasurementReport::TID1411_Measurements;

void need(const OFCondition& done, const std::string& what) {
    if (done.bad())
        throw Error(Errc::unsupported,
                    "The DICOM report cannot be made: " + what + " was refused (" + done.text() + ").");
}

DSRCodedEntryValue own_code(const std::string& name) {
    // A code value of at most 16 characters (VR SH) that follows from the name.
    std::string value;
    for (const char c : name)
        if (value.size() < 16 && c != ' ' && c > ' ' && c < 127) value += c;
    return DSRCodedEntryValue(value.c_str(), "99LACUNA", name.c_str());
}

CID7469_GenericIntensityAndSizeMeasurements concept_of(DicomQuantity quantity) {
    using Known = CID7469_GenericIntensityAndSizeMeasurements;
    switch (quantity) {
        case DicomQuantity::volume_mm3:
            return Known::Volume;
        case DicomQuantity::diameter_mm:
            return Known::Diameter;
        case DicomQuantity::area_mm2:
            return Known::Area;
        case DicomQuantity::equivalent_diameter_mm:
            return own_code("Equivalent diameter");
        case DicomQuantity::surface_distance_mm:
            return own_code("Surface distance");
        default:
            return own_code("Mean value");
    }
}

CID7181_AbstractMultiDimensionalImageModelComponentUnits unit_of(DicomQuantity quantity, const std::string& unit) {
    using Units = CID7181_AbstractMultiDimensionalImageModelComponentUnits;
    switch (quantity) {
        case DicomQuantity::volume_mm3:
            return Units::CubicMillimeter;
        case DicomQuantity::area_mm2:
            return Units::SquareMillimeter;
        case DicomQuantity::mean_value:
            return unit == "HU" ? Units::HounsfieldUnit : Units::NoUnits;
        default:
            return Units::Millimeter;
    }
}

/// Texts of the report and of the source stand in one object and so in one character set: UTF-8, where the source's can
/// be converted; else they stay the source's, and the report's are cut down to ASCII.
class Texts {
public:
    explicit Texts(DcmDataset& context) {
        if (!context.containsExtendedCharacters(OFTrue)) return;  // ASCII is UTF-8 already
        DcmDataset converted(context);
        if (converted.convertToUTF8().bad()) {
            utf8_ = false;
            return;
        }
        context = converted;
    }

    std::string operator()(const std::string& text) {
        const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 128; };
        if (std::all_of(text.begin(), text.end(), is_ascii)) return text;
        beyond_ascii_ = true;
        if (utf8_) return text;
        std::string plain;
        for (const char c : text)
            if (is_ascii(c))
                plain += c;
            else if ((static_cast<unsigned char>(c) & 0xc0) != 0x80)  // once a character
                plain += '?';
        return plain;
    }

    /// What the object is to name as its own; empty: ASCII.
    std::string character_set(DcmDataset& context) const {
        if (utf8_ && beyond_ascii_) return "ISO_IR 192";
        OFString all;
        (void)context.findAndGetOFStringArray(DCM_SpecificCharacterSet, all);
        return {all.c_str(), all.size()};
    }

private:
    bool utf8_ = true, beyond_ascii_ = false;
};

void add_group(TID1500_MeasurementReport& report, const DicomMeasurementGroup& group, const std::string& unit,
               const DicomSource& source, const std::string& seg_uid, Texts& texts) {
    need(report.addVolumetricROIMeasurements(), "a measurement group");
    Measurements& roi = report.getVolumetricROIMeasurements();
    need(roi.setTrackingIdentifier(group.label.c_str()), "a tracking id");
    need(roi.setTrackingUniqueIdentifier(group.tracking_uid.c_str()), "a tracking UID");
    need(roi.setFinding(own_code(group.type)), "a finding");
    DSRImageReferenceValue segment(UID_SegmentationStorage, seg_uid.c_str());
    segment.getSegmentList().addItem(Uint16(group.segment));
    need(roi.setReferencedSegment(segment), "a segment");
    need(roi.setSourceSeriesForSegmentation(source.series_uid.c_str()), "the source series");
    for (const DicomMeasurement& m : group.measurements) {
        if (!std::isfinite(m.value)) continue;
        const Measurements::MeasurementValue value(decimal(m.value).c_str(), unit_of(m.quantity, unit));
        need(roi.addMeasurement(concept_of(m.quantity), value), "a measurement");
    }
    for (const auto& [name, text] : group.said)
        need(roi.addQualitativeEvaluation(own_code(name), texts(text).c_str()), "an evaluation");
}

void add_evidence(DSRDocument& document, const DicomSource& source, const DicomProvenance& made,
                  const std::string& study_uid, const std::string& seg_uid) {
    DSRSOPInstanceReferenceList& evidence = document.getCurrentRequestedProcedureEvidence();
    evidence.addItem(study_uid.c_str(), uid_for(made, "seg-series").c_str(), UID_SegmentationStorage, seg_uid.c_str());
    for (const DicomSourceImage& image : source.images)
        if (!image.sop_class_uid.empty() && !image.sop_instance_uid.empty())
            evidence.addItem(study_uid.c_str(), source.series_uid.c_str(), image.sop_class_uid.c_str(),
                             image.sop_instance_uid.c_str());
}

}  // namespace

void write_dicom_report(const std::vector<DicomMeasurementGroup>& groups,
                        const std::vector<std::pair<std::string, std::string>>& said, const std::string& unit,
                        const DicomSource& source, const DicomProvenance& made, const std::filesystem::path& target) {
    DcmDataset context;
    copy_context(source, made, context);
    Texts texts(context);
    OFString study;
    context.findAndGetOFString(DCM_StudyInstanceUID, study);
    const std::string seg_uid = uid_for(made, "seg");

    TID1500_MeasurementReport report(CMR_CID7021::ImagingMeasurementReport);
    need(report.setLanguage(DSRCodedEntryValue("en", "RFC5646", "English")), "the language");
    need(report.getObservationContext().addDeviceObserver(
             uid_for({made.software, made.software, "", ""}, "device").c_str(), made.software.c_str(),
             made.software.c_str(), made.software.c_str()),
         "the observer");
    need(report.addProcedureReported(own_code("CT inspection")), "the procedure");
    for (const DicomMeasurementGroup& group : groups) add_group(report, group, unit, source, seg_uid, texts);
    for (const auto& [name, text] : said)
        need(report.addQualitativeEvaluation(own_code(name), texts(text).c_str()), "an evaluation");

    DSRDocument document(DSRTypes::DT_ComprehensiveSR);
    need(document.setSpecificCharacterSet(texts.character_set(context).c_str()), "the character set");
    need(document.readPatientData(context), "the source's patient");
    need(document.readStudyData(context), "the source's study");
    need(document.setTreeFromRootTemplate(report), "the content");
    // The template brings its own type, Enhanced SR; what reads measurements asks for Comprehensive.
    need(document.changeDocumentType(DSRTypes::DT_ComprehensiveSR), "the type");
    document.getCodingSchemeIdentification().addItem("99LACUNA");
    document.getCodingSchemeIdentification().setCodingSchemeName("Lacuna defect terms");
    need(document.setSeriesNumber("902"), "the series number");
    need(document.setManufacturer(made.software.c_str()), "the manufacturer");
    need(document.setManufacturerModelName(made.software.c_str()), "the model");
    need(document.setSoftwareVersions(made.version.c_str()), "the version");
    need(document.completeDocument(), "the completion");
    add_evidence(document, source, made, study.c_str(), seg_uid);
    DcmDataset set;
    need(document.write(set), "the whole");
    fix_identity(made, "sr", context, set);
    save_dataset(set, target);
}

}  // namespace lacuna
