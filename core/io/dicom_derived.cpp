#include "core/io/dicom_derived.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <set>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/io/dicom_header.h"
#include "core/io/dicom_tags.h"
#include "core/io/dicom_uid.h"

namespace lacuna::dicom {

namespace {

/// Patient and study modules and frame of reference.
const DcmTagKey k_context[] = {DCM_SpecificCharacterSet,
                               DCM_PatientName,
                               DCM_PatientID,
                               DCM_IssuerOfPatientID,
                               DCM_PatientBirthDate,
                               DCM_PatientSex,
                               DCM_PatientAge,
                               DCM_PatientSize,
                               DCM_PatientWeight,
                               DCM_PatientIdentityRemoved,
                               DCM_DeidentificationMethod,
                               DCM_StudyInstanceUID,
                               DCM_StudyDate,
                               DCM_StudyTime,
                               DCM_ReferringPhysicianName,
                               DCM_StudyID,
                               DCM_AccessionNumber,
                               DCM_StudyDescription,
                               DCM_FrameOfReferenceUID,
                               DCM_PositionReferenceIndicator};
const DcmTagKey k_must_be_there[] = {DCM_PatientName,    DCM_PatientID, DCM_PatientBirthDate,       DCM_PatientSex,
                                     DCM_StudyDate,      DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID,
                                     DCM_AccessionNumber};

/// Takes off what writers padded a value with (a zero byte, against PS3.5 6.2, or spaces) and leaves out what its VR
/// does not allow: one such value would have the whole object refused.
void repair(DcmDataset& set, const DcmTagKey& tag) {
    DcmElement* element = nullptr;
    if (set.findAndGetElement(tag, element).bad() || !element) return;
    char* raw = nullptr;
    Uint32 length = 0;
    if (element->getString(raw, length).good() && raw != nullptr) {
        std::string text(raw, length);
        while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
        element->putString(text.c_str(), Uint32(text.size()));
    }
    const bool many = tag == DCM_SpecificCharacterSet || tag == DCM_DeidentificationMethod;
    if (element->checkValue(many ? "1-n" : "1", OFFalse).bad()) element->putString("", 0);
}

}  // namespace

std::string decimal(double value) {
    for (int digits = 15; digits > 1; --digits) {
        std::string text = fmt::format("{:.{}g}", value, digits);
        if (text.size() <= 16) return text;
    }
    return "0";
}

std::string printable(const std::string& text) {
    std::string kept;
    for (const char c : text)
        if (c >= ' ' && c < 127 && c != '\\' && kept.size() < 64) kept += c;
    return kept;
}

std::string uid_for(const DicomProvenance& made, const std::string& what) {
    return derived_uid(made.seed + "\n" + made.software + " " + made.version + "\n" + what);
}

void copy_context(const DicomSource& source, const DicomProvenance& made, DcmDataset& into) {
    prepare_dcmtk();
    if (source.images.empty()) throw Error(Errc::bad_input, "The DICOM source names no image.");
    const std::filesystem::path& file = source.images.front().file;
    DcmFileFormat format;
    if (format
            .loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData)
            .bad())
        throw Error(Errc::io,
                    "Cannot read " + file.filename().string() + " again, whose header the DICOM files written copy.");
    DcmDataset& set = *format.getDataset();
    for (const DcmTagKey& tag : k_context)
        if (set.tagExists(tag)) {
            set.findAndInsertCopyOfElement(tag, &into, OFTrue);
            repair(into, tag);
        }
    for (const DcmTagKey& tag : k_must_be_there)
        if (!into.tagExists(tag)) into.insertEmptyElement(tag);
    if (text_of(into, DCM_StudyInstanceUID).empty())
        into.putAndInsertString(DCM_StudyInstanceUID, uid_for(made, "study").c_str());
    if (text_of(into, DCM_FrameOfReferenceUID).empty())
        into.putAndInsertString(DCM_FrameOfReferenceUID, uid_for(made, "frame of reference").c_str());
    if (!into.tagExists(DCM_PositionReferenceIndicator)) into.insertEmptyElement(DCM_PositionReferenceIndicator);
    const std::pair<DcmTagKey, DcmTagKey> dates[] = {{DCM_ContentDate, DCM_ContentTime},
                                                     {DCM_AcquisitionDate, DCM_AcquisitionTime},
                                                     {DCM_SeriesDate, DCM_SeriesTime},
                                                     {DCM_StudyDate, DCM_StudyTime}};
    std::string date = "19000101", time = "000000";
    for (const auto& [date_tag, time_tag] : dates)
        if (const std::string text = text_of(set, date_tag); text.size() == 8) {
            date = text;
            const std::string clock = text_of(set, time_tag);
            if (clock.size() >= 6) time = clock;
            break;
        }
    into.putAndInsertString(DCM_ContentDate, date.c_str());
    into.putAndInsertString(DCM_ContentTime, time.c_str());
}

void fix_identity(const DicomProvenance& made, const std::string& what, const DcmDataset& context, DcmDataset& set) {
    auto& from = const_cast<DcmDataset&>(context);  // DCMTK's look-ups are not const
    const auto put = [&set](const DcmTagKey& tag, const std::string& text) {
        set.putAndInsertString(tag, text.c_str());
    };
    put(DCM_SOPInstanceUID, uid_for(made, what));
    put(DCM_SeriesInstanceUID, uid_for(made, what + "-series"));
    put(DCM_SeriesDescription, printable(made.software + " " + what + ": " + made.title));
    const std::string date = text_of(from, DCM_ContentDate), time = text_of(from, DCM_ContentTime);
    for (const DcmTagKey& tag : {DCM_ContentDate, DCM_InstanceCreationDate, DCM_SeriesDate}) put(tag, date);
    for (const DcmTagKey& tag : {DCM_ContentTime, DCM_InstanceCreationTime, DCM_SeriesTime}) put(tag, time);
    set.findAndDeleteElement(DCM_TimezoneOffsetFromUTC);
}

void refer_to_source(const DicomSource& source, DcmDataset& set) {
    DcmItem* series = nullptr;
    if (source.series_uid.empty() || set.findOrCreateSequenceItem(DCM_ReferencedSeriesSequence, series, 0).bad())
        return;
    series->putAndInsertString(DCM_SeriesInstanceUID, source.series_uid.c_str());
    std::set<std::string> named;  // a file of several frames stands once
    for (const DicomSourceImage& image : source.images) {
        if (image.sop_class_uid.empty() || image.sop_instance_uid.empty()) continue;
        if (!named.insert(image.sop_instance_uid).second) continue;
        DcmItem* item = nullptr;
        if (series->findOrCreateSequenceItem(DCM_ReferencedInstanceSequence, item, -2).bad()) continue;
        item->putAndInsertString(DCM_ReferencedSOPClassUID, image.sop_class_uid.c_str());
        item->putAndInsertString(DCM_ReferencedSOPInstanceUID, image.sop_instance_uid.c_str());
    }
    if (named.empty()) set.findAndDeleteElement(DCM_ReferencedSeriesSequence);
}

void save_dataset(DcmDataset& set, const std::filesystem::path& target) {
    AtomicFile file(target);
    DcmFileFormat format(&set, OFFalse);
    const OFCondition saved = format.saveFile(file.path().c_str(), EXS_LittleEndianExplicit, EET_ExplicitLength);
    (void)format.getAndRemoveDataset();  // it is the caller's
    // The library does not report a disk that ran full when it closes the file: the length tells.
    std::error_code ec;
    const std::uintmax_t bytes = std::filesystem::file_size(file.path(), ec);
    const std::uintmax_t expected = set.calcElementLength(EXS_LittleEndianExplicit, EET_ExplicitLength);
    if (saved.bad() || ec || bytes < expected) throw_cannot_write(target, ENOSPC);
    file.commit();
}

}  // namespace lacuna::dicom
