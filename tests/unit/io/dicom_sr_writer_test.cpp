#include "core/io/dicom_sr_writer.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's configuration comes first
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include "core/io/dicom_tags.h"
#include "core/io/volume_reader.h"
#include "tests/support/dicom_zoo.h"

namespace lacuna {
namespace {

using test::TemporaryFolder;
using test::write_zoo_slice;
using test::ZooSlice;

/// The texts of every content item, one behind the other.
std::string all_text(DcmDataset& set) {
    std::string all;
    DcmStack stack;
    while (set.nextObject(stack, OFTrue).good())
        if (stack.top()->getTag() == DCM_TextValue) {
            char* text = nullptr;
            if (static_cast<DcmElement*>(stack.top())->getString(text).good() && text) all += text;
        }
    return all;
}

struct Written {
    std::string charset, patient, text;
    bool valid = false;
};

Written report_of(const std::string& charset, const std::string& patient, const std::string& said) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "in");
    for (int k = 0; k < 3; ++k) {
        ZooSlice slice;
        slice.instance = k + 1;
        slice.position.z = k;
        if (!charset.empty()) slice.extra.push_back({{0x0008, 0x0005}, charset});
        slice.extra.push_back({{0x0010, 0x0010}, patient});
        write_zoo_slice(folder / ("in/" + std::to_string(k)), slice);
    }
    const auto source = find_dicom_source((folder / "in").string(), {});
    const DicomProvenance made{"seed", "Lacuna", "0", "part"};
    write_dicom_report({{"Defect 1", "2.25.77", "void", 2, {{DicomQuantity::volume_mm3, 0.25}}, {{"Why", said}}}},
                       {{"Verdict", said}}, "HU", *source, made, folder / "sr.dcm");
    DcmFileFormat format;
    EXPECT_TRUE(format.loadFile((folder / "sr.dcm").c_str()).good());
    DcmDataset& set = *format.getDataset();
    Written written{dicom::text_of(set, DCM_SpecificCharacterSet), dicom::text_of(set, DCM_PatientName), all_text(set)};
    DcmElement* name = nullptr;
    written.valid = set.findAndGetElement(DCM_PatientName, name).good() && name->checkValue("1").good();
    return written;
}

TEST(DicomReport, NamesTheCharacterSetItsTextsAreIn) {
    const std::string latin =
                          "Pr\xfc"
                          "fst\xfc"
                          "ck^A",
                      utf8 =
                          "Pr\xc3\xbc"
                          "fst\xc3\xbc"
                          "ck^A";
    const Written plain = report_of("", "PART^A", "fine");
    EXPECT_EQ(plain.charset, "");
    EXPECT_TRUE(plain.text.ends_with("finefine"));

    const Written name = report_of("ISO_IR 100", latin, "fine");
    EXPECT_EQ(name.charset, "ISO_IR 192");
    EXPECT_EQ(name.patient, utf8);
    EXPECT_TRUE(name.valid);

    const std::string zone =
        "Gr\xc3\xb6\xc3\x9f"
        "e";
    for (const auto& [charset, patient] :
         {std::pair<std::string, std::string>{"", "PART^A"}, {"ISO_IR 100", latin}, {"ISO_IR 192", utf8}}) {
        const Written both = report_of(charset, patient, zone);
        EXPECT_EQ(both.charset, "ISO_IR 192");
        EXPECT_TRUE(both.text.ends_with(zone + zone)) << both.text;
        EXPECT_TRUE(both.valid);
    }
    const Written odd = report_of("", latin, zone);  // bytes that the source's own character set does not explain
    EXPECT_TRUE(odd.valid) << odd.patient;
    EXPECT_TRUE(odd.text.ends_with(odd.charset == "ISO_IR 192" ? zone + zone : "Gr??eGr??e")) << odd.text;
}

}  // namespace
}  // namespace lacuna
