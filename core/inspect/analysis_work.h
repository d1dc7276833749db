#pragma once

#include <algorithm>
#include <string>

#include "core/inspect/grey_levels.h"
#include "core/inspect/part_analysis.h"
#include "core/inspect/stability.h"

/// What the steps of analyse_part share; seen only inside the room.
namespace lacuna::inspect {

struct Work {
    const Volume& volume;
    const DetectionOptions& options;
    PartAnalysis analysis{};
    GreyLevels levels{};
    double void_threshold = 0, inclusion_threshold = 0, inclusion_level = 0;
    bool filled = false, binary = false;
    StabilitySweep sweep{};

    PartFacts& part() { return analysis.part; }
    bool local_voids() const { return options.method == ThresholdMethod::local && !void_is_given(); }
    /// Pores this shallow are looked for where the surface is local: blur leaves small ones short of half the contrast.
    double faint_threshold() const { return levels.material - std::max(0.3 * levels.contrast(), 5.5 * levels.noise); }
    void warn(std::string sentence) { analysis.part.warnings.push_back(std::move(sentence)); }
    bool void_is_given() const { return options.void_below || options.material; }
};

/// Parts the volume, finds voids and inclusions, measures, numbers and judges them; levels and thresholds stand
/// already.
void find_and_measure(Work& work, const JobContext& job);

}  // namespace lacuna::inspect
