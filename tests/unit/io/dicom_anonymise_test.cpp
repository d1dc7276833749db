#include "core/io/dicom_anonymise.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <set>

#include "../../support/dicom_zoo.h"
#include "../../support/test_data.h"
#include "core/io/dicom_profile.h"
#include "core/io/dicom_tags.h"
#include "core/io/folder_listing.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;
using dicom::ProfileAction;
using dicom::text_of;

namespace {

constexpr const char* k_study = "1.2.826.0.1.3680043.2.1143.77.1";
constexpr const char* k_frame = "1.2.826.0.1.3680043.2.1143.77.2";
constexpr const char* k_other = "1.2.826.0.1.3680043.2.1143.77.3";

/// Words that stand in the files before, and nowhere in them after.
const char* const k_secrets[] = {"Secret",  "19620330", "19990101", "Ward7",    "ACC4711", "DrWho",    "Clinic9",
                                 "SER0815", k_study,    k_frame,    "Nested77", "Curve77", "Overlay7", "Private7"};

void put(DcmItem& item, const DcmTag& tag, const std::string& text) {
    ASSERT_TRUE(item.putAndInsertString(tag, text.c_str()).good()) << tag.toString();
}

/// An image with something to hide in every way there is.
void write_image(const std::filesystem::path& file, int number, const char* series, const char* reference) {
    ZooSlice slice;
    slice.series_uid = series;
    slice.instance = number;
    slice.position = {0, 0, double(number)};
    write_zoo_slice(file, slice);
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(file.c_str()).good());
    DcmDataset& set = *format.getDataset();
    format.loadAllDataIntoMemory();
    put(set, DCM_PatientName, "Secret^Name");
    put(set, DCM_PatientID, "SecretId");
    put(set, DCM_PatientBirthDate, "19620330");
    put(set, DCM_PatientAge, "037Y");
    put(set, DCM_PatientWeight, "77");
    put(set, DCM_OtherPatientNames, "SecretOther");
    put(set, DCM_StudyInstanceUID, k_study);
    put(set, DCM_FrameOfReferenceUID, k_frame);
    put(set, DCM_StudyDate, "19990101");
    put(set, DCM_SeriesDate, "19990101");
    put(set, DCM_ContentDate, "19990101");
    put(set, DCM_AcquisitionDateTime, "19990101123456");
    put(set, DCM_AccessionNumber, "ACC4711");
    put(set, DCM_ReferringPhysicianName, "DrWho");
    put(set, DCM_InstitutionName, "Clinic9");
    put(set, DCM_StationName, "Ward7");
    put(set, DCM_DeviceSerialNumber, "SER0815");
    put(set, DCM_StudyDescription, "Secret words");
    put(set, DCM_SeriesDescription, "Secret words");
    put(set, DCM_ProtocolName, "Secret protocol");
    put(set, DCM_ImageComments, "Secret comment");
    put(set, DCM_Manufacturer, "Maker");
    put(set, DCM_KVP, "120");
    // A name, a date and a time that the table does not list.
    put(set, DcmTagKey(0x0008, 0x009C), "DrWho");
    put(set, DcmTagKey(0x0040, 0xA13A), "19990101");
    // Two levels down: a reference, a name, a private element.
    DcmItem *outer = nullptr, *inner = nullptr;
    ASSERT_TRUE(set.findOrCreateSequenceItem(DCM_ReferencedImageSequence, outer, 0).good());
    put(*outer, DCM_ReferencedSOPClassUID, UID_CTImageStorage);
    put(*outer, DCM_ReferencedSOPInstanceUID, reference);
    ASSERT_TRUE(outer->findOrCreateSequenceItem(DCM_PurposeOfReferenceCodeSequence, inner, 0).good());
    put(*inner, DCM_CodeValue, "121326");
    put(*inner, DCM_PatientName, "Nested77");
    put(*inner, DcmTag(0x0009, 0x0010, EVR_LO), "Private7");
    // Whole sequences that go.
    ASSERT_TRUE(set.findOrCreateSequenceItem(DCM_ReferencedPerformedProcedureStepSequence, outer, 0).good());
    put(*outer, DCM_ReferencedSOPInstanceUID, "1.2.3.4.5.77");
    ASSERT_TRUE(set.findOrCreateSequenceItem(DCM_RequestAttributesSequence, outer, 0).good());
    put(*outer, DCM_RequestedProcedureID, "Nested77");
    // Private elements, a curve, an overlay, group lengths.
    put(set, DcmTag(0x0009, 0x0010, EVR_LO), "Private7");
    put(set, DcmTag(0x0009, 0x1001, EVR_LO), "Private7 data");
    put(set, DcmTag(0x5000, 0x2500, EVR_LO), "Curve77");
    put(set, DcmTag(0x6000, 0x0022, EVR_LO), "Overlay7");
    put(set, DcmTag(0x6002, 0x4000, EVR_LT), "Overlay7");
    ASSERT_TRUE(format.saveFile(file.c_str(), EXS_LittleEndianExplicit, EET_ExplicitLength, EGL_withGL).good());
}

struct Loaded {
    DcmFileFormat format;
    explicit Loaded(const std::filesystem::path& file) {
        EXPECT_TRUE(format.loadFile(file.c_str()).good()) << file;
        format.loadAllDataIntoMemory();
    }
    DcmDataset& set() { return *format.getDataset(); }
};

/// Every element at any depth.
template <class Visit>
void each_element(DcmItem& item, Visit&& visit) {
    for (unsigned long i = 0; i < item.card(); ++i) {
        DcmElement* element = item.getElement(i);
        visit(*element);
        if (element->ident() != EVR_SQ) continue;
        auto& sequence = dynamic_cast<DcmSequenceOfItems&>(*element);
        for (unsigned long k = 0; k < sequence.card(); ++k) each_element(*sequence.getItem(k), visit);
    }
}

class Anonymise : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directory(folder / "in");
        write_image(folder / "in/Secret_a", 1, k_other, "1.2.3.4.2");
        write_image(folder / "in/Secret_b", 2, k_other, "1.2.3.4.1");
    }
    AnonymiseReport run(const std::string& key = "test", const std::string& out = "out") {
        AnonymiseOptions options;
        options.key = key;
        return anonymise_dicom(files_under(folder / "in").files, folder / out, options);
    }
    std::filesystem::path image(int number, const std::string& out = "out") const {
        return folder / (out + "/SE001/IM0000" + std::to_string(number) + ".dcm");
    }
    ScratchFolder folder;
};

}  // namespace

TEST_F(Anonymise, NothingOfThePatientIsLeftInAnyByte) {
    const std::string before = get_file(folder / "in/Secret_a");
    for (const char* secret : k_secrets) ASSERT_NE(before.find(secret), std::string::npos) << secret;
    const AnonymiseReport report = run();
    EXPECT_EQ(report.images, 2);
    EXPECT_EQ(report.series, 1);
    EXPECT_EQ(report.patients, 1);
    for (const int number : {1, 2}) {
        const std::string bytes = get_file(image(number));
        ASSERT_GT(bytes.size(), 200u);
        for (const char* secret : k_secrets) EXPECT_EQ(bytes.find(secret), std::string::npos) << secret;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "out"))
        EXPECT_EQ(entry.path().filename().string().find("Secret"), std::string::npos);
}

TEST_F(Anonymise, EachTagIsTreatedAsTheTableSays) {
    run();
    Loaded made(image(1));
    DcmDataset& set = made.set();
    for (const DcmTagKey& gone : {DCM_PatientAge, DCM_PatientWeight, DCM_OtherPatientNames, DCM_StudyDescription,
                                  DCM_SeriesDescription, DCM_ImageComments, DCM_ProtocolName, DCM_SeriesDate,
                                  DCM_RequestAttributesSequence, DCM_ReferencedPerformedProcedureStepSequence})
        EXPECT_FALSE(set.tagExists(gone)) << gone.toString();
    for (const DcmTagKey& empty : {DCM_PatientBirthDate, DCM_StudyDate, DCM_ContentDate, DCM_AccessionNumber,
                                   DCM_ReferringPhysicianName, DCM_AcquisitionDateTime}) {
        EXPECT_TRUE(set.tagExists(empty)) << empty.toString();
        EXPECT_EQ(text_of(set, empty), "") << empty.toString();
    }
    EXPECT_EQ(text_of(set, DcmTagKey(0x0040, 0xA13A)), "19000101000000");
    for (const auto& [kept, value] : std::initializer_list<std::pair<DcmTagKey, const char*>>{
             {DCM_Manufacturer, "Maker"}, {DCM_KVP, "120"}, {DCM_Modality, "CT"}, {DCM_InstanceNumber, "1"}})
        EXPECT_EQ(text_of(set, kept), value);
    EXPECT_EQ(text_of(set, DCM_PatientIdentityRemoved), "YES");
    EXPECT_NE(text_of(set, DCM_DeidentificationMethod).find("PS3.15"), std::string::npos);
    EXPECT_EQ(text_of(set, DCM_LongitudinalTemporalInformationModified), "REMOVED");
    DcmItem* code = dicom::item_of(set, DCM_DeidentificationMethodCodeSequence);
    ASSERT_NE(code, nullptr);
    EXPECT_EQ(text_of(*code, DCM_CodeValue), "113100");
    EXPECT_EQ(text_of(*code, DCM_CodingSchemeDesignator), "DCM");
    EXPECT_EQ(text_of(set, DCM_PatientName), "Anonymous^" + text_of(set, DCM_PatientID));
    each_element(set, [](DcmElement& element) {
        const DcmTag& tag = element.getTag();
        EXPECT_EQ(tag.getGroup() % 2, 0) << tag.toString();
        EXPECT_FALSE(tag.getGroup() >= 0x5000 && tag.getGroup() < 0x7000) << tag.toString();
        EXPECT_NE(tag.getElement(), 0) << tag.toString();
        const ProfileAction action = dicom::profile_action(tag.getGroup(), tag.getElement());
        EXPECT_NE(action, ProfileAction::remove) << tag.toString();
    });
}

namespace {

/// Every attribute the table lists, but those of command and file groups, which stand in no data set.
std::vector<std::pair<DcmTagKey, ProfileAction>> listed_attributes() {
    std::vector<std::pair<DcmTagKey, ProfileAction>> listed;
    for (const auto& [number, action] : dicom::profile_table())
        if (const unsigned group = number >> 16; group >= 0x0008 && group < 0x5000)
            listed.push_back({DcmTagKey(Uint16(group), Uint16(number & 0xFFFF)), action});
    return listed;
}

const char* secret_of(DcmEVR vr) {
    switch (vr) {
        case EVR_DA:
            return "19990101";
        case EVR_TM:
            return "121314.5";
        case EVR_DT:
            return "19990101121314";
        case EVR_AS:
            return "077Y";
        case EVR_IS:
        case EVR_DS:
            return "77177";
        case EVR_UI:
            return "1.2.3.77177";
        case EVR_CS:
        case EVR_AE:
            return "SECRET77";
        default:
            return "Secret77";
    }
}

/// Gives an item every attribute of the table with a value that tells something. Those that cannot be are left out.
void fill(DcmItem& item, const std::vector<std::pair<DcmTagKey, ProfileAction>>& listed) {
    for (const auto& [key, action] : listed) {
        const DcmTag tag(key);
        if (tag.error().bad() || item.tagExists(key)) continue;
        DcmItem* inner = nullptr;
        switch (tag.getEVR()) {
            case EVR_SQ:
                EXPECT_TRUE(item.findOrCreateSequenceItem(key, inner, 0).good()) << tag.toString();
                put(*inner, DCM_ReferencedSOPInstanceUID, "1.2.3.77177");
                put(*inner, DCM_CodeMeaning, "Inner words");
                break;
            case EVR_OB:
            case EVR_ox:
            case EVR_OW:
            case EVR_UN:
                EXPECT_TRUE(
                    item.putAndInsertUint8Array(DcmTag(key, EVR_OB), reinterpret_cast<const Uint8*>("Secret77"), 8)
                        .good())
                    << tag.toString();
                break;
            case EVR_US:
                EXPECT_TRUE(item.putAndInsertUint16(tag, 7717).good());
                break;
            case EVR_FD:
                EXPECT_TRUE(item.putAndInsertFloat64(tag, 77177).good());
                break;
            case EVR_FL:
                EXPECT_TRUE(item.putAndInsertFloat32(tag, 77177).good());
                break;
            default:
                put(item, tag, secret_of(tag.getEVR()));
        }
    }
}

/// How much of an element is left.
enum class Left { nothing, empty, something };
Left left_of(DcmItem& item, const DcmTagKey& key) {
    DcmElement* element = nullptr;
    if (item.findAndGetElement(key, element).bad() || !element) return Left::nothing;
    return element->getLength() == 0 ? Left::empty : Left::something;
}

/// Of a CT image, an object of one frame: where the table leaves a choice, it is the most private one.
void expect_treated(DcmItem& item, const std::vector<std::pair<DcmTagKey, ProfileAction>>& listed) {
    for (const auto& [key, action] : listed) {
        const DcmTag tag(key);
        const bool sequence = tag.getEVR() == EVR_SQ;
        const Left left = left_of(item, key);
        if (tag.error().bad()) {
            EXPECT_EQ(left, Left::nothing) << tag.toString();
            continue;
        }
        switch (action) {
            case ProfileAction::remove:
            case ProfileAction::remove_dummy:
                EXPECT_EQ(left, Left::nothing) << tag.toString();
                break;
            case ProfileAction::zero:
                EXPECT_EQ(left, Left::empty) << tag.toString();
                break;
            case ProfileAction::zero_dummy:
            case ProfileAction::remove_zero:
            case ProfileAction::remove_zero_dummy:
                EXPECT_EQ(left, sequence ? Left::nothing : Left::empty) << tag.toString();
                break;
            case ProfileAction::dummy:
                EXPECT_EQ(left, Left::something) << tag.toString();
                break;
            case ProfileAction::uid:
                EXPECT_TRUE(text_of(item, key).starts_with("2.25.")) << tag.toString();
                break;
            case ProfileAction::remove_uids: {
                DcmItem* reference = dicom::item_of(item, key);
                ASSERT_NE(reference, nullptr) << tag.toString();
                EXPECT_TRUE(text_of(*reference, DCM_ReferencedSOPInstanceUID).starts_with("2.25.")) << tag.toString();
                break;
            }
            case ProfileAction::keep:
                ADD_FAILURE() << tag.toString();
        }
    }
}

}  // namespace

TEST_F(Anonymise, EveryAttributeOfTheTableIsTreatedAsItSaysAtAnyDepth) {
    auto listed = listed_attributes();
    EXPECT_GT(listed.size(), 580u);
    {
        Loaded full(folder / "in/Secret_a");
        fill(full.set(), listed);
        DcmItem *outer = nullptr, *inner = nullptr;  // (0040,9096) is in no table, so what is in it is looked at
        ASSERT_TRUE(full.set().findOrCreateSequenceItem(DCM_RealWorldValueMappingSequence, outer, 0).good());
        ASSERT_TRUE(outer->findOrCreateSequenceItem(DCM_MeasurementUnitsCodeSequence, inner, 0).good());
        fill(*inner, listed);
        ASSERT_TRUE(full.format.saveFile((folder / "in/Secret_a").c_str(), EXS_LittleEndianExplicit).good());
    }
    run();
    Loaded made(image(1));
    DcmItem* outer = dicom::item_of(made.set(), DCM_RealWorldValueMappingSequence);
    ASSERT_NE(outer, nullptr);
    DcmItem* inner = dicom::item_of(*outer, DCM_MeasurementUnitsCodeSequence);
    ASSERT_NE(inner, nullptr);
    expect_treated(*inner, listed);
    // At the top two have names of their own.
    std::erase_if(listed, [](const auto& row) { return row.first == DCM_PatientName || row.first == DCM_PatientID; });
    expect_treated(made.set(), listed);
    const std::string bytes = get_file(image(1));
    for (const char* secret : {"Secret77", "SECRET77", "19990101", "121314", "077Y", "77177", "1.2.3.77177"})
        EXPECT_EQ(bytes.find(secret), std::string::npos) << secret;
}

TEST_F(Anonymise, UidsAreReplacedAlikeInAllFilesAndAtAllDepths) {
    Loaded before(folder / "in/Secret_a");
    run();
    Loaded one(image(1)), two(image(2));
    for (const DcmTagKey& shared : {DCM_StudyInstanceUID, DCM_SeriesInstanceUID, DCM_FrameOfReferenceUID}) {
        EXPECT_EQ(text_of(one.set(), shared), text_of(two.set(), shared)) << shared.toString();
        EXPECT_NE(text_of(one.set(), shared), text_of(before.set(), shared)) << shared.toString();
        EXPECT_TRUE(text_of(one.set(), shared).starts_with("2.25.")) << shared.toString();
    }
    EXPECT_NE(text_of(one.set(), DCM_SOPInstanceUID), text_of(two.set(), DCM_SOPInstanceUID));
    EXPECT_EQ(text_of(*one.format.getMetaInfo(), DCM_MediaStorageSOPInstanceUID),
              text_of(one.set(), DCM_SOPInstanceUID));
    EXPECT_EQ(text_of(one.set(), DCM_SOPClassUID), UID_CTImageStorage);
    DcmItem* item = dicom::item_of(one.set(), DCM_ReferencedImageSequence);
    ASSERT_NE(item, nullptr);
    EXPECT_EQ(text_of(*item, DCM_ReferencedSOPClassUID), UID_CTImageStorage);
    EXPECT_TRUE(text_of(*item, DCM_ReferencedSOPInstanceUID).starts_with("2.25."));
    DcmItem* inner = dicom::item_of(*item, DCM_PurposeOfReferenceCodeSequence);
    ASSERT_NE(inner, nullptr);
    EXPECT_EQ(text_of(*inner, DCM_CodeValue), "121326");
    EXPECT_EQ(text_of(*inner, DCM_PatientName), "");
}

TEST_F(Anonymise, AReferenceWithinAnExportStaysOne) {
    Loaded two(folder / "in/Secret_b");
    const std::string pointed_at = text_of(two.set(), DCM_SOPInstanceUID);
    write_image(folder / "in/Secret_a", 1, k_other, pointed_at.c_str());
    run();
    Loaded one(image(1)), other(image(2));
    DcmItem* item = dicom::item_of(one.set(), DCM_ReferencedImageSequence);
    ASSERT_NE(item, nullptr);
    EXPECT_EQ(text_of(*item, DCM_ReferencedSOPInstanceUID), text_of(other.set(), DCM_SOPInstanceUID));
}

TEST_F(Anonymise, TwoExportsCannotBeJoinedUnlessTheyShareAKey) {
    run("", "first");
    run("", "second");
    run("key", "third");
    run("key", "fourth");
    const auto study = [&](const char* out) {
        Loaded made(image(1, out));
        return text_of(made.set(), DCM_StudyInstanceUID) + text_of(made.set(), DCM_PatientID);
    };
    EXPECT_NE(study("first"), study("second"));
    EXPECT_EQ(study("third"), study("fourth"));
    EXPECT_NE(study("first"), study("third"));
}

TEST_F(Anonymise, TheVolumeStaysTheSame) {
    run();
    const Volume before = open_volume((folder / "in").string()), after = open_volume((folder / "out").string());
    expect_same_voxels(before, after);
    expect_same_geometry(before.geometry(), after.geometry(), 1e-9);
}

TEST_F(Anonymise, ImagesWithTextInTheirPixelsAreLeftOutOrNamed) {
    {
        Loaded marked(folder / "in/Secret_b");
        put(marked.set(), DCM_BurnedInAnnotation, "YES");
        ASSERT_TRUE(marked.format.saveFile((folder / "in/Secret_b").c_str(), EXS_LittleEndianExplicit).good());
        Loaded unsaid(folder / "in/Secret_a");
        put(unsaid.set(), DCM_Modality, "US");
        ASSERT_TRUE(unsaid.format.saveFile((folder / "in/Secret_a").c_str(), EXS_LittleEndianExplicit).good());
    }
    const AnonymiseReport report = run();
    EXPECT_EQ(report.images, 1);
    EXPECT_EQ(report.burned_in, 1);
    EXPECT_EQ(report.burned_in_unsaid, 1);
    EXPECT_EQ(report.notes().size(), 2u);
    AnonymiseOptions keep;
    keep.keep_burned_in = true;
    EXPECT_EQ(anonymise_dicom(files_under(folder / "in").files, folder / "kept", keep).images, 2);
}

TEST_F(Anonymise, TheFolderIsWrittenWholeOrNotAtAll) {
    std::stop_source stop;
    int reports = 0;
    JobContext job{stop.get_token(), [&](double) {
                       if (++reports > 1) stop.request_stop();
                   }};
    expect_error(Errc::cancelled, {},
                 [&] { anonymise_dicom(files_under(folder / "in").files, folder / "out", {}, job); });
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    EXPECT_EQ(folder.entries(), 1u);
    put_file(folder / "in/notes.txt", "no image");
    put_file(folder / "cut.dcm", get_file(folder / "in/Secret_a").substr(0, 700));
    std::filesystem::rename(folder / "cut.dcm", folder / "in/cut.dcm");
    const AnonymiseReport report = run();
    EXPECT_EQ(report.images, 2);
    EXPECT_EQ(report.unreadable, 1);
    expect_error(Errc::io, {"out"}, [&] { run(); });  // something stands there
    std::filesystem::create_directory(folder / "empty");
    expect_error(Errc::bad_input, {"no DICOM image"},
                 [&] { anonymise_dicom(files_under(folder / "empty").files, folder / "x"); });
}

TEST(AnonymiseTable, HoldsTheProfilesRows) {
    EXPECT_EQ(dicom::profile_action(0x0010, 0x0010), ProfileAction::zero);
    EXPECT_EQ(dicom::profile_action(0x0010, 0x0020), ProfileAction::zero_dummy);
    EXPECT_EQ(dicom::profile_action(0x0008, 0x0018), ProfileAction::uid);
    EXPECT_EQ(dicom::profile_action(0x0008, 0x103E), ProfileAction::remove);
    EXPECT_EQ(dicom::profile_action(0x0040, 0xA123), ProfileAction::dummy);
    EXPECT_EQ(dicom::profile_action(0x0008, 0x0016), ProfileAction::keep);
    EXPECT_EQ(dicom::profile_action(0x0009, 0x0010), ProfileAction::remove);
    EXPECT_EQ(dicom::profile_action(0x6004, 0x0010), ProfileAction::remove);
    EXPECT_EQ(dicom::profile_action(0x50FE, 0x3000), ProfileAction::remove);
    EXPECT_EQ(dicom::profile_action(0x7FE0, 0x0010), ProfileAction::keep);
    EXPECT_GT(dicom::profile_table().size(), 590u);
}

TEST(AnonymiseReal, EveryImageOfTheZooIsReadByPydicomAfterwards) {
    LACUNA_NEEDS_DATA(zoo, "dicom_zoo");
    ScratchFolder folder;
    const AnonymiseReport report = anonymise_dicom(files_under(zoo).files, folder / "out");
    EXPECT_GT(report.images, 40);
    if (std::system("/usr/bin/python3 -c 'import pydicom' 2>/dev/null") != 0)
        GTEST_SKIP() << "skipped in part: pydicom is not installed";
    put_file(folder / "check.py", R"(
import sys, pathlib, pydicom
names = set()
count = 0
for file in sorted(pathlib.Path(sys.argv[1]).rglob('*.dcm')):
    d = pydicom.dcmread(file)
    count += 1
    assert d.PatientIdentityRemoved == 'YES', file
    assert d.DeidentificationMethodCodeSequence[0].CodeValue == '113100', file
    assert str(d.PatientName).startswith('Anonymous^'), file
    assert d.file_meta.MediaStorageSOPInstanceUID == d.SOPInstanceUID, file
    def look(dataset, element):
        assert not element.tag.is_private, (file, element.tag)
        assert not 0x6000 <= element.tag.group <= 0x60ff, (file, element.tag)
        assert element.VR != 'PN' or str(element.value) in ('', 'ANONYMOUS') or element.tag == 0x00100010, (file, element.tag)
        assert element.VR not in ('DA', 'DT') or str(element.value) in ('', 'None') or str(element.value).startswith('1900'), (file, element.tag, element.value)
    d.walk(look)
print(count)
)");
    const std::string call = "/usr/bin/python3 -W ignore " + (folder / "check.py").string() + " " +
                             (folder / "out").string() + " > " + (folder / "said").string() + " 2>&1";
    EXPECT_EQ(std::system(call.c_str()), 0) << get_file(folder / "said");
    EXPECT_EQ(get_file(folder / "said"), std::to_string(report.images) + "\n");
}
