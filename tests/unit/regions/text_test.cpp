#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/region_columns.h"
#include "tests/unit/regions/shapes.h"

namespace lacuna::test {
namespace {

RegionTable sample_table() {
    const Volume volume = volume_of<std::int16_t>(grid({12, 10, 8}, {0.7, 0.7, 1.25}), [](int x, int y, int z) {
        return x < 5 ? -1000 : x == 8 && y == 4 && z == 4 ? 900 : 40;
    });
    return grown(volume, 0.1);
}

/// Fields of RFC 4180 text, row by row.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
            rows.back().back() += text[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && c == ',')
            rows.back().emplace_back();
        else if (!quoted && c == '\r' && i + 1 < text.size() && text[i + 1] == '\n')
            ++i, rows.emplace_back(1);
        else
            rows.back().back() += c;
    }
    rows.pop_back();
    return rows;
}

TEST(RegionsText, JsonHasTheContractsKeysInOrder) {
    const RegionTable table = sample_table();
    ASSERT_EQ(table.rows.size(), 3u);
    const auto json = nlohmann::ordered_json::parse(regions_to_json(table));
    EXPECT_EQ(json.at("adjacency"), "regions 6-connected, cavities 26-connected");
    EXPECT_TRUE(json.at("surface_method").get<std::string>().find("13 directions") != std::string::npos);
    EXPECT_EQ(json.at("value_range"), (std::vector<double>{-1000, 900}));
    ASSERT_EQ(json.at("regions").size(), 3u);
    std::size_t k = 0;
    for (const auto& [key, value] : json.at("regions")[0].items())
        if (k < k_contract_keys.size()) {
            EXPECT_EQ(key, k_contract_keys[k++]);
        }
    EXPECT_EQ(k, k_contract_keys.size());
    const auto& row = json.at("regions")[0];
    EXPECT_EQ(row.at("voxels"), table.rows[0].voxels);
    EXPECT_EQ(row.at("holes"), 1);
    EXPECT_EQ(row.at("centroid_mm")[0].get<double>(), table.rows[0].centroid_mm.x);
    EXPECT_EQ(row.at("bbox_mm")[1][2].get<double>(), table.rows[0].bbox_max_mm.z);
}

TEST(RegionsText, AnEmptyTableIsStillWhole) {
    RegionTable table;
    EXPECT_TRUE(nlohmann::json::parse(regions_to_json(table)).at("regions").empty());
    EXPECT_EQ(parse_csv(regions_to_csv(table)).size(), 1u);
}

TEST(RegionsText, CsvReadsBackTheSameNumbers) {
    const RegionTable table = sample_table();
    const auto rows = parse_csv(regions_to_csv(table));
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t k = 0; k < k_contract_keys.size(); ++k) EXPECT_EQ(rows[0][k], k_contract_keys[k]);
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    const auto field = [&](const std::string& key, std::size_t row) {
        return rows[row][std::size_t(std::find(rows[0].begin(), rows[0].end(), key) - rows[0].begin())];
    };
    EXPECT_EQ(std::stod(field("surface_mm2", 2)), table.rows[1].surface_mm2);
    EXPECT_EQ(std::stod(field("centroid_mm_y", 2)), table.rows[1].centroid_mm.y);
    std::istringstream box(field("bbox_mm", 1));
    for (const double expect :
         {table.rows[0].bbox_min_mm.x, table.rows[0].bbox_min_mm.y, table.rows[0].bbox_min_mm.z,
          table.rows[0].bbox_max_mm.x, table.rows[0].bbox_max_mm.y, table.rows[0].bbox_max_mm.z}) {
        double value = 0;
        box >> value;
        EXPECT_EQ(value, expect);
    }
}

TEST(RegionsText, KeepsDotsUnderALocaleWithCommas) {
    const RegionTable table = sample_table();
    const std::string csv = regions_to_csv(table), json = regions_to_json(table);
    struct Commas : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
    const std::string c_before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"})
        if (std::setlocale(LC_ALL, name)) break;
    EXPECT_EQ(regions_to_csv(table), csv);
    EXPECT_EQ(regions_to_json(table), json);
    std::locale::global(before);
    std::setlocale(LC_ALL, c_before.c_str());
}

TEST(RegionsText, QuotesAFlagWithACommaInIt) {
    RegionTable table = sample_table();
    table.rows.resize(1);
    table.rows[0].flags = {"a, \"b\"", "c"};
    const auto rows = parse_csv(regions_to_csv(table));
    EXPECT_EQ(rows[1][19], "a, \"b\";c");
    EXPECT_EQ(rows[0][19], "flags");
}

TEST(RegionsText, WhatSurfacesSayStandsBehindTheRest) {
    RegionTable table = sample_table();
    const auto before = parse_csv(regions_to_csv(table));
    const std::size_t columns = before[0].size();
    const auto column = [&](const std::string& key) {
        return std::size_t(std::find(before[0].begin(), before[0].end(), key) - before[0].begin());
    };
    for (const std::string& key : k_surface_keys) {
        ASSERT_LT(column(key), columns) << key;
        EXPECT_GT(column(key), column("principal_lengths_mm_3"));
        if (key != "surface_crofton_mm2") {
            EXPECT_EQ(before[1][column(key)], "") << key << " is not measured yet";
        }
    }
    const Volume volume = volume_of<std::int16_t>(grid({12, 10, 8}, {0.7, 0.7, 1.25}), [](int x, int y, int z) {
        return x < 5 ? -1000 : x == 8 && y == 4 && z == 4 ? 900 : 40;
    });
    measure_surfaces(volume, table);
    const auto after = parse_csv(regions_to_csv(table));
    for (std::size_t r = 1; r < after.size(); ++r) {
        ASSERT_EQ(after[r].size(), columns);
        const RegionCharacteristics& row = table.rows[r - 1];
        EXPECT_EQ(std::stod(after[r][column("surface_mesh_mm2")]), row.surface_mesh_mm2);
        EXPECT_EQ(std::stod(after[r][column("diameter_mm")]), row.diameter_mm);
        EXPECT_EQ(std::stod(after[r][column("projected_area_mm2_z")]), row.projected_area_mm2.z);
        EXPECT_EQ(std::stod(after[r][column("gap_mm")]), row.gap_mm);
    }
    const auto json = nlohmann::ordered_json::parse(regions_to_json(table));
    EXPECT_NE(json.at("surface_method").get<std::string>().find("Crofton"), std::string::npos);
    EXPECT_NE(json.at("surface_mesh_method").get<std::string>().find("marching cubes"), std::string::npos);
    for (const std::string& key : k_surface_keys) EXPECT_TRUE(json.at("regions")[0].contains(key)) << key;
    EXPECT_EQ(json.at("regions")[0].at("projected_area_mm2").size(), 3u);
}

TEST(RegionsText, NumbersThatAreNoneBecomeNullAndEmpty) {
    RegionTable table = sample_table();
    table.rows[0].mean = std::nan("");
    EXPECT_TRUE(nlohmann::json::parse(regions_to_json(table)).at("regions")[0].at("mean").is_null());
    EXPECT_EQ(parse_csv(regions_to_csv(table))[1][9], "");
}

}  // namespace
}  // namespace lacuna::test
