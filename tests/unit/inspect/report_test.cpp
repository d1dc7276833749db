// The report's files from a part whose every value is known.

#include "core/inspect/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <clocale>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/inspect/report_document.h"
#include "tests/unit/inspect/hand_made_part.h"

namespace lacuna {

namespace {

using test::HandMadePart;

Criteria strict() {
    return parse_criteria(R"({"limits": {"porosity_percent": 1.4, "defect_volume_mm3": 1.5, "min_gap_mm": 0.1}})",
                          "c.json");
}

/// Splits RFC 4180 text.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows{{""}};
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inside && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            rows.back().back() += '"';
            ++i;
        } else if (c == '"') {
            inside = !inside;
        } else if (!inside && c == ',') {
            rows.back().emplace_back();
        } else if (!inside && c == '\r') {
            EXPECT_EQ(text.at(i + 1), '\n');
            ++i;
            rows.push_back({""});
        } else {
            rows.back().back() += c;
        }
    }
    rows.pop_back();
    return rows;
}

/// A locale that writes 1,5 and groups by dots, whatever is installed.
struct CommaDecimals : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

class CommaLocale {
public:
    CommaLocale() : before_(std::locale::global(std::locale(std::locale(), new CommaDecimals))) {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
            if (std::setlocale(LC_ALL, name)) break;
    }
    ~CommaLocale() {
        std::locale::global(before_);
        std::setlocale(LC_ALL, "C");
    }

private:
    std::locale before_;
};

TEST(Csv, StartsWithTheContractsRowAndReadsBack) {
    const InspectionReport report = HandMadePart().report(strict(), {{2, true, "said \"fine\", twice\r\nover"}});
    const auto rows = parse_csv(defects_csv(report));
    ASSERT_EQ(rows.size(), 4u);
    const std::vector<std::string> contract{"id",
                                            "type",
                                            "volume_mm3",
                                            "voxels",
                                            "centroid_mm",
                                            "bbox_mm",
                                            "diameter_mm",
                                            "equivalent_diameter_mm",
                                            "sphericity",
                                            "shape_factor",
                                            "surface_distance_mm",
                                            "gap_mm",
                                            "projected_area_mm2",
                                            "mean_value",
                                            "probability",
                                            "verdict",
                                            "why"};
    ASSERT_GT(rows[0].size(), contract.size());
    for (std::size_t c = 0; c < contract.size(); ++c) EXPECT_EQ(rows[0][c], contract[c]);
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(rows[1][1], "void");
    EXPECT_EQ(rows[1][2], "3.375");
    EXPECT_EQ(rows[1][3], "27");
    EXPECT_EQ(rows[1][4], "3 3 3");
    EXPECT_EQ(rows[1][15], "fail");
    EXPECT_EQ(rows[2][16], "accepted by hand: said \"fine\", twice\r\nover");
}

TEST(Csv, HasDotsUnderACommaLocale) {
    const InspectionReport report = HandMadePart().report(strict());
    const std::string csv = defects_csv(report), json = report_json(report), html = report_html(report);
    const CommaLocale locale;
    std::ostringstream probe;
    probe << 1.5;
    ASSERT_EQ(probe.str(), "1,5");
    EXPECT_EQ(defects_csv(report), csv);
    EXPECT_EQ(report_json(report), json);
    EXPECT_EQ(report_html(report), html);
    const Criteria read = parse_criteria(R"({"limits": {"porosity_percent": 0.25}})", "c.json");
    EXPECT_EQ(read.limits[Rule::porosity_percent], 0.25);
}

/// Every key the schema requires is there, and every key there is one it knows, where it says so.
void hold_to_schema(const nlohmann::json& value, const nlohmann::json& schema, const nlohmann::json& root,
                    const std::string& at) {
    if (schema.contains("$ref")) {
        const std::string ref = schema["$ref"];
        if (!ref.starts_with("#/$defs/")) return;
        return hold_to_schema(value, root["$defs"][ref.substr(8)], root, at);
    }
    if (schema.contains("required"))
        for (const auto& key : schema["required"]) {
            EXPECT_TRUE(value.contains(key)) << at << " lacks " << key;
        }
    if (schema.contains("enum")) {
        const auto& list = schema["enum"];
        EXPECT_NE(std::find(list.begin(), list.end(), value), list.end()) << at << ": " << value;
    }
    if (value.is_object() && schema.contains("properties"))
        for (const auto& [key, inner] : value.items()) {
            if (schema["properties"].contains(key))
                hold_to_schema(inner, schema["properties"][key], root, at + "." + key);
            else
                EXPECT_FALSE(schema.contains("additionalProperties")) << at << " has " << key;
        }
    if (value.is_array() && schema.contains("items"))
        for (const auto& inner : value) hold_to_schema(inner, schema["items"], root, at + "[]");
}

TEST(Json, IsWhatItsSchemaSays) {
    HandMadePart part;
    part.analysis.defects[0].gap_mm = INFINITY;
    part.analysis.defects[1].volume_mm3 = {NAN, NAN, NAN};
    const auto json = nlohmann::json::parse(report_json(part.report(strict(), {{3, true, "small"}})));
    const auto schema = nlohmann::json::parse(read_file(LACUNA_SOURCE_DIR "/docs/schemas/report.schema.json"));
    hold_to_schema(json, schema, schema, "report");
    EXPECT_EQ(json["verdict"], "fail");
    EXPECT_EQ(json["count"], 3);
    EXPECT_EQ(json["defects"].size(), 3u);
    EXPECT_TRUE(json["defects"][0]["gap_mm"].is_null());
    EXPECT_TRUE(json["defects"][1]["volume_mm3"]["value"].is_null());
    EXPECT_EQ(json["criteria"]["limits"]["porosity_percent"], 1.4);
}

/// Checks that tags open and close in order; the few that never close are known.
void expect_well_formed(const std::string& html) {
    std::vector<std::string> open;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        if (html.compare(at, 2, "<!") == 0 || html.compare(at, 2, "<?") == 0) continue;
        const std::size_t end = html.find('>', at);
        ASSERT_NE(end, std::string::npos);
        const bool closes = html[at + 1] == '/';
        std::size_t from = at + 1 + closes, to = from;
        while (to < end && (std::isalnum(static_cast<unsigned char>(html[to])) || html[to] == '-' || html[to] == ':'))
            ++to;
        const std::string tag = html.substr(from, to - from);
        if (tag == "meta" || tag == "link" || tag == "img" || html[end - 1] == '/') continue;
        if (!closes) {
            open.push_back(tag);
            if (tag == "script" || tag == "style") at = html.find("</" + tag, at) - 1;
            continue;
        }
        ASSERT_FALSE(open.empty()) << tag;
        ASSERT_EQ(open.back(), tag);
        open.pop_back();
    }
    EXPECT_TRUE(open.empty());
}

TEST(Html, IsWellFormedSelfContainedAndEscapes) {
    HandMadePart part;
    part.analysis.part.warnings.push_back("<b onclick=\"x\"> & co");
    InspectionReport report = part.report(strict());
    report.scan.name = "a<script>alert(1)</script>";
    report.key = {"key", {2, 1}, {255, 0, 0, 0, 255, 0}, "plan", "error"};
    const std::string html = report_html(report);
    expect_well_formed(html);
    EXPECT_EQ(html.find("<script>alert"), std::string::npos);
    EXPECT_EQ(html.find("<b onclick"), std::string::npos);
    EXPECT_NE(html.find("FAIL"), std::string::npos);
    EXPECT_LT(html.find("FAIL"), html.find("SHA-256"));  // the verdict comes first
    for (const char* outside : {"src=\"http", "href=\"http", "@import", "<iframe", "<object"})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
    // A chart clips by url(#...), a part of the same file; any other url() would be fetched from elsewhere.
    for (std::size_t at = html.find("url("); at != std::string::npos; at = html.find("url(", at + 1))
        EXPECT_EQ(html.compare(at, 5, "url(#"), 0) << html.substr(at, 60);
    EXPECT_NE(html.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    EXPECT_EQ(html, report_html(report));
}

std::size_t count_of(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++n;
    return n;
}

TEST(Pdf, HasAsManyPagesAsItsRowsNeedAndTheSameBytesTwice) {
    ReportDocument document{"title", "Lacuna 0.0.0", {}};
    Table table{{{"Id", 40, true}, {"Why", 200}}, {}, false};
    for (int i = 0; i < 400; ++i)
        table.rows.push_back({{std::to_string(i)}, {i % 3 ? "short" : std::string(300, 'w')}});
    document.blocks.push_back(table);
    const std::string pdf = to_pdf(document);
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_GT(count_of(pdf, "/Type /Page\n") + count_of(pdf, "/Type /Page "), 8u);
    EXPECT_EQ(pdf, to_pdf(document));
    EXPECT_EQ(pdf.find("/CreationDate"), std::string::npos);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(to_pdf(document, {stop.get_token(), nullptr}), Error);
    document.blocks = {Paragraph{"one line"}};
    const std::string one = to_pdf(document);
    EXPECT_EQ(count_of(one, "/Type /Page\n") + count_of(one, "/Type /Page "), 1u);
}

}  // namespace

}  // namespace lacuna
