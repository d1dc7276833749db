// The zoo of criteria: what is refused names the key, what is accepted means what it says.

#include "core/inspect/criteria.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/io/volume_writer.h"
#include "core/volume/samples.h"
#include "tests/unit/inspect/hand_made_part.h"

namespace lacuna {

namespace {

struct BadCriteria {
    const char* name;
    const char* json;
    const char* named;  ///< what the message must hold
};

class Refused : public testing::TestWithParam<BadCriteria> {};

TEST_P(Refused, NamingTheKey) {
    try {
        parse_criteria(GetParam().json, "limits.json");
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::bad_input);
        const std::string what = error.what();
        EXPECT_NE(what.find(GetParam().named), std::string::npos) << what;
        EXPECT_NE(what.find("limits.json"), std::string::npos) << what;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Criteria, Refused,
    testing::Values(
        BadCriteria{"nan", R"({"limits": {"porosity_percent": NaN}})", "porosity_percent"},
        BadCriteria{"nan_as_text", R"({"limits": {"porosity_percent": "NaN"}})", "limits.porosity_percent"},
        BadCriteria{"too_large", R"({"limits": {"defect_volume_mm3": 1e999}})", "defect_volume_mm3"},
        BadCriteria{"negative", R"({"limits": {"defect_diameter_mm": -1}})", "limits.defect_diameter_mm"},
        BadCriteria{"over_100", R"({"limits": {"porosity_percent": 101}})", "limits.porosity_percent"},
        BadCriteria{"count_beyond_counting", R"({"limits": {"count": 1e30}})", "limits.count"},
        BadCriteria{"half_a_count", R"({"limits": {"count": 1.5}})", "limits.count"},
        BadCriteria{"unknown_at_top", R"({"limit": {}})", "limit is no known key"},
        BadCriteria{"unknown_limit", R"({"limits": {"pore_size_mm": 1}})", "limits.pore_size_mm"},
        BadCriteria{"no_unit", R"({"limits": {"defect_diameter": 1}})", "write defect_diameter_mm"},
        BadCriteria{"no_unit_porosity", R"({"limits": {"porosity": 1}})", "write porosity_percent"},
        BadCriteria{"no_unit_box", R"({"zones": [{"name": "a", "box": [], "limits": {}}]})", "write box_mm"},
        BadCriteria{"unit_in_value", R"({"limits": {"defect_diameter_mm": "1 mm"}})", "limits.defect_diameter_mm"},
        BadCriteria{"twice", R"({"limits": {"count": 1, "count": 2}})", "count is given twice"},
        BadCriteria{"material_order", R"({"material": [5, 4]})", "material has lo >= hi"},
        BadCriteria{"material_word", R"({"material": "metal"})", "material"},
        BadCriteria{"no_kind", R"({"defects": {}})", "defects names no kind"},
        BadCriteria{"unknown_kind", R"({"defects": {"crack": "auto"}})", "defects.crack"},
        BadCriteria{"void_above", R"({"defects": {"void": {"above": 3}}})", "defects.void.above"},
        BadCriteria{"sides_cross", R"({"defects": {"void": {"below": 9}, "inclusion": {"above": 3}}})", "lo > hi"},
        BadCriteria{"all_void", R"({"material": [1, 2], "defects": {"void": {"below": 9}}})", "defects.void.below"},
        BadCriteria{"no_voxel", R"({"min_voxels": 0})", "min_voxels"},
        BadCriteria{"connectivity", R"({"connectivity": 8})", "connectivity"},
        BadCriteria{"method", R"({"method": "magic"})", "method"},
        BadCriteria{"fixed_without_value", R"({"method": "fixed"})", "method"},
        BadCriteria{"zone_no_name", R"({"zones": [{"box_mm": [0,0,0,1,1,1], "limits": {}}]})", "zones[0].name"},
        BadCriteria{"zone_two_names",
                    R"({"zones": [{"name": "a", "box_mm": [0,0,0,1,1,1], "limits": {}},
                                  {"name": "a", "box_mm": [0,0,0,1,1,1], "limits": {}}]})",
                    "zones[1].name"},
        BadCriteria{"zone_nowhere", R"({"zones": [{"name": "a", "limits": {}}]})", "box_mm or labels"},
        BadCriteria{"zone_order", R"({"zones": [{"name": "a", "box_mm": [[0,0,0],[1,-1,1]], "limits": {}}]})",
                    "zones[0].box_mm has lo >= hi along y"},
        BadCriteria{"zone_five", R"({"zones": [{"name": "a", "box_mm": [0,0,0,1,1], "limits": {}}]})",
                    "zones[0].box_mm"},
        BadCriteria{"zone_no_limits", R"({"zones": [{"name": "a", "box_mm": [0,0,0,1,1,1]}]})", "zones[0].limits"},
        BadCriteria{"cut_short", "{\"limits\": {\n \"count\": ", "line 2"}, BadCriteria{"a_list", "[]", "object"},
        BadCriteria{"nothing", "", "JSON"}),
    [](const auto& row) { return std::string(row.param.name); });

/// docs/inspection.md's own example.
TEST(Criteria, AValueOfInclusionsLeavesVoidsToBeFound) {
    const Criteria c = parse_criteria(R"({"defects": {"void": "auto", "inclusion": {"above": 210}}})", "c.json");
    EXPECT_EQ(c.detection.method, ThresholdMethod::local);
    SampleOptions options;
    options.size = 32;
    const Volume volume = make_sample("casting", options).volume;
    EXPECT_TRUE(analyse_part(volume, c.detection).part.has_material);
    const Criteria alone = parse_criteria(R"({"defects": {"inclusion": {"above": 210}}})", "c.json");
    EXPECT_EQ(alone.detection.method, ThresholdMethod::fixed);
    EXPECT_TRUE(analyse_part(volume, alone.detection).part.has_material);
    const Criteria said = parse_criteria(R"({"defects": {"inclusion": {"above": 210}}, "method": "fixed"})", "c.json");
    EXPECT_EQ(said.detection.method, ThresholdMethod::fixed);
}

TEST(Criteria, MeanWhatTheySay) {
    const Criteria c =
        parse_criteria(R"({"material": [10, 200], "defects": {"void": {"below": 90}, "inclusion": "auto"},
        "min_voxels": 12, "connectivity": 6, "limits": {"porosity_percent": 0.5, "count": 0},
        "zones": [{"name": "seat", "box_mm": [[0, 1, 2], [3, 4, 5]], "limits": {"min_gap_mm": 2}}]})",
                       "c.json");
    EXPECT_EQ(c.detection.material, (ValueRange{10, 200}));
    EXPECT_TRUE(c.detection.voids && c.detection.inclusions);
    EXPECT_EQ(c.detection.void_below, 90);
    EXPECT_FALSE(c.detection.inclusion_above);
    EXPECT_EQ(c.detection.min_voxels, 12);
    EXPECT_EQ(c.detection.connectivity, Connectivity::c6);
    EXPECT_EQ(c.detection.method, ThresholdMethod::fixed);
    EXPECT_EQ(c.limits[Rule::porosity_percent], 0.5);
    EXPECT_EQ(c.limits[Rule::count], 0);
    EXPECT_FALSE(c.limits[Rule::min_gap_mm]);
    ASSERT_EQ(c.zones.size(), 1u);
    EXPECT_EQ(c.zones[0].box_max_mm, glm::dvec3(3, 4, 5));
    EXPECT_EQ(c.zones[0].limits[Rule::min_gap_mm], 2);
}

TEST(Criteria, SameContentHasOneForm) {
    const Criteria a = parse_criteria("{\"limits\":{\"count\":3}}", "a.json");
    const Criteria b = parse_criteria("{ \"limits\" : {\n\t\"count\" : 3 } }", "b.json");
    EXPECT_EQ(a.json, b.json);
    EXPECT_EQ(a.detection.method, ThresholdMethod::local);
}

TEST(Criteria, SchemaKnowsTheSameKeys) {
    const auto schema = nlohmann::json::parse(read_file(LACUNA_SOURCE_DIR "/docs/schemas/criteria.schema.json"));
    for (const Rule rule : k_rules)
        EXPECT_TRUE(schema["$defs"]["limits"]["properties"].contains(std::string(name_of(rule)))) << name_of(rule);
    EXPECT_EQ(schema["$defs"]["limits"]["properties"].size(), k_rules.size());
    for (const auto& [key, value] : schema["properties"].items()) {
        // Each key the schema names is one the reader knows: it may refuse the value, but not the key.
        try {
            parse_criteria("{\"" + key + "\": null}", "s.json");
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find("no known key"), std::string::npos) << error.what();
        }
    }
}

GridGeometry grid_of(glm::ivec3 size) {
    GridGeometry g;
    g.size = size;
    g.spacing = {0.5, 0.5, 2};
    g.origin = {10, 20, 30};
    return g;
}

Zone box(glm::dvec3 lo, glm::dvec3 hi) {
    Zone zone;
    zone.name = "seat";
    zone.box_min_mm = lo;
    zone.box_max_mm = hi;
    return zone;
}

TEST(ZoneMask, HoldsExactlyTheVoxelsWhoseCentreIsInTheBox) {
    const GridGeometry g = grid_of({7, 5, 3});
    const Zone zone = box({10.4, 20, 31}, {11.6, 21.2, 34});
    const ZoneMask mask(zone, g);
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 7; ++x) {
                const glm::dvec3 mm = g.voxel_to_mm({x, y, z});
                const bool inside = glm::all(glm::greaterThanEqual(mm, zone.box_min_mm)) &&
                                    glm::all(glm::lessThanEqual(mm, zone.box_max_mm));
                EXPECT_EQ(mask.contains(x, y, z), inside) << x << ' ' << y << ' ' << z;
            }
    EXPECT_FALSE(mask.reaches_out());
}

TEST(ZoneMask, OutsideIsRefusedAndReachingOutIsNoticed) {
    const GridGeometry g = grid_of({7, 5, 3});
    for (const Zone& zone : {box({0, 0, 0}, {1, 1, 1}), box({10.1, 20.1, 30.1}, {10.2, 20.2, 30.2})}) try {
            const ZoneMask mask(zone, g);
            FAIL() << "accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::bad_input);
            EXPECT_NE(std::string(error.what()).find("seat"), std::string::npos);
        }
    EXPECT_TRUE(ZoneMask(box({9, 20, 30}, {11, 21, 34}), g).reaches_out());
    // The whole volume, to the faces of its outermost voxels, is inside.
    EXPECT_FALSE(ZoneMask(box({9.75, 19.75, 29}, {13.25, 22.25, 35}), g).reaches_out());
}

TEST(ZoneMask, ReadsLabelsOnThePartsGridOnly) {
    const auto folder = std::filesystem::temp_directory_path() / ("lacuna-zone-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const GridGeometry g = grid_of({4, 3, 2});
    LabelVolume labels{g, std::make_shared<std::vector<std::uint32_t>>(24)};
    (*labels.labels)[5] = 2;
    (*labels.labels)[20] = 7;
    write_labels(labels, folder / "zones.nrrd");
    Zone zone;
    zone.name = "seat";
    zone.is_box = false;
    zone.labels = folder / "zones.nrrd";
    const ZoneMask any(zone, g);
    EXPECT_TRUE(any.contains(1, 1, 0) && any.contains(0, 2, 1));
    EXPECT_FALSE(any.contains(0, 0, 0));
    zone.label = 7;
    const ZoneMask seven(zone, g);
    EXPECT_FALSE(seven.contains(1, 1, 0));
    EXPECT_TRUE(seven.contains(0, 2, 1));
    zone.label = 3;
    EXPECT_THROW(ZoneMask(zone, g), Error);
    zone.label = 7;
    EXPECT_THROW(ZoneMask(zone, grid_of({4, 3, 3})), Error);
    GridGeometry moved = g;
    moved.origin.x += 0.3;
    EXPECT_THROW(ZoneMask(zone, moved), Error);

    const GridGeometry cube = grid_of({3, 3, 3});  // of whose axes two may be swapped and its ends stay where they are
    LabelVolume cubic{cube, std::make_shared<std::vector<std::uint32_t>>(27, 7u)};
    write_labels(cubic, folder / "zones.nrrd");
    EXPECT_NO_THROW(ZoneMask(zone, cube));
    GridGeometry swapped = cube;
    swapped.direction = glm::dmat3(cube.direction[0], cube.direction[2], cube.direction[1]);
    EXPECT_THROW(ZoneMask(zone, swapped), Error);
    std::filesystem::remove_all(folder);
}

TEST(CriteriaJson, WhatIsWrittenReadsBackTheSame) {
    const std::string json =
        R"({"material":[100.5,900.0],"defects":{"void":{"below":90.25},"inclusion":"auto"},"min_voxels":12,)"
        R"("method":"otsu","connectivity":18,"limits":{"porosity_percent":0.5,"count":3},)"
        R"("zones":[{"name":"rim","box_mm":[[0.0,1.0,2.0],[3.0,4.0,5.0]],"limits":{"min_gap_mm":1.25}}]})";
    const Criteria criteria = parse_criteria(json, "limits.json");
    EXPECT_EQ(criteria_to_json(criteria), json);
    const Criteria plain = parse_criteria(R"({"limits":{"count":1}})", "limits.json");
    EXPECT_EQ(criteria_to_json(parse_criteria(criteria_to_json(plain), "again.json")), criteria_to_json(plain));
}

}  // namespace

}  // namespace lacuna
