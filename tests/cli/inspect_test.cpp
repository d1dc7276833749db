// lacuna inspect as its users meet it.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/support/test_data.h"

namespace lacuna::test {

namespace {

namespace fs = std::filesystem;
using Inspect = ProgramTest;

void write_text(const std::string& file, const std::string& text) { std::ofstream(file) << text; }

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

const std::string k_easy = R"({"limits": {"porosity_percent": 50}})";
const std::string k_strict = R"({"limits": {"porosity_percent": 0, "count": 0}})";

TEST_F(Inspect, PassIsZeroAndFailIsThree) {
    write_text(path("easy.json"), k_easy);
    write_text(path("strict.json"), k_strict);
    const Outcome pass = lacuna(
        {"inspect", "sample:casting@64", "--criteria", path("easy.json"), "--report", path("a"), "--worst", "1"});
    EXPECT_EQ(pass.status, 0) << pass.err << pass.out;
    const Outcome fail = lacuna(
        {"inspect", "sample:casting@64", "--criteria", path("strict.json"), "--report", path("b"), "--worst", "1"});
    EXPECT_EQ(fail.status, 3) << fail.err << fail.out;
    const auto json = nlohmann::json::parse(bytes_of(folder_ / "b/report.json"));
    EXPECT_EQ(json["verdict"], "fail");
    EXPECT_GT(json["count"].get<int>(), 0);
    EXPECT_EQ(names_in(folder_ / "b"), (std::vector<std::string>{"defects.csv", "defects.stl", "labels.nrrd",
                                                                 "report.html", "report.json", "report.pdf"}));
}

TEST_F(Inspect, SameInputAndCriteriaGiveTheSameBytes) {
    write_text(path("c.json"), k_strict);
    for (const char* to : {"a", "b"})
        lacuna({"inspect", "sample:casting@48", "--criteria", path("c.json"), "--report", path(to), "--worst", "2"},
               {{{"LACUNA_THREADS", to[0] == 'a' ? "1" : "2"}}});
    ASSERT_FALSE(names_in(folder_ / "a").empty());
    EXPECT_EQ(names_in(folder_ / "a"), names_in(folder_ / "b"));
    for (const std::string& name : names_in(folder_ / "a"))
        EXPECT_EQ(bytes_of(folder_ / "a" / name), bytes_of(folder_ / "b" / name)) << name;
}

TEST_F(Inspect, AReportIsReplacedButNeverWhatSomebodyPutBesideIt) {
    write_text(path("c.json"), k_easy);
    const std::vector<std::string> words{"inspect",  "sample:casting@32", "--criteria", path("c.json"),
                                         "--report", path("r"),           "--worst",    "0"};
    ASSERT_EQ(lacuna(words).status, 0);
    ASSERT_EQ(lacuna(words).status, 0);
    write_text(path("r/limits.json"), k_easy);
    const Outcome outcome = lacuna(words);
    expect_failure(outcome, 1, "limits.json");
    EXPECT_EQ(bytes_of(folder_ / "r/limits.json"), k_easy);
    EXPECT_TRUE(fs::exists(path("r/report.json")));
}

TEST_F(Inspect, BadCriteriaAreRefusedBeforeAnyWork) {
    write_text(path("c.json"), R"({"limits": {"porosity": 1}})");
    // A volume this large takes seconds to make: the refusal must come before.
    const Outcome outcome =
        lacuna({"inspect", "sample:casting@512", "--criteria", path("c.json"), "--report", path("r")});
    expect_failure(outcome, 1, "porosity_percent");
    EXPECT_LT(outcome.seconds, 2);
    write_text(path("z.json"), R"({"zones": [{"name": "far", "box_mm": [900,900,900,901,901,901], "limits": {}}]})");
    expect_failure(lacuna({"inspect", "sample:casting@32", "--criteria", path("z.json"), "--report", path("r")}), 1,
                   "far");
    expect_failure(lacuna({"inspect", "sample:casting@32", "--criteria", path("none.json"), "--report", path("r")}), 1,
                   "none.json");
    EXPECT_FALSE(fs::exists(path("r")));
}

TEST_F(Inspect, NoPartACutPartAndOneValueCannotBeTold) {
    write_text(path("c.json"), k_easy);
    write_text(path("flat_16x16x16_uint8.raw"), std::string(4096, '\7'));
    std::string cut(4096, '\0');
    for (std::size_t i = 0; i < cut.size(); ++i)
        if (i % 16 > 3) cut[i] = char(120 + i % 5);
    write_text(path("cut_16x16x16_uint8.raw"), cut);
    for (const char* name : {"flat", "cut"}) {
        const Outcome outcome = lacuna({"inspect", path(std::string(name) + "_16x16x16_uint8.raw"), "--criteria",
                                        path("c.json"), "--report", path(name)});
        EXPECT_EQ(outcome.status, 3) << name << outcome.err;
        const auto json = nlohmann::json::parse(bytes_of(folder_ / name / "report.json"));
        EXPECT_EQ(json["verdict"], "cannot tell") << name;
        EXPECT_FALSE(json["reasons"].empty());
    }
}

TEST_F(Inspect, AFullDiskLeavesNoHalfReportAndTheOldOneStands) {
    write_text(path("c.json"), k_strict);
    const std::vector<std::string> words{"inspect",  "sample:casting@48", "--criteria", path("c.json"),
                                         "--report", path("r"),           "--worst",    "1"};
    Surroundings full = without_opencl(folder_);
    for (const long limit : {300L, 5000L, 40000L}) {
        full.file_size_limit = limit;
        expect_no_room(lacuna(words, full));
        EXPECT_EQ(files(), std::vector<std::string>{"c.json"}) << limit;
    }
    EXPECT_EQ(lacuna(words).status, 3);
    const std::string before = bytes_of(folder_ / "r/report.html");
    expect_no_room(lacuna(words, full));
    EXPECT_EQ(bytes_of(folder_ / "r/report.html"), before);
    EXPECT_EQ(files(), (std::vector<std::string>{"c.json", "r"}));
    EXPECT_EQ(lacuna(words).status, 3);  // a report is replaced
    EXPECT_EQ(files(), (std::vector<std::string>{"c.json", "r"}));
    fs::create_directory(path("mine"));
    write_text(path("mine/letter.txt"), "dear");
    expect_failure(lacuna({"inspect", "sample:casting@48", "--criteria", path("c.json"), "--report", path("mine")}), 1,
                   "not empty");
}

TEST_F(Inspect, AnInspectorsWordChangesTheVerdict) {
    write_text(path("c.json"), k_easy);
    const Outcome outcome = lacuna({"inspect", "sample:casting@48", "--criteria", path("c.json"), "--report", path("r"),
                                    "--worst", "0", "--reject", "1=looks like a crack"});
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_NE(bytes_of(folder_ / "r/report.html").find("rejected by hand: looks like a crack"), std::string::npos);
    expect_failure(
        lacuna({"inspect", "sample:casting@48", "--criteria", path("c.json"), "--report", path("s"), "--accept", "1"}),
        2, "--accept");
}

class DicomReport : public ProgramTest, public ::testing::WithParamInterface<const char*> {
protected:
    /// Inspects a series and holds each DICOM file of the report against dciodvfy and pydicom.
    void expect_sound_report(const std::string& input);
};

void DicomReport::expect_sound_report(const std::string& input) {
    write_text(path("c.json"), k_strict);
    const Outcome outcome =
        lacuna({"inspect", input, "--criteria", path("c.json"), "--report", path("r"), "--worst", "0"});
    ASSERT_EQ(outcome.status, 3) << outcome.err;
    std::string said;
    const bool validator = runs("command -v dciodvfy", said),
               pydicom = runs("/usr/bin/python3 -c 'import pydicom'", said);
    for (const char* name : {"seg.dcm", "sr.dcm", "key.dcm"}) {
        const std::string file = path(std::string("r/") + name);
        ASSERT_TRUE(fs::exists(file)) << name;
        if (validator) {
            runs("dciodvfy " + file, said);
            std::istringstream lines(said);
            for (std::string line; std::getline(lines, line);)
                EXPECT_FALSE(line.starts_with("Error")) << name << ": " << line;
        }
        if (pydicom) {
            EXPECT_TRUE(runs("/usr/bin/python3 -c \"import pydicom; d = pydicom.dcmread('" + file +
                                 "'); print(d.SOPClassUID, d.StudyInstanceUID); " +
                                 (std::string(name) == "sr.dcm" ? "d.ContentSequence[0]" : "d.PixelData[0]") + "\"",
                             said))
                << said;
        }
    }
    if (!validator || !pydicom) GTEST_SKIP() << "skipped in part: dciodvfy or pydicom is not installed";
}

TEST_P(DicomReport, PassesDciodvfyAndOpensInPydicom) {
    LACUNA_NEEDS_DATA(series, GetParam());
    expect_sound_report(series.string());
}

std::string series_name(const testing::TestParamInfo<const char*>& row) {
    constexpr const char* k_names[] = {"Diconde", "OneSlice", "HeadCt"};
    return k_names[row.index];
}
INSTANTIATE_TEST_SUITE_P(Series, DicomReport,
                         testing::Values("dicom_zoo/diconde_style_derived", "dicom_zoo/ct/CT_small.dcm",
                                         "medical/ct_head_vhf"),
                         series_name);

using DicomReportOfSample = DicomReport;

TEST_P(DicomReportOfSample, PassesDciodvfyAndOpensInPydicom) {
    const Outcome written = lacuna({"convert", std::string("sample:") + GetParam() + "@64", path("series/")});
    ASSERT_EQ(written.status, 0) << written.err;
    expect_sound_report(path("series"));
}

INSTANTIATE_TEST_SUITE_P(Written, DicomReportOfSample, testing::Values("head", "casting"),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace

}  // namespace lacuna::test
