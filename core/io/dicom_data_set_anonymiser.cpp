#include "core/io/dicom_data_set_anonymiser.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>

#include <random>
#include <set>
#include <string_view>

#include "core/io/dicom_profile.h"
#include "core/io/dicom_tags.h"
#include "core/io/dicom_uid.h"

namespace lacuna::dicom {

namespace {

constexpr std::string_view k_registered_uids = "1.2.840.10008.";  // the standard's own: classes, syntaxes, atlases

/// Objects of one frame, in which attributes of type 3 may go and those of type 2 be empty without making them invalid.
bool is_classic(const std::string& sop_class) {
    static const std::set<std::string> k_classic = {UID_CTImageStorage,
                                                    UID_MRImageStorage,
                                                    UID_PositronEmissionTomographyImageStorage,
                                                    UID_ComputedRadiographyImageStorage,
                                                    UID_SecondaryCaptureImageStorage,
                                                    UID_NuclearMedicineImageStorage};
    return k_classic.contains(sop_class);
}

/// The action with the choice by type taken.
ProfileAction chosen(ProfileAction action, bool classic) {
    switch (action) {
        case ProfileAction::zero_dummy:
        case ProfileAction::remove_zero_dummy:
            return classic ? ProfileAction::zero : ProfileAction::dummy;
        case ProfileAction::remove_zero:
            return ProfileAction::zero;
        case ProfileAction::remove_dummy:
            return classic ? ProfileAction::remove : ProfileAction::dummy;
        default:
            return action;
    }
}

const char* dummy_text(DcmEVR vr) {
    switch (vr) {
        case EVR_DA:
            return "19000101";
        case EVR_DT:
            return "19000101000000";
        case EVR_TM:
            return "000000";
        case EVR_AS:
            return "000Y";
        case EVR_IS:
        case EVR_DS:
            return "0";
        case EVR_UR:
            return "urn:anonymous";
        default:
            return "ANONYMOUS";
    }
}

/// Works through one data set.
class Anonymiser {
public:
    Anonymiser(const Pseudonyms& names, bool classic) : names_(names), classic_(classic) {}

    void work_through(DcmItem& item) const {
        for (unsigned long i = item.card(); i-- > 0;) {
            DcmElement* element = item.getElement(i);
            if (!work_on(*element)) delete item.remove(element);
        }
    }

private:
    /// False: the element is to go.
    bool work_on(DcmElement& element) const {
        const DcmTag& tag = element.getTag();
        if (tag.getElement() == 0x0000) return false;  // lengths of groups
        const DcmEVR vr = element.getVR();
        const ProfileAction listed = profile_action(tag.getGroup(), tag.getElement());
        const ProfileAction action = chosen(listed, classic_);
        if (action == ProfileAction::remove || vr == EVR_UN || is_unknown(tag)) return false;
        // Where it may go as well: a sequence that is there must often have an item.
        if (action == ProfileAction::zero && listed != action && is_sequence(element)) return false;
        switch (action) {
            case ProfileAction::zero:
                clear(element);
                break;
            case ProfileAction::dummy:
                if (element.getLength() > 0) replace(element);
                break;
            case ProfileAction::uid:
                rename(element);
                break;
            default:
                keep(element);
        }
        return true;
    }

    static bool is_unknown(const DcmTag& tag) {
        return DcmTag(tag.getXTag()).error().bad();  // looked up in the dictionary
    }

    static bool is_sequence(const DcmElement& element) {
        return element.ident() == EVR_SQ && dynamic_cast<const DcmSequenceOfItems*>(&element);
    }

    void keep(DcmElement& element) const {
        if (is_sequence(element)) {
            auto& sequence = dynamic_cast<DcmSequenceOfItems&>(element);
            for (unsigned long i = 0; i < sequence.card(); ++i) work_through(*sequence.getItem(i));
            return;
        }
        const DcmEVR vr = element.getVR();
        if (vr == EVR_PN || vr == EVR_DA || vr == EVR_DT) clear(element);
    }

    static void clear(DcmElement& element) { element.clear(); }

    void replace(DcmElement& element) const {
        if (is_sequence(element)) {
            element.clear();
            dynamic_cast<DcmSequenceOfItems&>(element).append(new DcmItem());
            return;
        }
        switch (element.getVR()) {
            case EVR_UI:
                rename(element);
                break;
            case EVR_OB:
            case EVR_OW: {
                const Uint16 nothing = 0;
                element.clear();
                if (element.putUint16Array(&nothing, 1).bad())
                    element.putUint8Array(reinterpret_cast<const Uint8*>(&nothing), 2);
                break;
            }
            default:
                if (element.putString(dummy_text(element.getVR())).bad()) clear(element);
        }
    }

    void rename(DcmElement& element) const {
        std::string joined;
        const unsigned long count = element.getVM();
        for (unsigned long i = 0; i < count; ++i) {
            OFString old;
            element.getOFString(old, i);
            if (i > 0) joined += '\\';
            if (!old.empty()) joined += names_.uid(std::string(old.c_str()));
        }
        if (element.putString(joined.c_str()).bad()) clear(element);
    }

    const Pseudonyms& names_;
    bool classic_;
};

void state_what_was_done(DcmDataset& set, const std::string& software) {
    set.putAndInsertString(DCM_PatientIdentityRemoved, "YES");
    set.putAndInsertString(DCM_DeidentificationMethod,
                           (software.substr(0, 20) + ": PS3.15 Annex E Basic Profile").c_str());
    set.putAndInsertString(DCM_LongitudinalTemporalInformationModified, "REMOVED");
    set.findAndDeleteElement(DCM_DeidentificationMethodCodeSequence);
    DcmItem* code = nullptr;
    if (set.findOrCreateSequenceItem(DCM_DeidentificationMethodCodeSequence, code, 0).bad()) return;
    code->putAndInsertString(DCM_CodeValue, "113100");
    code->putAndInsertString(DCM_CodingSchemeDesignator, "DCM");
    code->putAndInsertString(DCM_CodeMeaning, "Basic Application Confidentiality Profile");
}

}  // namespace

Pseudonyms::Pseudonyms(std::string key) : key_(std::move(key)) {
    if (!key_.empty()) return;
    std::random_device random;
    for (int i = 0; i < 8; ++i) key_ += std::to_string(random());
}

std::string Pseudonyms::uid(const std::string& old) const {
    return old.starts_with(k_registered_uids) ? old : derived_uid(key_ + "\nuid\n" + old);
}

std::string Pseudonyms::patient(const std::string& id_and_name) const {
    const std::string digits = derived_uid(key_ + "\npatient\n" + id_and_name);
    return digits.substr(digits.size() - 12);
}

void anonymise(DcmDataset& set, const Pseudonyms& names, const std::string& patient, const std::string& software) {
    Anonymiser(names, is_classic(text_of(set, DCM_SOPClassUID))).work_through(set);
    set.putAndInsertString(DCM_PatientName, ("Anonymous^" + patient).c_str());
    set.putAndInsertString(DCM_PatientID, patient.c_str());
    state_what_was_done(set, software);
}

}  // namespace lacuna::dicom
