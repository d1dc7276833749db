// report.json against the schema that is shipped for it, by a validator that is not ours.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/support/test_data.h"

namespace lacuna::test {

namespace {

using nlohmann::json;

const std::string k_source = LACUNA_SOURCE_DIR;

class ReportSchema : public ProgramTest {
protected:
    /// Whether the validator finds no fault in the files (quoted); `said` gets its lines.
    bool keeps_to(const std::string& schema, const std::string& files, std::string& said) const {
        return runs("/usr/bin/python3 -W ignore '" + k_source + "/tests/support/schema_faults.py' '" + k_source +
                        "/docs/schemas/" + schema + "' " + files,
                    said);
    }
    bool there_is_a_validator() const {
        std::string said;
        return runs("/usr/bin/python3 -c 'import jsonschema'", said);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    /// Inspects and holds report and criteria against their schemas.
    void expect_kept(const std::string& criteria, std::vector<std::string> input) const {
        write("criteria.json", criteria);
        std::vector<std::string> words{"inspect"};
        words.insert(words.end(), input.begin(), input.end());
        for (const std::string& word : {std::string("--criteria"), path("criteria.json"), std::string("--report"),
                                        path("r"), std::string("--worst"), std::string("1")})
            words.push_back(word);
        const Outcome outcome = lacuna(words);
        ASSERT_TRUE(outcome.status == 0 || outcome.status == 3) << input[0] << ": " << outcome.err;
        std::string said;
        EXPECT_TRUE(keeps_to("criteria.schema.json", "'" + path("criteria.json") + "'", said)) << said;
        EXPECT_TRUE(keeps_to("report.schema.json", "'" + path("r/report.json") + "'", said))
            << input[0] << " " << criteria << said;
    }
};

const std::string k_everything = R"({"material": [100, 100000],
    "defects": {"void": {"below": 100}, "inclusion": {"above": 5000}}, "min_voxels": 8, "connectivity": 18,
    "limits": {"porosity_percent": 0.5, "defect_volume_mm3": 1, "defect_diameter_mm": 1.2, "count": 2,
               "min_gap_mm": 0.6, "min_surface_distance_mm": 1},
    "zones": [{"name": "corner", "box_mm": [[0, 0, 0], [5, 5, 5]], "limits": {"count": 0}},
              {"name": "side", "box_mm": [0, 0, 0, 5, 9, 9], "limits": {"min_gap_mm": 0.1}}]})";
const std::string k_both = R"({"defects": {"void": "auto", "inclusion": "auto"}, "limits": {"count": 0}})";

TEST_F(ReportSchema, IsKeptByEveryKindOfReport) {
    if (!there_is_a_validator()) GTEST_SKIP() << "python3-jsonschema is not installed";
    for (const std::string& criteria : {k_everything, k_both, std::string("{}")})
        expect_kept(criteria, {"sample:casting@48"});
    expect_kept(k_both, {"sample:casting@48", "--reject", "1=a crack", "--accept", "2=machined off"});
    expect_kept(k_both, {"sample:spheres@32"});
}

TEST_F(ReportSchema, IsKeptWhereThereIsNothingToMeasure) {
    if (!there_is_a_validator()) GTEST_SKIP() << "python3-jsonschema is not installed";
    write("flat_8x8x8_uint8.raw", std::string(512, '\7'));
    std::string nan;
    for (int i = 0; i < 512; ++i) nan += std::string("\x00\x00\xc0\x7f", 4);
    write("nan.raw", nan);
    write("line_97x1x1_uint8.raw",
          std::string(20, '\0') + std::string(20, '\x64') + std::string(9, '\0') + std::string(48, '\x64'));
    expect_kept(k_both, {path("flat_8x8x8_uint8.raw")});
    expect_kept(k_both, {path("nan.raw"), "--raw", "8x8x8:f32"});
    expect_kept(k_both, {path("line_97x1x1_uint8.raw")});
}

TEST_F(ReportSchema, IsKeptOfADicondeSeries) {
    if (!there_is_a_validator()) GTEST_SKIP() << "python3-jsonschema is not installed";
    LACUNA_NEEDS_DATA(series, "dicom_zoo/diconde_style_derived");
    expect_kept(k_both, {series.string()});
    EXPECT_TRUE(json::parse(bytes_of(path("r/report.json")))["scan"]["dicom"].is_object());
}

TEST_F(ReportSchema, RefusesWhatIsNoReport) {
    if (!there_is_a_validator()) GTEST_SKIP() << "python3-jsonschema is not installed";
    expect_kept(k_everything, {"sample:casting@48"});
    const json whole = json::parse(bytes_of(path("r/report.json")));
    ASSERT_FALSE(whole["defects"].empty());
    ASSERT_FALSE(whole["pictures"].empty());
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, const json& report) {
        write(name + ".json", report.dump());
        names.push_back(name);
    };
    // The criteria's schema is a file of its own: its rules count too.
    json wrong = whole;
    wrong["criteria"]["limits"]["porosity"] = 1;
    add("limit-unknown", wrong);
    // Whatever is left out or added, wherever it stands.
    for (const auto& [key, value] : whole.items()) {
        wrong = whole;
        wrong.erase(key);
        add("without-" + key, wrong);
    }
    for (const char* place : {"scan", "part", "stability", "defects/0", "pictures/0", "rules/0"}) {
        const json::json_pointer at(std::string("/") + place);
        std::string name = place;
        std::replace(name.begin(), name.end(), '/', '-');
        wrong = whole;
        wrong.at(at)["another"] = 1;
        add(name + "-with-another", wrong);
        for (const auto& [key, value] : whole.at(at).items()) {
            wrong = whole;
            wrong.at(at).erase(key);
            add(name + "-without-" + key, wrong);
        }
    }
    std::string files, said;
    for (const std::string& name : names) files += " '" + path(name + ".json") + "'";
    EXPECT_FALSE(keeps_to("report.schema.json", files, said));
    for (const std::string& name : names) EXPECT_NE(said.find("/" + name + ".json: "), std::string::npos) << name;
}

}  // namespace

}  // namespace lacuna::test
