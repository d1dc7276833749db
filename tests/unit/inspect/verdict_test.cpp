#include "core/inspect/verdict.h"

#include <gtest/gtest.h>

#include "tests/unit/inspect/hand_made_part.h"

namespace lacuna {

namespace {

using test::HandMadePart;

struct Held {
    const char* name;
    Measured value;
    double limit;
    bool from_above;
    Verdict verdict;
};

class HoldAgainst : public testing::TestWithParam<Held> {};

TEST_P(HoldAgainst, IntervalDecides) {
    const Held& row = GetParam();
    EXPECT_EQ(hold_against(row.value, row.limit, row.from_above), row.verdict);
}

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_inf = std::numeric_limits<double>::infinity();
INSTANTIATE_TEST_SUITE_P(Verdict, HoldAgainst,
                         testing::Values(Held{"nan", {k_nan, k_nan, k_nan}, 1, true, Verdict::cannot_tell},
                                         Held{"nan_hi", {1, 0, k_nan}, 5, true, Verdict::cannot_tell},
                                         Held{"wholly_good", {1, 0.5, 1.5}, 2, true, Verdict::pass},
                                         Held{"touches_from_below", {1, 0.5, 2}, 2, true, Verdict::pass},
                                         Held{"straddles", {1.9, 1.5, 2.1}, 2, true, Verdict::cannot_tell},
                                         Held{"starts_on_the_limit", {2.2, 2, 2.4}, 2, true, Verdict::cannot_tell},
                                         Held{"wholly_bad", {2.5, 2.1, 3}, 2, true, Verdict::fail},
                                         Held{"zero_allowed", {0, 0, 0}, 0, true, Verdict::pass},
                                         Held{"one_of_zero", {1, 1, 1}, 0, true, Verdict::fail},
                                         Held{"gap_wide", {3, 2, 4}, 2, false, Verdict::pass},
                                         Held{"gap_straddles", {2, 1.5, 2.5}, 2, false, Verdict::cannot_tell},
                                         Held{"gap_narrow", {1, 0.5, 1.5}, 2, false, Verdict::fail},
                                         Held{"gap_endless", {k_inf, k_inf, k_inf}, 2, false, Verdict::pass}),
                         [](const auto& row) { return std::string(row.param.name); });

/// The verdict of one limit on the hand-made part.
RuleResult one_rule(const std::string& limits, const HandMadePart& part = {}) {
    const InspectionReport report = part.report(parse_criteria("{\"limits\": {" + limits + "}}", "c.json"));
    EXPECT_EQ(report.judgement.rules.size(), 1u);
    EXPECT_EQ(report.judgement.verdict, report.judgement.rules.at(0).verdict);
    return report.judgement.rules.at(0);
}

TEST(Judge, EachRuleOnAKnownPart) {
    // porosity 1.35 [1.25, 1.45]
    EXPECT_EQ(one_rule("\"porosity_percent\": 1.5").verdict, Verdict::pass);
    EXPECT_EQ(one_rule("\"porosity_percent\": 1.4").verdict, Verdict::cannot_tell);
    EXPECT_EQ(one_rule("\"porosity_percent\": 1.2").verdict, Verdict::fail);
    // largest volume 3.375 [3.0375, 3.7125]
    EXPECT_EQ(one_rule("\"defect_volume_mm3\": 4").verdict, Verdict::pass);
    EXPECT_EQ(one_rule("\"defect_volume_mm3\": 3.5").verdict, Verdict::cannot_tell);
    const RuleResult fails = one_rule("\"defect_volume_mm3\": 1.5");
    EXPECT_EQ(fails.verdict, Verdict::fail);
    EXPECT_EQ(fails.defect, 1u);
    EXPECT_DOUBLE_EQ(fails.value.value, 3.375);
    // 2 certain, 3 in all
    EXPECT_EQ(one_rule("\"count\": 3").verdict, Verdict::pass);
    EXPECT_EQ(one_rule("\"count\": 2").verdict, Verdict::cannot_tell);
    EXPECT_EQ(one_rule("\"count\": 1").verdict, Verdict::fail);
    // gap 1.2, surfaces off by a quarter of a millimetre each
    EXPECT_EQ(one_rule("\"min_gap_mm\": 0.6").verdict, Verdict::pass);
    EXPECT_EQ(one_rule("\"min_gap_mm\": 1").verdict, Verdict::cannot_tell);
    EXPECT_EQ(one_rule("\"min_gap_mm\": 1.8").verdict, Verdict::fail);
    EXPECT_EQ(one_rule("\"min_surface_distance_mm\": 1.4").verdict, Verdict::pass);
    EXPECT_EQ(one_rule("\"min_surface_distance_mm\": 1.5").verdict, Verdict::cannot_tell);
    EXPECT_EQ(one_rule("\"min_surface_distance_mm\": 1.7").verdict, Verdict::fail);
}

TEST(Judge, ADefectTooSmallToMeasureIsBoundedByItsVoxels) {
    // Defect 3 has one voxel of 0.5 mm: its ball is no wider than the diagonal of 3 x 3 x 3 voxels, 2.6 mm.
    HandMadePart part;
    part.analysis.defects.erase(part.analysis.defects.begin(), part.analysis.defects.begin() + 2);
    part.analysis.defects[0].id = 1;
    for (std::uint32_t& id : *part.analysis.labels.labels) id = id == 3 ? 1 : 0;
    EXPECT_EQ(one_rule("\"defect_diameter_mm\": 2.7", part).verdict, Verdict::pass);
    EXPECT_EQ(one_rule("\"defect_diameter_mm\": 1", part).verdict, Verdict::cannot_tell);
    EXPECT_EQ(one_rule("\"defect_volume_mm3\": 3.4", part).verdict, Verdict::pass);
    EXPECT_EQ(one_rule("\"defect_volume_mm3\": 0", part).verdict, Verdict::cannot_tell);
}

TEST(Judge, DefectsCarryTheRuleTheyBreak) {
    const InspectionReport report = HandMadePart().report(
        parse_criteria(R"({"limits": {"defect_volume_mm3": 1.5, "min_surface_distance_mm": 1}})", "c.json"));
    EXPECT_EQ(report.judgement.defects[0].verdict, Verdict::fail);
    EXPECT_NE(report.judgement.defects[0].why.find("defect_volume_mm3"), std::string::npos);
    EXPECT_EQ(report.judgement.defects[1].verdict, Verdict::pass);
    EXPECT_EQ(report.judgement.defects[1].why, "within all limits");
    EXPECT_EQ(worst_first(report.analysis, report.judgement).front(), 1u);
}

TEST(Judge, ZonesSeeOnlyWhatIsInThem) {
    // The box holds defect 2 alone, and 4 x 4 x 4 voxels of the part.
    const Criteria criteria = parse_criteria(R"({"zones": [
        {"name": "seat", "box_mm": [[5.4, 3.9, 3.4], [7.1, 5.6, 5.1]],
         "limits": {"count": 1, "porosity_percent": 20, "defect_volume_mm3": 0.5}},
        {"name": "air", "box_mm": [[0, 0, 0], [0.6, 0.6, 0.6]], "limits": {"count": 0}},
        {"name": "rim", "box_mm": [[-5, 0, 0], [9, 8, 7]], "limits": {"count": 9}}]})",
                                             "c.json");
    const Judgement judged = HandMadePart().report(criteria).judgement;
    ASSERT_EQ(judged.rules.size(), 5u);
    EXPECT_EQ(judged.rules[0].zone, "seat");
    EXPECT_DOUBLE_EQ(judged.rules[0].value.value, 100.0 * 8 / 64);  // porosity: 8 of 64 voxels
    EXPECT_EQ(judged.rules[0].verdict, Verdict::pass);
    EXPECT_EQ(judged.rules[1].rule, Rule::defect_volume_mm3);
    EXPECT_EQ(judged.rules[1].verdict, Verdict::fail);
    EXPECT_EQ(judged.rules[1].defect, 2u);
    EXPECT_EQ(judged.rules[2].value.value, 1);
    EXPECT_EQ(judged.rules[3].verdict, Verdict::cannot_tell);  // nothing of the part
    EXPECT_EQ(judged.rules[4].verdict, Verdict::cannot_tell);  // reaches out of the volume
    EXPECT_EQ(judged.defects[1].zones, (std::vector<std::string>{"seat", "rim"}));
    EXPECT_EQ(judged.verdict, Verdict::fail);
}

TEST(Judge, APartNotWhollySeenCannotBeTold) {
    const Criteria easy = parse_criteria(R"({"limits": {"porosity_percent": 50}})", "c.json");
    const Criteria hard = parse_criteria(R"({"limits": {"porosity_percent": 0}})", "c.json");
    HandMadePart cut;
    cut.analysis.part.cut_by_frame = true;
    EXPECT_EQ(cut.report(easy).judgement.verdict, Verdict::cannot_tell);
    const Judgement judged = cut.report(hard).judgement;
    EXPECT_EQ(judged.verdict, Verdict::cannot_tell);
    EXPECT_EQ(judged.rules[0].verdict, Verdict::fail);
    EXPECT_NE(judged.reasons[0].find("cut"), std::string::npos);

    HandMadePart empty;
    empty.analysis.defects.clear();
    empty.analysis.part = PartFacts{};
    empty.analysis.part.porosity_percent = {k_nan, k_nan, k_nan};
    const Judgement none = empty.report(easy).judgement;
    EXPECT_EQ(none.verdict, Verdict::cannot_tell);
    EXPECT_NE(none.reasons[0].find("no material"), std::string::npos);

    EXPECT_EQ(HandMadePart().report(parse_criteria("{}", "c.json")).judgement.verdict, Verdict::cannot_tell);
}

TEST(Judge, AnInspectorsWordStandsOverTheComputedOne) {
    const Criteria criteria = parse_criteria(R"({"limits": {"defect_volume_mm3": 1.5}})", "c.json");
    const HandMadePart part;
    EXPECT_EQ(part.report(criteria).judgement.verdict, Verdict::fail);
    const Judgement accepted = part.report(criteria, {{1, true, "a drilled hole"}, {3, true, "noise"}}).judgement;
    EXPECT_EQ(accepted.verdict, Verdict::pass);
    EXPECT_EQ(accepted.defects[0].why, "accepted by hand: a drilled hole");
    const Judgement rejected = part.report(criteria, {{1, true, "a drilled hole"}, {2, false, "a crack"}}).judgement;
    EXPECT_EQ(rejected.verdict, Verdict::fail);
    EXPECT_EQ(rejected.defects[1].verdict, Verdict::fail);
    EXPECT_THROW(part.report(criteria, {{9, true, "x"}}), Error);
    EXPECT_THROW(part.report(criteria, {{1, true, ""}}), Error);
}

}  // namespace

}  // namespace lacuna
