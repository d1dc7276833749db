#include "core/inspect/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/names.h"

namespace lacuna {

namespace {

constexpr double k_sure = 0.95;  // probability from which a find counts as a defect for certain
constexpr NameTable<Verdict, 3> k_verdict_names{
    {{Verdict::pass, "pass"}, {Verdict::fail, "fail"}, {Verdict::cannot_tell, "cannot tell"}}};

Verdict worse(Verdict a, Verdict b) {
    if (a == Verdict::fail || b == Verdict::fail) return Verdict::fail;
    return a == Verdict::cannot_tell ? a : b;
}

/// Fail over cannot tell over pass: what a row is sorted by.
int rank(Verdict v) { return v == Verdict::fail ? 2 : v == Verdict::cannot_tell ? 1 : 0; }

/// What lies in one zone (or in the whole part).
struct Place {
    std::string name;
    const Limits* limits = nullptr;
    const ZoneMask* mask = nullptr;         ///< none: the whole part
    std::vector<std::int64_t> voxels_of{};  ///< of each defect (by id - 1) inside
    std::int64_t part_voxels = 0;
    bool holds(const Defect& defect) const { return !mask || voxels_of[defect.id - 1] > 0; }
};

Place survey(const PartAnalysis& part, const Zone& zone, const ZoneMask& mask, const JobContext& job) {
    Place place{zone.name, &zone.limits, &mask, std::vector<std::int64_t>(part.defects.size()), 0};
    if (!part.labels.labels || !part.part_mask.labels) return place;
    for (int z = mask.first().z; z <= mask.last().z; ++z) {
        job.check();
        for (int y = mask.first().y; y <= mask.last().y; ++y)
            for (int x = mask.first().x; x <= mask.last().x; ++x) {
                const std::uint32_t id = part.labels(x, y, z), inside = part.part_mask(x, y, z);
                if ((id == 0 && inside == 0) || !mask.contains(x, y, z)) continue;
                place.part_voxels += inside != 0;
                if (id > 0 && id <= place.voxels_of.size()) ++place.voxels_of[id - 1];
            }
    }
    return place;
}

/// The judge at work: the part, and which defects an inspector has taken out.
class Court {
public:
    Court(const PartAnalysis& part, std::vector<HandDecision> by_hand) : part_(part) {
        judgement_.by_hand = std::move(by_hand);
        for (const Defect& defect : part.defects)
            judgement_.defects.push_back({defect.id, Verdict::pass, "within all limits", {}});
        for (const HandDecision& word : judgement_.by_hand) {
            if (word.defect < 1 || word.defect > part.defects.size())
                throw Error(Errc::bad_usage,
                            fmt::format("There is no defect {}; the part has {}.", word.defect, part.defects.size()));
            if (word.reason.empty())
                throw Error(Errc::bad_usage, fmt::format("The decision on defect {} needs a reason.", word.defect));
            words_[word.defect] = &word;
        }
    }

    void hear(const Place& place) {
        if (place.mask)
            for (const Defect& defect : part_.defects)
                if (place.holds(defect)) judgement_.defects[defect.id - 1].zones.push_back(place.name);
        for (const Rule rule : k_rules)
            if ((*place.limits)[rule]) judgement_.rules.push_back(result(place, rule, *(*place.limits)[rule]));
    }

    Judgement finish(const Criteria& criteria) {
        for (const auto& [id, word] : words_) {
            DefectJudgement& row = judgement_.defects[id - 1];
            row.verdict = word->accepted ? Verdict::pass : Verdict::fail;
            row.why = (word->accepted ? "accepted by hand: " : "rejected by hand: ") + word->reason;
        }
        Verdict verdict = Verdict::pass;
        for (const RuleResult& rule : judgement_.rules) verdict = worse(verdict, rule.verdict);
        for (const auto& [id, word] : words_)
            if (!word->accepted) verdict = Verdict::fail;
        explain(criteria, verdict);
        return std::move(judgement_);
    }

private:
    bool counts(const Defect& defect) const {
        const auto word = words_.find(defect.id);
        return word == words_.end() || !word->second->accepted;
    }

    /// Size in mm of the defect's box of voxels, grown by a voxel on every side.
    glm::dvec3 grown_box(const Defect& defect) const {
        return glm::dvec3(defect.bbox_last - defect.bbox_first + 3) * part_.labels.geometry.spacing;
    }

    Measured volume(const Defect& defect) const {
        if (defect.measurable && std::isfinite(defect.volume_mm3.value)) return defect.volume_mm3;
        const glm::dvec3 box = grown_box(defect);
        const double seen = double(defect.voxels) * part_.labels.geometry.voxel_volume_mm3();
        return {seen, 0, std::max(seen, box.x * box.y * box.z)};
    }

    Measured diameter(const Defect& defect) const {
        if (defect.measurable && std::isfinite(defect.diameter_mm.value)) return defect.diameter_mm;
        const glm::dvec3 extent(defect.bbox_last - defect.bbox_first + 1);
        const double seen = glm::length(extent * part_.labels.geometry.spacing);
        return {seen, 0, std::max(seen, glm::length(grown_box(defect)))};
    }

    Measured gap(const Defect& defect) const {
        const double half_voxel = 0.5 * part_.labels.geometry.smallest_spacing_mm();
        const Measured& d = defect.equivalent_diameter_mm;
        const double own = 0.5 * (d.hi - d.lo);
        const double off = 2 * (own > half_voxel ? own : half_voxel);  // of both surfaces; NaN: half a voxel
        return {defect.gap_mm, std::max(0.0, defect.gap_mm - off), defect.gap_mm + off};
    }

    Measured of_defect(const Defect& defect, Rule rule) const {
        switch (rule) {
            case Rule::defect_volume_mm3:
                return volume(defect);
            case Rule::defect_diameter_mm:
                return diameter(defect);
            case Rule::min_gap_mm:
                return gap(defect);
            default:
                return defect.surface_distance_mm;
        }
    }

    RuleResult result(const Place& place, Rule rule, double limit) {
        RuleResult row;
        row.zone = place.name;
        row.rule = rule;
        row.limit = limit;
        if (rule == Rule::porosity_percent)
            judge_whole(row, porosity(place));
        else if (rule == Rule::count)
            judge_whole(row, count(place));
        else
            judge_defects(row, place);
        if (place.mask && row.verdict == Verdict::pass) {
            const bool empty = place.part_voxels == 0;
            if (!empty && !place.mask->reaches_out()) return row;
            row.verdict = Verdict::cannot_tell;
            row.why = empty ? "The zone holds nothing of the part."
                            : "The zone reaches out of the volume; a piece of it was not seen.";
        }
        return row;
    }

    void judge_whole(RuleResult& row, const Measured& value) {
        row.value = value;
        row.verdict = hold_against(value, row.limit, limits_from_above(row.rule));
        row.why = sentence(row);
    }

    /// Every defect against the limit; the row shows the one that decides.
    void judge_defects(RuleResult& row, const Place& place) {
        const bool from_above = limits_from_above(row.rule);
        bool any = false;
        for (const Defect& defect : part_.defects) {
            if (!counts(defect) || !place.holds(defect)) continue;
            const Measured value = of_defect(defect, row.rule);
            const Verdict verdict = hold_against(value, row.limit, from_above);
            RuleResult one = row;
            one.value = value;
            one.verdict = verdict;
            one.defect = defect.id;
            one.why = sentence(one);
            blame(judgement_.defects[defect.id - 1], one);
            const bool farther = from_above ? value.value > row.value.value : value.value < row.value.value;
            if (!any || rank(verdict) > rank(row.verdict) || (verdict == row.verdict && farther)) row = one;
            any = true;
        }
        if (any) return;
        row.value = from_above ? Measured{0, 0, 0} : Measured{INFINITY, INFINITY, INFINITY};
        row.verdict = Verdict::pass;
        row.why = "There is no defect.";
    }

    static void blame(DefectJudgement& defect, const RuleResult& rule) {
        if (rank(rule.verdict) <= rank(defect.verdict)) return;
        defect.verdict = rule.verdict;
        defect.why =
            fmt::format("{}{}: {}", rule.zone.empty() ? "" : "zone " + rule.zone + ", ", name_of(rule.rule), rule.why);
    }

    Measured porosity(const Place& place) const {
        const bool all_count = std::all_of(part_.defects.begin(), part_.defects.end(),
                                           [&](const Defect& defect) { return counts(defect); });
        if (!place.mask && all_count) return part_.part.porosity_percent;
        const Measured& whole = part_.part.part_volume_mm3;
        const double voxel = part_.labels.geometry.voxel_volume_mm3();
        // The part's volume in the zone is counted in voxels; it is off by the same share as that of the whole part.
        const double here = place.mask ? double(place.part_voxels) * voxel : whole.value;
        Measured voids{0, 0, 0};
        for (const Defect& defect : part_.defects) {
            if (!counts(defect) || defect.type != DefectType::void_ || !place.holds(defect)) continue;
            const double share =
                place.mask ? double(place.voxels_of[defect.id - 1]) / double(std::max<std::int64_t>(1, defect.voxels))
                           : 1.0;
            const Measured v = volume(defect);
            voids.value += v.value * share;
            voids.lo += v.lo * share;
            voids.hi += v.hi * share;
        }
        if (!(here > 0) || !(whole.value > 0)) return {NAN, NAN, NAN};
        const double largest = here * whole.hi / whole.value, smallest = here * whole.lo / whole.value;
        return {100 * voids.value / here, 100 * voids.lo / largest,
                smallest > 0 ? std::min(100.0, 100 * voids.hi / smallest) : 100.0};
    }

    Measured count(const Place& place) const {
        Measured n{0, 0, 0};
        for (const Defect& defect : part_.defects) {
            if (!counts(defect) || !place.holds(defect)) continue;
            n.hi += 1;
            n.lo += defect.probability >= k_sure ? 1 : 0;
        }
        n.value = n.hi;
        return n;
    }

    static std::string sentence(const RuleResult& row) {
        const bool above = limits_from_above(row.rule);
        const std::string of = row.defect ? fmt::format("defect {}: ", row.defect) : "";
        if (std::isnan(row.value.value)) return of + "it cannot be measured.";
        const std::string interval =
            row.value.lo == row.value.hi
                ? fmt::format("{:.4g}", row.value.value)
                : fmt::format("{:.4g} [{:.4g}, {:.4g}]", row.value.value, row.value.lo, row.value.hi);
        const std::string unit = unit_of(row.rule).empty() ? "" : " " + std::string(unit_of(row.rule));
        const char* limit = above ? "the most allowed" : "the least allowed";
        switch (row.verdict) {
            case Verdict::pass:
                return fmt::format("{}{}{} keeps {:g}{}, {}.", of, interval, unit, row.limit, unit, limit);
            case Verdict::fail:
                return fmt::format("{}{}{} breaks {:g}{}, {}.", of, interval, unit, row.limit, unit, limit);
            default:
                return fmt::format("{}{}{} lies on both sides of {:g}{}, {}.", of, interval, unit, row.limit, unit,
                                   limit);
        }
    }

    void explain(const Criteria& criteria, Verdict verdict) {
        std::vector<std::string>& reasons = judgement_.reasons;
        const PartFacts& facts = part_.part;
        const auto broken = std::count_if(judgement_.rules.begin(), judgement_.rules.end(),
                                          [](const RuleResult& r) { return r.verdict == Verdict::fail; });
        if (!facts.has_material) {
            verdict = Verdict::cannot_tell;
            reasons.push_back("The volume holds no part: no material was found in it.");
        } else if (facts.cut_by_frame) {
            verdict = Verdict::cannot_tell;
            reasons.push_back("The part is cut by the volume's frame: what lies outside was not seen.");
            if (broken > 0)
                reasons.push_back(
                    fmt::format("What was seen breaks {} of {} limits.", broken, judgement_.rules.size()));
        }
        const bool limits = !criteria.limits.empty() || std::any_of(criteria.zones.begin(), criteria.zones.end(),
                                                                    [](const Zone& z) { return !z.limits.empty(); });
        if (!limits && verdict == Verdict::pass) {
            verdict = Verdict::cannot_tell;
            reasons.push_back("The criteria set no limit, so there is nothing to pass.");
        }
        for (const auto& [id, word] : words_)
            if (!word->accepted) reasons.push_back(fmt::format("Defect {} was rejected by hand: {}", id, word->reason));
        for (const Verdict listed : {Verdict::fail, Verdict::cannot_tell})
            for (const RuleResult& rule : judgement_.rules)
                if (rule.verdict == listed)
                    reasons.push_back(fmt::format("{}{}: {}", rule.zone.empty() ? "" : "Zone " + rule.zone + ", ",
                                                  name_of(rule.rule), rule.why));
        if (reasons.empty()) reasons.push_back(fmt::format("All {} limits are kept.", judgement_.rules.size()));
        judgement_.verdict = verdict;
    }

    const PartAnalysis& part_;
    Judgement judgement_;
    std::map<std::uint32_t, const HandDecision*> words_;
};

}  // namespace

std::string_view name_of(Verdict verdict) { return name_in(k_verdict_names, verdict); }

Verdict hold_against(const Measured& value, double limit, bool from_above) {
    if (std::isnan(value.lo) || std::isnan(value.hi) || std::isnan(limit)) return Verdict::cannot_tell;
    if (from_above) return value.hi <= limit ? Verdict::pass : value.lo > limit ? Verdict::fail : Verdict::cannot_tell;
    return value.lo >= limit ? Verdict::pass : value.hi < limit ? Verdict::fail : Verdict::cannot_tell;
}

Judgement judge(const PartAnalysis& part, const Criteria& criteria, std::span<const ZoneMask> masks,
                std::vector<HandDecision> by_hand, const JobContext& job) {
    if (masks.size() != criteria.zones.size()) throw Error(Errc::bad_usage, "Judging needs one mask a zone.");
    Court court(part, std::move(by_hand));
    court.hear({"", &criteria.limits, nullptr, {}, 0});
    for (std::size_t i = 0; i < masks.size(); ++i) court.hear(survey(part, criteria.zones[i], masks[i], job));
    return court.finish(criteria);
}

}  // namespace lacuna
