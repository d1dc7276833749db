#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/inspect/criteria.h"
#include "core/inspect/part_analysis.h"

namespace lacuna {

/// What is known about a limit being kept. cannot_tell: the value's interval lies on both sides of the limit, or
/// something keeps the value from being known at all.
enum class Verdict { pass, fail, cannot_tell };

std::string_view name_of(Verdict verdict);  ///< "pass", "fail", "cannot tell"

/// Holds an interval against a limit: pass if it lies wholly on the good side (the limit itself is good), fail if
/// wholly on the bad side, else, and for NaN, cannot_tell.
Verdict hold_against(const Measured& value, double limit, bool from_above);

/// One rule held against one value.
struct RuleResult {
    std::string zone;  ///< empty: the whole part
    Rule rule = Rule::count;
    Verdict verdict = Verdict::pass;
    Measured value;
    double limit = 0;
    std::uint32_t defect = 0;  ///< the defect that decides; 0: none, or the part as a whole
    std::string why;           ///< one sentence
};

/// One defect held against the limits of the part and of every zone it reaches into.
struct DefectJudgement {
    std::uint32_t id = 0;
    Verdict verdict = Verdict::pass;
    std::string why;                 ///< the rule that decides, or "within all limits"
    std::vector<std::string> zones;  ///< zones it reaches into
};

/// An inspector's word on one defect, which stands over the computed one.
struct HandDecision {
    std::uint32_t defect = 0;
    bool accepted = true;  ///< true: counts no longer; false: the part fails by it
    std::string reason;
};

/// The verdict on a part and all that led to it.
struct Judgement {
    Verdict verdict = Verdict::cannot_tell;
    std::vector<std::string> reasons;      ///< sentences, the decisive one first
    std::vector<RuleResult> rules;         ///< part first, then zones, in the criteria's order
    std::vector<DefectJudgement> defects;  ///< as PartAnalysis::defects
    std::vector<HandDecision> by_hand;
};

/// Judges a measured part. What no interval is given for gets one here:
/// - count: from the defects of probability 0.95 or more, to all;
/// - gap: the two surfaces may each lie off by half the interval of the equivalent diameter, but no less than half the
///   smallest voxel spacing;
/// - size of a defect too small to measure: from 0 to that of its box of voxels grown by one voxel on every side;
/// - a zone's porosity: each void's interval by the share of its voxels in the zone, over the part's volume there.
/// A part without material or cut by the frame is "cannot tell" whatever the rules say; they are listed all the same.
/// A zone that reaches out of the volume or holds no part can fail, but not pass.
/// @param masks  one a zone, see lay_zones
/// @throws Error(bad_usage) for a hand decision on a defect that does not exist, or without a reason
Judgement judge(const PartAnalysis& part, const Criteria& criteria, std::span<const ZoneMask> masks,
                std::vector<HandDecision> by_hand = {}, const JobContext& job = {});

}  // namespace lacuna
