#include "core/io/dicom_sr_writer.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmsr/cmr/tid1500.h>
#include <dcmtk/dcmsr/dsrdoc.h>

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

void add_group(TID1500_MeasurementReport& report, const DicomMeasurementGroup& group, const std::string& unit,
               const DicomSource& source, const std::string& seg_uid) {
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
        need(roi.addQualitativeEvaluation(own_code(name), text.c_str()), "an evaluation");
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
    OFString study;
    context.findAndGetOFString(DCM_StudyInstanceUID, study);
    const std::string seg_uid = uid_for(made, "seg");

    TID1500_MeasurementReport report(CMR_CID7021::ImagingMeasurementReport);
    need(report.setLanguage(DSRCodedEntryValue("en", "RFC5646", "English")), "the language");
    need(report.getObservationContext().addDeviceObserver(
             uid_for({made.software, made.software, "", ""}, "device").c_str(), made.software.c_str(),
             made.software.c_str(), made.version.c_str()),
         "the observer");
    need(report.addProcedureReported(own_code("CT inspection")), "the procedure");
    for (const DicomMeasurementGroup& group : groups) add_group(report, group, unit, source, seg_uid);
    for (const auto& [name, text] : said)
        need(report.addQualitativeEvaluation(own_code(name), text.c_str()), "an evaluation");

    DSRDocument document(DSRTypes::DT_ComprehensiveSR);
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
