#include "core/io/dicom_identity.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "core/io/dicom_header.h"
#include "core/io/dicom_lut.h"
#include "core/io/dicom_tags.h"
#include "core/io/dicom_text.h"

namespace lacuna {

namespace {

/// "Doe^Jane^M.^Dr." as "Doe, Dr. Jane M."; of several writings (alphabetic=ideographic=phonetic) the first there is.
std::string readable_name(std::string_view name) {
    std::string_view group = name.substr(0, name.find('='));
    while (group.empty() && name.find('=') != std::string_view::npos) {
        name.remove_prefix(name.find('=') + 1);
        group = name.substr(0, name.find('='));
    }
    std::string_view part[5];  // family, given, middle, prefix, suffix
    for (auto& each : part) {
        const std::size_t end = group.find('^');
        each = group.substr(0, end);
        group = end == std::string_view::npos ? std::string_view{} : group.substr(end + 1);
    }
    std::string given;
    for (const std::string_view each : {part[3], part[1], part[2], part[4]})
        if (!each.empty()) given += (given.empty() ? "" : " ") + std::string(each);
    std::string all(part[0]);
    if (!given.empty()) all += (all.empty() ? "" : ", ") + given;
    return all;
}

/// "20240131" as "2024-01-31"; anything else as it is.
std::string readable_date(const std::string& date) {
    if (date.size() != 8 || !std::all_of(date.begin(), date.end(), [](char c) { return c >= '0' && c <= '9'; }))
        return date;
    return date.substr(0, 4) + "-" + date.substr(4, 2) + "-" + date.substr(6, 2);
}

std::shared_ptr<const PatientIdentity> identity_of(DcmItem& data) {
    dicom::Utf8Texts text(data);
    PatientIdentity patient;
    patient.name = readable_name(text(DCM_PatientName, "\\^="));
    patient.id = text(DCM_PatientID);
    patient.birth_date = readable_date(text(DCM_PatientBirthDate));
    patient.sex = text(DCM_PatientSex);
    patient.age = text(DCM_PatientAge);
    patient.study_date = readable_date(text(DCM_StudyDate));
    patient.study = text(DCM_StudyDescription);
    patient.place = text(DCM_InstitutionName);
    return patient.empty() ? nullptr : std::make_shared<const PatientIdentity>(std::move(patient));
}

/// The word of the frame's own window, else of all frames', else of the image.
std::string function_word(DcmItem& data, int frame) {
    const auto in_groups = [](DcmItem* groups) -> std::string {
        DcmItem* window = groups ? dicom::item_of(*groups, DCM_FrameVOILUTSequence) : nullptr;
        return window ? dicom::text_of(*window, DCM_VOILUTFunction) : std::string();
    };
    std::string word;
    if (frame > 0)
        word = in_groups(
            dicom::item_of(data, DCM_PerFrameFunctionalGroupsSequence, static_cast<unsigned long>(frame - 1)));
    if (word.empty()) word = in_groups(dicom::item_of(data, DCM_SharedFunctionalGroupsSequence));
    return word.empty() ? dicom::text_of(data, DCM_VOILUTFunction) : word;
}

}  // namespace

DicomScreenFacts read_screen_facts(const std::filesystem::path& file, int frame) {
    dicom::prepare_dcmtk();
    DicomScreenFacts facts;
    DcmFileFormat format;
    const OFCondition read = format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                                     ERM_autoDetect, DcmTagKey(0x7FE0, 0));
    if (read.bad()) return facts;
    DcmDataset& data = *format.getDataset();
    facts.patient = identity_of(data);
    const std::string word = function_word(data, frame);
    if (word == "LINEAR") facts.voi_function = VoiFunction::linear;
    if (word == "LINEAR_EXACT") facts.voi_function = VoiFunction::linear_exact;
    if (word == "SIGMOID") facts.voi_function = VoiFunction::sigmoid;
    dicom::Utf8Texts text(data);
    for (VoiTable& table : dicom::voi_tables(data, frame)) {
        table.name = text.readable(std::move(table.name));
        facts.voi_tables.push_back(std::make_shared<const VoiTable>(std::move(table)));
    }
    return facts;
}

}  // namespace lacuna
